// When frames are, what does not move, and how both and the coded tracks become the bytes of docs/format.md.
#pragma once

#include <set>
#include <vector>

#include "asset/format.h"
#include "cook/clip/compress/choose_steps.h"
#include "cook/clip/measure/rig.h"
#include "cook/scene/built.h"

namespace marrow::cook {

struct ConstantTrack {
  TrackId id;
  format::Constant numbers;
};

constexpr int kMostConstant = 32767;

// The numbers up to `most` closest to a rotation among many factors of its quaternion: with kMostConstant off by a few
// 1e-6 rad.
format::Constant code_rotation(const glm::dquat& q, int most);
glm::dquat decode_rotation(const format::Constant& constant);

// The numbers up to `most` closest to a difference from the rest pose: off by half a step of 4/3 of its largest
// component / most, at most.
format::Constant code_offset(const glm::dvec3& offset, int most);
glm::dvec3 decode_offset(const format::Constant& constant);

struct Grid {
  float start_s, end_s;
  std::size_t intervals;
  std::vector<float> times_s;  // intervals + 1; none: even steps

  // Moments are kMoments an interval.
  double exact_time_of(std::size_t moment) const;
};

// The times of the keys that are to be coded.
std::set<float> key_times(const BuiltClip& clip);

// Grids worth trying: of LINEAR tracks the keys' own, on even steps but for the rounding of their times, then where
// they are, which loses nothing; of curves even steps that come close enough, coarse to fine. None if nothing is to be
// coded.
std::vector<Grid> grids(const BuiltClip& clip);

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
