#include "cook/clip/compress/coded_track.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "unpack/clip/track_fit.h"

namespace marrow::cook {
namespace {

constexpr double kLargestInteger = 1e9;  // so that sums of two stay in 32 bits

}  // namespace

void fit(CodedTrack& track) {
  std::int32_t low[3], high[3];
  for (std::size_t c = 0; c < 3; ++c) {
    low[c] = high[c] = track.values[0][c];
    for (const std::array<std::int32_t, 3>& n : track.values) {
      low[c] = std::min(low[c], n[c]);
      high[c] = std::max(high[c], n[c]);
    }
  }
  TrackFit found;
  track.fits = fit_track(low, high, found);
  if (!track.fits) return;
  track.shift = found.shift;
  for (std::size_t c = 0; c < 3; ++c) {
    track.least[c] = found.least[c];
    track.width_codes[c] = found.width_codes[c];
  }
  track.frame_bits = found.bits;
}

int code_of_step(double step) {
  int code = 255;
  while (code > 0 && static_cast<double>(format::step_size(static_cast<std::uint32_t>(code))) > step) --code;
  return code;
}

CodedTrack quantise(const std::vector<glm::dvec3>& frames, int step_code) {
  CodedTrack track;
  track.step_code = step_code;
  const double inverse = 1 / static_cast<double>(format::step_size(static_cast<std::uint32_t>(step_code)));
  track.values.reserve(frames.size());
  for (const glm::dvec3& v : frames) {
    std::array<std::int32_t, 3> n{};
    for (std::size_t c = 0; c < 3; ++c) {
      const double exact = v[static_cast<int>(c)] * inverse;
      if (!(std::fabs(exact) < kLargestInteger)) return track;
      n[c] = static_cast<std::int32_t>(std::lround(exact));
    }
    track.values.push_back(n);
  }
  fit(track);
  return track;
}

CodedTrack part_of(const CodedTrack& track, std::size_t first_frame, std::size_t frame_count) {
  CodedTrack out;
  out.step_code = track.step_code;
  const auto begin = track.values.begin() + static_cast<std::ptrdiff_t>(first_frame);
  out.values.assign(begin, begin + static_cast<std::ptrdiff_t>(frame_count));
  fit(out);
  return out;
}

glm::dvec3 decode(const CodedTrack& track, std::size_t frame) {
  const double step = static_cast<double>(format::step_size(static_cast<std::uint32_t>(track.step_code)));
  const std::array<std::int32_t, 3>& n = track.values[frame];
  return step * glm::dvec3(n[0], n[1], n[2]);
}

glm::dvec3 to_rodrigues(const glm::dquat& q) {
  return glm::dvec3(q.x, q.y, q.z) / (1 + q.w);
}

glm::dquat from_rodrigues(const glm::dvec3& m) {
  const double squared = glm::dot(m, m), inverse = 1 / (1 + squared);
  return glm::dquat((1 - squared) * inverse, 2 * inverse * m.x, 2 * inverse * m.y, 2 * inverse * m.z);
}

}  // namespace marrow::cook
