#include "cook/clip/measure/clip_measure.h"

#include <algorithm>
#include <cmath>

#include "common/check_status.h"
#include "marrow/blend.h"
#include "marrow/sample.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kMostSkinned = 15'000'000;  // vertices that one measurement skins, if it need not more
constexpr double kNearest = 0.1;                  // of what is between two moments

// Looks at moments, and keeps the worst that it has seen.
class Look {
 public:
  Look(const BuiltClip& source, const BuiltClip& channels, const BuiltSkeleton& skeleton, const Rig& rig,
       const Hung& hung, const SourceCurves& curves, const BuiltClip& out, const Promise& promise)
      : source_clip_(source),
        skeleton_(skeleton),
        rig_(rig),
        curves_(curves),
        promise_(promise),
        clip_(view(out, view(skeleton))),
        local_(skeleton.rest.size()),
        source_(rig.size()),
        decoded_(rig.size()),
        vertices_(hung, channels) {}

  // How far the joints stray at a moment, as a share of the promise.
  double joints(float at_s);
  // The vertices, in units of the scene, where joints() has looked.
  double vertices(float at_s);
  const ClipError& worst() const { return worst_; }

 private:
  void pose(float time_s);

  const BuiltClip& source_clip_;
  const BuiltSkeleton& skeleton_;
  const Rig& rig_;
  const SourceCurves& curves_;
  const Promise& promise_;
  Clip clip_;
  std::vector<SoaTransform> local_;
  std::vector<World> source_, decoded_;
  VertexErrors vertices_;
  ClipError worst_;
};

// As a game plays it: an additive clip's change is added to the pose that it was taken from.
void Look::pose(float time_s) {
  const Skeleton skeleton = view(skeleton_);
  tools::check(sample(skeleton, clip_, time_s, local_));
  if (source_clip_.additive.empty()) return;
  const std::vector<SoaTransform>& reference = source_clip_.reference.empty() ? skeleton_.rest : source_clip_.reference;
  std::vector<AdditiveTransform> change(local_.size());
  tools::check(make_additive(skeleton, local_, reference, change));
  local_ = reference;
  tools::check(add(skeleton, {change}, local_));
}

double Look::joints(float at_s) {
  pose(at_s);
  BuiltSkeleton posed;
  posed.rest = local_;
  posed.parents = skeleton_.parents;
  const std::vector<Transform> transforms = rest_transforms(posed);
  double most = 0;
  for (std::size_t j = 0; j < rig_.size(); ++j) {
    const bool root = rig_.parents[j] == kNone;
    const auto up = static_cast<std::size_t>(rig_.parents[j]);
    const auto time_s = static_cast<double>(at_s);
    source_[j] = rig_.place(j, root ? nullptr : &source_[up], curves_.at(j, time_s));
    decoded_[j] = rig_.place(j, root ? nullptr : &decoded_[up], transforms[j]);
    const double error = shell_error(source_[j], decoded_[j], promise_.shell);
    const double share = error / promise_.error[j];
    if (!(share <= most)) most = share;
    if (!(share <= worst_.share)) worst_.share = share;
    if (error <= worst_.error_m) continue;
    worst_.error_m = error;
    worst_.joint = j;
    worst_.time_s = time_s;
  }
  return most;
}

double Look::vertices(float at_s) {
  const VertexError here = vertices_.at(source_, decoded_, at_s);
  worst_.vertex_error_m = std::max(worst_.vertex_error_m, here.error_m);
  worst_.vertex_share = std::max(worst_.vertex_share, here.share);
  return here.error_m;
}

// Goes from a moment to where `look` gives more, by ever smaller steps. Moments are counted in halves and quarters,
// too.
template <class Visit>
void climb(const std::vector<float>& moments, std::size_t from, double most, std::size_t stride, Visit look) {
  const auto last = static_cast<double>(moments.size() - 1);
  const auto time_of = [&](double moment) {
    const auto before = static_cast<std::size_t>(moment), after = std::min(before + 1, moments.size() - 1);
    const double a = static_cast<double>(moments[before]), b = static_cast<double>(moments[after]);
    return static_cast<float>(a + (b - a) * (moment - static_cast<double>(before)));
  };
  auto best = static_cast<double>(from);
  double step = static_cast<double>(stride);
  while (step > kNearest) {
    step /= 2;
    if (step > 1) step = std::floor(step);
    const double middle = best;
    for (const double moment : {middle - step, middle + step}) {
      if (moment < 0 || moment > last) continue;
      const double here = look(time_of(moment));
      if (here <= most) continue;
      most = here;
      best = moment;
    }
  }
}

bool jumps_somewhere(const BuiltClip& channels, const Channel& channel) {
  if (channel.interpolation == Interpolation::step) return true;
  const float* const times = channels.times_s.data() + channel.first_time;
  return std::adjacent_find(times, times + channel.key_count) != times + channel.key_count;
}

}  // namespace

ClipMeasure::ClipMeasure(const BuiltClip& clip, const BuiltClip& channels, const BuiltSkeleton& skeleton,
                         const Rig& rig, const Hung& hung)
    : clip_(clip), channels_(channels), skeleton_(skeleton), rig_(rig), hung_(hung), curves_(clip, skeleton) {}

std::vector<float> ClipMeasure::moments(const std::vector<float>& of_grid) const {
  std::vector<float> out = of_grid;
  const auto add = [&](float key_s, bool both_sides) {
    const auto end = of_grid.end(), after = std::lower_bound(of_grid.begin(), end, key_s);
    const float near = key_s * 0x1p-22f;
    const bool is_there =
        (after != end && *after - key_s <= near) || (after != of_grid.begin() && key_s - after[-1] <= near);
    if (both_sides) out.push_back(just_before(key_s));
    if (both_sides || !is_there) out.push_back(key_s);
  };
  for (const Track& track : clip_.tracks) {
    const bool both_sides = jumps(clip_, track);
    for (std::uint32_t k = 0; k < track.key_count; ++k) add(clip_.times_s[track.first_time + k], both_sides);
  }
  for (const Channel& channel : channels_.channels) {
    const bool both_sides = jumps_somewhere(channels_, channel);
    for (std::uint32_t k = 0; k < channel.key_count && hung_.is_weighed; ++k)
      add(channels_.times_s[channel.first_time + k], both_sides);
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

ClipError ClipMeasure::measure(const BuiltClip& out, const std::vector<float>& moments, const Promise& promise) const {
  const std::size_t stride = 1 + hung_.slots * moments.size() / kMostSkinned;
  Look look(clip_, channels_, skeleton_, rig_, hung_, curves_, out, promise);
  struct Worst {
    double error = 0;
    std::size_t moment = 0;
  } joints, vertices;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const double share = look.joints(moments[i]);
    if (share > joints.error) joints = {share, i};
    if (i % stride != 0 || !(look.worst().share <= 1)) continue;
    const double error = look.vertices(moments[i]);
    if (error > vertices.error) vertices = {error, i};
  }
  climb(moments, joints.moment, joints.error, 1, [&](float time_s) { return look.joints(time_s); });
  if (!(look.worst().share <= 1)) return look.worst();
  climb(moments, vertices.moment, vertices.error, stride, [&](float time_s) {
    look.joints(time_s);
    return look.vertices(time_s);
  });
  return look.worst();
}

}  // namespace marrow::cook
