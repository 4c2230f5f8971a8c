#include "cook/clip/compress/grid.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "asset/format.h"
#include "cook/clip/compress/choose_steps.h"

namespace marrow::cook {
namespace {

constexpr double kGridSlack = 1e-3;  // of a frame
constexpr std::size_t kMostIntervals = 20000;
constexpr double kMostRefined = 8;     // frames between two keys of the shortest distance
constexpr std::size_t kMostEmpty = 2;  // even steps for a key
constexpr float kLeastStep = 1e-4f;    // seconds between uneven frames

// The times of the keys that are to be coded.
std::set<float> key_times(const BuiltClip& clip) {
  std::set<float> times;
  for (const Track& track : clip.tracks) {
    const auto first = clip.times_s.begin() + track.first_time;
    if (!jumps(clip, track)) times.insert(first, first + track.key_count);
  }
  return times;
}

// Without those that are others but for rounding.
std::vector<float> distinct(const std::set<float>& times) {
  std::vector<float> out = {*times.begin()};
  for (const float t : times) {
    if (t - out.back() >= kLeastStep) out.push_back(t);
  }
  if (out.size() > 1) out.back() = *times.rbegin();
  return out;
}

// The coarsest steps that every key falls on; nullopt if there are none.
std::optional<Grid> find_grid(const std::set<float>& times) {
  const double start = static_cast<double>(*times.begin()), length = static_cast<double>(*times.rbegin()) - start;
  double least = length;
  for (auto a = times.begin(), b = std::next(a); b != times.end(); ++a, ++b)
    least = std::min(least, static_cast<double>(*b) - static_cast<double>(*a));
  const double fewest = std::round(length / least);
  const auto on_grid = [&](double intervals) {
    return std::all_of(times.begin(), times.end(), [&](float t) {
      const double at = (static_cast<double>(t) - start) / length * intervals;
      return std::fabs(at - std::round(at)) <= kGridSlack;
    });
  };
  for (double n = fewest; n <= std::min(kMostRefined * fewest, static_cast<double>(kMostIntervals)); ++n)
    if (on_grid(n)) return Grid{*times.begin(), *times.rbegin(), static_cast<std::size_t>(n), {}};
  return std::nullopt;
}

bool has_cubic(const BuiltClip& clip) {
  return std::any_of(clip.tracks.begin(), clip.tracks.end(),
                     [](const Track& t) { return t.interpolation == Interpolation::cubic_spline; });
}

}  // namespace

// A STEP track that changes cannot be blended between frames. Exporters write STEP for what is constant but for the
// rounding of floats.
bool jumps(const BuiltClip& clip, const Track& track) {
  constexpr float kRounding = 1e-6f;
  if (track.interpolation != Interpolation::step) return false;
  const std::size_t width = format::floats_per_key(track.path, track.interpolation);
  const float* const first = clip.values.data() + track.first_value;
  float largest = track.path == TrackPath::translation ? 0.0f : 1.0f;
  for (std::size_t i = 0; i < width; ++i) largest = std::max(largest, std::fabs(first[i]));
  for (std::size_t i = width; i < track.key_count * width; ++i)
    if (!(std::fabs(first[i] - first[i % width]) <= kRounding * largest)) return true;
  return false;
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
    if (own && own->intervals <= times.size() * kMostEmpty) return {*own};
    std::vector<float> uneven = distinct(times);
    if (uneven.size() > 1) return {{uneven.front(), uneven.back(), uneven.size() - 1, uneven}};
  }
  const double length = static_cast<double>(*times.rbegin()) - static_cast<double>(*times.begin());
  const double coarsest = own ? static_cast<double>(own->intervals) : std::ceil(length * 30);
  for (const double finer : {1.0, 2.0, 4.0, 8.0})
    if (coarsest * finer <= static_cast<double>(kMostIntervals))
      out.push_back({*times.begin(), *times.rbegin(), static_cast<std::size_t>(coarsest * finer), {}});
  return out;
}

}  // namespace marrow::cook
