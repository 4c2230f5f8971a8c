#include "render/legend.h"

#include <algorithm>
#include <cmath>

#include "common/quantity.h"
#include "image/caption.h"
#include "render/heat.h"

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
  const int unit = static_cast<int>(std::lround(text)), bar = 16 * unit, pad = unit;
  const std::string largest = "at most " + length_text(static_cast<double>(largest_m));
  const int words = static_cast<int>(std::ceil(std::max(text_width(text, heading), text_width(text, largest))));
  const int half_number = static_cast<int>(text_width(text, length_text(static_cast<double>(full_scale_m)))) / 2;
  const bool nothing = shows_nothing(largest_m, full_scale_m);
  const int width = std::max(bar + half_number, words) + 2 * pad, height = (nothing ? 3 : 8) * unit + 2 * pad;
  const int left = pad, top = image.height - pad - height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) blend(image, left + x, top + y, kPlate, 0.8f);
  const auto line = [&](int baseline) { return static_cast<float>(top + pad + baseline); };
  const auto x = static_cast<float>(left + pad);
  draw_text(image, x, line(unit), text, kBright, heading);
  draw_text(image, x, line(3 * unit), text, kQuiet, largest);
  if (nothing) return;
  draw_bar(image, left + pad, top + pad + 4 * unit, bar, unit + unit / 2);
  draw_text(image, x, line(8 * unit), text, kQuiet, "0");
  for (const int half : {1, 2}) {
    const std::string number = length_text(0.5 * half * static_cast<double>(full_scale_m));
    const float at = x + 0.5f * static_cast<float>(half * bar) - 0.5f * text_width(text, number);
    draw_text(image, at, line(8 * unit), text, kQuiet, number);
  }
}

}  // namespace marrow::tools
