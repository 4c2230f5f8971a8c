// Normals through tangents against closed forms, and against the derivatives' definition in double precision.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/surface.h"

namespace marrow {
namespace {

using test::Map;
using test::SurfaceVertex;
using test::TestSurface;
using test::Triangle;
using test::Vec3;

Vec3 three(const std::vector<float>& v, std::size_t slot, std::size_t stride = 3) {
  return {static_cast<double>(v[slot * stride]), static_cast<double>(v[slot * stride + 1]),
          static_cast<double>(v[slot * stride + 2])};
}

struct Skinned {
  std::vector<float> coordinates, tau, positions, normals, tangents;
  explicit Skinned(const Mesh& mesh)
      : coordinates(as_coordinate_count(mesh.geometry)),
        tau(as_tangent_count(mesh.geometry)),
        positions(std::size_t{3} * mesh.geometry.slot_count),
        normals(positions.size()),
        tangents(std::size_t{4} * mesh.geometry.slot_count) {
    EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  }
  SkinOutput output() { return {positions, normals, tangents}; }
};

std::vector<Affine> entries(const std::vector<Map>& palette) {
  std::vector<Affine> out;
  for (const Map& m : palette) out.push_back(test::to_affine(m));
  return out;
}

void derive(const std::vector<AsPart>& parts) {
  std::vector<std::uint32_t> scratch(as_tangent_scratch_bytes(parts) / 4);
  ASSERT_EQ(scratch.size() * 4, as_tangent_scratch_bytes(parts));
  ASSERT_EQ(as_tangents(parts, {reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * 4}), Status::ok);
}

Skinned skin(const Mesh& mesh, const std::vector<Map>& palette) {
  Skinned out(mesh);
  derive({{&mesh, out.coordinates, out.tau}});
  EXPECT_EQ(skin_as(mesh, out.coordinates, entries(palette), out.output(), out.tau), Status::ok);
  return out;
}

// The whole of a mesh's vertices through one and the same map.
void expect_map(const test::Sheet& sheet, const TestSurface& surface, const Map& map) {
  const Mesh mesh = surface.view();
  const Skinned got = skin(mesh, std::vector<Map>(mesh.joint_count, map));
  const bool mirrors = test::determinant(map) < 0;
  for (std::size_t v = 0; v < sheet.vertices.size(); ++v) {
    const std::uint32_t slot = surface.slot(v);
    const test::TestVertex& vertex = sheet.vertices[v].vertex;
    EXPECT_LT(test::angle_deg(three(got.normals, slot), test::normal(map, vertex.normal)), 0.01) << v;
    EXPECT_NEAR(test::length(three(got.normals, slot)), 1, 1e-6);
    // The tangent's part in the surface.
    const double along = test::dot(vertex.tangent, vertex.normal);
    Vec3 in_surface = vertex.tangent;
    for (std::size_t c = 0; c < 3; ++c) in_surface[c] -= along * vertex.normal[c];
    EXPECT_LT(test::angle_deg(three(got.tangents, slot, 4), test::direction(map, in_surface)), 0.01) << v;
    EXPECT_EQ(got.tangents[slot * 4 + 3], static_cast<float>(mirrors ? -vertex.sign : vertex.sign)) << v;
  }
}

TEST(AsTangents, RotationUnevenScaleAndMirrorAreTheInverseTranspose) {
  const test::Quat turn = test::axis_angle({1, 2, -3}, 1.25);
  const Vec3 scales[] = {{1, 1, 1}, {0.5, 1, 2}, {1, -1, 1}};
  int cases = 0;
  for (const bool residuals : {false, true}) {
    const test::Sheet sheet = test::make_sheet(3, 8, 9, 8, residuals);
    const TestSurface surface(sheet.vertices, sheet.triangles, std::vector<Map>(9), residuals);
    expect_map(sheet, surface, Map{});
    for (const Vec3& scale : scales) {
      expect_map(sheet, surface, test::from_trs({10, -20, 30}, turn, scale));
      ++cases;
    }
  }
  EXPECT_EQ(cases, 6);
}

// As the cooker merges runs: a joint without a weight, before the last one.
TEST(AsTangents, JointsWithoutAWeightChangeNothing) {
  test::Random random(5);
  std::vector<Map> palette;
  for (int j = 0; j < 9; ++j)
    palette.push_back(test::from_trs({0.1 * j, 0, -0.05 * j}, test::axis_angle({1, 2, -3}, 0.2 * j), {1, 1, 1}));
  std::size_t padded = 0;
  for (const bool residuals : {false, true}) {
    const test::Sheet sheet = test::make_sheet(3, 8, 9, 6, residuals);
    std::vector<SurfaceVertex> vertices = sheet.vertices;
    for (SurfaceVertex& v : vertices) {
      const auto joint = static_cast<std::uint16_t>(random.below(9));
      if (std::find(v.set.begin(), v.set.end(), joint) != v.set.end()) continue;
      v.set.insert(v.set.begin(), joint);
      v.vertex.weights.insert(v.vertex.weights.begin(), 0.0);
      if (residuals) v.vertex.residual.insert(v.vertex.residual.begin(), std::array<double, 4>{});
      ++padded;
    }
    const TestSurface surface(sheet.vertices, sheet.triangles, std::vector<Map>(9), residuals),
        with_more(vertices, sheet.triangles, std::vector<Map>(9), residuals);
    const Skinned got = skin(surface.view(), palette), more = skin(with_more.view(), palette);
    for (std::size_t v = 0; v < vertices.size(); ++v)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t a = 3 * surface.slot(v) + c, b = 3 * with_more.slot(v) + c;
        EXPECT_EQ(got.positions[a], more.positions[b]) << v;
        EXPECT_NEAR(got.normals[a], more.normals[b], 1e-5) << v;  // sums over copies have another order
      }
  }
  EXPECT_GT(padded, 50u);
}

// The definition: of each triangle round a vertex the linear map that takes its edges in the bind pose to those in the
// pose, and the triangles' normal to nothing; the mean by area as seen along the mean normal. `blend` maps what a
// direction has beside.
struct Reference {
  std::vector<SurfaceVertex> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> place;  // of a vertex: the first one that it coincides with

