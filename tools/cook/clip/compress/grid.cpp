#include "cook/clip/compress/grid.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "asset/format.h"
#include "cook/clip/compress/choose_steps.h"

namespace marrow::cook {
namespace {

constexpr double kGridSlack = 1e-3;      // of a frame
constexpr double kMostRounding = 0.125;  // of a frame
constexpr std::size_t kMostIntervals = 20000;
constexpr double kMostRefined = 8;     // frames between two keys of the shortest distance
constexpr std::size_t kMostEmpty = 2;  // even steps for a key
constexpr float kLeastStep = 1e-4f;    // seconds between uneven frames

// Without those that are others but for rounding.
std::vector<float> distinct(const std::set<float>& times) {
  std::vector<float> out = {*times.begin()};
  for (const float t : times) {
    if (t - out.back() >= kLeastStep) out.push_back(t);
  }
  if (out.size() > 1) out.back() = *times.rbegin();
  return out;
}

// The coarsest steps that every key falls on but for rounding, no two keys on one; nullopt if there are none.
std::optional<Grid> find_grid(const std::set<float>& times) {
  const double start = static_cast<double>(*times.begin()), length = static_cast<double>(*times.rbegin()) - start;
  const double rounding = rounding_at(*times.rbegin());
  double least = length;
  for (auto a = times.begin(), b = std::next(a); b != times.end(); ++a, ++b)
    if (const double gap = static_cast<double>(*b) - static_cast<double>(*a); gap > rounding)
      least = std::min(least, gap);
  const double fewest = std::max(1.0, std::ceil(length / (least + rounding)));
  const auto on_grid = [&](double intervals) {
    const double slack = std::max(kGridSlack, std::min(kMostRounding, rounding / length * intervals));
    double last_s = -1, last = -1;
    return std::all_of(times.begin(), times.end(), [&](float t) {
      const double time_s = static_cast<double>(t), at = (time_s - start) / length * intervals, near = std::round(at);
      const bool is_next = near > last || time_s - last_s <= rounding;
      last_s = time_s, last = near;
      return is_next && std::fabs(at - near) <= slack;
    });
  };
  const double most = std::min(kMostRefined * std::round(length / least), static_cast<double>(kMostIntervals));
  for (double n = fewest; n <= most; ++n)
    if (on_grid(n)) return Grid{*times.begin(), *times.rbegin(), static_cast<std::size_t>(n), {}};
  return std::nullopt;
}

bool has_cubic(const BuiltClip& clip) {
  return std::any_of(clip.tracks.begin(), clip.tracks.end(),
                     [](const Track& t) { return t.interpolation == Interpolation::cubic_spline; });
}

}  // namespace

std::set<float> key_times(const BuiltClip& clip) {
  std::set<float> times;
  for (const Track& track : clip.tracks) {
    const auto first = clip.times_s.begin() + track.first_time;
    if (!jumps(clip, track)) times.insert(first, first + track.key_count);
  }
  return times;
}

double Grid::exact_time_of(std::size_t moment) const {
  if (times_s.empty()) {
    const double start = static_cast<double>(start_s), length = static_cast<double>(end_s) - start;
    return start + length * static_cast<double>(moment) / static_cast<double>(intervals * kMoments);
  }
  const std::size_t frame = std::min(moment / kMoments, intervals - 1);
  const double from = static_cast<double>(times_s[frame]), to = static_cast<double>(times_s[frame + 1]);
  return from + (to - from) * static_cast<double>(moment - frame * kMoments) / static_cast<double>(kMoments);
}

std::vector<Grid> grids(const BuiltClip& clip) {
  const std::set<float> times = key_times(clip);
  std::vector<Grid> out;
  if (times.empty()) return out;
  if (times.size() == 1) return {{*times.begin(), *times.begin() + 1, 1, {}}};  // nothing moves
  const std::optional<Grid> own = find_grid(times);
  if (!has_cubic(clip)) {
    // Steps that are even cost no times, and frames of them that have no keys few bits.
    if (own && own->intervals <= times.size() * kMostEmpty) out.push_back(*own);
    std::vector<float> uneven = distinct(times);
    if (uneven.size() > 1) out.push_back({uneven.front(), uneven.back(), uneven.size() - 1, uneven});
    if (!out.empty()) return out;
  }
  const double length = static_cast<double>(*times.rbegin()) - static_cast<double>(*times.begin());
  const double coarsest = own ? static_cast<double>(own->intervals) : std::ceil(length * 30);
  for (const double finer : {1.0, 2.0, 4.0, 8.0})
    if (coarsest * finer <= static_cast<double>(kMostIntervals))
      out.push_back({*times.begin(), *times.rbegin(), static_cast<std::size_t>(coarsest * finer), {}});
  return out;
}

}  // namespace marrow::cook
