#include "render/legend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "image/caption.h"
#include "render/heat.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

constexpr int kLeastWidth = 240, kLeastHeight = 160;  // pixels
constexpr Rgb kPlate = {20, 25, 31}, kBright = {236, 233, 226}, kQuiet = {170, 178, 186};

void draw_bar(Image& image, int left, int top, int width, int height) {
  for (int x = 0; x < width; ++x) {
    const Rgb colour = heat_colour(static_cast<float>(x) / static_cast<float>(width - 1));
    for (int y = 0; y < height; ++y) blend(image, left + x, top + y, colour, 1);
  }
}

}  // namespace

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
