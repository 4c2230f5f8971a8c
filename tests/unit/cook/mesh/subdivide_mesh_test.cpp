// Finer meshes by hand: flat and round, hard and smooth, with morph targets, on more joints than there may be.
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "common/failure.h"
#include "cook/mesh/subdivide_mesh.h"
#include "cook/prepare/prepare_scene.h"
#include "unit/cook/mesh/looped.h"

namespace marrow::cook {
namespace {

// Squares of side 1 over [0, side]², two triangles each, in the plane z = 0, facing up.
RawPrimitive grid(std::uint32_t side) {
  RawPrimitive out;
  out.pointer = "/meshes/0/primitives/0";
  for (std::uint32_t y = 0; y <= side; ++y)
    for (std::uint32_t x = 0; x <= side; ++x) {
      out.positions.emplace_back(x, y, 0);
      out.normals.emplace_back(0, 0, 1);
      out.tangents.emplace_back(1, 0, 0, -1);
      out.uvs.emplace_back(x, y);
      out.colours.emplace_back(x, 0, 0, 1);
    }
  const std::uint32_t row = side + 1;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t a = y * row + x;
      out.indices.insert(out.indices.end(), {a, a + 1, a + row + 1, a, a + row + 1, a + row});
    }
  return out;
}

std::size_t border_edges(const RawPrimitive& p) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> triangles;
  for (std::size_t i = 0; i < p.indices.size(); ++i)
    ++triangles[std::minmax(p.indices[i], p.indices[i % 3 == 2 ? i - 2 : i + 1])];
  return static_cast<std::size_t>(std::ranges::count_if(triangles, [](const auto& e) { return e.second == 1; }));
}

TEST(SubdivideMesh, AFlatGridStaysFlatWithinItsBorders) {
  RawMesh mesh{"", {}, {grid(4)}};
  const FinerMesh finer = subdivide_mesh(mesh, {}, 2);
  EXPECT_EQ(finer.cut, 0u);
  mesh = finer.mesh;
  const RawPrimitive& p = mesh.primitives[0];
  ASSERT_EQ(p.positions.size(), 17u * 17);
  EXPECT_EQ(p.indices.size(), 16u * 32 * 3);
  EXPECT_EQ(border_edges(p), 4u * 16);
  std::size_t on_border = 0, in_order = 0;
  double area = 0;
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    const glm::vec3& at = p.positions[v];
    EXPECT_EQ(at.z, 0);
    EXPECT_EQ(p.normals[v], glm::vec3(0, 0, 1));
    EXPECT_EQ(p.tangents[v], glm::vec4(1, 0, 0, -1));
    EXPECT_TRUE(at.x >= 0 && at.x <= 4 && at.y >= 0 && at.y <= 4);
    EXPECT_EQ(p.colours[v].x, p.uvs[v].x) << "both linear in what they were";
    on_border += at.x == 0 || at.x == 4 || at.y == 0 || at.y == 4 ? 1u : 0u;
    in_order += glm::vec2(at) == p.uvs[v] ? 1u : 0u;
  }
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    const glm::vec3 a = p.positions[p.indices[i]], b = p.positions[p.indices[i + 1]], c = p.positions[p.indices[i + 2]];
    const double up = glm::cross(b - a, c - a).z;
    EXPECT_GT(up, 0) << "no triangle turns over";
    area += up / 2;
  }
  // At each corner five points leave the border: itself, in the second step its neighbours and the middles between.
  EXPECT_EQ(on_border, 4u * 16 - 4 * 5);
  EXPECT_GT(in_order, p.positions.size() / 2);
  EXPECT_GT(area, 16 - 4 * 0.2);
  EXPECT_LT(area, 16);
}

