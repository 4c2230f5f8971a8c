#include "deform/motion/range_of_motion.h"

#include <limits>

#include "deform/motion/motion_errors.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

using Why = LeftOut::Why;
const std::vector<int> kChain = {-1, 0};

// Radius 1, from x = -2 to 2, without caps; the first joint at x = -2, the second in the middle. The second's share is
// (x + 2) / 4, so a row of vertices stands where it is one half.
SkinnedMesh tube(std::uint32_t round = 24, std::uint32_t along = 16) {
  SkinnedMesh mesh;
  mesh.joint_count = 2;
  for (std::uint32_t i = 0; i <= along; ++i) {
    const double share = static_cast<double>(i) / along;
    for (std::uint32_t k = 0; k < round; ++k) {
      const double angle = 2 * std::numbers::pi * k / round;
      mesh.positions.emplace_back(4 * share - 2, std::cos(angle), std::sin(angle));
      mesh.influences.push_back({{0, 1 - share}, {1, share}});
    }
  }
  for (std::uint32_t i = 0; i < along; ++i)
    for (std::uint32_t k = 0; k < round; ++k) {
      const std::uint32_t a = i * round + k, b = i * round + (k + 1) % round;
      mesh.indices.insert(mesh.indices.end(), {a, b, b + round, a, b + round, a + round});
    }
  return mesh;
}
const std::vector<glm::dvec3> kPlaces = {{-2, 0, 0}, {0, 0, 0}};

std::vector<MotionPose> of_joint(const RangeOfMotion& motion, std::uint32_t joint) {
  std::vector<MotionPose> out;
  for (const MotionPose& pose : motion.poses)
    if (pose.joint == joint) out.push_back(pose);
  return out;
}

std::vector<std::pair<std::uint32_t, Why>> reasons(const RangeOfMotion& motion) {
  std::vector<std::pair<std::uint32_t, Why>> out;
  for (const LeftOut& l : motion.left_out) out.emplace_back(l.joint, l.why);
  return out;
}

TEST(RangeOfMotion, TurnsAJointAndWhatIsBelowIt) {
  SkinnedMesh mesh = tube();
  mesh.joint_count = 4;  // a hand below the second joint, and another arm that stays
  mesh.influences.back() = {{2, 0.5}, {3, 0.5}};
  const std::vector<glm::dvec3> places = {{-2, 0, 0}, {0, 0, 0}, {0, 3, 4}, {-1, 0, 0}};
  const std::vector<MotionPose> poses = of_joint(range_of_motion(mesh, {-1, 0, 1, 0}, places), 1);
  const std::vector<std::pair<MotionKind, double>> expected = {
      {MotionKind::twist, 85},       {MotionKind::twist, 170},      {MotionKind::twist, -85},
      {MotionKind::twist, -170},     {MotionKind::bend, 65},        {MotionKind::bend, 130},
      {MotionKind::bend, -65},       {MotionKind::bend, -130},      {MotionKind::other_bend, 65},
      {MotionKind::other_bend, 130}, {MotionKind::other_bend, -65}, {MotionKind::other_bend, -130}};
  ASSERT_EQ(poses.size(), expected.size());
  const glm::dvec3 bone(0, 0.6, 0.8);  // to the hand
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(poses[i].kind, expected[i].first);
    EXPECT_NEAR(poses[i].angle_rad, expected[i].second * kDegree, 1e-12);
    const double along = glm::dot(poses[i].axis, bone);
    EXPECT_NEAR(along, poses[i].kind == MotionKind::twist ? 1 : 0, 1e-12);
    const Pose pose = poses[i].pose();
    ASSERT_EQ(pose.size(), 4u);
    const glm::dmat3 turned = glm::mat3_cast(glm::angleAxis(expected[i].second * kDegree, poses[i].axis));
    for (const std::size_t j : {0u, 3u}) EXPECT_EQ(pose[j], Matrix(1.0));
    for (const std::size_t j : {1u, 2u}) {
      for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(pose[j][c] - turned[c]), 1e-12);
      EXPECT_LT(glm::length(transform(pose[j], places[1]) - places[1]), 1e-12) << "the joint stays where it is";
    }
  }
  EXPECT_NEAR(glm::dot(poses[4].axis, poses[8].axis), 0, 1e-12);
}

