#include <algorithm>

#include <meshoptimizer.h>

#include "common/failure.h"
#include "cook/geometry/encode_streams.h"
#include "cook/geometry/record.h"
#include "marrow/meshopt.h"
#include "unpack/arrange.h"

namespace marrow::cook {
namespace {

// Vertices in the order in which the runtime will store them: those with the same joints follow each other.
void arrange_vertices(OwnedStreams& s) {
  const MeshStreams view = s.view();
  std::vector<std::byte> memory(arrange_scratch_bytes(view.vertex_count));
  Memory scratch{memory.data(), 0, memory.size()};
  Arrangement a;
  if (!arrange(view, scratch, a)) throw tools::Failure(tools::Exit::internal, "", "", "arrange", "not enough memory");
  std::vector<std::uint32_t> place(view.vertex_count);
  for (std::uint32_t i = 0; i < view.vertex_count; ++i) place[a.order[i]] = i;
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    const std::size_t components = s.streams[i].components;
    std::vector<std::int32_t> values(s.values[i].size());
    for (std::size_t v = 0; v < view.vertex_count; ++v)
      std::copy_n(&s.values[i][a.order[v] * components], components, &values[v * components]);
    s.values[i] = std::move(values);
  }
  for (std::uint32_t& index : s.indices) index = place[index];
  for (std::uint32_t& vertex : s.source_map)
    if (vertex != kNoSlot) vertex = place[vertex];
}

template <class Number>
std::vector<unsigned char> narrowed(const Stream& s, const std::vector<std::int32_t>& values, std::size_t stride) {
  std::vector<unsigned char> out(values.size() / s.components * stride);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Number number = static_cast<Number>(values[i]);
    std::memcpy(&out[i / s.components * stride + i % s.components * sizeof number], &number, sizeof number);
  }
  return out;
}

void add_part(const std::vector<unsigned char>& part, std::vector<std::byte>& out) {
  add_varint(static_cast<std::uint32_t>(part.size()), out);
  for (const unsigned char byte : part) out.push_back(std::byte{byte});
}

}  // namespace

std::vector<std::byte> encode_meshopt(OwnedStreams& s) {
  arrange_vertices(s);
  const std::uint32_t vertices = s.mesh.vertex_count;
  meshopt_encodeIndexVersion(1);
  meshopt_encodeVertexVersion(0);
  std::vector<std::byte> out;
  std::vector<unsigned char> part(meshopt_encodeIndexBufferBound(s.indices.size(), vertices));
  part.resize(meshopt_encodeIndexBuffer(part.data(), part.size(), s.indices.data(), s.indices.size()));
  add_part(part, out);
  // The index codec may turn triangles round; what the runtime decodes is what counts.
  meshopt_decodeIndexBuffer(s.indices.data(), s.indices.size(), sizeof(std::uint32_t), part.data(), part.size());
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    const Stream& stream = s.streams[i];
    const std::size_t number_bytes = stream.bits <= 8 ? 1 : stream.bits <= 16 ? 2 : 4;
    const std::size_t stride = (stream.components * number_bytes + 3) / 4 * 4;
    const std::vector<unsigned char> numbers = number_bytes == 1 ? narrowed<std::uint8_t>(stream, s.values[i], stride)
                                               : number_bytes == 2
                                                   ? narrowed<std::uint16_t>(stream, s.values[i], stride)
                                                   : narrowed<std::int32_t>(stream, s.values[i], stride);
    part.resize(meshopt_encodeVertexBufferBound(vertices, stride));
    part.resize(meshopt_encodeVertexBuffer(part.data(), part.size(), numbers.data(), vertices, stride));
    add_part(part, out);
  }
  OwnedStreams decoded = s;
  for (auto& values : decoded.values) std::fill(values.begin(), values.end(), 0);
  if (meshopt_decoder().decode({out.data(), out.size()}, decoded.view()) != Status::ok || s.values != decoded.values)
    throw tools::Failure(tools::Exit::internal, "", "", "meshopt-mesh-differs",
                         "the encoded mesh does not decode to itself");
  return out;
}

}  // namespace marrow::cook