  Vec3 edge(std::uint32_t a, std::uint32_t b) const {
    return test::minus(vertices[b].vertex.position, vertices[a].vertex.position);
  }

  // weights_seen(vertex, neighbour) → the neighbour's weights on joints, as the vertex sees them.
  template <class Weights>
  Vec3 normal(std::uint32_t v, const std::vector<Map>& palette, const Weights& weights_seen) const {
    const test::TestVertex& at = vertices[v].vertex;
    Vec3 mean{0, 0, 0};
    std::vector<std::array<std::uint32_t, 2>> ring;
    for (const Triangle& t : triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (place[t[i]] != place[v]) continue;
        ring.push_back({t[(i + 1) % 3], t[(i + 2) % 3]});
        const Vec3 n = test::cross(edge(v, ring.back()[0]), edge(v, ring.back()[1]));
        for (std::size_t c = 0; c < 3; ++c) mean[c] += n[c];
      }
    }
    const double area = test::length(mean);
    const Vec3 n = test::normalised(mean);
    const auto posed = [&](std::uint32_t k) {
      Vec3 out{0, 0, 0};
      const std::vector<double> weights = weights_seen(v, k);
      for (std::size_t j = 0; j < weights.size(); ++j) {
        const Vec3 p = test::point(palette[j], vertices[k].vertex.position);
        for (std::size_t c = 0; c < 3; ++c) out[c] += weights[j] * p[c];
      }
      return out;
    };
    Map blend{{{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}};
    const std::vector<double> own = weights_seen(v, v);
    for (std::size_t j = 0; j < own.size(); ++j)
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) blend.rows[r][c] += own[j] * palette[j].rows[r][c];
    const Vec3 axis0 = test::normalised(test::cross(at.normal, {0, 0.28, 0.96})), axis1 = test::cross(at.normal, axis0);
    const Vec3 v_posed = posed(v);
    const auto derivative = [&](const Vec3& axis) {
      Vec3 now{0, 0, 0}, before{0, 0, 0};
      for (const auto& [k, l] : ring) {
        const Vec3 a = edge(v, k), b = edge(v, l);
        const double of_k = test::dot(n, test::cross(axis, b)) / area, of_l = test::dot(n, test::cross(a, axis)) / area;
        const Vec3 k_now = test::minus(posed(k), v_posed), l_now = test::minus(posed(l), v_posed);
        for (std::size_t c = 0; c < 3; ++c) {
          now[c] += of_k * k_now[c] + of_l * l_now[c];
          before[c] += of_k * a[c] + of_l * b[c];
        }
      }
      const Vec3 rest = test::direction(blend, test::minus(axis, before));
      return Vec3{now[0] + rest[0], now[1] + rest[1], now[2] + rest[2]};
    };
    return test::normalised(test::cross(derivative(axis0), derivative(axis1)));
  }
};

