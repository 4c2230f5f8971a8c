// Coded tracks at a time → local transforms; the part of `sample` that unpacks.
#pragma once

#include "marrow/sample.h"
#include "math/f32x4.h"

namespace marrow {

// The joints of a group of four that are asked for, one bit each.
inline std::uint32_t wanted_lanes(const SampleOptions& options, std::size_t group) {
  return options.joints.empty() ? 15u : options.joints[group / 8] >> (4 * (group % 8)) & 15u;
}

template <std::size_t N>
inline void copy(const float (&from)[N][4], float (&to)[N][4]) {
  f32x4 v[N];
  for (std::size_t i = 0; i < N; ++i) v[i] = load_aligned(from[i]);
  for (std::size_t i = 0; i < N; ++i) store(to[i], v[i]);
}

// One by one.
void copy_some_lanes(const SoaTransform& from, std::uint32_t lanes, SoaTransform& to);

// All lanes are copied inline, which is faster than a call of memcpy() for a few hundred bytes.
inline void copy_lanes(const SoaTransform& from, std::uint32_t lanes, SoaTransform& to) {
  if (lanes != 15) return copy_some_lanes(from, lanes, to);
  copy(from.translation, to.translation);
  copy(from.rotation, to.rotation);
  copy(from.scale, to.scale);
}

// Two neighbouring frames of four sub-tracks of one kind, a lane each, ready to be blended. An even frame stands in
// frame[0], an odd one in frame[1], so that both stay where they are when the later one becomes the earlier.
//   rotations  frame: modified Rodrigues parameters m; other: factors 2 / (1 + m²) of the even and the odd frame, and
//              the squared chord between the two
//   others     frame: integers; other: the least x, y and z, to be added to the integers; step: the step
// step[0] is below 0 if the two frames are alike. Rotations use it for that alone.
struct FramePair {
  alignas(16) float frame[2][3][4], other[3][4], step[4];
};

// Writes what does not move, for the joints asked for: the rest pose, then the clip's constants over it. The clip may
// have no coded tracks.
void set_still(const Skeleton& skeleton, const CodedTracks& coded, const SampleOptions& options, SoaTransform* out);

// Writes the moving tracks over that. time_s is not NaN. cache: null or this clip's; then all joints are asked for.
// Method: rotations are rest · q(m) with m = axis · tan(θ/4), the modified Rodrigues parameters (Shuster, "A survey of
// attitude representations", 1993), translations and scales rest + v; each component an integer times the track's step.
// Two neighbouring frames are unpacked and blended, rotations on the sphere.
void sample_coded(const Skeleton& skeleton, const CodedTracks& coded, float time_s, const SampleOptions& options,
                  SoaTransform* out, SampleCache* cache);

// How many pairs of frames a clip has: one for each kind of sub-track that moves in a group of four joints.
std::size_t frame_pairs(const CodedTracks& coded, std::size_t groups);

}  // namespace marrow
