#include "cook/learn/trainees.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "cook/learn/learn.h"
#include "deform/cylinder.h"
#include "deform/elastic/elastic.h"
#include "deform/fit/remembered.h"

namespace marrow::cook {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// How far the cylinder's second joint is turned.
double angle(const deform::Pose& pose) {
  const deform::Matrix& m = pose[1];
  return std::acos(std::clamp((m[0][0] + m[1][1] + m[2][2] - 1) / 2, -1.0, 1.0));
}

deform::RangeOfMotion motion() {
  return deform::range_of_motion(deform::cylinder(), {-1, 0}, {{0, 0, 0}, {0, 0, 0}});
}

// Both ways about three axes by 0.4 and 0.85 of 170 degrees, which twists go to, and of 130, which bends go to: 12
// poses, none of them judged by.
TEST(SingleJoints, AreBetweenThoseJudgedBy) {
  const deform::RangeOfMotion judged = motion();
  const std::vector<deform::TrainingPose> poses = single_joints(judged.poses, 100, 5);
  ASSERT_EQ(poses.size(), 12u);
  std::multiset<int> tenths;
  std::set<std::uint32_t> folds;
  for (const deform::TrainingPose& p : poses) {
    tenths.insert(static_cast<int>(std::lround(10 * angle(p.pose) / kDegree)));
    folds.insert(p.fold);
    EXPECT_TRUE(p.learnt);
    EXPECT_FALSE(p.shipped);
    for (const deform::MotionPose& other : judged.poses)
      EXPECT_GT(std::abs(angle(other.pose()) - angle(p.pose)), 2 * kDegree);
  }
  EXPECT_EQ(tenths, (std::multiset<int>{520, 520, 520, 520, 680, 680, 1105, 1105, 1105, 1105, 1445, 1445}));
  EXPECT_EQ(folds, (std::set<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST(SingleJoints, AreNoMoreThanAskedFor) {
  EXPECT_EQ(single_joints(motion().poses, 7, 1).size(), 7u);
  EXPECT_TRUE(single_joints({}, 7, 1).empty());
  EXPECT_TRUE(single_joints(motion().poses, 0, 1).empty());
}

// A root that scales a character to a hundredth, or doubles it thrice; a joint that scales on its own stays as it is.
TEST(BringToBindSize, TakesTheRootsScaleAway) {
  const deform::Pose pose = deform::cylinder_pose(0, 0.3);
  for (const double scale : {0.01, 8.0}) {
    std::vector<deform::TrainingPose> poses = {{pose}, {pose}, {pose}};
    for (deform::Matrix& m : poses[0].pose)
      for (int c = 0; c < 4; ++c) m[c] *= scale;
    for (int c = 0; c < 3; ++c) poses[1].pose[1][c] *= 1.5;
    const deform::Pose stretched = poses[1].pose;
    poses[2].pose[1] = deform::Matrix(std::numeric_limits<double>::quiet_NaN());
    bring_to_bind_size(poses);
    for (std::size_t j = 0; j < pose.size(); ++j)
      for (int c = 0; c < 4; ++c) {
        EXPECT_LT(glm::length(poses[0].pose[j][c] - pose[j][c]), 1e-12);
        EXPECT_EQ(poses[1].pose[j][c], stretched[j][c]);
      }
    EXPECT_TRUE(std::isnan(poses[2].pose[1][0][0]));
  }
}

double squares(const deform::Deformer& a, const deform::Deformer& b, const deform::Pose& pose) {
  deform::Positions first, second;
  a(pose, first);
  b(pose, second);
  double out = 0;
  for (std::size_t v = 0; v < first.size(); ++v) out += glm::dot(first[v] - second[v], first[v] - second[v]);
  return out;
}

// A clip that bends one way alone. The body's fit is nearer to it than SSD all the same when the joint bends the other
// way, or twists, to angles that it was not shown.
TEST(SingleJoints, TeachWhatNoClipShows) {
  DeformSource source;
  source.mesh = deform::cylinder();
  source.parents = {kNone, 0};
  source.centres.assign(2, glm::dvec3(0));
  source.joints = {0, 1};
  source.motion = motion().poses;
  const auto elastic = std::make_shared<const deform::Elastic>(source.mesh, deform::ElasticOptions(), 500);
  source.elastic =
      deform::remembered([elastic](const deform::Pose& pose, deform::Positions& out) { elastic->pose(pose, out); });
  std::vector<deform::TrainingPose> poses;
  for (std::uint32_t i = 0; i < 20; ++i) poses.push_back({deform::cylinder_pose(4 * i * kDegree, 0), i / 5, true});
  LearnOptions options;
  options.animation_space = AnimationSpace::fit;
  options.truth = Truth::elastic;
  options.helpers = kAutoHelpers;
  const Learnt learnt = learn(source, poses, options);
  EXPECT_LT(learnt.quality.share, 0.5);
  const deform::Deformer ssd = deform::ssd(source.mesh);
  const deform::Deformer ours = [&](const deform::Pose& pose, deform::Positions& out) {
    deform::Pose at = pose;
    deform::append_helpers(learnt.helpers, at);
    deform::animation_space(learnt.coordinates)(at, out);
  };
  std::size_t counted = 0;
  for (const deform::MotionPose& p : source.motion) {
    EXPECT_LT(squares(ours, source.elastic, p.pose()), 0.7 * 0.7 * squares(ssd, source.elastic, p.pose()))
        << name_of(p.kind) << " by " << p.angle_rad / kDegree;
    ++counted;
  }
  EXPECT_EQ(counted, 12u);
}

}  // namespace
}  // namespace marrow::cook
