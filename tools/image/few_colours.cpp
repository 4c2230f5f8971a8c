#include "image/few_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace marrow::tools {
namespace {

constexpr double kLeastSpread = 1e-6;
constexpr int kRounds = 4;

// Colours that are alike, by six bits a channel: their mean, and how much they count.
struct Alike {
  std::array<double, 3> mean = {};
  double weight = 0;
};

std::vector<Alike> gather(std::span<const Image> samples) {
  std::vector<Alike> cells(std::size_t{1} << 18);
  for (const Image& image : samples)
    for (std::size_t at = 0; at < image.rgb.size(); at += 3) {
      const std::uint8_t* const colour = image.rgb.data() + at;
      const int cell = (colour[0] >> 2) << 12 | (colour[1] >> 2) << 6 | colour[2] >> 2;
      Alike& to = cells[static_cast<std::size_t>(cell)];
      for (std::size_t c = 0; c < 3; ++c) to.mean[c] += colour[c];
      ++to.weight;
    }
  std::erase_if(cells, [](const Alike& a) { return a.weight == 0; });
  for (Alike& a : cells) {
    for (double& channel : a.mean) channel /= a.weight;
    a.weight = std::sqrt(a.weight);  // or large plain areas would take all
  }
  return cells;
}

// Neighbours among the colours; the channel in which they are spread most, and how much.
struct Box {
  std::span<Alike> of;
  std::array<double, 3> mean = {};
  std::size_t channel = 0;
  double spread = 0;

  explicit Box(std::span<Alike> all) : of(all) {
    double weight = 0;
    std::array<double, 3> squares = {};
    for (const Alike& a : of) {
      weight += a.weight;
      for (std::size_t c = 0; c < 3; ++c) mean[c] += a.weight * a.mean[c];
    }
    for (double& m : mean) m /= weight;
    for (const Alike& a : of)
      for (std::size_t c = 0; c < 3; ++c) squares[c] += a.weight * (a.mean[c] - mean[c]) * (a.mean[c] - mean[c]);
    channel = static_cast<std::size_t>(std::ranges::max_element(squares) - squares.begin());
    spread = squares[channel];
  }
};

// The box that is spread most is cut at its mean, again and again.
std::vector<std::array<double, 3>> cut(std::span<Alike> all, std::size_t most) {
  std::vector<Box> boxes = {Box(all)};
  while (boxes.size() < most) {
    const auto widest = std::ranges::max_element(boxes, {}, &Box::spread);
    if (widest->spread < kLeastSpread) break;
    const std::size_t channel = widest->channel;
    const double mean = widest->mean[channel];
    const auto behind = std::stable_partition(widest->of.begin(), widest->of.end(),
                                              [&](const Alike& a) { return a.mean[channel] < mean; });
    const auto count = static_cast<std::size_t>(behind - widest->of.begin());
    const std::span<Alike> before = widest->of.first(count), rest = widest->of.subspan(count);
    *widest = Box(before);
    boxes.emplace_back(rest);
  }
  std::vector<std::array<double, 3>> out;
  for (const Box& box : boxes) out.push_back(box.mean);
  return out;
}

template <class T, class U>
double squared_distance(const T& a, const U& b) {
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

// Each colour goes to the mean of those that it stands for, a few times.
void settle(std::span<const Alike> all, std::vector<std::array<double, 3>>& colours) {
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Alike> sums(colours.size());
    for (const Alike& a : all) {
      const auto nearest = std::ranges::min_element(
          colours, {}, [&](const std::array<double, 3>& colour) { return squared_distance(a.mean, colour); });
      Alike& sum = sums[static_cast<std::size_t>(nearest - colours.begin())];
      for (std::size_t c = 0; c < 3; ++c) sum.mean[c] += a.weight * a.mean[c];
      sum.weight += a.weight;
    }
    for (std::size_t i = 0; i < colours.size(); ++i)
      for (std::size_t c = 0; c < 3 && sums[i].weight > 0; ++c) colours[i][c] = sums[i].mean[c] / sums[i].weight;
  }
}

std::size_t nearest(const std::vector<Rgb>& colours, const std::array<int, 3>& wanted) {
  std::size_t best = 0;
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const int r = wanted[0] - colours[i][0], g = wanted[1] - colours[i][1], b = wanted[2] - colours[i][2];
    const int distance = r * r + g * g + b * b;
    if (distance >= least) continue;
    least = distance;
    best = i;
  }
  return best;
}

// Bayer's matrix: a share between 0 and 1 for each pixel of four by four.
constexpr int kPattern[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

}  // namespace

Palette Palette::of(std::span<const Image> samples) {
  std::vector<Alike> all = gather(samples);
  std::vector<std::array<double, 3>> means = cut(all, kMost);
  settle(all, means);
  Palette out;
  for (const std::array<double, 3>& mean : means) {
    Rgb& colour = out.colours.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) colour[c] = static_cast<std::uint8_t>(std::lround(mean[c]));
  }
  return out;
}

std::size_t Palette::index(const std::uint8_t* colour, int x, int y) const {
  const std::array<int, 3> wanted = {colour[0], colour[1], colour[2]};
  const std::size_t near = nearest(colours, wanted);
  std::array<int, 3> beyond = {};
  for (std::size_t c = 0; c < 3; ++c) beyond[c] = 2 * wanted[c] - colours[near][c];
  const std::size_t far = nearest(colours, beyond);
  int along = 0, length = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const int step = colours[far][c] - colours[near][c];
    along += (wanted[c] - colours[near][c]) * step;
    length += step * step;
  }
  return 32 * along > (2 * kPattern[y & 3][x & 3] + 1) * length ? far : near;
}

}  // namespace marrow::tools