// A cube of edge 2 about the origin, each side with vertices of its own; normals of the sides, or of the corners.
RawPrimitive cube(bool hard) {
  RawPrimitive out;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const float sign = side % 2 == 0 ? 1.0f : -1.0f;
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    for (const auto& [a, b] : {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
      glm::vec3 v(0);
      v[axis] = sign;
      v[(axis + 1) % 3] = a;
      v[(axis + 2) % 3] = b * sign;
      out.positions.push_back(v);
      glm::vec3 normal(0);
      normal[axis] = sign;
      out.normals.push_back(hard ? normal : glm::normalize(v));
      out.uvs.emplace_back(side, a + 2 * b);
    }
    out.indices.insert(out.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
  }
  return out;
}

using Key = std::tuple<float, float, float>;
Key key(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

TEST(SubdivideMesh, HardEdgesStayHardAndSmoothOnesSmooth) {
  for (const bool hard : {false, true}) {
    RawMesh mesh{"", {}, {cube(hard)}};
    mesh = subdivide_mesh(mesh, {}, 2).mesh;
    const RawPrimitive& p = mesh.primitives[0];
    std::map<Key, std::set<Key>> normals;
    std::map<Key, std::size_t> vertices;
    for (std::size_t v = 0; v < p.positions.size(); ++v) {
      EXPECT_NEAR(glm::length(p.normals[v]), 1, 1e-6);
      EXPECT_GT(glm::dot(p.normals[v], glm::normalize(p.positions[v])), hard ? 0.7 : 0.95);
      normals[key(p.positions[v])].insert(key(p.normals[v]));
      ++vertices[key(p.positions[v])];
    }
    EXPECT_EQ(normals.size(), 12u * 16 / 2 + 2) << "it is closed: Euler";
    std::size_t seams = 0;
    for (const auto& [at, of] : normals) {
      EXPECT_EQ(of.size(), hard ? vertices[at] : 1u);
      seams += vertices[at] > 1 ? 1u : 0u;
    }
    EXPECT_EQ(seams, 8u + 12 * 3);
  }
}

// Of the surface: area-weighted over the sides' own triangles.
TEST(SubdivideMesh, NormalsAreTheFinerSurfaces) {
  RawMesh mesh{"", {}, {cube(true)}};
  mesh = subdivide_mesh(mesh, {}, 1).mesh;
  const RawPrimitive& p = mesh.primitives[0];
  std::vector<glm::dvec3> sums(p.positions.size(), glm::dvec3(0));
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    const glm::dvec3 a(p.positions[p.indices[i]]), b(p.positions[p.indices[i + 1]]), c(p.positions[p.indices[i + 2]]);
    for (std::size_t k = 0; k < 3; ++k) sums[p.indices[i + k]] += glm::cross(b - a, c - a);
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
    EXPECT_LT(glm::length(glm::normalize(sums[v]) - glm::dvec3(p.normals[v])), 1e-5);
}

// Normals that are not the surface's, as grass has them, stay what they are beside it.
TEST(SubdivideMesh, NormalsOfTheArtistsOwnStay) {
  RawMesh mesh{"", {}, {grid(3)}};
  for (glm::vec3& n : mesh.primitives[0].normals) n = {0.6f, 0, 0.8f};
  mesh = subdivide_mesh(mesh, {}, 2).mesh;
  for (std::size_t v = 0; v < mesh.primitives[0].normals.size(); ++v) {
    EXPECT_LT(glm::length(mesh.primitives[0].normals[v] - glm::vec3(0.6f, 0, 0.8f)), 1e-6f);
    EXPECT_LT(glm::length(mesh.primitives[0].tangents[v] - glm::vec4(0.8f, 0, -0.6f, -1)), 1e-6f) << "at right angles";
  }
}

// Smoothing the mesh with a morph target on it, and smoothing both, is the same; directions go along edges.
TEST(SubdivideMesh, MorphTargetsAreSmoothedToo) {
  RawPrimitive p = grid(3);
  RawTarget target;
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    const auto number = static_cast<float>(v);
    target.positions.emplace_back(0, 0.125f * std::sin(number), std::cos(3 * number));
    target.normals.emplace_back(number, 0, 0);
    target.tangents.emplace_back(0, number, 0);
  }
  p.targets = {target};
  Net bind, morphed;
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    bind.at.emplace_back(p.positions[v]);
    morphed.at.push_back(bind.at[v] + glm::dvec3(target.positions[v]));
  }
  for (std::size_t i = 0; i < p.indices.size(); i += 3)
    bind.triangles.push_back({p.indices[i], p.indices[i + 1], p.indices[i + 2]});
  morphed.triangles = bind.triangles;
  RawMesh mesh{"", {{"t", "t", 0}}, {p}};
  mesh = subdivide_mesh(mesh, {}, 1).mesh;
  const RawPrimitive& fine = mesh.primitives[0];
  const Places rest = looped(bind).at, moved = looped(morphed).at;
  Places got;
  for (const glm::vec3& v : fine.positions) got.emplace_back(v);
  const std::vector<std::uint32_t> which = nearest(got, rest, 1e-6);
  for (std::size_t v = 0; v < got.size(); ++v)
    EXPECT_LT(glm::length(got[v] + glm::dvec3(fine.targets[0].positions[v]) - moved[which[v]]), 1e-6);
  // The first new vertex lies between 0 and 1.
  EXPECT_EQ(fine.targets[0].normals[16], glm::vec3(0.5f, 0, 0));
  EXPECT_EQ(fine.targets[0].tangents[16], glm::vec3(0, 0.5f, 0));
}

