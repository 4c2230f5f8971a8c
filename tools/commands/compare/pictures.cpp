#include "commands/compare/pictures.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "commands/compare/stage.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

constexpr int kSide = 620;  // as wide as the slider shows them

// The held-out poses with the largest errors, no two of one clip; of poses without a clip just the worst.
std::vector<std::size_t> worst_poses(const Round& round, const std::vector<double>& errors, std::size_t most) {
  std::map<std::string, std::size_t> worst_of_clip;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const auto [at, is_new] = worst_of_clip.try_emplace(round.held[i].clip, i);
    if (errors[i] > errors[at->second]) at->second = i;
  }
  std::multimap<double, std::size_t> by_error;
  for (const auto& [clip, i] : worst_of_clip) by_error.emplace(-errors[i], i);
  std::vector<std::size_t> out;
  for (const auto& [error, i] : by_error)
    if (out.size() < most) out.push_back(i);
  return out;
}

}  // namespace

std::vector<PictureRow> draw_worst_poses(const Study& study, const DeformerComparison& comparison,
                                         const deform::Deformer& truth, const std::vector<std::size_t>& deformers,
                                         std::size_t most) {
  Stage stage(study, kSide);
  const Round& round = study.rounds.front();
  std::vector<PictureRow> out;
  for (const std::size_t i : worst_poses(round, comparison.rows[deformers.front()].error_of_pose, most)) {
    const HeldPose& held = round.held[i];
    PictureRow row;
    row.title =
        held.clip.empty() ? fmt::format("pose {}", i) : fmt::format("{} at {} s", held.clip, plain_number(held.time_s));
    stage.draw(
        {held.pose, truth, comparison, deformers},
        [&](const Stage::Compared& compared) { return stage.whole(compared); }, row);
    out.push_back(std::move(row));
  }
  return out;
}

}  // namespace marrow::tools
