#include <cstring>

#include "asset/format.h"
#include "math/f32x4.h"
#include "pose/coded_lanes.h"
#include "pose/sample_coded.h"

namespace marrow {
namespace {

// The constants of the lanes `first` and `first` + 1. next: the constants, one for each lane in `lanes`.
inline i32x4 two_constants(const LaneTables& t, const std::byte* next, std::uint32_t lanes, std::uint32_t first) {
  const std::uint8_t(&offset)[4] = t.constant[lanes];
  return words(load_pair(next + offset[first], next + offset[first + 1]));
}

// ab, cd: constants of two lanes each, quaternions of any length.
inline void set_rotations(const LaneTables& t, i32x4 ab, i32x4 cd, std::uint32_t lanes, float (&rotation)[4][4]) {
  i32x4 v[4];
  widen(t, ab, cd, v);
  const f32x4 x = to_float(v[0]), y = to_float(v[1]), z = to_float(v[2]), w = to_float(v[3]);
  const f32x4 inverse = load_aligned(t.one) / sqrt(x * x + y * y + z * z + w * w);
  store_lanes(t, {x * inverse, y * inverse, z * inverse, w * inverse}, lanes, rotation);
}

// ab, cd: constants of two lanes each, a difference from the rest pose and its step.
inline void set_vectors(const LaneTables& t, i32x4 ab, i32x4 cd, const float (&rest)[3][4], std::uint32_t lanes,
                        float (&vector)[3][4]) {
  i32x4 v[4];
  widen(t, ab, cd, v);
  const f32x4 step = splat(1.0f / 65536) * step_sizes(v[3]);
  store_lanes(t,
              {load_aligned(rest[0]) + to_float(v[0]) * step, load_aligned(rest[1]) + to_float(v[1]) * step,
               load_aligned(rest[2]) + to_float(v[2]) * step},
              lanes, vector);
}

// Writes the rest pose, then the constants over it, four numbers at a time.
void set_still_coded(const Skeleton& skeleton, const CodedTracks& coded, const SampleOptions& options,
                     SoaTransform* out) {
  const LaneTables& t = lane_tables();
  const std::byte* next = coded.constants;
  const GroupMasks* masks = coded.masks;
  const SoaTransform* rest = skeleton.rest;
  SoaTransform* const end = out + skeleton.soa_size();
  for (std::size_t g = 0; out != end; ++g, ++out, ++rest, ++masks) {
    const std::uint32_t constant = masks->constant, wanted = wanted_lanes(options, g);
    // If every rotation is constant or moves, the rest pose's rotations need not be copied: all are overwritten.
    const bool rotations_follow = wanted == 15 && (~(masks->moving | constant) & 15u) == 0;
    if (rotations_follow) {
      copy(rest->translation, out->translation);
      copy(rest->scale, out->scale);
    } else {
      copy_lanes(*rest, wanted, *out);
    }
    if (const std::uint32_t lanes = constant & 15u; lanes == 15) {
      set_rotations(t, load_words(next), load_words(next + 2 * kConstantBytes), wanted, out->rotation);
      next += 4 * kConstantBytes;
    } else if (lanes != 0) {
      set_rotations(t, two_constants(t, next, lanes, 0), two_constants(t, next, lanes, 2),
                    rotations_follow ? 15 : lanes & wanted, out->rotation);
      next += t.constant_bytes[lanes];
    }
    if ((constant & 0xFF0u) == 0) continue;
    for (std::uint32_t shift = 4; shift <= 8; shift += 4) {
      const std::uint32_t lanes = constant >> shift & 15u;
      if (lanes == 0) continue;
      set_vectors(t, two_constants(t, next, lanes, 0), two_constants(t, next, lanes, 2),
                  shift == 4 ? rest->translation : rest->scale, lanes & wanted,
                  shift == 4 ? out->translation : out->scale);
      next += t.constant_bytes[lanes];
    }
  }
}

}  // namespace

void copy_some_lanes(const SoaTransform& from, std::uint32_t lanes, SoaTransform& to) {
  if (lanes == 15) {
    to = from;
    return;
  }
  constexpr std::size_t kNumbers = sizeof from / sizeof(float);
  const auto* const source = reinterpret_cast<const float*>(&from);
  auto* const target = reinterpret_cast<float*>(&to);
  for (std::size_t i = 0; i < kNumbers; ++i)
    if ((lanes >> i % 4 & 1u) != 0) target[i] = source[i];
}

void set_still(const Skeleton& skeleton, const CodedTracks& coded, const SampleOptions& options, SoaTransform* out) {
  if (coded.frame_count != 0) return set_still_coded(skeleton, coded, options, out);
  for (std::size_t g = 0; g < skeleton.soa_size(); ++g) copy_lanes(skeleton.rest[g], wanted_lanes(options, g), out[g]);
}

}  // namespace marrow
