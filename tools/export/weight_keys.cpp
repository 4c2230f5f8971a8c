#include "export/weight_keys.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "marrow/morph.h"

namespace marrow::tools {
namespace {

struct Point {
  double in = 0, value = 0, out = 0;  // slopes a second before and behind
};

class Curve {
 public:
  Curve(const Clip& clip, const Channel& channel)
      : times_(clip.times_s + channel.first_time),
        values_(clip.values + channel.first_value),
        count_(channel.key_count),
        interpolation_(channel.interpolation) {}

  bool moves() const { return count_ > 1; }
  Interpolation interpolation() const { return interpolation_; }

  void add_times(bool jumps, std::set<float>& to) const {
    to.insert(times_, times_ + count_);
    for (std::size_t i = 1; jumps && interpolation_ == Interpolation::step && i < count_; ++i)
      to.insert(std::nextafter(times_[i], -std::numeric_limits<float>::infinity()));
  }

  Point at(float time_s) const {
    const auto next = static_cast<std::size_t>(std::upper_bound(times_, times_ + count_, time_s) - times_);
    if (next == 0) return {0, value(0), 0};
    const std::size_t key = next - 1;
    Point out{0, value(key), 0};
    if (times_[key] == time_s) {
      if (key > 0) out.in = piece(key - 1, time_s).in;
      if (next < count_) out.out = piece(key, time_s).out;
      return out;
    }
    return next == count_ ? out : piece(key, time_s);
  }

 private:
  double value(std::size_t key) const { return part(key, 1); }
  double part(std::size_t key, std::size_t which) const {
    return static_cast<double>(interpolation_ == Interpolation::cubic_spline ? values_[3 * key + which] : values_[key]);
  }

  // Of the curve from `key` to the next. Splines: glTF 2.0, appendix C.5, and its derivative.
  Point piece(std::size_t key, float time_s) const {
    const double a = static_cast<double>(times_[key]), run = static_cast<double>(times_[key + 1]) - a;
    const double t = (static_cast<double>(time_s) - a) / run, p = value(key), q = value(key + 1);
    if (interpolation_ == Interpolation::step) return {0, p, 0};
    if (interpolation_ == Interpolation::linear) return {(q - p) / run, p + t * (q - p), (q - p) / run};
    const double m = run * part(key, 2), n = run * part(key + 1, 0);
    const double x = (2 * t - 3) * t * t + 1, y = ((t - 2) * t + 1) * t, z = (3 - 2 * t) * t * t, w = (t - 1) * t * t;
    const double slope = (6 * t * (t - 1) * (p - q) + ((3 * t - 4) * t + 1) * m + (3 * t - 2) * t * n) / run;
    return {slope, x * p + y * m + z * q + w * n, slope};
  }

  const float* times_;
  const float* values_;
  std::size_t count_;
  Interpolation interpolation_;
};

// What all curves that move can be written as.
Interpolation common(const std::vector<Curve>& curves) {
  bool steps = true, splines = false;
  for (const Curve& curve : curves) {
    if (!curve.moves()) continue;
    steps = steps && curve.interpolation() == Interpolation::step;
    splines = splines || curve.interpolation() == Interpolation::cubic_spline;
  }
  return splines ? Interpolation::cubic_spline : steps ? Interpolation::step : Interpolation::linear;
}

}  // namespace

WeightKeys weight_keys(const Clip& clip, const std::vector<std::uint32_t>& channels,
                       const std::vector<float>& weights) {
  std::vector<Curve> curves;
  for (const std::uint32_t channel : channels)
    if (channel != kNoChannel) curves.emplace_back(clip, clip.channels[channel]);
  const bool any_moves = std::any_of(curves.begin(), curves.end(), [](const Curve& c) { return c.moves(); });
  WeightKeys keys{common(curves), {}, {}};
  std::set<float> times;
  for (const Curve& curve : curves)
    if (curve.moves() || !any_moves) curve.add_times(keys.interpolation != Interpolation::step, times);
  keys.times_s.assign(times.begin(), times.end());
  for (const float time_s : times) {
    std::vector<float> in, values, out;
    for (std::size_t t = 0, curve = 0; t < channels.size(); ++t) {
      const Point p =
          channels[t] == kNoChannel ? Point{0, static_cast<double>(weights[t]), 0} : curves[curve++].at(time_s);
      in.push_back(static_cast<float>(p.in));
      values.push_back(static_cast<float>(p.value));
      out.push_back(static_cast<float>(p.out));
    }
    const bool spline = keys.interpolation == Interpolation::cubic_spline;
    if (spline) keys.values.insert(keys.values.end(), in.begin(), in.end());
    keys.values.insert(keys.values.end(), values.begin(), values.end());
    if (spline) keys.values.insert(keys.values.end(), out.begin(), out.end());
  }
  return keys;
}

}  // namespace marrow::tools
