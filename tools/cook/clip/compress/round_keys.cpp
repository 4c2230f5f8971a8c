#include "cook/clip/compress/round_keys.h"

#include <algorithm>
#include <cmath>

namespace marrow::cook {
namespace {

// By how much each number of a track may be off. least: promised of what hangs on its joint.
double slack_of(const Track& track, const Rig& rig, const Promise& promise, double least) {
  // A quaternion's numbers are halves of an angle.
  const double lever = track.path == TrackPath::translation ? rig.scale_above[track.joint]
                       : track.path == TrackPath::rotation  ? 2 * reach_below(track.joint, rig, promise)
                                                            : reach_below(track.joint, rig, promise);
  return least / (std::sqrt(3.0) * std::max(lever, 1e-30));
}

}  // namespace

float rounded_within(double slack, float value) {
  constexpr int kFinest = -100, kCoarsest = 80;
  int exponent = 0;
  std::frexp(2 * slack, &exponent);  // the power of two is at most that much
  if (!(slack > 0) || exponent < kFinest) return value;
  const double step = std::ldexp(0.5, std::min(exponent, kCoarsest));
  const double steps = std::round(static_cast<double>(value) / step);
  return static_cast<float>(steps * step) + 0.0f;  // no -0
}

// Twice the largest of t³ − 2 t² + t, as both ends have one.
double tangent_lever(std::span<const float> times_s) {
  double longest_s = 0;
  for (std::size_t k = 1; k < times_s.size(); ++k)
    longest_s = std::max(longest_s, static_cast<double>(times_s[k]) - static_cast<double>(times_s[k - 1]));
  return longest_s * 8 / 27;
}

BuiltClip with_rounded_keys(const BuiltClip& clip, const Rig& rig, const Promise& promise, double share) {
  BuiltClip out = clip;
  const std::vector<double> least = rig.least_below(promise.error);
  for (const Track& track : clip.tracks) {
    const bool is_spline = track.interpolation == Interpolation::cubic_spline;
    if (track.path == TrackPath::rotation && !is_spline) continue;
    const double slack = share * slack_of(track, rig, promise, least[track.joint]);
    const double lever = tangent_lever({clip.times_s.data() + track.first_time, track.key_count});
    const std::uint32_t width = track.path == TrackPath::rotation ? 4 : 3;
    const std::uint32_t count = track.key_count * format::floats_per_key(track.path, track.interpolation);
    for (std::uint32_t i = 0; i < count; ++i) {
      float& value = out.values[track.first_value + i];
      const bool is_tangent = is_spline && i / width % 3 != 1;
      value = rounded_within(is_tangent && lever > 0 ? slack / lever : slack, value);
    }
  }
  return out;
}

}  // namespace marrow::cook
