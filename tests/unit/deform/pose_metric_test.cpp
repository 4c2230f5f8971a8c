#include "deform/pose_metric.h"

#include <gtest/gtest.h>

#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

// Five joints that turn and go anywhere.
std::vector<Pose> wild_poses(std::size_t count, std::size_t joints, unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  std::vector<Pose> out(count);
  for (Pose& pose : out)
    for (std::size_t j = 0; j < joints; ++j)
      pose.push_back(matrix(glm::dquat(number(), number(), number(), number()), {number(), number(), number()}));
  return out;
}

glm::dvec3 posed(const std::vector<Coordinate>& vertex, const Pose& pose) {
  glm::dvec3 out(0);
  for (const Coordinate& c : vertex) out += linear_of(pose[c.joint]) * glm::dvec3(c.q) + pose[c.joint][3] * c.q.w;
  return out;
}

double mean_squared(const std::vector<Coordinate>& p, const std::vector<Coordinate>& q,
                    const std::vector<Pose>& poses) {
  double sum = 0;
  for (const Pose& pose : poses) {
    const glm::dvec3 off = posed(p, pose) - posed(q, pose);
    sum += glm::dot(off, off) / static_cast<double>(poses.size());
  }
  return sum;
}

const std::vector<Coordinate> kVertex = {
    {0, {0.2, 0.1, 0.3, 0.4}}, {1, {0.1, 0.5, 0.2, 0.3}}, {2, {0.3, 0, 0.1, 0.2}}, {4, {0.02, 0.03, 0.01, 0.1}}};

TEST(PoseMetric, IsTheMeanOverPoses) {
  std::vector<Pose> poses = wild_poses(40, 5, 3);
  for (Pose& pose : poses) pose = moved(glm::dquat(1, 0, 0, 0), {1000, 0, 0}, pose);
  const PoseMetric metric(poses, {kVertex});
  const std::vector<Coordinate> other = {{0, {0.5, 0.2, 0.3, 0.7}}, {4, {0.1, 0.4, 0.2, 0.3}}};
  EXPECT_NEAR(metric.squared_distance(kVertex, other), mean_squared(kVertex, other, poses), 1e-9);
  EXPECT_NEAR(metric.squared_distance(kVertex, kVertex), 0, 1e-12);
}

// Joint 2 moves as joint 0 does but for a little, joint 4 as joint 1: those two go.
TEST(PoseMetric, KeepsJointsThatNoOtherReplaces) {
  std::vector<Pose> poses = wild_poses(40, 5, 4);
  for (Pose& pose : poses) {
    pose[2] = pose[0];
    pose[2][3] += glm::dvec3(0.01, 0, 0);
    pose[4] = pose[1];
  }
  const PoseMetric metric(poses, {kVertex});
  EXPECT_EQ(joints_to_keep(metric, kVertex, 4), (std::vector<std::uint32_t>{0, 1, 2, 4}));
  const std::vector<std::uint32_t> three = joints_to_keep(metric, kVertex, 3);
  const std::vector<Coordinate> exact = with_joints(metric, kVertex, three);
  EXPECT_LT(metric.squared_distance(kVertex, exact), 1e-12) << "joints 1 and 4 are the same";
  const std::vector<std::uint32_t> two = joints_to_keep(metric, kVertex, 2);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_TRUE(two[0] == 0 || two[0] == 2 || two[1] == 2) << "one of 0 and 2";
  EXPECT_LT(metric.squared_distance(kVertex, with_joints(metric, kVertex, two)), 1e-4);
}

// The least of all that leave the bind pose alone: no step along any of those directions is better.
TEST(PoseMetric, LeastSquaresKeepTheBindPose) {
  const std::vector<Pose> poses = wild_poses(60, 5, 5);
  const PoseMetric metric(poses, {kVertex});
  const std::vector<Coordinate> best = with_joints(metric, kVertex, {0, 2, 4});
  ASSERT_EQ(best.size(), 3u);
  glm::dvec4 sum(0), before(0);
  for (const Coordinate& c : best) sum += c.q;
  for (const Coordinate& c : kVertex) before += c.q;
  for (int r = 0; r < 4; ++r) EXPECT_NEAR(sum[r], before[r], 1e-12);
  const double least = mean_squared(kVertex, best, poses);
  EXPECT_GT(least, 1e-3);
  for (std::size_t a = 0; a < 3; ++a)
    for (int r = 0; r < 4; ++r)
      for (const double step : {-1e-3, 1e-3}) {
        std::vector<Coordinate> other = best;
        other[a].q[r] += step;
        other[(a + 1) % 3].q[r] -= step;
        EXPECT_GT(mean_squared(kVertex, other, poses), least);
      }
}

TEST(PoseMetric, WeightsAreLeastSquaresAndNotBelowZero) {
  const std::vector<Pose> poses = wild_poses(60, 5, 6);
  const glm::dvec3 position(0.3, -0.8, 0.5);
  const std::vector<Influence> influences = {{0, 0.4}, {1, 0.3}, {2, 0.2}, {4, 0.1}};
  Coordinates lifted(1);
  for (const Influence& i : influences) lifted[0].push_back({i.joint, glm::dvec4(position, 1) * i.weight});
  const PoseMetric metric(poses, lifted);
  const auto error = [&](const std::vector<Influence>& on) {
    std::vector<Coordinate> q;
    for (const Influence& i : on) q.push_back({i.joint, glm::dvec4(position, 1) * i.weight});
    return mean_squared(lifted[0], q, poses);
  };
  const std::vector<Influence> best = with_joints(metric, position, influences, {0, 1, 4});
  double sum = 0;
  for (const Influence& i : best) {
    EXPECT_GE(i.weight, 0);
    sum += i.weight;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  ASSERT_EQ(best.size(), 3u);
  EXPECT_LT(error(best), error({{0, 0.5}, {1, 0.375}, {4, 0.125}})) << "better than to share out what is lost";
  for (std::size_t a = 0; a < 3; ++a)
    for (const double step : {-1e-3, 1e-3}) {
      std::vector<Influence> other = best;
      other[a].weight += step;
      other[(a + 1) % 3].weight -= step;
      EXPECT_GT(error(other), error(best));
    }
  // A joint that goes the other way would need a negative weight.
  std::vector<Pose> opposed = poses;
  for (Pose& pose : opposed) {
    pose[0] = Matrix(1.0);
    pose[1] = pose[2] = Matrix(1.0);
    pose[1][3] = {1, 0, 0};
    pose[2][3] = {-1, 0, 0};
  }
  Coordinates two(1);
  two[0] = {{0, glm::dvec4(position, 1) * 0.5}, {1, glm::dvec4(position, 1) * 0.5}, {2, glm::dvec4(0)}};
  const std::vector<Influence> clipped = with_joints(PoseMetric(opposed, two), position, {{0, 0.5}, {1, 0.5}}, {0, 2});
  ASSERT_EQ(clipped.size(), 1u);
  EXPECT_EQ(clipped[0].joint, 0u);
  EXPECT_NEAR(clipped[0].weight, 1, 1e-12);
}

}  // namespace
}  // namespace marrow::deform
