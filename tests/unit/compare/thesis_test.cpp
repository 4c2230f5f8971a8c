// What the thesis's comparison reckons: smoothness against surfaces whose curvature is known, labour and claims by
// hand.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "compare/thesis/thesis.h"

namespace marrow::tools {
namespace {

using deform::SkinnedMesh;

// n × n vertices of what `at` makes of (0 … 1, 0 … 1).
template <class At>
SkinnedMesh grid(std::uint32_t n, At at) {
  SkinnedMesh mesh;
  mesh.joint_count = 2;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < n; ++k) {
      mesh.positions.push_back(at(static_cast<double>(i) / (n - 1), static_cast<double>(k) / (n - 1)));
      mesh.influences.push_back({{0, 0.5}, {1, 0.5}});
    }
  for (std::uint32_t i = 0; i + 1 < n; ++i)
    for (std::uint32_t k = 0; k + 1 < n; ++k) {
      const std::uint32_t a = i * n + k;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + n + 1, a, a + n + 1, a + n});
    }
  return mesh;
}

// At a vertex well inside.
double middle_curvature(const SkinnedMesh& mesh, std::uint32_t n) {
  return mean_curvatures(mesh.positions, mesh.indices)[n / 2 * n + n / 2];
}

TEST(Smoothness, MeanCurvatureOfKnownSurfaces) {
  constexpr std::uint32_t kSide = 41;
  const SkinnedMesh plane = grid(kSide, [](double u, double v) { return glm::dvec3(u, 2 * v, 3 * u - v); });
  EXPECT_NEAR(middle_curvature(plane, kSide), 0, 1e-9);
  const SkinnedMesh tube =
      grid(kSide, [](double u, double v) { return glm::dvec3(2 * std::cos(v), 2 * std::sin(v), u); });
  EXPECT_NEAR(middle_curvature(tube, kSide), 0.25, 0.001) << "1 / 2r";
  const SkinnedMesh ball = grid(kSide, [](double u, double v) {
    const double a = 0.7 + u * 0.6, b = v * 0.6;
    return 2.0 * glm::dvec3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
  });
  EXPECT_NEAR(middle_curvature(ball, kSide), 0.5, 0.01) << "1 / r";
}

// A sheet with a ridge, folded along a line on either side of it: what the ridge has in the bind pose does not count.
TEST(Smoothness, TheSharpestEdgeIsFoundAmongAll) {
  const SkinnedMesh mesh = grid(9, [](double u, double v) { return glm::dvec3(8 * u, 8 * v, u == 0.5 ? 2 : 0); });
  const Shape shape(mesh);
  std::size_t tried = 0;
  for (const double left_deg : {0.0, 20.0, 70.0, 150.0, 179.0})
    for (const double right_deg : {0.0, 30.0, 69.0, 120.0, 180.0}) {
      deform::Positions p = mesh.positions;
      const double left = glm::radians(left_deg), right = glm::radians(right_deg);
      for (glm::dvec3& v : p) {
        if (v.x < 2) v = {2 - (2 - v.x) * std::cos(left), v.y, v.z + (2 - v.x) * std::sin(left)};
        if (v.x > 6) v = {6 + (v.x - 6) * std::cos(right), v.y, v.z + (v.x - 6) * std::sin(right)};
      }
      EXPECT_NEAR(glm::degrees(shape.sharpest_rad(p)), std::max(left_deg, right_deg), 1e-5) << left_deg << right_deg;
      ++tried;
    }
  EXPECT_EQ(tried, 25u);
}

