// EigenSkin: arithmetic by hand, what principal components promise, truths that are known.
#include "deform/fit/eigen_skin.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include <gtest/gtest.h>

#include "deform/deformers.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

constexpr double kAlone = std::numeric_limits<double>::infinity();

// Two vertices, half of whose weight is on a joint that turns.
SkinnedMesh two_points() {
  SkinnedMesh mesh;
  mesh.positions = {{1, 0, 0}, {2, 0, 0}};
  mesh.influences = {{{0, 0.5}, {1, 0.5}}, {{0, 0.5}, {1, 0.5}}};
  mesh.joint_count = 2;
  return mesh;
}

Pose turned_by(double degrees) {
  return {matrix(turn(0, {0, 0, 1}), {}), matrix(turn(degrees, {0, 0, 1}), {})};
}

TEST(EigenSkin, InterpolatesByHand) {
  const SkinnedMesh mesh = two_points();
  EigenSkin skin;
  skin.parents = kCylinderParents;
  // 1 / 2σ² = 1: φ = exp(-sin²(half the angle)).
  skin.joints = {
      {1, {1}, {{{0, 0, 1}}, {{0, 0, 10}}}, {turn(90, {0, 0, 1})}, {{3, 0.5}}, std::sqrt(0.5)},
  };
  const auto height = [&](double degrees, std::size_t v) {
    return at(eigen_skin(mesh, skin), turned_by(degrees))[v].z;
  };
  EXPECT_NEAR(height(0, 1), 0, 1e-15);
  EXPECT_NEAR(height(90, 1), 8 * (1 - std::exp(-0.5)), 1e-12);
  EXPECT_NEAR(height(-90, 1), 8 * (1 - std::exp(-0.5)) * std::exp(-1.0), 1e-12);
  EXPECT_EQ(height(90, 0), 0) << "not in the support";
  const glm::dvec3 p = at(eigen_skin(mesh, skin), turned_by(90))[0];
  EXPECT_LT(glm::length(p - glm::dvec3(0.5, 0.5, 0)), 1e-12) << "SSD";
  EXPECT_EQ(displacements_per_vertex(mesh, skin), 1) << "two displacements on one of two vertices";
}

// Any four turns: with as many fields as examples each is reproduced. All of them are of one joint, so nothing adds up.
TEST(EigenSkin, IsExactInItsExamplesWithAsManyFields) {
  const SkinnedMesh mesh = cylinder();
  const Deformer truth = dual_quaternions(mesh);
  const std::vector<Pose> poses = {cylinder_pose(100 * kDegree, 0), cylinder_pose(0, 120 * kDegree),
                                   cylinder_pose(90 * kDegree, 90 * kDegree),
                                   cylinder_pose(40 * kDegree, 20 * kDegree)};
  const auto far_off = [&](std::size_t fields) {
    const EigenSkinOptions options{
        .most_fields = fields, .ridge = 1e-14, .least_displacement = 0, .widths = {0.5}, .together = kAlone};
    const EigenSkin skin = fit_eigen_skin(mesh, kCylinderParents, kCylinderCentres, training(poses, 1), truth, options);
    EXPECT_EQ(skin.joints.size(), 1u);
    EXPECT_LT(farthest(at(eigen_skin(mesh, skin), cylinder_pose(0, 0)), mesh.positions), 1e-12);
    double out = 0;
    for (const Pose& pose : poses) out = std::max(out, farthest(at(eigen_skin(mesh, skin), pose), at(truth, pose)));
    return out;
  };
  EXPECT_LT(far_off(4), 1e-6);
  EXPECT_GT(far_off(1), 1e-2);
}

