#include "cook/clip/compress/coded_track.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>

#include "asset/format.h"

namespace marrow::cook {
namespace {

constexpr double kLargestInteger = 1e9;  // so that sums of two stay in 32 bits

std::uint32_t width_code(std::uint32_t range) {
  const auto bits = static_cast<std::uint32_t>(std::bit_width(range));
  return bits <= 14 ? bits : bits <= 19 ? 15 : 16;
}

}  // namespace

int code_of_step(double step) {
  int code = 255;
  while (code > 0 && static_cast<double>(format::step_size(static_cast<std::uint32_t>(code))) > step) --code;
  return code;
}

CodedTrack quantise(const std::vector<glm::dvec3>& frames, int step_code) {
  CodedTrack track;
  track.step_code = step_code;
  const double inverse = 1 / static_cast<double>(format::step_size(static_cast<std::uint32_t>(step_code)));
  std::array<std::int32_t, 3> low{}, high{};
  track.values.reserve(frames.size());
  for (const glm::dvec3& v : frames) {
    std::array<std::int32_t, 3> n{};
    for (std::size_t c = 0; c < 3; ++c) {
      const double exact = v[static_cast<int>(c)] * inverse;
      if (!(std::fabs(exact) < kLargestInteger)) return track;
      n[c] = static_cast<std::int32_t>(std::lround(exact));
      low[c] = track.values.empty() ? n[c] : std::min(low[c], n[c]);
      high[c] = track.values.empty() ? n[c] : std::max(high[c], n[c]);
    }
    track.values.push_back(n);
  }
  const auto fits16 = [&](std::int32_t n) { return n >> track.shift >= -32768 && n >> track.shift <= 32767; };
  while (!std::all_of(low.begin(), low.end(), fits16)) ++track.shift;
  if (track.shift > 15) return track;
  track.fits = true;
  for (std::size_t c = 0; c < 3; ++c) {
    track.least[c] = low[c] >> track.shift;
    const std::int64_t range = std::int64_t{high[c]} - std::int64_t{track.least[c]} * (std::int64_t{1} << track.shift);
    track.width_codes[c] = range < (1 << 19) ? width_code(static_cast<std::uint32_t>(range)) : 16;
    if (track.width_codes[c] > 15) track.fits = false;
    track.frame_bits += format::component_bits(track.width_codes[c]);
  }
  return track;
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
