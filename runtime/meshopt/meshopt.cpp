// Decodes streams that meshoptimizer's codecs compressed.
#include "marrow/meshopt.h"

#include <meshoptimizer.h>

#include "core/byte_reader.h"
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

Status decode(Span<const std::byte> bytes, const MeshStreams& out) {
  ByteReader reader(bytes.data, bytes.size);
  const auto take = [&] {
    const Span<const std::byte> part = reader.take_bytes(reader.take_varint());
    return Span<const unsigned char>(reinterpret_cast<const unsigned char*>(part.data), part.size);
  };
  const Span<const unsigned char> indices = take();
  if (reader.failed() || meshopt_decodeIndexBuffer(out.indices, std::size_t{out.triangle_count} * 3,
                                                   sizeof(std::uint32_t), indices.data, indices.size) != 0)
    return Status::bad_data;
  for (std::uint32_t i = 0; i < out.stream_count; ++i) {
    const Stream& s = out.streams[i];
    const std::size_t number_bytes = s.bits <= 8 ? 1 : s.bits <= 16 ? 2 : 4;
    const std::size_t stride = padded(s.components * number_bytes);
    const Span<const unsigned char> part = take();
    if (reader.failed() || meshopt_decodeVertexBuffer(s.values, out.vertex_count, stride, part.data, part.size) != 0)
      return Status::bad_data;
    if (number_bytes == 1) spread<std::uint8_t>(s, out.vertex_count);
    if (number_bytes == 2) spread<std::uint16_t>(s, out.vertex_count);
  }
  return reader.left() == 0 ? Status::ok : Status::bad_data;
}

}  // namespace

MeshDecoder meshopt_decoder() {
  return {packed::kMeshopt, decode};
}

}  // namespace marrow
