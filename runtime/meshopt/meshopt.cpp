// Decodes streams that meshoptimizer's codecs compressed.
#include "marrow/meshopt.h"

#include <meshoptimizer.h>

#include "core/byte_reader.h"
#include "core/step.h"
#include "unpack/streams.h"

namespace marrow {
namespace {

constexpr std::size_t padded(std::size_t bytes) {
  return (bytes + 3) / 4 * 4;
}

// A stream's numbers lie in as few bytes as its bits fit in, padded to four a vertex; spreads them, back to front, in
// the array that they have been decoded to. Most: of a vertex, 2 to 4; or else as many as there can be.
template <class Number, std::size_t Most>
void spread(const Stream& s, std::uint32_t vertex_count) {
  const std::size_t components = Most <= 4 ? Most : s.components, stride = padded(components * sizeof(Number));
  auto* const bytes = reinterpret_cast<const std::byte*>(s.values);
  for (std::size_t v = vertex_count; v-- > 0;) {
    Number numbers[padded(Most * sizeof(Number)) / sizeof(Number)];
    std::memcpy(numbers, bytes + v * stride, stride);
    for (std::size_t c = 0; c < components; ++c) s.values[v * components + c] = static_cast<std::int32_t>(numbers[c]);
  }
}

template <class Number>
void spread(const Stream& s, std::uint32_t vertex_count) {
  if (s.components == 2) return spread<Number, 2>(s, vertex_count);
  if (s.components == 3) return spread<Number, 3>(s, vertex_count);
  if (s.components == 4) return spread<Number, 4>(s, vertex_count);
  spread<Number, 256>(s, vertex_count);
}

Status decode_stream(Span<const unsigned char> part, const Stream& s, std::uint32_t vertex_count) {
  const std::size_t number_bytes = s.bits <= 8 ? 1 : s.bits <= 16 ? 2 : 4;
  const std::size_t stride = padded(s.components * number_bytes);
  if (meshopt_decodeVertexBuffer(s.values, vertex_count, stride, part.data, part.size) != 0) return Status::bad_data;
  if (number_bytes == 1) spread<std::uint8_t>(s, vertex_count);
  if (number_bytes == 2) spread<std::uint16_t>(s, vertex_count);
  return Status::ok;
}

// Indices, then stream by stream; in steps of as many as are worth one.
Status decode(Span<const std::byte> bytes, const MeshStreams& out) {
  Decoding in_one_go;
  Decoding& work = out.decoding != nullptr ? *out.decoding : in_one_go;
  ByteReader reader(bytes.data, bytes.size);
  std::uint64_t numbers = 0;
  while (work.parts <= out.stream_count && (out.decoding == nullptr || numbers * sizeof(std::int32_t) < kStepBytes)) {
    const Span<const std::byte> taken = reader.take_bytes(reader.take_varint());
    if (reader.failed()) return Status::bad_data;
    const Span<const unsigned char> part(reinterpret_cast<const unsigned char*>(taken.data), taken.size);
    if (work.parts == 0) {
      const std::size_t count = std::size_t{out.triangle_count} * 3;
      if (meshopt_decodeIndexBuffer(out.indices, count, sizeof(std::uint32_t), part.data, part.size) != 0)
        return Status::bad_data;
      numbers += count;
    } else {
      const Stream& s = out.streams[work.parts - 1];
      if (decode_stream(part, s, out.vertex_count) != Status::ok) return Status::bad_data;
      numbers += std::uint64_t{out.vertex_count} * s.components;
    }
    ++work.parts;
  }
  work.read += static_cast<std::uint32_t>(bytes.size - reader.left());
  return work.parts <= out.stream_count || reader.left() == 0 ? Status::ok : Status::bad_data;
}

}  // namespace

MeshDecoder meshopt_decoder() {
  return {packed::kMeshopt, decode};
}

}  // namespace marrow
