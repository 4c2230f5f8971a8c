// Stitching and joint-dependent local deformations: by hand, and what they promise of bends and twists.
#include "deform/deformers.h"

#include <gtest/gtest.h>

#include "deform/cylinder.h"
#include "deform/deformers.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

using Weights = std::vector<std::vector<double>>;  // a column: a joint

// A strip along x, two vertices a column half a unit from the line, from -1.5 on.
SkinnedMesh strip(const Weights& columns) {
  SkinnedMesh mesh;
  mesh.joint_count = static_cast<std::uint32_t>(columns[0].size());
  for (std::uint32_t c = 0; c < columns.size(); ++c) {
    for (const double y : {-0.5, 0.5}) {
      mesh.positions.emplace_back(c - 1.5, y, 0);
      std::vector<Influence>& influences = mesh.influences.emplace_back();
      for (std::uint32_t j = 0; j < mesh.joint_count; ++j)
        if (columns[c][j] > 0) influences.push_back({j, columns[c][j]});
    }
    if (c == 0) continue;
    const std::uint32_t a = 2 * c - 2;
    mesh.indices.insert(mesh.indices.end(), {a, a + 2, a + 3, a, a + 3, a + 1});
  }
  return mesh;
}

// What the vertices of columns follow.
std::vector<std::string> followed(const SkinnedMesh& mesh) {
  std::vector<std::string> out;
  for (std::size_t v = 0; v < mesh.influences.size(); v += 2) {
    std::string text;
    for (const Influence& i : mesh.influences[v])
      text += std::to_string(i.joint) + (i.weight == 1 ? "" : i.weight == 0.5 ? "/2 " : "?");
    EXPECT_EQ(mesh.influences[v + 1].size(), mesh.influences[v].size());
    out.push_back(text);
  }
  return out;
}

TEST(Stitching, SharesTheEndOfASeamThatIsNearerToBoth) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(followed(stitched(strip({{1, 0}, {0.7, 0.3}, {0.45, 0.55}, {0, 1}}))), (Texts{"0", "0", "0/2 1/2 ", "1"}));
  EXPECT_EQ(followed(stitched(strip({{1, 0}, {0.55, 0.45}, {0.3, 0.7}, {0, 1}}))), (Texts{"0", "0/2 1/2 ", "1", "1"}));
  EXPECT_EQ(followed(stitched(strip({{1, 0}, {0.6, 0.4}, {0.4, 0.6}, {0, 1}}))), (Texts{"0", "0", "0/2 1/2 ", "1"}))
      << "of equal ends that of the later joint";
  EXPECT_EQ(followed(stitched(strip({{0.6, 0.4}, {0.9, 0.1}}))), (Texts{"0", "0"})) << "no seam";
  EXPECT_EQ(followed(stitched(strip({{1, 0, 0}, {0.3, 0.4, 0.3}, {0, 0.1, 0.9}}))), (Texts{"0", "0/2 1/2 ", "2"}))
      << "seams on both sides, and as much weight of either";
  EXPECT_EQ(followed(stitched(strip({{1, 0, 0}, {0.25, 0.4, 0.35}, {0, 0.1, 0.9}}))), (Texts{"0", "1/2 2/2 ", "2"}));
}

TEST(Stitching, PutsSeamsHalfWay) {
  const SkinnedMesh mesh = stitched(strip({{1, 0}, {0.55, 0.45}, {0, 1}}));
  const Pose pose = {matrix(turn(0, {0, 0, 1}), {}), matrix(turn(90, {0, 0, 1}), {})};
  const Positions p = at(ssd(mesh), pose);
  EXPECT_EQ(p[0], glm::dvec3(-1.5, -0.5, 0));
  EXPECT_LT(glm::length(p[2] - glm::dvec3(0, -0.5, 0)), 1e-12) << "from (-0.5, -0.5) and (0.5, -0.5)";
  EXPECT_LT(glm::length(p[4] - glm::dvec3(0.5, 0.5, 0)), 1e-12);
}

// Of the cylinder's joint 1: 1000 vertices at 1 from the line, and one on it.
TEST(JointOperators, TurnByAShareOfTheJointsTurn) {
  const SkinnedMesh mesh = cylinder();
  const double thickness = 1000.0 / 1001.0;
  const Positions p = at(joint_operators(mesh, kCylinderParents, kCylinderCentres), cylinder_pose(90 * kDegree, 0));
  std::size_t inside = 0, outside = 0;
  for (std::size_t v = 0; v + 2 < p.size(); ++v) {
    const glm::dvec3& bind = mesh.positions[v];
    const double x = std::min(1.0, std::abs(bind.x) / thickness), share = (1 - x * x * (3 - 2 * x)) / 2;
    const double angle = bind.x < 0 ? 90 * share : 90 * (1 - share);
    EXPECT_LT(glm::length(p[v] - turn(angle, {0, 0, 1}) * bind), 1e-12) << v;
    (x < 1 ? inside : outside) += 1;
  }
  EXPECT_EQ(inside, 10u * 40) << "five rings on either side are nearer than the limb is thick";
  EXPECT_EQ(outside, 40u * 40);
}