// A sheet that folds along its middle by 40°: only edges there jump.
TEST(Smoothness, JumpsByHand) {
  constexpr std::uint32_t kSide = 5;
  const auto flat = [](double u, double v) { return glm::dvec3(4 * u, 4 * v, 0); };
  const SkinnedMesh mesh = grid(kSide, flat);
  const Shape shape(mesh);
  deform::RangeOfMotion motion;
  motion.poses.resize(2);
  for (deform::MotionPose& pose : motion.poses) {
    pose.turns = std::make_shared<const std::vector<char>>(std::vector<char>{0, 1});
    pose.axis = {0, 1, 0};
  }
  motion.poses[1].kind = deform::MotionKind::bend;
  const double fold = glm::radians(40.0);
  const deform::Deformer folded = [&](const deform::Pose&, deform::Positions& out) {
    out = mesh.positions;
    for (glm::dvec3& p : out)
      if (p.x > 2) p = {2 + (p.x - 2) * std::cos(fold), p.y, (p.x - 2) * std::sin(fold)};
  };
  const Smoothness s = smoothness(shape, motion, true, folded);
  EXPECT_NEAR(s.largest_jump_deg, 40, 1e-6);
  // Of 4 × 4 squares of two triangles, 40 edges have two: 16 diagonals and 24 between squares, 4 of them on the fold.
  ASSERT_EQ(shape.hinges.size(), 40u);
  EXPECT_NEAR(s.rms_jump_deg, 40 * std::sqrt(4.0 / 40), 1e-6);
  // Where the fold is nobody meets: it does not count.
  SkinnedMesh apart = mesh;
  for (std::size_t v = 0; v < apart.influences.size(); ++v)
    if (mesh.positions[v].x >= 1) apart.influences[v] = {{1, 1.0}};
  const Shape shape_apart(apart);
  EXPECT_EQ(smoothness(shape_apart, motion, true, folded).largest_jump_deg, 0);
  const deform::Deformer still = [&](const deform::Pose&, deform::Positions& out) { out = mesh.positions; };
  EXPECT_EQ(smoothness(shape, motion, false, still).largest_jump_deg, 0);
  motion.poses.resize(1);
  EXPECT_EQ(smoothness(shape, motion, false, folded).largest_jump_deg, 0) << "no bends";
}

TEST(Labour, ByHand) {
  Study study;
  study.source.mesh = grid(2, [](double u, double v) { return glm::dvec3(u, v, 0); });
  study.source.mesh.influences[0] = {{0, 1.0}};
  EXPECT_EQ(labour_of("rigid", study, 0).numbers_per_vertex, 1);
  EXPECT_EQ(labour_of("ssd", study, 0).numbers_per_vertex, 0.75) << "three vertices of two joints, one of one";
  EXPECT_EQ(labour_of("psd", study, 0).poses, 0u) << "shapes of another deformer";
  EXPECT_EQ(labour_of("psd", study, 7).poses, 7u);
  EXPECT_EQ(labour_of("psd", study, 7).files, 1u);
  EXPECT_EQ(labour_of("ssd", study, 7).poses, 0u);
}

TEST(Claims, FollowTheFigures) {
  Thesis thesis;
  thesis.studies.push_back({"one", 10, 2, {}, {}});
  for (const auto& [name, of_ssd] : {std::pair("as_fit", 0.5), std::pair("as_helpers_fit5", 0.25)}) {
    ThesisRow row;
    row.algorithm = name;
    row.held_of_ssd = of_ssd;
    thesis.studies[0].rows.push_back(row);
  }
  thesis.rates = {{"ssd", "ubo", false, {100, 200, 300, 400}},
                  {"as", "ubo", false, {90, 190, 270, 400}},
                  {"as", "texture", false, {1, 1, 1, 1}}};
  const std::vector<Claim> slower = claims(thesis);
  EXPECT_EQ(slower[0].holds, "no: 0.95 times as many, the median of 4 paths and sizes; 0.90 to 1.00");
  EXPECT_EQ(slower[1].holds.find("yes"), 0u) << slower[1].holds;
  EXPECT_NE(slower[1].holds.find("fitted one 0.50; with helpers one 0.25"), std::string::npos) << slower[1].holds;
  for (double& rate : thesis.rates[1].frames_per_s) rate *= 2;
  thesis.studies[0].rows[1].held_of_ssd = 1.5;
  EXPECT_EQ(claims(thesis)[0].holds.find("yes: 1.9"), 0u);
  EXPECT_EQ(claims(thesis)[1].holds.find("no"), 0u);
  const std::string page = thesis_page(thesis);
  EXPECT_NE(page.find("<h2>Table 3: frames a second</h2>"), std::string::npos);
  EXPECT_NE(page.find("<td data-value=\"180\">180</td>"), std::string::npos);
  EXPECT_EQ(page.find("://"), std::string::npos);
}

}  // namespace
}  // namespace marrow::tools