// Weights on all joints of a vertex that follows them.
std::vector<double> dense(const SurfaceVertex& v, std::size_t joints) {
  std::vector<double> out(joints, 0.0);
  for (std::size_t k = 0; k < v.set.size(); ++k) out[v.set[k]] = v.vertex.weights[k];
  return out;
}

Reference reference_of(const test::Sheet& sheet) {
  Reference out{sheet.vertices, sheet.triangles, {}};
  for (std::uint32_t v = 0; v < sheet.vertices.size(); ++v) out.place.push_back(v);
  for (const auto& [a, b] : sheet.seam) out.place[b] = out.place[a];
  return out;
}

std::vector<Map> bent_palette(std::size_t count) {
  std::vector<Map> out;
  for (std::size_t j = 0; j < count; ++j) {
    const Map turned = test::from_trs({0.125, 0.25 * static_cast<double>(j), 0},
                                      test::axis_angle({0.25, 1, 0.125}, 0.375 * static_cast<double>(j)), {1, 1, 1});
    out.push_back(test::to_map(test::to_affine(turned)));
  }
  return out;
}

// Where all vertices follow the same joints nothing is left out.
TEST(AsTangents, BendIsTheDefinition) {
  for (const std::size_t joints : {1u, 2u, 4u, 8u}) {
    test::Random random(joints);
    test::Sheet sheet = test::make_sheet(5, 8, 1, 1, false);
    for (SurfaceVertex& v : sheet.vertices) {
      v.set.clear();
      v.vertex.weights.clear();
      double left = 1;
      for (std::size_t j = 0; j < joints; ++j) {
        v.set.push_back(static_cast<std::uint16_t>(j));
        const double w = j + 1 == joints ? left : left * random.between(0.25, 0.75);
        v.vertex.weights.push_back(w);
        left -= w;
      }
    }
    for (const auto& [a, b] : sheet.seam) sheet.vertices[b] = sheet.vertices[a];
    const TestSurface surface(sheet.vertices, sheet.triangles, std::vector<Map>(joints));
    const Reference reference = reference_of(sheet);
    const std::vector<Map> palette = bent_palette(joints);
    const Skinned got = skin(surface.view(), palette);
    for (std::uint32_t v = 0; v < sheet.vertices.size(); ++v) {
      const Vec3 want = reference.normal(
          v, palette, [&](std::uint32_t, std::uint32_t k) { return dense(sheet.vertices[k], joints); });
      EXPECT_LT(test::angle_deg(three(got.normals, surface.slot(v)), want), 0.02) << joints << " joints, vertex " << v;
    }
  }
}

