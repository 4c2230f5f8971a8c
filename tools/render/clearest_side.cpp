#include "render/clearest_side.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "common/vertex_order.h"

namespace marrow::tools {
namespace {

constexpr int kPixels = 72;  // each way, of a depth map
constexpr float kNothing = -std::numeric_limits<float>::infinity();
constexpr std::array<float, 2> kPitches = {0.21f, 0.6f};  // radians
constexpr int kYaws = 8;
// The usual side stays if it shows this share of what the best side shows.
constexpr float kNearlyAsGood = 0.7f;
// Of a surface that another hides or that is gone a pixel counts whole, of one that has only moved away from the eye
// this share.
constexpr float kInDepth = 0.4f;

// A vertex as a camera far away sees it: pixels to the right and up, and pixels towards the eye.
struct Seat {
  float x, y, z;
};

// The surface nearest to the eye, a number a pixel.
class DepthMap {
 public:
  DepthMap(const File& file, const std::vector<PosedMesh>& posed, const Part& part, const Orbit& side)
      : depth_(kPixels * kPixels, kNothing) {
    const glm::vec3 right = right_of(side), up = up_of(side), back = glm::cross(right, up);
    const float scale = 0.5f * kPixels / part.radius;
    std::vector<Seat> seats;
    for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
      const std::vector<float>& p = posed[m].positions;
      seats.resize(p.size() / 3);
      for (std::size_t i = 0; i < seats.size(); ++i) {
        const float x = p[3 * i] - part.centre.x, y = p[3 * i + 1] - part.centre.y, z = p[3 * i + 2] - part.centre.z;
        seats[i] = {scale * (x * right.x + y * right.y + z * right.z) + 0.5f * kPixels,
                    scale * (x * up.x + y * up.y + z * up.z) + 0.5f * kPixels,
                    scale * (x * back.x + y * back.y + z * back.z)};
      }
      const Geometry g = file.mesh(m).geometry;
      for (std::uint32_t i = 0; i + 2 < g.index_count; i += 3)
        draw(seats[index_at(g, i)], seats[index_at(g, i + 1)], seats[index_at(g, i + 2)]);
    }
  }
  float at(int x, int y) const { return depth_[static_cast<std::size_t>(y * kPixels + x)]; }

 private:
  // The first and last pixel whose middle lies between two numbers; none that are not finite.
  static bool pixels(float low, float high, int& first, int& last) {
    if (!(low < kPixels) || !(high >= 0)) return false;
    first = std::max(0, static_cast<int>(std::ceil(std::max(low, 0.0f) - 0.5f)));
    last = std::min(kPixels - 1, static_cast<int>(std::floor(std::min(high, static_cast<float>(kPixels)) - 0.5f)));
    return first <= last;
  }

  void draw(const Seat& a, const Seat& b, const Seat& c) {
    int x0, x1, y0, y1;
    if (!pixels(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), x0, x1)) return;
    if (!pixels(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), y0, y1)) return;
    const float whole = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (!(std::abs(whole) > 1e-6f)) return;
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const float px = static_cast<float>(x) + 0.5f - a.x, py = static_cast<float>(y) + 0.5f - a.y;
        const float of_b = (px * (c.y - a.y) - py * (c.x - a.x)) / whole;
        const float of_c = (py * (b.x - a.x) - px * (b.y - a.y)) / whole;
        if (of_b < 0 || of_c < 0 || of_b + of_c > 1) continue;
        float& depth = depth_[static_cast<std::size_t>(y * kPixels + x)];
        depth = std::max(depth, a.z + of_b * (b.z - a.z) + of_c * (c.z - a.z));
      }
    }
  }

  std::vector<float> depth_;
};

// What is in the middle of the picture counts most.
float change(const DepthMap& a, const DepthMap& b) {
  constexpr float kHalf = 0.5f * kPixels;
  float sum = 0, all = 0;
  for (int y = 0; y < kPixels; ++y) {
    for (int x = 0; x < kPixels; ++x) {
      const float away = std::hypot(static_cast<float>(x) + 0.5f - kHalf, static_cast<float>(y) + 0.5f - kHalf) / kHalf;
      const float weight = std::max(0.0f, 1 - away);
      all += weight;
      const float p = a.at(x, y), q = b.at(x, y);
      if (p == q) continue;
      const bool is_outline = p == kNothing || q == kNothing;
      sum += weight * (is_outline ? 1.0f : std::min(1.0f, kInDepth * std::abs(p - q) / (0.25f * kHalf)));
    }
  }
  return sum / all;
}

}  // namespace

std::vector<glm::vec3> framed(const Part& part) {
  std::vector<glm::vec3> points;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0f, 1.0f}) {
      points.push_back(part.centre);
      points.back()[axis] += sign * part.radius;
    }
  }
  return points;
}

Seen clearest_side(const File& file, const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b,
                   const Part& part) {
  const auto share = [&](const Orbit& side) {
    return change(DepthMap(file, a, part, side), DepthMap(file, b, part, side));
  };
  Seen out;
  out.share = share(out.side);
  float best = out.share / kNearlyAsGood;
  for (const float pitch : kPitches) {
    for (int i = 0; i < kYaws; ++i) {
      Orbit side;
      side.yaw += 6.2831853f * static_cast<float>(i) / kYaws;
      side.pitch = pitch;
      const float seen = share(side);
      if (seen <= best) continue;
      best = out.share = seen;
      out.side = side;
    }
  }
  return out;
}

}  // namespace marrow::tools
