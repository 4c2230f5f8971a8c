#include "deform/simplify/simplify.h"

#include <algorithm>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "deform/deformers.h"
#include "deform/simplify/surface_error.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

// A flat n × n grid of squares, two triangles each.
struct Grid {
  Positions positions;
  std::vector<std::uint32_t> indices;
};
Grid grid(std::uint32_t n) {
  Grid out;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) out.positions.emplace_back(x, y, 0);
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
      for (const std::uint32_t v : {a, b, d, a, d, c}) out.indices.push_back(v);
    }
  return out;
}

double area(const Positions& at, const std::vector<std::uint32_t>& indices) {
  double sum = 0;
  for (std::size_t i = 0; i < indices.size(); i += 3)
    sum += glm::cross(at[indices[i + 1]] - at[indices[i]], at[indices[i + 2]] - at[indices[i]]).z / 2;
  return sum;
}

Positions placed(const SimplerSurface& surface, const Positions& source) {
  Positions out;
  for (const Combination& c : surface.vertices) out.push_back(combined(c, source));
  return out;
}

// What is flat needs its four corners and no more.
TEST(Simplify, AFlatSquareBecomesTwoTriangles) {
  const Grid g = grid(8);
  for (const Placement placement : {Placement::ends, Placement::line}) {
    const std::vector<SimplerSurface> out = simplify(plain(81, g.indices), {{g.positions}}, {40, 2}, placement);
    ASSERT_EQ(out.size(), 2u);
    EXPECT_EQ(out[0].indices.size(), 40u * 3);
    ASSERT_EQ(out[1].indices.size(), 2u * 3);
    for (const SimplerSurface& level : out) EXPECT_NEAR(area(placed(level, g.positions), level.indices), 64, 1e-9);
    std::set<std::uint32_t> corners;
    for (const Combination& c : out[1].vertices) corners.insert(c.front().vertex);
    EXPECT_EQ(corners, (std::set<std::uint32_t>{0, 8, 72, 80}));
  }
}

// Four triangles of a tetrahedron cannot be fewer.
TEST(Simplify, TopologyStays) {
  const Positions at = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::uint32_t> faces = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  const std::vector<SimplerSurface> out = simplify(plain(4, faces), {{at}}, {1}, Placement::ends);
  EXPECT_EQ(out[0].indices.size(), 12u);
}

// A fold that only a pose has: the bind pose alone would let it go, the two shapes keep it.
TEST(Simplify, KeepsWhatOnlyAPoseShows) {
  const Grid g = grid(8);
  Positions folded = g.positions;
  for (glm::dvec3& v : folded)
    if (v.x > 4) v = {4, v.y, v.x - 4};
  const std::vector<SimplerSurface> out =
      simplify(plain(81, g.indices), {{g.positions, 0.5}, {folded, 0.5}}, {4}, Placement::ends);
  ASSERT_EQ(out[0].indices.size(), 4u * 3);
  std::size_t on_the_fold = 0;
  for (const Combination& c : out[0].vertices) on_the_fold += g.positions[c.front().vertex].x == 4 ? 1u : 0u;
  EXPECT_EQ(on_the_fold, 2u);
}

// Halves with textures of their own: each point on the line between them is two vertices, and the line stays.
TEST(Simplify, SeamsStay) {
  const Grid g = grid(8);
  SeamedSurface surface = plain(81, g.indices);
  std::vector<std::uint32_t> right(81, 0);
  for (std::uint32_t p = 0; p < 81; ++p) {
    if (g.positions[p].x != 4) continue;
    right[p] = static_cast<std::uint32_t>(surface.point_of.size());
    surface.point_of.push_back(p);
    surface.chart_of.push_back(100 + p);
    surface.normals.emplace_back(0, 0, 1);
  }
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, g.positions[surface.indices[i + c]].x);
    for (std::size_t c = 0; c < 3; ++c)
      if (most > 4 && right[surface.indices[i + c]] != 0) surface.indices[i + c] = right[surface.indices[i + c]];
  }
  const std::vector<SimplerSurface> out = simplify(surface, {{g.positions}}, {4}, Placement::ends);
  ASSERT_EQ(out[0].indices.size(), 4u * 3);
  double left_area = 0;
  for (std::size_t i = 0; i < out[0].indices.size(); i += 3) {
    Positions at;
    bool is_right = false, is_left = false;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = out[0].vertices[out[0].indices[i + c]].front().vertex;
      at.push_back(g.positions[surface.point_of[v]]);
      is_right = is_right || v > 80 || at.back().x > 4;
      is_left = is_left || (v <= 80 && at.back().x <= 4);
    }
    EXPECT_NE(is_left, is_right) << "a triangle has one texture";
    if (is_left) left_area += area(at, {0, 1, 2});
  }
  EXPECT_NEAR(left_area, 32, 1e-9);
}