// What a neighbour has of joints that the vertex lacks counts as that of the vertex's which it follows most; if none,
// the vertex's first heaviest.
std::vector<double> inherited(const SurfaceVertex& v, const SurfaceVertex& neighbour, std::size_t joints) {
  const std::vector<double> own = dense(v, joints), theirs = dense(neighbour, joints);
  std::vector<double> out(joints, 0.0);
  std::size_t heir = v.set[0];
  for (const std::uint16_t j : v.set)
    if (own[j] > own[heir]) heir = j;
  double most = 0, lost = 1;
  for (const std::uint16_t j : v.set) {
    out[j] = theirs[j];
    lost -= theirs[j];
    if (theirs[j] > most) heir = j;
    most = std::max(most, theirs[j]);
  }
  out[heir] += lost;
  return out;
}

TEST(AsTangents, JointsThatAVertexLacks) {
  const test::Sheet sheet = test::make_sheet(7, 10, 5, 4, false);
  const TestSurface surface(sheet.vertices, sheet.triangles, std::vector<Map>(5));
  const Reference reference = reference_of(sheet);
  const std::vector<Map> palette = bent_palette(5);
  const Skinned got = skin(surface.view(), palette);
  std::size_t lacking = 0;
  for (std::uint32_t v = 0; v < sheet.vertices.size(); ++v) {
    const Vec3 want = reference.normal(v, palette, [&](std::uint32_t at, std::uint32_t k) {
      lacking += dense(sheet.vertices[k], 5) != inherited(sheet.vertices[at], sheet.vertices[k], 5);
      return inherited(sheet.vertices[at], sheet.vertices[k], 5);
    });
    EXPECT_LT(test::angle_deg(three(got.normals, surface.slot(v)), want), 0.02) << "vertex " << v;
  }
  EXPECT_GT(lacking, 100u);
}

TEST(AsTangents, ASeamIsNoCrease) {
  const test::Sheet sheet = test::make_sheet(8, 8, 6, 6, true);
  const TestSurface surface(sheet.vertices, sheet.triangles, std::vector<Map>(6), true);
  const Skinned got = skin(surface.view(), bent_palette(6));
  ASSERT_EQ(sheet.seam.size(), 9u);
  for (const auto& [a, b] : sheet.seam)
    EXPECT_LT(test::angle_deg(three(got.normals, surface.slot(a)), three(got.normals, surface.slot(b))), 0.001);
}

// The sheet cut at its seam into two meshes; the second one's palette stands backwards.
TEST(AsTangents, MeshesThatTouchAreOneSurface) {
  const test::Sheet sheet = test::make_sheet(9, 8, 6, 6, true);
  const TestSurface whole(sheet.vertices, sheet.triangles, std::vector<Map>(6), true);
  const std::vector<Map> palette = bent_palette(6);
  const Skinned want = skin(whole.view(), palette);

  std::vector<Triangle> left, right;
  for (const Triangle& t : sheet.triangles)
    (sheet.vertices[t[0]].vertex.position[0] + sheet.vertices[t[1]].vertex.position[0] < 0 ? left : right).push_back(t);
  ASSERT_EQ(left.size(), right.size());
  std::vector<SurfaceVertex> backwards = sheet.vertices;
  for (SurfaceVertex& v : backwards)
    for (std::uint16_t& j : v.set) j = static_cast<std::uint16_t>(5 - j);
  const TestSurface a(sheet.vertices, left, std::vector<Map>(6), true);
  const TestSurface b(backwards, right, std::vector<Map>(6), true);
  const std::uint16_t joints[6] = {5, 4, 3, 2, 1, 0};
  const Mesh mesh_a = a.view();
  Mesh mesh_b = b.view();
  mesh_b.joints = joints;
  Skinned got_a(mesh_a), got_b(mesh_b);
  derive({{&mesh_a, got_a.coordinates, got_a.tau}, {&mesh_b, got_b.coordinates, got_b.tau}});
  ASSERT_EQ(skin_as(mesh_a, got_a.coordinates, entries(palette), got_a.output(), got_a.tau), Status::ok);
  const std::vector<Map> reversed(palette.rbegin(), palette.rend());
  ASSERT_EQ(skin_as(mesh_b, got_b.coordinates, entries(reversed), got_b.output(), got_b.tau), Status::ok);
  for (std::uint32_t v = 0; v < sheet.vertices.size(); ++v) {
    const Vec3 n = three(want.normals, whole.slot(v));
    const double x = sheet.vertices[v].vertex.position[0];
    if (x <= 0) {
      EXPECT_LT(test::angle_deg(three(got_a.normals, a.slot(v)), n), 0.002) << "left " << v;
    }
    if (x >= 0) {
      EXPECT_LT(test::angle_deg(three(got_b.normals, b.slot(v)), n), 0.002) << "right " << v;
    }
  }
}