TEST(RangeOfMotion, OfAJointWithoutChildrenIsAboutItsVerticesOrOnFromItsParent) {
  const SkinnedMesh mesh = tube();
  const RangeOfMotion leaf = range_of_motion(mesh, kChain, kPlaces);
  EXPECT_LT(glm::length(of_joint(leaf, 1).front().axis - glm::dvec3(1, 0, 0)), 1e-12);
  EXPECT_EQ(reasons(leaf), (std::vector<std::pair<std::uint32_t, Why>>{{0, Why::moves_as_one}}));
  // Its vertices' mean, weighted, is 2/3 along: there, it goes on from the parent.
  SkinnedMesh even = mesh;
  for (glm::dvec3& p : even.positions) p.x = 0;
  EXPECT_LT(glm::length(of_joint(range_of_motion(even, kChain, {{0, -3, 0}, {0, 0, 0}}), 1).front().axis -
                        glm::dvec3(0, 1, 0)),
            1e-12);
}

TEST(RangeOfMotion, SaysWhichJointsHaveNone) {
  SkinnedMesh mesh = tube();
  mesh.joint_count = 5;
  // 2 has no vertices; 3 is where its vertices and its parent are; 4's place is not known.
  mesh.positions.resize(mesh.positions.size() + 2, glm::dvec3(-2, 0, 0));
  mesh.influences.resize(mesh.positions.size() - 1, {{0, 0.5}, {3, 0.5}});
  mesh.influences.push_back({{0, 0.5}, {4, 0.5}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const RangeOfMotion motion =
      range_of_motion(mesh, {-1, 0, 1, 0, 0}, {{-2, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-2, 0, 0}, {nan, 0, 0}});
  EXPECT_EQ(reasons(motion),
            (std::vector<std::pair<std::uint32_t, Why>>{
                {0, Why::moves_as_one}, {2, Why::no_vertices}, {3, Why::no_axis}, {4, Why::not_finite}}));
  EXPECT_EQ(of_joint(motion, 1).size(), 12u);
  EXPECT_EQ(motion.poses.size(), 12u);
  for (const MotionPose& pose : motion.poses)
    for (const Matrix& m : pose.pose()) EXPECT_TRUE(is_finite(m));
}

// Ten vertices without triangles: poses, and no ring to measure.
TEST(RangeOfMotion, OfTenVertices) {
  SkinnedMesh mesh = tube(2, 4);
  mesh.indices.clear();
  ASSERT_EQ(mesh.positions.size(), 10u);
  const RangeOfMotion motion = range_of_motion(mesh, kChain, kPlaces);
  EXPECT_EQ(motion.poses.size(), 12u);
  const std::vector<Deformer> all = {ssd(mesh)};
  for (const MotionErrors& e : motion_errors(mesh, motion.poses, dual_quaternions(mesh), all)) {
    EXPECT_TRUE(e.is_usable);
    EXPECT_GT(e.ssd_rms, 0.01);
    EXPECT_EQ(e.of[0].rms, e.ssd_rms);
    EXPECT_FALSE(e.of[0].ring_over_bind || e.of[0].ring_over_truth || e.of[0].volume_over_truth);
  }
  EXPECT_TRUE(range_of_motion({}, {}, {}).poses.empty());
}

TEST(RangeOfMotion, StaysWithinLimits) {
  const SkinnedMesh mesh = tube();
  const auto limited = [&](const std::function<glm::dquat(const glm::dquat&)>& nearest) {
    MotionOptions options;
    options.nearest_allowed = [&](std::uint32_t joint, const glm::dquat& turn) {
      return joint == 1 ? nearest(turn) : turn;
    };
    RangeOfMotion out = range_of_motion(mesh, kChain, kPlaces, options);
    std::erase_if(out.left_out, [](const LeftOut& l) { return l.why == Why::moves_as_one; });
    return out;
  };
  // 40° about any axis: the farther of two poses is the nearer one again, and is left out.
  const RangeOfMotion narrow =
      limited([](const glm::dquat& q) { return glm::angleAxis(std::min(glm::angle(q), 40 * kDegree), glm::axis(q)); });
  EXPECT_EQ(narrow.poses.size(), 6u);
  for (const MotionPose& pose : narrow.poses) EXPECT_NEAR(std::abs(pose.angle_rad), 40 * kDegree, 1e-9);
  EXPECT_LT(narrow.poses[1].angle_rad, 0);
  EXPECT_TRUE(narrow.left_out.empty());
  // A hinge about the bone, given as the quaternion of either sign.
  const RangeOfMotion hinge = limited([](const glm::dquat& q) { return -glm::normalize(glm::dquat(q.w, q.x, 0, 0)); });
  EXPECT_EQ(reasons(hinge), (std::vector<std::pair<std::uint32_t, Why>>{{1, Why::limits_of_bends}}));
  ASSERT_EQ(hinge.poses.size(), 4u);
  EXPECT_NEAR(hinge.poses[3].angle_rad, -170 * kDegree, 1e-9);
  EXPECT_LT(glm::length(hinge.poses[3].axis - glm::dvec3(1, 0, 0)), 1e-9);
  // What is left of a twist is no twist where it is about another axis.
  const RangeOfMotion tilted = limited(
      [](const glm::dquat& q) { return std::abs(q.x) > 0.5 ? glm::angleAxis(20 * kDegree, glm::dvec3(0, 1, 0)) : q; });
  EXPECT_EQ(reasons(tilted), (std::vector<std::pair<std::uint32_t, Why>>{{1, Why::limits_of_twist}}));
  const RangeOfMotion swing = limited([](const glm::dquat& q) { return glm::normalize(glm::dquat(q.w, 0, q.y, q.z)); });
  EXPECT_EQ(reasons(swing), (std::vector<std::pair<std::uint32_t, Why>>{{1, Why::limits_of_twist}}));
  const RangeOfMotion still = limited([](const glm::dquat&) { return glm::dquat(1, 0, 0, 0); });
  EXPECT_EQ(reasons(still), (std::vector<std::pair<std::uint32_t, Why>>{{1, Why::limits}}));
  EXPECT_TRUE(still.poses.empty());
  const RangeOfMotion broken =
      limited([](const glm::dquat&) { return glm::dquat(std::numeric_limits<double>::quiet_NaN(), 0, 0, 0); });
  EXPECT_TRUE(broken.poses.empty());
}

// Linear blend skinning at share s takes a point to (1 - s) p + s R p: its distance from the axis shrinks by
// |1 - s + s e^(iθ)|, least at one half, where it is cos(θ / 2). Dual quaternions turn about the axis and keep it.
TEST(MotionErrors, OfTheRingOfATube) {
  const SkinnedMesh mesh = tube();
  MotionOptions options;
  options.twist_rad = std::numbers::pi;
  const std::vector<MotionPose> poses = range_of_motion(mesh, kChain, kPlaces, options).poses;
  const std::vector<Deformer> all = {ssd(mesh), dual_quaternions(mesh)};
  const std::vector<MotionErrors> errors = motion_errors(mesh, poses, all[1], all);
  ASSERT_EQ(errors.size(), 12u);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double expected = std::cos(poses[i].angle_rad / 2);
    const MotionFigures &plain = errors[i].of[0], &truth = errors[i].of[1];
    EXPECT_NEAR(plain.ring_over_bind.value(), expected, 1e-12) << name_of(poses[i].kind) << poses[i].angle_rad;
    EXPECT_NEAR(truth.ring_over_bind.value(), 1, 1e-12) << "a row of vertices stands at each eighth";
    EXPECT_NEAR(plain.ring_over_truth.value(), expected, 1e-12);
    EXPECT_EQ(truth.rms, 0);
    EXPECT_FALSE(truth.is_worse || plain.is_worse);
    EXPECT_TRUE(poses[i].kind != MotionKind::twist || errors[i].truth_flipped == 0);
  }
  EXPECT_LT(errors[1].of[0].ring_over_bind.value(), 1e-12) << "at half a turn nothing is left of it";
}

// No row of vertices stands in the middle of the cylinder: the ring cuts edges along it, where the same holds, and
// diagonals, where it nearly does.
TEST(MotionErrors, OfTheRingOfTheCylinder) {
  const SkinnedMesh mesh = cylinder();
  const std::vector<MotionPose> poses = range_of_motion(mesh, kChain, {{0, 0, 0}, {0, 0, 0}}).poses;
  const std::vector<Deformer> all = {ssd(mesh)};
  const std::vector<MotionErrors> errors = motion_errors(mesh, poses, dual_quaternions(mesh), all);
  ASSERT_FALSE(poses.empty());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (poses[i].kind != MotionKind::twist) continue;
    EXPECT_NEAR(errors[i].of[0].ring_over_bind.value(), std::cos(poses[i].angle_rad / 2), 0.02);
  }
}

