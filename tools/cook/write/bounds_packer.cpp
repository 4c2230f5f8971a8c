#include "cook/write/bounds_packer.h"

#include <algorithm>
#include <cstdlib>
#include <span>

#include "cook/geometry/record.h"
#include "unpack/clip/bounds_codec.h"

namespace marrow::cook {
namespace {

using Codec = BoundsCodec<SymbolEncoder>;
static_assert(Codec::kBytes == sizeof(format::BoundsCodes));

using Row = std::span<format::BoundsCodes>;  // of a clip

constexpr std::size_t kMostBack = 256;     // clips that are tried
constexpr std::uint32_t kFurtherBits = 4;  // to name a clip that is not the one before

// About how many bits the ends of boxes are apart from those of another clip.
std::uint32_t bits_between(Row row, Row other) {
  std::uint32_t out = 0;
  for (std::size_t m = 0; m < row.size(); ++m) {
    const format::BoundsCodes &a = row[m], &b = other[m];
    const auto add = [&](std::int32_t to, std::int32_t from) {
      out += bit_length(static_cast<std::uint32_t>(std::abs(to - rescaled(from, 4 * b.exponent, 4 * a.exponent))));
    };
    for (int c = 0; c < 3; ++c) {
      add(a.box_min[c], b.box_min[c]);
      add(a.box_max[c], b.box_max[c]);
    }
  }
  return out;
}

}  // namespace

std::vector<std::byte> pack_bounds(const MeasuredBounds& bounds) {
  std::vector<std::byte> out;
  for (const std::uint32_t n : {bounds.header.skeleton, bounds.header.clip_count, bounds.header.mesh_count})
    add_varint(n, out);
  std::vector<format::BoundsCodes> codes = bounds.codes;
  const std::size_t meshes = bounds.header.mesh_count;
  const auto row = [&](std::size_t clip) { return Row(codes).subspan(clip * meshes, meshes); };
  const auto bytes_of = [](format::BoundsCodes& c) { return reinterpret_cast<std::byte*>(&c); };
  SymbolEncoder encoder;
  Codec codec;
  for (std::size_t clip = 0; clip < bounds.header.clip_count; ++clip) {
    std::size_t like = clip;
    std::uint32_t least = UINT32_MAX;
    for (std::size_t other = clip; other-- > clip - std::min(clip, kMostBack);) {
      const std::uint32_t bits = bits_between(row(clip), row(other)) + (other + 1 < clip ? kFurtherBits : 0);
      if (bits < least) {
        least = bits;
        like = other;
      }
    }
    if (clip > 0) codec.code_between(encoder, static_cast<std::uint32_t>(clip - 1 - like));
    for (std::size_t m = 0; m < meshes; ++m)
      codec.code(encoder,
                 clip > 0 ? bytes_of(row(like)[m])
                 : m > 0  ? bytes_of(row(0)[m - 1])
                          : Codec::kNothing,
                 bytes_of(row(clip)[m]));
  }
  const std::vector<std::byte> symbols = encoder.finish();
  out.insert(out.end(), symbols.begin(), symbols.end());
  return out;
}

}  // namespace marrow::cook
