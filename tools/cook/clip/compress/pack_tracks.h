// When frames are, what does not move, and how both and the coded tracks become the bytes of docs/format.md.
#pragma once

#include <vector>

#include "asset/format.h"
#include "cook/clip/compress/choose_steps.h"
#include "cook/clip/measure/rig.h"
#include "cook/scene/built.h"

namespace marrow::cook {

// A sub-track that does not move: the numbers that stand for it once a clip.
struct ConstantTrack {
  TrackId id;
  format::Constant numbers;
};

constexpr int kMostConstant = 32767;

// A rotation as integers up to `most`: of many multiples of its quaternion the one that rounds best. With kMostConstant
// it is off by a few 1e-6 rad.
format::Constant code_rotation(const glm::dquat& q, int most);
glm::dquat decode_rotation(const format::Constant& constant);

// A difference from the rest pose as integers up to `most` and a step, which is at most 4/3 of the largest component /
// most. It is off by at most half a step.
format::Constant code_offset(const glm::dvec3& offset, int most);
glm::dvec3 decode_offset(const format::Constant& constant);

// When the frames of a coded clip are.
struct Grid {
  float start_s, end_s;
  std::size_t intervals;
  std::vector<float> times_s;  // intervals + 1; none: even steps

  // Moments are kMoments an interval.
  double exact_time_of(std::size_t moment) const;
};

// Grids worth trying, in this order. Of LINEAR tracks: even steps on which all keys fall but for rounding, then the
// keys' own times, which loses nothing. Of curves: even steps, coarse to fine. Empty if there is nothing to code.
std::vector<Grid> grids(const BuiltClip& clip);

// Coded tracks → the bytes of docs/format.md.
class Packer {
 public:
  // Both in the order in which they are stored: by groups of four joints, in each rotations, translations, scales.
  Packer(const std::vector<TrackId>& moving, const std::vector<ConstantTrack>& constant, std::size_t joint_count);
  // A segment's tracks, one for each that moves.
  void add(const std::vector<CodedTrack>& tracks);
  BuiltCoded finish(const Grid& grid, std::size_t segment_intervals);

 private:
  BuiltCoded out_;
};

}  // namespace marrow::cook
