#include "draco/decode_skin.h"

#include <algorithm>
#include <memory>

#include "draco/skin_codec.h"

namespace marrow {

void SkinModels::begin() {
  begin_near(3, distances);
  for (std::uint32_t size = 0; size < kSizes; ++size) begin_near(size, weights[size]);
}

SkinBefore::SkinBefore(const MeshStreams& mesh)
    : twin(mesh.vertex_count), first(mesh.vertex_count), second(mesh.vertex_count) {
  const std::int32_t* const positions = mesh.find(StreamKind::position)->values;
  std::uint32_t table_bits = 1;
  while (table_bits < 31 && mesh.vertex_count >> table_bits != 0) ++table_bits;
  std::vector<std::uint32_t> latest(std::size_t{1} << table_bits, UINT32_MAX);  // by a hash of its position
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
    const std::int32_t* const p = positions + std::size_t{v} * 3;
    const std::uint32_t mixed = static_cast<std::uint32_t>(p[0]) * 0x9e3779b1u ^
                                static_cast<std::uint32_t>(p[1]) * 0x85ebca77u ^
                                static_cast<std::uint32_t>(p[2]) * 0xc2b2ae3du;
    std::uint32_t& last = latest[mixed * 0x9e3779b1u >> (32 - table_bits)];
    twin[v] = first[v] = second[v] = v;
    if (last != UINT32_MAX) {
      const std::int32_t* const q = positions + std::size_t{last} * 3;
      if (p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) twin[v] = last;
    }
    last = v;
  }
  for (std::uint32_t t = 0; t < mesh.triangle_count; ++t) {
    std::uint32_t i[3];
    for (std::size_t corner = 0; corner < 3; ++corner) i[corner] = mesh.indices[std::size_t{t} * 3 + corner];
    std::sort(i, i + 3);
    const auto [earliest, earlier, v] = i;
    if (earlier == v) continue;
    if (first[v] != v && (first[v] > earlier || (first[v] == earlier && second[v] >= earliest))) continue;
    first[v] = earlier;
    second[v] = earliest;
  }
  for (std::uint32_t v = 1; v < mesh.vertex_count; ++v)
    if (first[v] == v) first[v] = second[v] = v - 1;
}

bool has_skin_for_bits(const MeshStreams& mesh) {
  const Stream* const weights = mesh.find(StreamKind::weights);
  return mesh.find(StreamKind::joints) != nullptr &&
         (weights == nullptr || (weights->bits > 0 && weights->bits <= kMostWeightBits));
}

bool decode_skin(Span<const std::byte> bits, const MeshStreams& mesh) {
  if (!has_skin_for_bits(mesh)) return false;
  const SkinBefore before(mesh);
  const auto models = std::make_unique<SkinModels>();
  models->begin();
  SymbolDecoder decoder(bits);
  SkinCodec<SymbolDecoder> codec(mesh, before, *models, decoder);
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
    if (!codec.code(v)) return false;
  return decoder.at_end();
}

}  // namespace marrow
