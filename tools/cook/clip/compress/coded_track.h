// One coded sub-track of one segment: integers a frame, what they stand for, and what they cost on disk.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "cook/clip/measure/rig.h"
#include "unpack/clip/clip_codec.h"

namespace marrow::cook {

// As format::TrackHeader, with the integers of every frame.
struct CodedTrack {
  int step_code = 0;
  bool fits = false;  // no component is wider than the format allows
  std::array<std::uint32_t, 3> width_codes{};
  std::uint32_t shift = 0;
  std::array<std::int32_t, 3> least{};  // before the shift
  std::uint32_t frame_bits = 0;
  std::uint64_t cost = 0;                           // of all frames, as who searches counts it
  std::vector<std::array<std::int32_t, 3>> values;  // least not yet subtracted
};

// Rounds every frame's value to the step.
CodedTrack quantise(const std::vector<glm::dvec3>& frames, int step_code);

// Finds the widths of the integers.
void fit(CodedTrack& track);

// Some frames of a track that fits.
CodedTrack part_of(const CodedTrack& track, std::size_t first_frame, std::size_t frame_count);

// The code of the largest step that is at most `step`, clamped to what a byte holds.
int code_of_step(double step);

// What a frame of the integers stands for.
glm::dvec3 decode(const CodedTrack& track, std::size_t frame);

// Modified Rodrigues parameters, axis · tan(θ/4), and back. -q gives other parameters than q: the caller chooses.
glm::dvec3 to_rodrigues(const glm::dquat& q);
glm::dquat from_rodrigues(const glm::dvec3& m);

using ClipFrames = std::vector<std::array<std::int32_t, 3>>;

bool moves(const ClipFrames& frames, std::size_t component);
// The predictor that codes a component of a track in the fewest bits, and how far off it is at first. Of equal ones the
// first.
ClipCurve choose_curve(const ClipFrames& frames, std::size_t component);

// Estimates what the integers of a track take in a packed file, by the coder itself, but with models that do not learn.
class PackedCost {
 public:
  static constexpr std::uint64_t kBit = 256;

  PackedCost();
  // In 1 / kBit of a bit. curves: of choose_curve for this track, or for the same one in other steps.
  std::uint64_t of(const ClipFrames& frames, const std::array<ClipCurve, 3>& curves);

 private:
  ClipModels models_;
  std::vector<std::uint16_t> cost_of_share_;
};

}  // namespace marrow::cook
