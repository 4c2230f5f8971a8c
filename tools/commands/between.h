// --between and --frames: a clip played from frames that are evenly apart, in place of its own curves.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "deform/motion/between_frames.h"
#include "pose/evaluate.h"

namespace marrow::tools {

struct BetweenArguments {
  std::optional<deform::BetweenFrames> kind;  // none: the clip's own curves
  double hz = 0;
};

// A clip has one parameter, its time: there bicubic interpolation is the cubic.
inline constexpr Named<deform::BetweenFrames> kPlayedBetween[] = {{"linear", deform::BetweenFrames::linear},
                                                                  {"quadratic", deform::BetweenFrames::quadratic},
                                                                  {"cubic", deform::BetweenFrames::cubic},
                                                                  {"bicubic", deform::BetweenFrames::cubic}};

void add_between(CLI::App* command, BetweenArguments& to);

// Frames of a play, both ends of it among them, at least so many a second.
class PlayedFrames {
 public:
  // Throws Failure (usage) if nothing plays. file and play outlive it; parameters: as Character::set_parameters().
  PlayedFrames(const File& file, const Play& play, const BetweenArguments& arguments,
               const std::map<std::string, float>& parameters);
  PlayedFrames(const PlayedFrames&) = delete;
  PlayedFrames& operator=(const PlayedFrames&) = delete;

  // Looks at the frames about a moment; outside the play its first or last one.
  void move_to(float time_s);
  bool has_moved() const { return !poses_.empty() && !poses_.front().empty(); }
  // What they make of a skeleton's joints and a mesh's weights at that moment, for Character's hooks.
  void change(std::uint32_t skeleton, const Pose& pose) const;
  void weigh(std::uint32_t mesh, Span<float> weights) const;

 private:
  const Play& play_;
  deform::BetweenFrames kind_;
  std::size_t intervals_;
  Character character_;
  double at_ = 0;                                              // in frames, from the first that was looked at
  std::vector<std::vector<std::vector<SoaTransform>>> poses_;  // a skeleton, a frame
  std::vector<std::vector<std::vector<float>>> weights_;       // a mesh, a frame
};

}  // namespace marrow::tools