SurfaceVertex on_two(const Vec3& position, const Vec3& normal, double second) {
  SurfaceVertex v;
  v.set = {0, 1};
  v.vertex.position = position;
  v.vertex.normal = normal;
  v.vertex.tangent = {0, 1, 0};
  v.vertex.weights = {1 - second, second};
  return v;
}

// Helpers at 1/4, 1/2 and 3/4 between two joints are entries along a line; a vertex follows two that lie side by side.
// Whatever its neighbour follows is a point of that line, and so a sum of the vertex's two, one of them below 0
// perhaps.
TEST(AsTangents, HelpersThatAVertexLacks) {
  constexpr double kShares[5] = {0, 1, 0.25, 0.5, 0.75};  // of joint 1, entry by entry
  constexpr std::uint16_t kSets[4][2] = {{0, 2}, {2, 3}, {3, 4}, {1, 4}};
  const Helper helpers[] = {{0, 1, 0.25f}, {0, 1, 0.5f}, {0, 1, 0.75f}};
  test::Random random(11);
  test::Sheet sheet = test::make_sheet(11, 8, 1, 1, false);
  for (SurfaceVertex& v : sheet.vertices) {
    const auto& set = kSets[random.below(4)];
    v.set = {set[0], set[1]};
    const double w = random.between(0.125, 0.875);
    v.vertex.weights = {w, 1 - w};
  }
  for (const auto& [a, b] : sheet.seam) sheet.vertices[b] = sheet.vertices[a];
  const TestSurface surface(sheet.vertices, sheet.triangles, std::vector<Map>(2));
  Mesh mesh = surface.view();
  mesh.helpers = helpers;
  const Reference reference = reference_of(sheet);
  const std::vector<Map> palette = bent_palette(5);
  const Skinned got = skin(mesh, palette);
  std::size_t beyond = 0;
  for (std::uint32_t v = 0; v < sheet.vertices.size(); ++v) {
    const Vec3 want = reference.normal(v, palette, [&](std::uint32_t at, std::uint32_t k) {
      const SurfaceVertex &own = sheet.vertices[at], &other = sheet.vertices[k];
      const double place =
          other.vertex.weights[0] * kShares[other.set[0]] + other.vertex.weights[1] * kShares[other.set[1]];
      const double from = kShares[own.set[0]], to = kShares[own.set[1]], along = (place - from) / (to - from);
      beyond += along < 0 || along > 1;
      std::vector<double> out(5, 0.0);
      out[own.set[0]] = 1 - along;
      out[own.set[1]] = along;
      return out;
    });
    EXPECT_LT(test::angle_deg(three(got.normals, surface.slot(v)), want), 0.05) << "vertex " << v;
  }
  EXPECT_GT(beyond, 100u);
}