// Linear blending leaves cos 85° of the radius.
TEST(JointOperators, TwistsAreNotWrung) {
  const SkinnedMesh mesh = cylinder();
  const Positions p = at(joint_operators(mesh, kCylinderParents, kCylinderCentres), cylinder_pose(0, 170 * kDegree));
  for (std::size_t v = 0; v + 2 < p.size(); ++v) EXPECT_NEAR(glm::length(glm::dvec2(p[v].y, p[v].z)), 1, 1e-12) << v;
}

TEST(JointOperators, MoveWithTheRoot) {
  const SkinnedMesh mesh = cylinder();
  const Deformer deformer = joint_operators(mesh, kCylinderParents, kCylinderCentres);
  const glm::dquat rotation = turn(77, {1, -2, 3});
  const glm::dvec3 translation(30, -20, 5);
  Positions expected = at(deformer, kBent);
  for (glm::dvec3& v : expected) v = rotation * v + translation;
  EXPECT_LT(farthest(at(deformer, moved(rotation, translation, kBent)), expected), 1e-12);
}

double smooth_step_of(double x) {
  return x * x * (3 - 2 * x);
}

// The last bone is half a unit thick, and the one before it is one long: its operator reaches half a unit.
TEST(JointOperators, ReachAsFarAsTheLimbIsThick) {
  SkinnedMesh mesh = strip({{1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 1}});
  mesh.positions.emplace_back(0.5, 1.25, 0);
  mesh.influences.push_back({{1, 1.0}});
  const std::vector<glm::dvec3> centres = {{-1, 0, 0}, {-0.4, 0, 0}, {0.6, 0, 0}};
  const Positions p =
      at(joint_operators(mesh, {-1, 0, 1}, centres), {about({}, 0), about({}, 0), about(centres[2], 60)});
  EXPECT_EQ(p[0], mesh.positions[0]);
  EXPECT_EQ(p[2], mesh.positions[2]) << "far from it";
  const double share = (1 - smooth_step_of(0.1 / 0.5)) / 2;
  EXPECT_LT(glm::length(p[4] - transform(about(centres[2], 60 * share), mesh.positions[4])), 1e-12);
  EXPECT_LT(glm::length(p[6] - transform(about(centres[2], 60), mesh.positions[6])), 1e-12) << "beyond the domain";
  EXPECT_LT(glm::length(p[8] - transform(about(centres[2], 60 * share / 2), mesh.positions[8])), 1e-12)
      << "two and a half times as far from the line as the limb is thick";
}

// Two fingers on a hand, and a vertex of the hand between them, nearer to the first.
TEST(JointOperators, AVertexIsInOneDomain) {
  SkinnedMesh mesh;
  mesh.positions = {{-0.1, -0.05, 0}, {1, -0.7, 0}, {1, 0.1, 0}, {1, -0.1, 0}, {1, 0.7, 0}};
  mesh.influences = {{{0, 1.0}}, {{1, 1.0}}, {{1, 1.0}}, {{2, 1.0}}, {{2, 1.0}}};
  mesh.joint_count = 3;
  const std::vector<glm::dvec3> centres = {{-1, 0, 0}, {0, -0.3, 0}, {0, 0.3, 0}};
  const Deformer deformer = joint_operators(mesh, {-1, 0, 0}, centres);
  const Matrix still = about({}, 0);
  const glm::dvec3 bind = mesh.positions[0];
  EXPECT_LT(glm::length(at(deformer, {still, still, about(centres[2], 60)})[0] - bind), 1e-12);
  const glm::dvec3 by_first = at(deformer, {still, about(centres[1], 60), still})[0];
  EXPECT_GT(glm::length(by_first - bind), 0.05);
  EXPECT_NEAR(glm::length(by_first - centres[1]), glm::length(bind - centres[1]), 1e-12);
  EXPECT_LT(glm::length(at(deformer, {still, about(centres[1], 60), about(centres[2], -40)})[0] - by_first), 1e-12);
}

TEST(JointOperators, SegmentsAreRigidWithoutThem) {
  const SkinnedMesh mesh = cylinder();
  EXPECT_LT(farthest(at(joint_operators(mesh, {-1, -1}, kCylinderCentres), kBent), at(rigid(mesh), kBent)), 1e-12);
  SkinnedMesh point;
  point.positions = {{0, 0, 0}};
  point.influences = {{{1, 1.0}}};
  point.joint_count = 2;
  EXPECT_EQ(at(joint_operators(point, kCylinderParents, kCylinderCentres), kBent)[0], glm::dvec3(0))
      << "a bone without length";
  const Matrix flat(0.0);
  EXPECT_TRUE(is_finite(at(joint_operators(mesh, kCylinderParents, kCylinderCentres), {flat, flat})));
}

}  // namespace
}  // namespace marrow::deform