// What is missing is a sum of two fields of length 0.05 and 0.1: the first component is the longer one.
TEST(EigenSkin, FieldsArePrincipalComponents) {
  const SkinnedMesh mesh = two_points();
  const glm::dvec3 lesser[] = {{0, 0, 0.03}, {0, 0, 0.04}}, greater[] = {{0, 0, -0.08}, {0, 0, 0.06}};
  const std::vector<Pose> poses = {turned_by(60), turned_by(-60), turned_by(70), turned_by(-70)};
  // lesser in both turns, greater with the sign of the turn: orthogonal over poses and vertices.
  const Deformer truth = [&](const Pose& pose, Positions& out) {
    ssd(mesh)(pose, out);
    const double sign = pose[1][0].y > 0 ? 1 : pose[1][0].y < 0 ? -1 : 0;
    for (std::size_t v = 0; v < 2; ++v) out[v] += lesser[v] * std::abs(sign) + greater[v] * sign;
  };
  const EigenSkinOptions options{.most_fields = 4, .ridge = 1e-14, .widths = {1}, .together = kAlone};
  const EigenSkin skin = fit_eigen_skin(mesh, kCylinderParents, kCylinderCentres, training(poses, 1), truth, options);
  ASSERT_EQ(skin.joints.size(), 1u);
  const EigenJoint& joint = skin.joints[0];
  EXPECT_EQ(joint.joint, 1u);
  EXPECT_EQ(joint.support, (std::vector<std::uint32_t>{0, 1}));
  ASSERT_EQ(joint.fields.size(), 2u) << "what is missing has two dimensions";
  for (const Positions& field : joint.fields)
    EXPECT_NEAR(glm::dot(field[0], field[0]) + glm::dot(field[1], field[1]), 1, 1e-12);
  EXPECT_NEAR(std::abs(joint.fields[0][0].z), 0.8, 1e-9);
  EXPECT_NEAR(std::abs(joint.fields[1][0].z), 0.6, 1e-9);
  EXPECT_LT(joint.fields[0][0].z * joint.fields[0][1].z, 0);
  EXPECT_GT(joint.fields[1][0].z * joint.fields[1][1].z, 0);
  for (const Pose& pose : poses) EXPECT_LT(farthest(at(eigen_skin(mesh, skin), pose), at(truth, pose)), 1e-9);
}

// A chain of three joints, of which the last turns about its own place: what hangs on a joint turns with it.
TEST(EigenSkin, TurnsJointsAloneAboutTheirPlaces) {
  SkinnedMesh mesh;
  mesh.positions = {{1.5, 0, 0}, {2.5, 0, 0}};
  mesh.influences = {{{0, 0.5}, {1, 0.5}}, {{1, 0.5}, {2, 0.5}}};
  mesh.joint_count = 3;
  const std::vector<glm::dvec3> centres = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::vector<Pose> poses = {{matrix(turn(0, {0, 0, 1}), {}), matrix(turn(90, {0, 0, 1}), {1, -1, 0}),
                                    matrix(turn(120, {0, 0, 1}), {2, -2, 0})}};
  std::vector<Pose> asked;
  const Deformer truth = [&](const Pose& pose, Positions& out) {
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    asked.push_back(pose);
    ssd(mesh)(pose, out);
  };
  const EigenSkin skin = fit_eigen_skin(mesh, {-1, 0, 1}, centres, training(poses, 1), truth);
  EXPECT_TRUE(skin.joints.empty()) << "SSD misses nothing";
  ASSERT_EQ(asked.size(), 3u) << "two joints alone, and the pose";
  asked.pop_back();
  std::ranges::sort(asked, {}, [](const Pose& p) { return p[1][0].y; });
  const auto far_off = [](const Matrix& m, const glm::dvec3& v, const glm::dvec3& expected) {
    return glm::length(transform(m, v) - expected);
  };
  // The last by 30° about (2, 0, 0); then the middle by 90° about (1, 0, 0), and the last with it.
  EXPECT_LT(far_off(asked[0][2], {3, 0, 0}, {2 + std::cos(30 * kDegree), 0.5, 0}), 1e-12);
  EXPECT_LT(far_off(asked[0][1], {3, 0, 0}, {3, 0, 0}), 1e-12);
  for (const std::size_t j : {1u, 2u}) EXPECT_LT(far_off(asked[1][j], {3, 0, 0}, {1, 2, 0}), 1e-12);
}