// A triangle whose corners follow joint 0 and a helper between 0 and 1, joint 2 and a helper between 1 and 2, and joint
// 2 alone. Of the first one's joints the second corner follows joint 1 most, so joint 2 counts as that, and joint 1 as
// twice the helper less joint 0; the third corner follows none of them and counts as the heaviest, joint 0.
TEST(AsTangents, JointsThatNoHelperOfAVertexBlends) {
  const Helper helpers[] = {{0, 1, 0.5f}, {1, 2, 0.5f}};
  std::vector<SurfaceVertex> vertices = {on_two({0, 0, 0}, {0, 0, 1}, 0.375), on_two({1, 0, 0}, {0, 0, 1}, 0.75),
                                         on_two({0, 1, 0}, {0, 0, 1}, 0)};
  vertices[0].set = {0, 3};
  vertices[1].set = {2, 4};
  vertices[2].set = {2};
  vertices[2].vertex.weights = {1};
  const TestSurface surface(vertices, {{0, 1, 2}}, std::vector<Map>(3));
  Mesh mesh = surface.view();
  mesh.helpers = helpers;
  const Reference reference{vertices, {{0, 1, 2}}, {0, 1, 2}};
  const std::vector<Map> palette = bent_palette(5);
  const Skinned got = skin(mesh, palette);
  const std::vector<std::vector<double>> seen = {{0.625, 0, 0, 0.375, 0}, {-1, 0, 0, 2, 0}, {1, 0, 0, 0, 0}};
  const Vec3 want = reference.normal(0, palette, [&](std::uint32_t, std::uint32_t k) { return seen[k]; });
  EXPECT_LT(test::angle_deg(three(got.normals, surface.slot(0)), want), 0.01);
}

// Two squares meet on the y axis at a right angle; joint 1 opens the hinge. Each side's slots keep to their own square.
TEST(AsTangents, ACreaseStaysOne) {
  const Vec3 up{0, 0, 1}, right{1, 0, 0};
  const std::vector<SurfaceVertex> vertices = {on_two({-1, 0, 0}, up, 0),     on_two({-1, 1, 0}, up, 0),
                                               on_two({0, 0, 0}, up, 0.5),    on_two({0, 1, 0}, up, 0.5),
                                               on_two({0, 0, 0}, right, 0.5), on_two({0, 1, 0}, right, 0.5),
                                               on_two({0, 0, -1}, right, 1),  on_two({0, 1, -1}, right, 1)};
  const std::vector<Triangle> triangles = {{0, 2, 3}, {0, 3, 1}, {4, 6, 7}, {4, 7, 5}};
  const TestSurface surface(vertices, triangles, std::vector<Map>(2));
  const Map opened = test::from_trs({0, 0, 0}, test::axis_angle({0, 1, 0}, -0.75), {1, 1, 1});
  const Skinned got = skin(surface.view(), {Map{}, opened});
  for (const std::size_t v : {0u, 1u, 2u, 3u}) {
    EXPECT_LT(test::angle_deg(three(got.normals, surface.slot(v)), up), 0.001) << v;
    EXPECT_LT(test::angle_deg(three(got.normals, surface.slot(v + 4)), test::direction(opened, right)), 0.001) << v;
  }
}

// A square whose residual tilts it by 45° in the bind pose already: its normals, said to be straight up, tilt with it.
TEST(AsTangents, ResidualsTiltNormals) {
  std::vector<SurfaceVertex> vertices;
  for (int i = 0; i < 4; ++i) {
    SurfaceVertex v = on_two({i % 2 * 1.0, i / 2 * 1.0, 0}, {0, 0, 1}, 0.5);
    v.vertex.residual = {{0, 0, 0.25 * (i % 2), 0}, {0, 0, 0.75 * (i % 2), 0}};
    vertices.push_back(v);
  }
  const TestSurface surface(vertices, {{0, 1, 3}, {0, 3, 2}}, std::vector<Map>(2), true);
  const Map turned = test::from_trs({1, 2, 3}, test::axis_angle({1, 2, 3}, 0.5), {1, 1, 1});
  const Skinned got = skin(surface.view(), {turned, turned});
  for (std::size_t v = 0; v < 4; ++v)
    EXPECT_LT(test::angle_deg(three(got.normals, surface.slot(v)), test::direction(turned, {-1, 0, 1})), 0.001) << v;
}

