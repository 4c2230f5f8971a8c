#include "commands/between.h"

#include <algorithm>
#include <cmath>

#include "commands/arguments.h"
#include "deform/motion/between_frames.h"

namespace marrow::tools {
namespace {

constexpr double kLeastFrames_hz = 0.1, kMostFrames_hz = 240;

std::size_t intervals(const Play& play, double hz) {
  if (!(hz >= kLeastFrames_hz && hz <= kMostFrames_hz))
    throw Failure(Exit::usage, "--frames", "", "not a rate", "give 0.1 to 240 frames a second");
  if (play.empty() || !(play.duration_s > 0))
    throw Failure(Exit::usage, "--between", "", "nothing plays", "give --clip too");
  return static_cast<std::size_t>(std::max(1.0, std::ceil(static_cast<double>(play.duration_s) * hz - 1e-6)));
}

}  // namespace

void add_between(CLI::App* command, BetweenArguments& to) {
  const auto set = [&to](const std::string& name) { to.kind = value_of(kPlayedBetween, name); };
  CLI::Option* const between =
      command
          ->add_option_function<std::string>("--between", set,
                                             "play the clip from --frames, and interpolate between them: quadratic by "
                                             "the frame before and both, cubic by one more; bicubic is the cubic")
          ->check(CLI::IsMember(names_of(kPlayedBetween)));
  CLI::Option* const frames =
      command->add_option("--frames", to.hz, "with --between: frames a second, evenly apart")->type_name("HZ");
  between->needs(frames);
  frames->needs(between);
}

PlayedFrames::PlayedFrames(const File& file, const Play& play, const BetweenArguments& arguments,
                           const std::map<std::string, float>& parameters)
    : play_(play),
      kind_(*arguments.kind),
      intervals_(intervals(play, arguments.hz)),
      character_(file),
      poses_(file.skeleton_count()),
      weights_(file.mesh_count()) {
  character_.set_parameters(parameters);
  character_.set_change([this](std::uint32_t skeleton, const Pose& pose) {
    poses_[skeleton].emplace_back(pose.local.begin(), pose.local.end());
  });
  character_.set_weigh(
      [this](std::uint32_t mesh, Span<float> weights) { weights_[mesh].emplace_back(weights.begin(), weights.end()); });
}

void PlayedFrames::move_to(float time_s) {
  for (auto& frames : poses_) frames.clear();
  for (auto& frames : weights_) frames.clear();
  const double count = static_cast<double>(intervals_), duration_s = static_cast<double>(play_.duration_s);
  const double at = std::clamp(static_cast<double>(time_s) / duration_s, 0.0, 1.0) * count;
  const auto interval = static_cast<std::size_t>(std::min(std::floor(at), count - 1));
  const std::size_t first = interval - std::min<std::size_t>(1, interval);
  for (std::size_t f = first; f <= std::min(interval + 2, intervals_); ++f)
    character_.pose(play_, static_cast<float>(static_cast<double>(f) * duration_s / count));
  at_ = at - static_cast<double>(first);
}

void PlayedFrames::change(std::uint32_t skeleton, const Pose& pose) const {
  std::ranges::copy(deform::between_poses(kind_, poses_[skeleton], at_), pose.local.begin());
  check(local_to_model(pose.skeleton, pose.local, pose.model_from_joint));
}

void PlayedFrames::weigh(std::uint32_t mesh, Span<float> weights) const {
  for (std::size_t t = 0; t < weights.size; ++t) {
    std::vector<glm::dvec3> numbers;
    for (const std::vector<float>& frame : weights_[mesh]) numbers.emplace_back(frame[t]);
    weights[t] = static_cast<float>(deform::between_frames(kind_, numbers, at_).x);
  }
}

}  // namespace marrow::tools
