// Coded tracks → the bytes of docs/format.md.
#pragma once

#include "cook/clip/compress/choose_steps.h"
#include "cook/clip/compress/constant.h"
#include "cook/clip/compress/grid.h"
#include "cook/scene/built.h"

namespace marrow::cook {

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
