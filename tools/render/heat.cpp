#include "render/heat.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "image/caption.h"
#include "text/quantity.h"

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

constexpr int kLeastWidth = 240, kLeastHeight = 160;  // pixels
constexpr Rgb kPlate = {20, 25, 31}, kBright = {236, 233, 226}, kQuiet = {170, 178, 186};

void draw_bar(Image& image, int left, int top, int width, int height) {
  for (int x = 0; x < width; ++x) {
    const Rgb colour = heat_colour(static_cast<float>(x) / static_cast<float>(width - 1));
    for (int y = 0; y < height; ++y) blend(image, left + x, top + y, colour, 1);
  }
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

bool shows_nothing(float largest_m, float full_scale_m) {
  return largest_m < 0.01f * full_scale_m;
}

int draw_ramp(Image& image, int right, int baseline, float cap_height, Rgb colour, float full_scale_m) {
  const std::string hottest = length_text(static_cast<double>(full_scale_m));
  const auto y = static_cast<float>(baseline);
  const int height = static_cast<int>(std::lround(cap_height)), gap = height;
  const int length = 16 * height;
  const float numbers = static_cast<float>(right) - text_width(cap_height, hottest);
  draw_text(image, numbers, y, cap_height, colour, hottest);
  const int bar = static_cast<int>(numbers) - gap - length;
  draw_bar(image, bar, baseline - height, length, height);
  const float zero = static_cast<float>(bar - gap) - text_width(cap_height, "0");
  draw_text(image, zero, y, cap_height, colour, "0");
  return static_cast<int>(zero);
}

void draw_legend(Image& image, const std::string& heading, float largest_m, float full_scale_m) {
  if (image.width < kLeastWidth || image.height < kLeastHeight) return;
  const float text = std::clamp(static_cast<float>(image.height) / 64, 7.0f, 24.0f);
  const int unit = static_cast<int>(std::lround(text)), baseline = image.height - unit;
  for (int y = image.height - 3 * unit; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) blend(image, x, y, kPlate, 0.8f);
  int end = image.width - unit;
  if (!shows_nothing(largest_m, full_scale_m)) end = draw_ramp(image, end, baseline, text, kQuiet, full_scale_m) - unit;
  const std::string largest = "at most " + length_text(static_cast<double>(largest_m));
  auto x = static_cast<float>(unit);
  for (const auto& [word, colour] : {std::pair(heading, kBright), std::pair(largest, kQuiet)}) {
    if (x + text_width(text, word) > static_cast<float>(end)) return;
    x = draw_text(image, x, static_cast<float>(baseline), text, colour, word) + 2 * text;
  }
}

}  // namespace marrow::tools
