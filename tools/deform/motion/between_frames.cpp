#include "deform/motion/between_frames.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "deform/rotations.h"

namespace marrow::deform {
namespace {

// Which frames count, and how much.
struct Taps {
  std::size_t count = 0;
  std::array<std::size_t, 4> frame{};
  std::array<double, 4> weight{};

  void add(std::size_t f, double w) {
    frame[count] = f;
    weight[count++] = w;
  }
};

// Of the parabola through the values at 0, 1 and 2.
std::array<double, 3> parabola(double x) {
  return {(1 - x) * (2 - x) / 2, x * (2 - x), x * (x - 1) / 2};
}

// The frame at or before `at` that has another behind it, and how far from it to the next.
std::pair<std::size_t, double> interval(std::size_t count, double at) {
  const double last = static_cast<double>(count) - 2;
  const double from = std::clamp(std::floor(at), 0.0, std::max(0.0, last));
  return {static_cast<std::size_t>(from), std::clamp(at - from, 0.0, 1.0)};
}

Taps taps(BetweenFrames kind, std::size_t count, double at) {
  Taps out;
  const auto [i, u] = interval(count, at);
  if (count == 1) {
    out.add(0, 1);
  } else if (kind == BetweenFrames::linear || count == 2) {
    out.add(i, 1 - u);
    out.add(i + 1, u);
  } else {
    const bool has_before = i > 0, has_after = i + 2 < count;
    // How much the parabola counts that begins with i, rather than with the frame before it.
    const double later = !has_before ? 1 : !has_after || kind == BetweenFrames::quadratic ? 0 : u;
    const std::array<double, 3> p = parabola(1 + u), q = parabola(u);
    if (has_before) out.add(i - 1, (1 - later) * p[0]);
    out.add(i, (1 - later) * p[1] + later * q[0]);
    out.add(i + 1, (1 - later) * p[2] + later * q[1]);
    if (has_after) out.add(i + 2, later * q[2]);
  }
  return out;
}

}  // namespace

glm::dvec3 between_frames(BetweenFrames kind, const std::vector<glm::dvec3>& frames, double at) {
  const Taps t = taps(kind, frames.size(), at);
  glm::dvec3 sum(0);
  for (std::size_t k = 0; k < t.count; ++k) sum += frames[t.frame[k]] * t.weight[k];
  return sum;
}

glm::dquat between_frames(BetweenFrames kind, const std::vector<glm::dquat>& frames, double at) {
  const auto [i, u] = interval(frames.size(), at);
  if (kind == BetweenFrames::linear && frames.size() > 1) return slerp(frames[i], frames[i + 1], u);
  const Taps t = taps(kind, frames.size(), at);
  glm::dquat sum(0, 0, 0, 0);
  for (std::size_t k = 0; k < t.count; ++k) {
    const glm::dquat& q = frames[t.frame[k]];
    sum = sum + q * (glm::dot(q, frames[i]) < 0 ? -t.weight[k] : t.weight[k]);
  }
  const double length = std::sqrt(glm::dot(sum, sum));
  return length > 0 ? sum / length : frames[i];
}

namespace {

// Of one joint, from a row of poses.
glm::dvec3 three(const float (&lanes)[3][4], std::size_t lane) {
  return {lanes[0][lane], lanes[1][lane], lanes[2][lane]};
}

void put(const glm::dvec3& v, std::size_t lane, float (&lanes)[3][4]) {
  for (int i = 0; i < 3; ++i) lanes[i][lane] = static_cast<float>(v[i]);
}

}  // namespace

std::vector<SoaTransform> between_poses(BetweenFrames kind, const std::vector<std::vector<SoaTransform>>& frames,
                                        double at) {
  std::vector<SoaTransform> out = frames.front();
  for (std::size_t j = 0; j < 4 * out.size(); ++j) {
    std::vector<glm::dvec3> translations, scales;
    std::vector<glm::dquat> rotations;
    for (const std::vector<SoaTransform>& frame : frames) {
      const SoaTransform& t = frame[j / 4];
      translations.push_back(three(t.translation, j % 4));
      scales.push_back(three(t.scale, j % 4));
      rotations.emplace_back(t.rotation[3][j % 4], t.rotation[0][j % 4], t.rotation[1][j % 4], t.rotation[2][j % 4]);
    }
    SoaTransform& to = out[j / 4];
    put(between_frames(kind, translations, at), j % 4, to.translation);
    put(between_frames(kind, scales, at), j % 4, to.scale);
    const glm::dquat q = between_frames(kind, rotations, at);
    const double parts[] = {q.x, q.y, q.z, q.w};
    for (int i = 0; i < 4; ++i) to.rotation[i][j % 4] = static_cast<float>(parts[i]);
  }
  return out;
}

}  // namespace marrow::deform