TEST(AsTangents, VerticesWithoutAreaHaveTheBlendsNormal) {
  const Vec3 slanted = test::normalised(Vec3{1, 2, 3});
  std::vector<SurfaceVertex> vertices;
  for (int i = 0; i < 5; ++i) vertices.push_back(on_two({0.25 * i, 0, 0}, slanted, 0.125 + 0.125 * i));
  vertices.push_back(on_two({3, 3, 3}, slanted, 0.5));  // no triangle
  // On a line; in one point; and one that another undoes.
  const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 3, 3}, {2, 3, 4}, {1, 1, 4}};
  const TestSurface surface(vertices, triangles, std::vector<Map>(2));
  const Mesh mesh = surface.view();
  const std::vector<Map> palette = {test::from_trs({1, 0, 0}, test::axis_angle({1, 1, 0}, 0.5), {1, 0.5, 2}),
                                    test::from_trs({0, 1, 0}, test::axis_angle({0, 1, 2}, -0.75), {1, 1, 1})};
  const Skinned got = skin(mesh, palette);
  Skinned blended(mesh);
  ASSERT_EQ(skin_as(mesh, blended.coordinates, entries(palette), blended.output()), Status::ok);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::uint32_t slot = surface.slot(v);
    EXPECT_LT(test::angle_deg(three(got.normals, slot), three(blended.normals, slot)), 0.001) << v;
  }
}

TEST(AsTangents, NeverNaN) {
  // A palette that folds everything flat, normals of no length, tangents along normals.
  std::vector<SurfaceVertex> vertices = {on_two({0, 0, 0}, {0, 0, 0}, 0.5), on_two({1, 0, 0}, {0, 1, 0}, 0.5),
                                         on_two({0, 1, 0}, {0, 0, 1}, 0.25)};
  const TestSurface surface(vertices, {{0, 1, 2}}, std::vector<Map>(2));
  const Map flat{{{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}};
  for (const Map& m : {flat, Map{}}) {
    const Skinned got = skin(surface.view(), {m, m});
    for (const float f : got.normals) EXPECT_TRUE(std::isfinite(f));
    for (const float f : got.tangents) EXPECT_TRUE(std::isfinite(f));
  }
}

TEST(AsTangents, PaddingRepeatsTheLastVertexAndPositionsAreTheSameBits) {
  const test::Sheet sheet = test::make_sheet(10, 6, 9, 8, true);
  const TestSurface surface(sheet.vertices, sheet.triangles, std::vector<Map>(9), true);
  const Mesh mesh = surface.view();
  const std::vector<Map> palette = bent_palette(9);
  const Skinned got = skin(mesh, palette);
  Skinned plain(mesh), normals_alone(mesh);
  ASSERT_EQ(skin_as(mesh, plain.coordinates, entries(palette), plain.output()), Status::ok);
  EXPECT_EQ(got.positions, plain.positions);
  ASSERT_EQ(
      skin_as(mesh, got.coordinates, entries(palette), {normals_alone.positions, normals_alone.normals, {}}, got.tau),
      Status::ok);
  EXPECT_EQ(normals_alone.normals, got.normals);
  std::size_t slot = 0, padding = 0;
  for (const marrow::Run& run : mesh.geometry.runs) {
    const std::size_t last = slot + run.vertex_count - 1;
    for (slot += run.vertex_count; slot % 4 != 0; ++slot, ++padding)
      EXPECT_EQ(three(got.normals, slot), three(got.normals, last)) << slot;
  }
  EXPECT_EQ(slot, surface.slot_count());
  EXPECT_GT(padding, 0u);
}

}  // namespace
}  // namespace marrow
