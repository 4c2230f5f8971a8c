// What is learnt must not look worse than plain skinning: parts that follow joints alike move as one.
#include "cook/learn/look_better.h"

#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "deform/helpers/closed_form.h"

namespace marrow::cook {
namespace {

using deform::Influence;

// Two triangles: the first follows both joints alike, the second differently at each vertex. The middle of the first is
// next to vertex 2.
deform::SkinnedMesh two_parts() {
  deform::SkinnedMesh mesh;
  mesh.joint_count = 2;
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {1, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  mesh.indices = {0, 1, 2, 3, 4, 5};
  const std::vector<Influence> same = {{0, 0.25}, {1, 0.75}};
  mesh.influences = {same, same, same, {{0, 1}}, {{0, 0.5}, {1, 0.5}}, {{1, 1}}};
  return mesh;
}

TEST(LookBetter, StiffPartsMoveAsOne) {
  const deform::SkinnedMesh mesh = two_parts();
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Learnt learnt;
  learnt.weights = mesh.influences;
  for (std::size_t v = 0; v < 6; ++v)
    learnt.coordinates.push_back({{0, {number(), number(), number(), 0.4}}, {1, {number(), number(), number(), 0.6}}});
  const deform::Coordinates before = learnt.coordinates;
  move_stiff_parts_as_one(mesh, learnt);
  // Along x, y and z joint 0 stretches by 2, 3, 4, and joint 1 by 5, 6, 7: what has a quarter and three quarters of
  // them by 4.25, 5.25, 6.25.
  const deform::Pose pose = {{{2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {1, 2, 3}},
                             {{5, 0, 0}, {0, 6, 0}, {0, 0, 7}, {4, 5, 6}}};
  const auto place_of = [&](const std::vector<deform::Coordinate>& coordinates) {
    glm::dvec3 out(0);
    for (const deform::Coordinate& c : coordinates) out += pose[c.joint] * c.q;
    return out;
  };
  const glm::dvec3 middle = place_of(before[2]);
  EXPECT_LT(glm::length(place_of(learnt.coordinates[2]) - middle), 1e-12);
  EXPECT_LT(glm::length(place_of(learnt.coordinates[0]) - middle - glm::dvec3(-4.25, -5.25, 0)), 1e-12);
  EXPECT_LT(glm::length(place_of(learnt.coordinates[1]) - middle - glm::dvec3(8.5, -5.25, 0)), 1e-12);
  for (std::size_t v = 3; v < 6; ++v)
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(learnt.coordinates[v][i].q, before[v][i].q) << v;
}

// Weights are the artist's: what is only nearly alike keeps its own, and so does a part whose middle has none.
TEST(LookBetter, NearlyAlikeIsNotStiff) {
  for (const std::vector<Influence>& other : {std::vector<Influence>{{0, 0.24}, {1, 0.76}}, {}}) {
    deform::SkinnedMesh mesh = two_parts();
    mesh.influences[2] = other;
    Learnt learnt;
    learnt.weights = mesh.influences;
    for (std::size_t v = 0; v < 6; ++v)
      learnt.coordinates.push_back(deform::lift(mesh.influences[v], mesh.positions[v]));
    const Learnt before = learnt;
    move_stiff_parts_as_one(mesh, learnt);
    for (std::size_t v = 0; v < 6; ++v) {
      ASSERT_EQ(learnt.coordinates[v].size(), before.coordinates[v].size()) << v;
      EXPECT_EQ(learnt.weights[v].size(), before.weights[v].size()) << v;
      for (std::size_t i = 0; i < before.coordinates[v].size(); ++i)
        EXPECT_EQ(learnt.coordinates[v][i].q, before.coordinates[v][i].q) << v;
    }
  }
}

}  // namespace
}  // namespace marrow::cook
