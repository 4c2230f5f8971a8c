// Poses and meshes that the tests of offline deformers share.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "deform/cylinder.h"
#include "deform/deformers.h"
#include "deform/fit/fit.h"
#include "deform/simplify/simplify.h"

namespace marrow::deform {

inline constexpr double kDegree = std::numbers::pi / 180;

inline Matrix matrix(const glm::dquat& rotation, const glm::dvec3& translation, double scale = 1) {
  const glm::dmat3 r = glm::mat3_cast(glm::normalize(rotation)) * scale;
  return {r[0], r[1], r[2], translation};
}

inline glm::dquat turn(double degrees, const glm::dvec3& axis) {
  return glm::angleAxis(degrees * kDegree, glm::normalize(axis));
}

// A turn about z through `centre`.
inline Matrix about(const glm::dvec3& centre, double degrees) {
  const glm::dquat q = turn(degrees, {0, 0, 1});
  return matrix(q, centre - q * centre);
}

// The cylinder bent and twisted, far but not too far.
inline const Pose kBent = cylinder_pose(80 * kDegree, 50 * kDegree);

// The cylinder's joints, both in its middle.
inline const std::vector<int> kCylinderParents = {-1, 0};
inline const std::vector<glm::dvec3> kCylinderCentres = {{0, 0, 0}, {0, 0, 0}};

// A rigid motion after a pose.
inline Pose moved(const glm::dquat& rotation, const glm::dvec3& translation, Pose pose) {
  for (Matrix& m : pose) {
    for (int c = 0; c < 4; ++c) m[c] = rotation * m[c];
    m[3] += translation;
  }
  return pose;
}

inline double farthest(const Positions& a, const Positions& b) {
  double worst = a.size() == b.size() && !a.empty() ? 0 : 1e300;
  for (std::size_t v = 0; v < std::min(a.size(), b.size()); ++v) worst = std::max(worst, glm::length(a[v] - b[v]));
  return worst;
}

inline Positions at(const Deformer& deformer, const Pose& pose) {
  Positions out;
  deformer(pose, out);
  return out;
}

// Bends to 120° and twists to 150°, as the cylinder's study has them.
inline std::vector<Pose> random_cylinder_poses(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto up_to = [&](double most) { return most * static_cast<double>(random()) / 4294967296.0; };
  std::vector<Pose> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double bend = up_to(120), twist = up_to(150);
    out.push_back(cylinder_pose(bend * kDegree, twist * kDegree));
  }
  return out;
}

// Pose i of fold i modulo `folds`.
inline std::vector<TrainingPose> training(const std::vector<Pose>& poses, std::uint32_t folds) {
  std::vector<TrainingPose> out;
  for (const Pose& pose : poses) out.push_back({pose, static_cast<std::uint32_t>(out.size()) % folds});
  return out;
}

// Root mean square over poses and vertices of how far two deformers are apart.
inline double rms(const Deformer& a, const Deformer& b, const std::vector<Pose>& poses) {
  double sum = 0;
  std::size_t count = 0;
  for (const Pose& pose : poses) {
    const Positions p = at(a, pose), q = at(b, pose);
    for (std::size_t v = 0; v < p.size(); ++v) sum += glm::dot(p[v] - q[v], p[v] - q[v]);
    count += p.size();
  }
  return std::sqrt(sum / static_cast<double>(count));
}

// How a fit fares: the share of SSD's error that cross-validation foresaw, and what it makes of poses.
struct Judged {
  double foreseen;
  double error;  // RMS from the truth in `held`
};
using Judge =
    std::function<Judged(const std::vector<TrainingPose>& train, const std::vector<Pose>& held, const Deformer& truth)>;

// Of SSD's error against dual quaternions on 200 poses of the cylinder held out, learnt from 30: the mean of three
// draws.
inline double share_held_out(const SkinnedMesh& mesh, const Judge& judge) {
  const Deformer truth = dual_quaternions(mesh), reference = ssd(mesh);
  double share = 0;
  const int seeds = 3;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    const std::vector<Pose> held = random_cylinder_poses(200, seed + 20);
    const Judged judged = judge(training(random_cylinder_poses(30, seed + 10), 5), held, truth);
    const double of_this = judged.error / rms(reference, truth, held);
    EXPECT_NEAR(judged.foreseen, of_this, 0.15) << "what cross-validation foresaw";
    share += of_this / seeds;
  }
  ::testing::Test::RecordProperty("share", std::to_string(share));
  return share;
}

// Points are vertices: no seams.
inline SeamedSurface plain(std::size_t points, std::vector<std::uint32_t> indices) {
  SeamedSurface out;
  for (std::uint32_t p = 0; p < points; ++p) {
    out.point_of.push_back(p);
    out.chart_of.push_back(p);
    out.normals.emplace_back(0, 0, 1);
  }
  out.indices = std::move(indices);
  return out;
}

}  // namespace marrow::deform