// Two primitives that touch, one of which a target leaves alone: where they touch it moves with the other.
TEST(SubdivideMesh, PrimitivesStayClosedWhereTheyTouch) {
  RawPrimitive left = grid(2), right = grid(2);
  for (glm::vec3& v : right.positions) v.x += 2;
  left.targets.resize(1);
  right.targets.resize(1);
  for (const glm::vec3& v : left.positions) left.targets[0].positions.emplace_back(0, 0, v.x < 2 ? 1 : 0);
  RawMesh mesh{"", {{"t", "t", 0}}, {left, right}};
  mesh = subdivide_mesh(mesh, {}, 1).mesh;
  ASSERT_EQ(mesh.primitives[0].positions.size(), 25u);
  ASSERT_EQ(mesh.primitives[1].targets[0].positions.size(), 25u);
  std::size_t touching = 0, moved = 0;
  for (std::size_t a = 0; a < 25; ++a)
    for (std::size_t b = 0; b < 25; ++b) {
      const RawPrimitive &l = mesh.primitives[0], &r = mesh.primitives[1];
      if (l.positions[a] != r.positions[b]) continue;
      ++touching;
      EXPECT_EQ(l.targets[0].positions[a], r.targets[0].positions[b]);
      moved += r.targets[0].positions[b].z > 0 ? 1u : 0u;
    }
  EXPECT_EQ(touching, 5u);
  EXPECT_EQ(moved, 5u);
}

// A hub with a rim of twelve, each point on a joint of its own. By hand the hub has 1 - nβ and 12 times β.
struct Wheel {
  Wheel() {
    RawPrimitive p;
    p.pointer = "/meshes/0/primitives/0";
    binding.primitives.emplace_back();
    for (std::uint32_t k = 0; k <= 12; ++k) {
      const double angle = k * std::numbers::pi / 6, radius = k < 12 ? 1 : 0;
      p.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
      p.influences.push_back({{k, 1.0f}});
      binding.primitives[0].push_back({{k, 1.0}});
      if (k < 12) p.indices.insert(p.indices.end(), {12, k, (k + 1) % 12});
    }
    mesh.primitives.push_back(p);
  }
  // Every joint turns by an angle of its own about the hub.
  static std::vector<deform::Pose> poses() {
    std::vector<deform::Pose> out(3, deform::Pose(13, deform::Matrix(1.0)));
    for (std::size_t k = 0; k < 13; ++k) {
      const double turn = 0.1 * static_cast<double>(k);
      out[1][k] = {{std::cos(turn), std::sin(turn), 0}, {-std::sin(turn), std::cos(turn), 0}, {0, 0, 1}, {0, 0, 0}};
      out[2][k][3] = {0, 0, turn};
    }
    return out;
  }
  RawMesh mesh;
  SkinBinding binding;
};

TEST(SubdivideMesh, VerticesKeepAsManyJointsAsTheyMayHave) {
  for (const double residual_step_m : {0.0, 1e-4}) {
    Wheel wheel;
    wheel.binding.residual_step_m = residual_step_m;
    const FinerMesh finer = subdivide_mesh(wheel.mesh, {{&wheel.binding, Wheel::poses}}, 1);
    EXPECT_EQ(finer.cut, 1u) << "the hub alone";
    const RawPrimitive& p = finer.mesh.primitives[0];
    const std::vector<BoundVertex>& vertices = finer.bindings[0].primitives[0];
    ASSERT_EQ(vertices.size(), p.positions.size());
    ASSERT_EQ(p.influences.size(), p.positions.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      double weight = 0;
      glm::dvec4 sum(0);
      ASSERT_LE(vertices[v].size(), std::size_t{kMaxInfluences});
      for (const BoundInfluence& i : vertices[v]) {
        weight += i.weight;
        sum += i.residual;
        EXPECT_GE(i.weight, 0);
      }
      EXPECT_NEAR(weight, 1, 1e-9);
      EXPECT_LT(glm::length(sum), 1e-7) << "the bind pose stays, to single precision";
    }
    // In the last pose every joint lifts it by a tenth of its number.
    const double part = 3.0 / 8 + std::cos(std::numbers::pi / 6) / 4, beta = (5.0 / 8 - part * part) / 12;
    double lift = 0;
    for (const BoundInfluence& i : vertices[12]) lift += (i.weight + i.residual.w) * 0.1 * i.joint;
    EXPECT_NEAR(lift, (1 - 12 * beta) * 1.2 + beta * 6.6, 1e-4);
    // A spoke's middle, by hand: 3/8 of its ends, 1/8 of the two beside, each where it was.
    std::size_t spokes = 0;
    for (std::size_t v = 13; v < vertices.size(); ++v) {
      if (vertices[v].size() != 4) continue;
      ++spokes;
      std::vector<double> weights;
      for (const BoundInfluence& i : vertices[v]) {
        weights.push_back(i.weight);
        const glm::dvec3 from = i.joint == 12 ? glm::dvec3(0)
                                              : glm::dvec3(std::cos(i.joint * std::numbers::pi / 6),
                                                           std::sin(i.joint * std::numbers::pi / 6), 0);
        const glm::dvec3 wanted = residual_step_m > 0 ? (from - glm::dvec3(p.positions[v])) * i.weight : glm::dvec3(0);
        EXPECT_LT(glm::length(glm::dvec3(i.residual) - wanted), 1e-6);
      }
      std::ranges::sort(weights);
      EXPECT_NEAR(weights[1], 0.125, 1e-12);
      EXPECT_NEAR(weights[2], 0.375, 1e-12);
    }
    EXPECT_EQ(spokes, 12u);
  }
}

