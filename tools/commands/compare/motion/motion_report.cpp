#include "commands/compare/motion/motion_report.h"

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

ordered_json or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

ordered_json place(const Study& study, std::size_t number) {
  if (number == MotionRow::kNowhere) return {};
  const deform::MotionPose& pose = study.motion.poses[number];
  return {{"joint", study.joint_names[pose.joint]},
          {"kind", deform::name_of(pose.kind)},
          {"angle_deg", glm::degrees(pose.angle_rad)}};
}

ordered_json rows(const Study& study, const DeformerComparison& comparison, const std::vector<MotionRow>& of) {
  ordered_json out = ordered_json::array();
  for (std::size_t d = 0; d < of.size(); ++d) {
    const MotionRow& row = of[d];
    out.push_back({{"deformer", comparison.rows[d].deformer},
                   {"worse_poses", row.worse},
                   {"worse_folding_poses", row.worse_folding},
                   {"of_ssd", row.of_ssd},
                   {"worst_of_ssd", row.worst_of_ssd},
                   {"worst_pose", place(study, row.worst_pose)},
                   {"ring_over_bind", or_null(row.ring_over_bind)},
                   {"ring_over_truth", or_null(row.ring_over_truth)},
                   {"narrowest_pose", place(study, row.narrowest_pose)},
                   {"volume_over_truth", or_null(row.volume_over_truth)},
                   {"flipped_triangles", row.flipped}});
  }
  return out;
}

}  // namespace

ordered_json motion_report(const Study& study, const DeformerComparison& comparison, const MotionStudy& motion) {
  ordered_json joints = ordered_json::array(), folding = ordered_json::array();
  for (const MotionJoint& j : motion.joints)
    joints.push_back({{"joint", study.joint_names[j.joint]},
                      {"poses", j.poses},
                      {"folding_poses", j.folding},
                      {"deformers", rows(study, comparison, j.of)}});
  for (const std::size_t i : motion.folding) {
    ordered_json pose = place(study, i);
    pose["flipped_triangles"] = motion.errors[i].truth_flipped;
    folding.push_back(std::move(pose));
  }
  return {{"poses", motion.poses},
          {"folding_poses", folding},
          {"deformers", rows(study, comparison, motion.of)},
          {"joints", joints},
          {"left_out", study.left_out_of_motion}};
}

void print_motion(const Study& study, const DeformerComparison& comparison, const MotionStudy& motion) {
  if (motion.joints.empty()) {
    fmt::print("\nNo range of motion: no joint deforms anything alone, or the truth is known in no such pose.\n");
  } else {
    fmt::print(
        "\n{}\nEach joint alone, twisted and bent: {} joints, {} poses, and {} in which the truth itself folds\n",
        summary(comparison, motion), motion.joints.size(), motion.poses, motion.folding.size());
    fmt::print("{:<14}{:>7}{:>9}{:>10}{:>8}{:>7}{:>9}{:>8}{:>9}  {}\n", "deformer", "worse", "folding", "of ssd's",
               "worst", "ring", "truth's", "volume", "flipped", "narrowest ring beside the truth's");
  }
  const auto or_none = [](const std::optional<double>& x) { return x ? fmt::format("{:.2f}", *x) : std::string("-"); };
  for (std::size_t d = 0; d < motion.of.size(); ++d) {
    const MotionRow& r = motion.of[d];
    fmt::print("{:<14}{:>7}{:>9}{:>10.3f}{:>8.2f}{:>7}{:>9}{:>8}{:>9}  {}\n", comparison.rows[d].deformer, r.worse,
               r.worse_folding, r.of_ssd, r.worst_of_ssd, or_none(r.ring_over_bind), or_none(r.ring_over_truth),
               or_none(r.volume_over_truth), r.flipped,
               r.narrowest_pose == MotionRow::kNowhere ? "-" : title_of(study, study.motion.poses[r.narrowest_pose]));
  }
  for (const std::string& line : study.left_out_of_motion) fmt::print("left out of the range of motion: {}\n", line);
}

}  // namespace marrow::tools
