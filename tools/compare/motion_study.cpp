#include "compare/motion_study.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "common/check_status.h"
#include "common/parallel.h"
#include "cook/scene/views.h"
#include "deform/deformers.h"
#include "deform/motion/between_frames.h"
#include "marrow/sample.h"

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

using deform::BetweenFrames;
using Local = std::vector<SoaTransform>;

constexpr std::size_t kKinds = std::size(deform::kBetweenFrames);
constexpr std::size_t kMostIntervals = 500;  // of a clip that are looked at
constexpr int kParts = 4;                    // of an interval

// Two frames of a clip, by the number of the first.
struct Interval {
  std::uint32_t clip;
  std::size_t number, count;
};

std::vector<Interval> intervals(const Study& study, double hz, std::size_t& frames) {
  std::vector<Interval> out;
  for (std::uint32_t c = 0; c < study.built.clips.size(); ++c) {
    const cook::BuiltClip& clip = study.built.clips[c];
    if (clip.skeleton != study.source.skeleton || clip.tracks.empty() || !(clip.duration_s > 0)) continue;
    const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(double{clip.duration_s} * hz - 1e-6)));
    const std::size_t looked_at = std::min(count, kMostIntervals);
    for (std::size_t i = 0; i < looked_at; ++i) out.push_back({c, i * count / looked_at, count});
    frames += count + 1;
  }
  return out;
}

struct Distance {
  double squares = 0, most = 0;
};

// How far each kind is off in an interval.
class Looker {
 public:
  explicit Looker(const Study& study)
      : study_(study),
        built_(study.built.skeletons[study.source.skeleton]),
        skeleton_(view(built_)),
        ssd_(deform::ssd(study.source.mesh)) {}

  std::array<Distance, kKinds> look(const Interval& interval) const {
    const cook::BuiltClip& of = study_.built.clips[interval.clip];
    const Clip clip = view(of, skeleton_);
    const double step_s = double{of.duration_s} / static_cast<double>(interval.count);
    const auto pose_at = [&](double frame) {
      Local out(skeleton_.soa_size());
      check(sample(skeleton_, clip, static_cast<float>(frame * step_s), out));
      return out;
    };
    const std::size_t first = interval.number - std::min<std::size_t>(1, interval.number);
    std::vector<Local> frames;
    for (std::size_t f = first; f <= std::min(interval.number + 2, interval.count); ++f)
      frames.push_back(pose_at(static_cast<double>(f)));
    std::array<Distance, kKinds> out;
    for (int part = 1; part < kParts; ++part) {
      const double at = static_cast<double>(interval.number) + static_cast<double>(part) / kParts;
      const deform::Positions wanted = vertices(pose_at(at));
      for (std::size_t k = 0; k < kKinds; ++k)
        add(vertices(deform::between_poses(deform::kBetweenFrames[k].value, frames, at - static_cast<double>(first))),
            wanted, out[k]);
    }
    return out;
  }

 private:
  deform::Positions vertices(const Local& local) const {
    deform::Positions out;
    ssd_(cook::deform_pose(study_.source, built_, local), out);
    return out;
  }

  static void add(const deform::Positions& got, const deform::Positions& wanted, Distance& to) {
    for (std::size_t v = 0; v < got.size(); ++v) {
      const double d = glm::length(got[v] - wanted[v]);
      to.squares += d * d;
      to.most = std::max(to.most, d);
    }
  }

  const Study& study_;
  const cook::BuiltSkeleton& built_;
  Skeleton skeleton_;
  deform::Deformer ssd_;
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

std::vector<FramesRow> study_frames(const Study& study, const std::vector<double>& rates_hz) {
  std::vector<FramesRow> out;
  if (rates_hz.empty() || study.built.clips.empty()) return out;
  const Looker looker(study);
  for (const double hz : rates_hz) {
    std::size_t frames = 0;
    const std::vector<Interval> of = intervals(study, hz, frames);
    if (of.empty()) return {};
    std::vector<std::array<Distance, kKinds>> distances(of.size());
    for_each_in_parallel(of.size(), [&](std::size_t i) { distances[i] = looker.look(of[i]); });
    const double count = static_cast<double>(of.size() * study.source.mesh.positions.size()) * (kParts - 1);
    for (std::size_t k = 0; k < kKinds; ++k) {
      FramesRow row{hz, deform::kBetweenFrames[k].value, frames};
      for (const auto& d : distances) {
        row.rms += d[k].squares / count;
        row.most = std::max(row.most, d[k].most);
      }
      row.rms = std::sqrt(row.rms);
      out.push_back(row);
    }
  }
  return out;
}

}  // namespace marrow::tools