// Two at one place that follow different joints are two, as lips are that open.
TEST(SubdivideMesh, WhatComesApartStaysApart) {
  RawPrimitive upper = grid(2), lower = grid(2);
  for (glm::vec3& v : lower.positions) v.y -= 2;
  SkinBinding binding;
  for (RawPrimitive* const p : {&upper, &lower}) {
    const std::uint32_t joint = p == &upper ? 0 : 1;
    p->influences.assign(9, {{joint, 1.0f}});
    binding.primitives.emplace_back(9, BoundVertex{{joint, 1.0}});
  }
  const RawMesh mesh{"", {}, {upper, lower}};
  binding = subdivide_mesh(mesh, {{&binding, {}}}, 1).bindings[0];
  for (std::uint32_t p = 0; p < 2; ++p)
    for (const BoundVertex& vertex : binding.primitives[p]) {
      ASSERT_EQ(vertex.size(), 1u);
      EXPECT_EQ(vertex[0].joint, p);
    }
}

TEST(SubdivideMesh, TakesTrianglesThatAreNone) {
  RawMesh mesh{"", {}, {grid(1), RawPrimitive()}};
  mesh.primitives[0].positions[3] = mesh.primitives[0].positions[0];
  mesh.primitives[0].indices.insert(mesh.primitives[0].indices.end(), {0, 0, 1, 0, 3, 2, 1, 1, 1, 0, 1, 2, 0, 1, 2});
  const std::size_t corners = mesh.primitives[0].indices.size();
  mesh = subdivide_mesh(mesh, {}, 3).mesh;
  const RawPrimitive& p = mesh.primitives[0];
  EXPECT_EQ(p.indices.size(), 64 * corners);
  for (const std::uint32_t i : p.indices) ASSERT_LT(i, p.positions.size());
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    EXPECT_TRUE(glm::length(p.positions[v]) < 3);
    EXPECT_NEAR(glm::length(p.normals[v]), 1, 1e-6);
    EXPECT_NEAR(glm::length(glm::vec3(p.tangents[v])), 1, 1e-6);
  }
}

TEST(SubdivideMesh, RefusesWhatWouldBeTooMuch) {
  RawScene scene;
  scene.source = "big.glb";
  scene.meshes.resize(2);
  for (RawMesh& mesh : scene.meshes) mesh.primitives.push_back(grid(100));
  scene.meshes[1].primitives[0].pointer = "/meshes/1/primitives/0";
  scene.instances = {{0, 0, kNone, {}, kNone}, {0, 0, kNone, {}, kNone}};
  scene.meshes[0].primitives[0].indices.resize(3 * 62'500);
  check_subdivision(scene, 3);  // 4 000 000, drawn twice
  scene.instances.push_back({0, 1, kNone, {}, kNone});
  check_subdivision(scene, 2);
  try {
    check_subdivision(scene, 3);
    ADD_FAILURE();
  } catch (const tools::Failure& failure) {
    EXPECT_EQ(failure.code(), tools::Exit::unsupported);
    EXPECT_EQ(failure.where(), "/meshes/1/primitives/0");
    EXPECT_EQ(failure.rule(), "too-many-triangles");
  }
  scene.meshes[0].primitives[0].targets.resize(32);
  check_subdivision(scene, 1);
  EXPECT_THROW(check_subdivision(scene, 2), tools::Failure);
}

}  // namespace
}  // namespace marrow::cook