// Normals of a crease do not hold a vertex; where corners go they take the nearest normal there.
TEST(Simplify, CornersTakeTheNearestNormal) {
  // A strip of two squares a row, bent by 90° along its middle, flat-shaded there.
  SeamedSurface surface;
  Positions at;
  const std::uint32_t rows = 4;
  for (std::uint32_t r = 0; r <= rows; ++r) {
    const double y = r;
    at.insert(at.end(), {{-1, y, 0}, {0, y, 0}, {0, y, -1}});
    for (const std::uint32_t p : {3 * r, 3 * r + 1, 3 * r + 1, 3 * r + 2}) {
      surface.point_of.push_back(p);
      surface.chart_of.push_back(p);
    }
    surface.normals.insert(surface.normals.end(), {{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}});
  }
  for (std::uint32_t r = 0; r < rows; ++r)
    for (const std::uint32_t side : {0u, 2u}) {
      const std::uint32_t a = 4 * r + side, b = a + 1, c = a + 4, d = a + 5;
      surface.indices.insert(surface.indices.end(), {a, b, d, a, d, c});
    }
  const std::vector<SimplerSurface> out = simplify(surface, {{at}}, {4}, Placement::ends);
  ASSERT_EQ(out[0].indices.size(), 4u * 3);
  for (std::size_t i = 0; i < out[0].indices.size(); i += 3) {
    glm::dvec3 p[3], n[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = out[0].vertices[out[0].indices[i + c]].front().vertex;
      p[c] = at[surface.point_of[v]];
      n[c] = surface.normals[v];
    }
    const glm::dvec3 face = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    for (const glm::dvec3& normal : n) EXPECT_NEAR(glm::dot(face, normal), 1, 1e-12);
  }
}

// Three triangles on one edge, two cones tip to tip, a triangle without area, points in one place: nothing breaks.
TEST(Simplify, TakesWhatIsNoManifold) {
  const Positions at = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}, {2, 2, 2}, {3, 2, 2}, {0, 0, 0}};
  const std::vector<std::uint32_t> faces = {0, 1, 2, 0, 1, 3, 0, 1, 4, 2, 5, 6, 0, 0, 1, 7, 2, 3, 5, 5, 5};
  const std::vector<SimplerSurface> out = simplify(plain(8, faces), {{at}}, {1}, Placement::line);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_GE(out[0].indices.size(), 3u);
  for (const std::uint32_t v : out[0].indices) ASSERT_LT(v, out[0].vertices.size());
  EXPECT_TRUE(simplify(plain(0, {}), {{{}}}, {1}, Placement::ends)[0].indices.empty());
}

// A fan of 20 000 triangles round one point, which would cost the cube of that.
TEST(Simplify, ManyTrianglesAtAPointTakeNoTime) {
  constexpr std::uint32_t kRim = 20000;
  Positions at = {{0, 0, 0}};
  std::vector<std::uint32_t> faces;
  for (std::uint32_t i = 0; i < kRim; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRim;
    at.emplace_back(std::cos(angle), std::sin(angle), 0);
    faces.insert(faces.end(), {0, i + 1, (i + 1) % kRim + 1});
  }
  const std::vector<SimplerSurface> out = simplify(plain(kRim + 1, faces), {{at}}, {100}, Placement::ends);
  ASSERT_EQ(out[0].indices.size(), 100u * 3);
  EXPECT_NEAR(area(placed(out[0], at), out[0].indices), std::numbers::pi, 0.01);
}

// The cylinder in its poses: what is measured, and that it is linear.
class SimplifyCylinder : public testing::Test {
 protected:
  const SkinnedMesh mesh_ = cylinder();
  const Coordinates lifted_ = lift(mesh_);
  std::vector<Pose> poses_ = [] {
    std::vector<Pose> out = random_cylinder_poses(30, 7);
    out.insert(out.begin(), cylinder_pose(0, 0));
    return out;
  }();
  const SeamedSurface surface_ = plain(mesh_.positions.size(), mesh_.indices);