TEST(MotionErrors, VolumeAndFlippedTriangles) {
  const SkinnedMesh mesh = tube();
  const std::vector<MotionPose> poses = range_of_motion(mesh, kChain, kPlaces).poses;
  const Deformer truth = dual_quaternions(mesh);
  const auto changed = [&](const std::function<glm::dvec3(const glm::dvec3&)>& change) {
    return [=](const Pose& pose, Positions& out) {
      truth(pose, out);
      for (glm::dvec3& p : out) p = change(p);
    };
  };
  // Twice as large; and each point on the other side of the bone, where triangles face inwards.
  const std::vector<Deformer> all = {changed([](const glm::dvec3& p) { return p * 2.0; }),
                                     changed([](const glm::dvec3& p) { return glm::dvec3(p.x, -p.y, -p.z); }),
                                     changed([](const glm::dvec3& p) { return -p; })};
  const std::vector<MotionErrors> errors = motion_errors(mesh, poses, truth, all);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::vector<MotionFigures>& of = errors[i].of;
    EXPECT_NEAR(of[0].volume_over_truth.value(), 8, 1e-9);
    EXPECT_NEAR(of[0].ring_over_truth.value(), 2, 1e-12);
    EXPECT_EQ(of[0].flipped, errors[i].truth_flipped);
    EXPECT_NEAR(of[2].volume_over_truth.value(), -1, 1e-9);
    if (poses[i].kind == MotionKind::twist) {
      EXPECT_EQ(of[1].flipped, mesh.indices.size() / 3);
    }
  }
}

