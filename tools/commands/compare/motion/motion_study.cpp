#include "commands/compare/motion/motion_study.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

namespace marrow::tools {
namespace {

// The sums of a row.
struct Tally {
  MotionRow row;
  double squares = 0, ssd_squares = 0;
  std::size_t flipped = 0, poses = 0;

  void add(std::size_t number, const deform::MotionPose& pose, const deform::MotionErrors& errors, std::size_t which) {
    const deform::MotionFigures& f = errors.of[which];
    if (pose.kind == deform::MotionKind::twist) add_rings(number, f);
    flipped += f.flipped;
    ++poses;
    if (errors.truth_flipped > 0) {
      row.worse_folding += f.is_worse;
      return;
    }
    row.worse += f.is_worse;
    squares += f.rms * f.rms;
    ssd_squares += errors.ssd_rms * errors.ssd_rms;
    if (errors.ssd_rms > 0 && !(f.rms / errors.ssd_rms <= row.worst_of_ssd)) {
      row.worst_of_ssd = f.rms / errors.ssd_rms;
      row.worst_pose = number;
    }
    row.flipped = std::max(row.flipped, f.flipped);
    const auto is_farther = [](double a, double b) { return std::abs(a - 1) > std::abs(b - 1); };
    if (f.volume_over_truth && is_farther(*f.volume_over_truth, row.volume_over_truth.value_or(1)))
      row.volume_over_truth = f.volume_over_truth;
  }

  MotionRow result() {
    if (poses > 0) row.mean_flipped = static_cast<double>(flipped) / static_cast<double>(poses);
    row.of_ssd = ssd_squares > 0 ? std::sqrt(squares / ssd_squares) : 1;
    return row;
  }

 private:
  void add_rings(std::size_t number, const deform::MotionFigures& f) {
    if (f.ring_over_bind) row.ring_over_bind = std::min(*f.ring_over_bind, row.ring_over_bind.value_or(1e300));
    if (!f.ring_over_truth || (row.ring_over_truth && !(*f.ring_over_truth < *row.ring_over_truth))) return;
    row.ring_over_truth = f.ring_over_truth;
    row.narrowest_pose = number;
  }
};

}  // namespace

MotionStudy study_motion(const Study& study, const DeformerComparison& comparison, const deform::Deformer& truth) {
  const std::vector<deform::MotionPose>& poses = study.motion.poses;
  std::vector<deform::Deformer> deformers;
  for (const Trained& trained : comparison.trained_in_first_round) deformers.push_back(trained.deform);
  MotionStudy out;
  out.errors = deform::motion_errors(study.source.mesh, poses, truth, deformers);
  std::vector<Tally> all(deformers.size());
  std::vector<std::vector<Tally>> of_joint;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const deform::MotionErrors& errors = out.errors[i];
    if (!errors.is_usable) continue;
    if (out.joints.empty() || out.joints.back().joint != poses[i].joint) {
      out.joints.emplace_back().joint = poses[i].joint;
      of_joint.emplace_back(deformers.size());
    }
    const bool folds = errors.truth_flipped > 0;
    ++(folds ? out.joints.back().folding : out.joints.back().poses);
    if (folds) out.folding.push_back(i);
    out.poses += !folds;
    if (poses[i].kind == deform::MotionKind::twist && errors.truth_ring_over_bind)
      out.truth_ring = std::min(*errors.truth_ring_over_bind, out.truth_ring.value_or(*errors.truth_ring_over_bind));
    for (std::size_t d = 0; d < deformers.size(); ++d) {
      all[d].add(i, poses[i], errors, d);
      of_joint.back()[d].add(i, poses[i], errors, d);
    }
  }
  if (out.joints.empty()) return out;
  for (Tally& tally : all) out.of.push_back(tally.result());
  for (std::size_t j = 0; j < out.joints.size(); ++j)
    for (Tally& tally : of_joint[j]) out.joints[j].of.push_back(tally.result());
  return out;
}

std::string title_of(const Study& study, const deform::MotionPose& pose) {
  return fmt::format("{}, {} by {:.0f}°", study.joint_names[pose.joint], deform::name_of(pose.kind),
                     glm::degrees(pose.angle_rad));
}

std::string summary(const DeformerComparison& comparison, const MotionStudy& motion) {
  if (motion.poses == 0) return "";
  std::string out;
  for (std::size_t d = 0; d < motion.of.size(); ++d) {
    const std::string& name = comparison.rows[d].deformer;
    if (name == "ssd" || name == "as_lift" || is_before_ssd(name)) continue;
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", name, motion.of[d].worse);
  }
  return fmt::format("Poses of the range of motion worse than linear blend skinning, of {}: {}.", motion.poses, out);
}

}  // namespace marrow::tools