// The truth raises vertices by how far the last joint is turned from the first. The middle one alone does so, and the
// last one alone; together they turn against each other, and do not.
TEST(EigenSkin, IsFittedToJointsThatTurnTogether) {
  SkinnedMesh mesh;
  mesh.positions = {{1, 0, 0}, {2, 0, 0}};
  mesh.influences = {{{0, 0.4}, {1, 0.3}, {2, 0.3}}, {{0, 0.4}, {1, 0.3}, {2, 0.3}}};
  mesh.joint_count = 3;
  const std::vector<int> parents = {-1, 0, 1};
  const std::vector<glm::dvec3> centres(3, glm::dvec3(0));
  const auto bent = [](double degrees) {
    return Pose{matrix(turn(0, {0, 0, 1}), {}), matrix(turn(degrees, {0, 0, 1}), {}), matrix(turn(0, {0, 0, 1}), {})};
  };
  // How far the last joint is turned from the first.
  const Deformer truth = [&](const Pose& pose, Positions& out) {
    ssd(mesh)(pose, out);
    for (glm::dvec3& v : out) v.z += 1 - pose[2][0].x;
  };
  const std::vector<Pose> poses = {bent(30), bent(45), bent(60), bent(75)}, held = {bent(38), bent(52), bent(67)};
  const auto share = [&](double together) {
    const EigenSkin skin = fit_eigen_skin(mesh, parents, centres, training(poses, 1), truth, {.together = together});
    EXPECT_EQ(skin.joints.size(), 2u);
    return rms(eigen_skin(mesh, skin), truth, held);
  };
  const double alone = share(kAlone);
  EXPECT_GT(alone, 0.5) << "each raises the vertex, and together they do not";
  EXPECT_LT(share(1e-6), 0.02 * alone);
}

TEST(EigenSkin, MovesWithTheRoot) {
  const SkinnedMesh mesh = cylinder();
  const EigenSkin skin = fit_eigen_skin(mesh, kCylinderParents, kCylinderCentres,
                                        training(random_cylinder_poses(12, 1), 4), dual_quaternions(mesh));
  ASSERT_EQ(skin.joints.size(), 1u);
  const glm::dquat rotation = turn(77, {1, -2, 3});
  const glm::dvec3 translation(30, -20, 5);
  const Pose bent = cylinder_pose(80 * kDegree, 50 * kDegree);
  Positions expected = at(eigen_skin(mesh, skin), bent);
  for (glm::dvec3& v : expected) v = rotation * v + translation;
  EXPECT_LT(farthest(at(eigen_skin(mesh, skin), moved(rotation, translation, bent)), expected), 1e-10);
}

TEST(EigenSkin, SharpensPosesHeldOutWithEachField) {
  const SkinnedMesh mesh = cylinder();
  const Deformer truth = dual_quaternions(mesh), reference = ssd(mesh);
  const std::vector<Pose> held = random_cylinder_poses(100, 20);
  const auto share = [&](std::size_t fields) {
    const EigenSkin skin = fit_eigen_skin(mesh, kCylinderParents, kCylinderCentres,
                                          training(random_cylinder_poses(30, 10), 5), truth, {.most_fields = fields});
    return rms(eigen_skin(mesh, skin), truth, held) / rms(reference, truth, held);
  };
  const double two = share(2), eight = share(8);
  EXPECT_LT(two, 0.6);
  EXPECT_LT(eight, 0.2);
  EXPECT_LT(eight, two);
}

// Nothing that turns, nothing that is missing, nothing that is finite, no pose: SSD.
TEST(EigenSkin, LeavesSsdWhereNothingIsToBeLearnt) {
  const SkinnedMesh mesh = cylinder();
  const auto fitted = [&](const std::vector<Pose>& poses, const Deformer& truth) {
    return fit_eigen_skin(mesh, kCylinderParents, kCylinderCentres, training(poses, 1), truth);
  };
  const Deformer nowhere = [&](const Pose&, Positions& out) { out.assign(mesh.positions.size(), glm::dvec3(NAN)); };
  EXPECT_TRUE(fitted({cylinder_pose(0, 0)}, dual_quaternions(mesh)).joints.empty());
  EXPECT_TRUE(fitted(random_cylinder_poses(5, 1), ssd(mesh)).joints.empty());
  EXPECT_TRUE(fitted(random_cylinder_poses(5, 1), nowhere).joints.empty());
  const EigenSkin none = fitted({}, dual_quaternions(mesh));
  EXPECT_TRUE(none.joints.empty());
  const Pose bent = cylinder_pose(1, 1);
  EXPECT_LT(farthest(at(eigen_skin(mesh, none), bent), at(ssd(mesh), bent)), 1e-12);
}

}  // namespace
}  // namespace marrow::deform
