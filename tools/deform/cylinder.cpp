#include "deform/cylinder.h"

#include <algorithm>
#include <numbers>

#include "common/elementary.h"

namespace marrow::deform {

SkinnedMesh cylinder() {
  constexpr std::uint32_t kRound = 40, kAlong = 50;
  constexpr double kLength = 10, kRamp = 1.5;
  SkinnedMesh mesh;
  mesh.joint_count = 2;
  const auto add = [&](double x, double y, double z) {
    mesh.positions.emplace_back(x, y, z);
    const double t = std::clamp((x + kRamp) / (2 * kRamp), 0.0, 1.0), w = t * t * t * (10 + t * (6 * t - 15));
    if (w <= 0) {
      mesh.influences.push_back({{0, 1.0}});
    } else if (w >= 1) {
      mesh.influences.push_back({{1, 1.0}});
    } else {
      mesh.influences.push_back({{0, 1 - w}, {1, w}});
    }
  };
  for (std::uint32_t i = 0; i < kAlong; ++i) {
    for (std::uint32_t k = 0; k < kRound; ++k) {
      const double angle = 2 * std::numbers::pi * k / kRound;
      add(kLength * (static_cast<double>(i) / (kAlong - 1) - 0.5), tools::cosine(angle), tools::sine(angle));
    }
  }
  add(-kLength / 2, 0, 0);
  add(kLength / 2, 0, 0);
  const auto at = [](std::uint32_t i, std::uint32_t k) { return i * kRound + k % kRound; };
  for (std::uint32_t k = 0; k < kRound; ++k) {
    for (std::uint32_t i = 0; i + 1 < kAlong; ++i)
      mesh.indices.insert(mesh.indices.end(),
                          {at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    mesh.indices.insert(mesh.indices.end(), {kAlong * kRound, at(0, k + 1), at(0, k)});
    mesh.indices.insert(mesh.indices.end(), {kAlong * kRound + 1, at(kAlong - 1, k), at(kAlong - 1, k + 1)});
  }
  return mesh;
}

Pose cylinder_pose(double bend_rad, double twist_rad) {
  const double cz = tools::cosine(bend_rad), sz = tools::sine(bend_rad), cx = tools::cosine(twist_rad),
               sx = tools::sine(twist_rad);
  const Matrix still{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  return {still, {{cz, sz, 0}, {-sz * cx, cz * cx, sx}, {sz * sx, -cz * sx, cx}, {0, 0, 0}}};
}

}  // namespace marrow::deform
