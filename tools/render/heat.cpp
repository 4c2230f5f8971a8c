#include "render/heat.h"

#include <algorithm>
#include <cmath>

namespace marrow::tools {
namespace {

// sRGB, CIE lightness about 32, 40, 50, 62, 75, 92.
constexpr float kRamp[][3] = {{72, 78, 92},   {112, 76, 138}, {186, 76, 120},
                              {232, 112, 76}, {242, 170, 68}, {250, 236, 150}};
constexpr int kRampSteps = 5;

float to_linear(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

// sRGB, 0 … 255.
void ramp(float t, float out[3]) {
  const float at = std::clamp(t, 0.0f, 1.0f) * kRampSteps;
  const int step = std::min(static_cast<int>(at), kRampSteps - 1);
  const float f = at - static_cast<float>(step);
  for (int c = 0; c < 3; ++c) out[c] = kRamp[step][c] * (1 - f) + kRamp[step + 1][c] * f;
}

float distance(const PosedMesh& a, const PosedMesh& b, std::size_t slot) {
  float sum = 0;
  for (std::size_t c = 3 * slot; c < 3 * slot + 3; ++c) {
    const float d = a.positions[c] - b.positions[c];
    sum += d * d;
  }
  return std::sqrt(sum);
}

}  // namespace

Rgb heat_colour(float t) {
  float srgb[3];
  ramp(t, srgb);
  Rgb out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(std::lround(srgb[c]));
  return out;
}

float largest_distance(const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b) {
  float largest = 0;
  for (std::size_t mesh = 0; mesh < a.size(); ++mesh) {
    for (std::size_t slot = 0; 3 * slot < a[mesh].positions.size(); ++slot) {
      largest = std::max(largest, distance(a[mesh], b[mesh], slot));
    }
  }
  return largest;
}

float sensible_scale(float largest, float diagonal) {
  return std::max({largest, 1e-3f * diagonal, 1e-30f});
}

HeatMap compare(const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b, float full_scale) {
  HeatMap map;
  map.full_scale = full_scale;
  map.largest = largest_distance(a, b);
  for (std::size_t mesh = 0; mesh < a.size(); ++mesh) {
    std::vector<float>& colours = map.colours.emplace_back();
    for (std::size_t slot = 0; 3 * slot < a[mesh].positions.size(); ++slot) {
      float srgb[3];
      ramp(distance(a[mesh], b[mesh], slot) / full_scale, srgb);
      for (const float value : srgb) colours.push_back(to_linear(value / 255));
      colours.push_back(1);
    }
  }
  return map;
}

}  // namespace marrow::tools