// The inside of the bend: at x the surface is a turn by share · θ of where it was, and its speed along x there,
// 1 - θ / 4 · r, is below 0 where the tube is short beside the angle and above where it is long.
TEST(MotionErrors, TellFoldsFromBends) {
  SkinnedMesh mesh = tube();
  const auto folded = [&] {
    std::size_t most = 0;
    const std::vector<MotionPose> poses = range_of_motion(mesh, kChain, kPlaces).poses;
    for (const MotionErrors& e : motion_errors(mesh, poses, dual_quaternions(mesh), {}))
      most = std::max(most, e.truth_flipped);
    return most;
  };
  for (glm::dvec3& p : mesh.positions) p.x *= 4;
  EXPECT_EQ(folded(), 0u);
  for (glm::dvec3& p : mesh.positions) p.x /= 16;
  EXPECT_GT(folded(), 0u);
}

TEST(WorseThanSsd, NamesThePosesThatAFitMakesWorse) {
  const SkinnedMesh mesh = tube();
  const std::vector<MotionPose> poses = range_of_motion(mesh, kChain, kPlaces).poses;
  const Deformer truth = dual_quaternions(mesh), plain = ssd(mesh);
  std::vector<std::size_t> counted;  // those in which the truth does not fold
  const std::vector<MotionErrors> errors = motion_errors(mesh, poses, truth, {});
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (errors[i].truth_flipped == 0) counted.push_back(i);
  ASSERT_GE(counted.size(), 4u);
  const auto worse = [&](double share, bool twists_only) {
    return worse_than_ssd(mesh, poses, truth, [&, share, twists_only](const Pose& pose, Positions& out) {
      Positions at_ssd;
      truth(pose, out);
      plain(pose, at_ssd);
      const bool is_twist = std::abs(pose[1][0].x - 1) < 1e-9;
      for (std::size_t v = 0; v < out.size(); ++v)
        out[v] += (at_ssd[v] - out[v]) * (twists_only && !is_twist ? 0.5 : share);
    });
  };
  EXPECT_TRUE(worse(1, false).empty());
  EXPECT_TRUE(worse(0.9, false).empty());
  EXPECT_EQ(worse(1.001, false), counted);
  EXPECT_EQ(worse(1.001, true), (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(worse(std::numeric_limits<double>::quiet_NaN(), true), (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_TRUE(worse_than_ssd(mesh, poses, truth, truth).empty());
  // A truth that is known nowhere judges nobody.
  const Deformer unknown = [&](const Pose&, Positions& out) {
    out.assign(mesh.positions.size(), glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
  };
  EXPECT_TRUE(worse_than_ssd(mesh, poses, unknown, truth).empty());
}

}  // namespace
}  // namespace marrow::deform