  std::vector<Shape> shapes(const Coordinates& of, std::size_t most) const {
    std::vector<Shape> out;
    for (const Representative& r : representative_poses(ssd(mesh_), poses_, 0, most))
      out.push_back({at(animation_space(of), poses_[r.pose]), r.weight});
    return out;
  }
  Coordinates coordinates_of(const SimplerSurface& level) const {
    Coordinates out;
    for (const Combination& c : level.vertices) out.push_back(combined(c, lifted_));
    return out;
  }
  SurfaceError error_of(const SimplerSurface& level) const {
    const Coordinates less = coordinates_of(level);
    std::vector<Shape> simpler;
    for (const Representative& r : representative_poses(ssd(mesh_), poses_, 0, 8))
      simpler.push_back({at(animation_space(less), poses_[r.pose]), r.weight});
    return surface_error(ssd(mesh_), animation_space(less), anchor(level, shapes(lifted_, 8), simpler), level.home,
                         poses_);
  }
};

TEST_F(SimplifyCylinder, PosingThenCollapsingIsCollapsingThenPosing) {
  const SimplerSurface level =
      simplify(surface_, shapes(lifted_, 8), {mesh_.indices.size() / 12}, Placement::line).front();
  EXPECT_EQ(level.indices.size() / 3, mesh_.indices.size() / 12);
  std::size_t blended = 0;
  for (const Combination& c : level.vertices) {
    double sum = 0;
    for (const Share& s : c) {
      EXPECT_GE(s.share, 0);
      sum += s.share;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    blended += c.size() > 1 ? 1u : 0u;
  }
  EXPECT_GT(blended, 20u);
  for (const Pose& pose : poses_)
    EXPECT_LT(farthest(at(animation_space(coordinates_of(level)), pose), placed(level, at(ssd(mesh_), pose))), 1e-11);
}

TEST_F(SimplifyCylinder, PosesMakeItBetterThanTheBindPose) {
  const std::vector<std::size_t> target = {mesh_.indices.size() / 12};
  const std::vector<Shape> all = shapes(lifted_, 16);
  const SurfaceError by_poses = error_of(simplify(surface_, all, target, Placement::ends).front());
  const SurfaceError by_bind = error_of(simplify(surface_, {all.front()}, target, Placement::ends).front());
  EXPECT_GT(by_poses.rms, 0);
  EXPECT_LT(by_poses.rms, 0.7 * by_bind.rms);
  EXPECT_GE(by_poses.worst, by_poses.rms);
}

TEST_F(SimplifyCylinder, NothingIsLostWhereNothingIsAsked) {
  const SimplerSurface level = simplify(surface_, shapes(lifted_, 2), {mesh_.indices.size()}, Placement::ends).front();
  EXPECT_EQ(level.indices, mesh_.indices);
  EXPECT_LT(error_of(level).worst, 1e-12);
}

// A pose and the same pose elsewhere are one.
TEST_F(SimplifyCylinder, RepresentativesDoNotCareWhereACharacterStands) {
  const Pose bent = cylinder_pose(90 * kDegree, 0);
  const std::vector<Pose> poses = {cylinder_pose(0, 0), bent, moved(turn(70, {1, 2, 3}), {5, 0, 1}, bent), bent};
  const std::vector<Representative> out = representative_poses(ssd(mesh_), poses, 0, 2);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0].pose, 0u);
  EXPECT_NEAR(out[0].weight, 0.25, 1e-12);
  EXPECT_NEAR(out[1].weight, 0.75, 1e-12);
}

// By hand: a square whose middle vertex goes 1 up in a pose, and is left out.
TEST(SurfaceError, IsTheDistanceFromTheAnchor) {
  const Grid g = grid(2);
  SkinnedMesh mesh;
  mesh.positions = g.positions;
  mesh.indices = g.indices;
  mesh.joint_count = 2;
  for (std::uint32_t p = 0; p < 9; ++p) mesh.influences.push_back({{p == 4 ? 1u : 0u, 1.0}});
  SimplerSurface level = simplify(plain(9, g.indices), {{g.positions}}, {2}, Placement::ends).front();
  ASSERT_EQ(level.indices.size(), 6u);
  SkinnedMesh less;
  less.joint_count = 2;
  for (const Combination& c : level.vertices) {
    less.positions.push_back(g.positions[c.front().vertex]);
    less.influences.push_back({{0, 1.0}});
  }
  const Pose rest(2, Matrix(1.0));
  Pose up = rest;
  up[1][3] = {0, 0, 1};
  const std::vector<Anchor> anchors = anchor(level, {{mesh.positions}}, {{less.positions}});
  const SurfaceError error = surface_error(ssd(mesh), ssd(less), anchors, level.home, {rest, up});
  EXPECT_NEAR(error.worst, 1, 1e-12);
  EXPECT_NEAR(error.rms, std::sqrt(1.0 / 18), 1e-12);  // one of nine vertices in one of two poses
}

}  // namespace
}  // namespace marrow::deform
