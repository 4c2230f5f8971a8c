#include "commands/compare/motion/frames_study.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/check_status.h"
#include "common/parallel.h"
#include "cook/scene/views.h"
#include "deform/deformers.h"
#include "deform/motion/between_frames.h"
#include "marrow/sample.h"

namespace marrow::tools {
namespace {

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
