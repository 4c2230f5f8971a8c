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

void add_colour(float t, std::vector<float>& colours) {
  float srgb[3];
  ramp(t, srgb);
  for (const float value : srgb) colours.push_back(to_linear(value / 255));
  colours.push_back(1);
}

// How much of a palette entry is the joint's.
float share_of(const Mesh& mesh, std::uint32_t entry, std::uint32_t joint) {
  const auto is_joint = [&](std::uint32_t e) { return mesh.joints[e] == joint ? 1.0f : 0.0f; };
  if (entry < mesh.joint_count) return is_joint(entry);
  const Helper& helper = mesh.helpers[entry - mesh.joint_count];
  return helper.share * is_joint(helper.second) + (1 - helper.share) * is_joint(helper.first);
}

}  // namespace

std::vector<float> joint_weights(const Mesh& mesh, std::uint32_t joint) {
  std::vector<float> out;
  const std::uint16_t* set = mesh.geometry.sets;
  const float* weights = mesh.geometry.skin;
  for (const Run& run : mesh.geometry.runs) {
    const std::uint32_t last = run.influences - 1;
    for (std::uint32_t block = 0; block < (run.vertex_count + 3) / 4; ++block) {
      weights += 12;  // behind positions
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        float sum = 0, left = 1;
        for (std::uint32_t j = 0; j < last; ++j) {
          sum += weights[4 * j + lane] * share_of(mesh, set[j], joint);
          left -= weights[4 * j + lane];
        }
        out.push_back(sum + left * share_of(mesh, set[last], joint));
      }
      weights += std::size_t{4} * last;
    }
    set += run.influences;
  }
  return out;
}

std::vector<float> ramp_colours(const std::vector<float>& numbers) {
  std::vector<float> colours;
  for (const float number : numbers) add_colour(number, colours);
  return colours;
}

Rgb heat_colour(float t) {
  float srgb[3];
  ramp(t, srgb);
  Rgb out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(std::lround(srgb[c]));
  return out;
}

Farthest farthest(const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b) {
  Farthest out;
  for (std::size_t mesh = 0; mesh < a.size(); ++mesh) {
    for (std::size_t slot = 0; 3 * slot < a[mesh].positions.size(); ++slot) {
      const float d = distance(a[mesh], b[mesh], slot);
      if (d > out.distance) out = {static_cast<std::uint32_t>(mesh), slot, d};
    }
  }
  return out;
}

float largest_distance(const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b) {
  return farthest(a, b).distance;
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
      add_colour(distance(a[mesh], b[mesh], slot) / full_scale, colours);
    }
  }
  return map;
}

}  // namespace marrow::tools
