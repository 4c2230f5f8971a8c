// Skeletons put into meshes: bodies of capsules, whose joints are known; parts by brute force; what has no place for a
// skeleton.
#include "deform/rig/auto_skeleton.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "deform/rig/embed.h"
#include "deform/rig/room.h"
#include "unit/deform/bodies.h"

namespace marrow::deform {
namespace {

using test::Body;

// Hips, a head and two arms: the least that branches and mirrors.
SkeletonTemplate cross() {
  return {{"Hips", kNoJoint, {0, 0, 0}},        {"Chest", 0, {0, 1, 0}},        {"Head", 1, {0, 1.2, 0}},
          {"", 2, {0, 1.6, 0}, kNoJoint, true}, {"LeftArm", 1, {0.2, 1, 0}, 5}, {"RightArm", 1, {-0.2, 1, 0}, 4},
          {"", 4, {1, 1, 0}, 7, true},          {"", 5, {-1, 1, 0}, 6, true}};
}

// A body that `cross` fits: its upright from y = 0 to 1.6.
Body cross_body(const glm::dvec3& at = glm::dvec3(0)) {
  Body body;
  test::add_capsule(at + glm::dvec3(0, 0.1, 0), at + glm::dvec3(0, 1.5, 0), 0.1, body);
  test::add_capsule(at + glm::dvec3(-0.9, 1, 0), at + glm::dvec3(0.9, 1, 0), 0.1, body);
  return body;
}

TEST(Knots, AreWhereWaysPartOrEnd) {
  const std::vector<Knot> knots = knots_of(cross());
  ASSERT_EQ(knots.size(), 5U);
  EXPECT_EQ(knots[0].joint, 0U);
  EXPECT_EQ(knots[1].joint, 1U);
  EXPECT_FALSE(knots[1].is_leaf);
  EXPECT_NEAR(knots[1].place.y, (1.2 + 1 + 1) / 3, 1e-12);  // the mean of what is below
  EXPECT_NEAR(knots[1].lengths[0], 1, 1e-12);
  EXPECT_NEAR(knots[1].length, 1 + 0.2 / 3, 1e-12);
  EXPECT_EQ(knots[2].chain, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(knots[3].mirror, 4);
  EXPECT_EQ(knots[4].mirror, 3);
  EXPECT_EQ(knots[3].parent, 1);
  EXPECT_TRUE(knots[3].is_leaf);
}

TEST(Room, DistancesAreThoseOfBruteForce) {
  Body body;
  test::add_capsule({0, 0, 0}, {0.3, 1, 0.2}, 0.2, body);
  test::add_capsule({0, 0, 0}, {1, 0.1, 0}, 0.1, body);
  const Voxels voxels(body.positions, body.indices, 16);
  const std::vector<double> distances = squared_distances_inside(voxels);
  int inside = 0;
  for (std::size_t cell = 0; cell < voxels.cells(); ++cell) {
    double least = 1e300;
    for (std::size_t other = 0; other < voxels.cells(); ++other) {
      if (voxels.solid(other)) continue;
      const glm::dvec3 way(voxels.voxel_of(cell) - voxels.voxel_of(other));
      least = std::min(least, glm::dot(way, way));
    }
    ASSERT_EQ(distances[cell], least);
    inside += least > 1;
  }
  EXPECT_GT(inside, 20);
}

TEST(Room, FindsTheMirrorOffTheOrigin) {
  const Body body = cross_body({7.3, 0, 0});
  const Voxels voxels(body.positions, body.indices, 64);
  const MirrorPlane plane = mirror_plane(voxels);
  EXPECT_NEAR(voxels.from_grid({plane.x, 0, 0}).x, 7.3, voxels.side());
  EXPECT_GT(plane.share, 0.95);
}

TEST(Room, SpheresFillAndHangTogether) {
  const Body body = test::humanoid_body();
  const Voxels voxels(body.positions, body.indices, 128);
  const Room room(voxels);
  ASSERT_GT(room.size(), 50U);
  EXPECT_EQ(room.share_of_largest_part(), 1);
  EXPECT_NEAR(room.widest() * voxels.side(), 0.16, 0.03);
  for (std::size_t s = 0; s < room.size(); ++s) {
    const Sphere& sphere = room.spheres()[s];
    ASSERT_TRUE(voxels.solid(voxels.cell_at(sphere.centre)));
    // No shorter than straight, and no longer than round the whole body.
    EXPECT_GE(room.distance(0, s) + 1e-9, glm::length(sphere.centre - room.spheres()[0].centre));
    EXPECT_LT(room.distance(0, s) * voxels.side(), 2.5);
  }
  const std::vector<std::size_t> way = room.way(0, room.size() - 1);
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i)
    length += glm::length(room.spheres()[way[i]].centre - room.spheres()[way[i - 1]].centre);
  EXPECT_NEAR(length, room.distance(0, room.size() - 1), 1e-6);
}

// A hand that hangs in the air a little way from its arm is of the body, one that is further off is not.
TEST(Room, BridgesSmallGaps) {
  for (const double gap : {0.035, 0.3}) {
    Body body = cross_body();
    test::add_capsule({1.1 + gap, 1, 0}, {1.2 + gap, 1, 0}, 0.1, body);
    const Voxels voxels(body.positions, body.indices, 128);
    const Room room(voxels);
    double farthest = 0;
    for (const Sphere& sphere : room.spheres()) farthest = std::max(farthest, voxels.from_grid(sphere.centre).x);
    EXPECT_NEAR(farthest, gap < 0.1 ? 1.2 + gap : 0.9, 0.06);
    EXPECT_EQ(room.share_of_largest_part() == 1, gap < 0.1);
  }
}

TEST(AutoSkeleton, ACrossByHand) {
  for (const double scale : {1.0, 1e-9, 1e12}) {
    Body body = cross_body({3, 0, 0});
    for (glm::dvec3& p : body.positions) p *= scale;
    const AutoSkeleton made = auto_skeleton(body.positions, body.indices, cross());
    ASSERT_EQ(made.failure, RigFailure::none);
    const auto expect_at = [&](std::size_t joint, const glm::dvec3& wanted) {
      EXPECT_LT(glm::length(made.places[joint] / scale - wanted), 0.16) << joint;
    };
    expect_at(1, {3, 1, 0});
    expect_at(3, {3, 1.6, 0});
    expect_at(6, {4, 1, 0});
    expect_at(7, {2, 1, 0});
    EXPECT_NEAR(made.places[6].x / scale - 3, 3 - made.places[7].x / scale, 0.02);
  }
}

// Nothing is far enough aside for arms.
TEST(AutoSkeleton, WhatTheTemplateDoesNotFit) {
  Body bar;
  test::add_capsule({0, 0.1, 0}, {0, 1.5, 0}, 0.1, bar);
  const AutoSkeleton made = auto_skeleton(bar.positions, bar.indices, cross());
  EXPECT_EQ(made.failure, RigFailure::no_fit);
  EXPECT_TRUE(made.places.empty());
  const SkeletonTemplate upright = {
      {"low", kNoJoint, {0, 0, 0}}, {"high", 0, {0, 1, 0}}, {"", 1, {0, 2, 0}, kNoJoint, true}};
  const AutoSkeleton fits = auto_skeleton(bar.positions, bar.indices, upright);
  ASSERT_EQ(fits.failure, RigFailure::none);
  EXPECT_GT(fits.places[2].y, fits.places[1].y);
}

TEST(AutoSkeleton, WhatHasNoInside) {
  const std::vector<std::uint32_t> quad = {0, 1, 2, 0, 2, 3};
  const Positions flat = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}};
  EXPECT_EQ(auto_skeleton(flat, quad, cross()).failure, RigFailure::no_room);
  EXPECT_EQ(auto_skeleton({}, {}, cross()).failure, RigFailure::no_room);
  EXPECT_EQ(auto_skeleton({{1, 1, 1}}, {}, cross()).failure, RigFailure::no_room);
  EXPECT_EQ(auto_skeleton({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, std::vector<std::uint32_t>{0, 1, 2}, cross()).failure,
            RigFailure::no_room);
  // A box of which only two neighbouring sides are left: nothing says what is inside.
  const Positions corner = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 1}, {0, 2, 1}};
  const std::vector<std::uint32_t> sides = {0, 1, 2, 0, 2, 3, 0, 3, 5, 0, 5, 4};
  EXPECT_EQ(auto_skeleton(corner, sides, cross()).failure, RigFailure::no_room);
}

TEST(AutoSkeleton, BodiesThatAreApart) {
  Body two = cross_body();
  const Body other = cross_body({3, 0, 0});
  const auto first = static_cast<std::uint32_t>(two.positions.size());
  two.positions.insert(two.positions.end(), other.positions.begin(), other.positions.end());
  for (const std::uint32_t i : other.indices) two.indices.push_back(first + i);
  EXPECT_EQ(auto_skeleton(two.positions, two.indices, cross()).failure, RigFailure::several_parts);
}

// Joints that were pushed aside come part of the way back towards the middle of the mesh, and to one another's mirror
// images.
TEST(AutoSkeleton, RefinementFindsTheMiddle) {
  const Body body = cross_body();
  const Voxels voxels(body.positions, body.indices, 96);
  const Room room(voxels);
  const SkeletonTemplate skeleton = cross();
  const std::vector<Knot> knots = knots_of(skeleton);
  const Embedding embedding = {skeleton, knots, room, mirror_plane(voxels), 1 / voxels.side()};
  std::vector<glm::dvec3> places;
  for (const TemplateJoint& joint : skeleton)
    places.push_back(voxels.to_grid(joint.place * 0.9 + glm::dvec3(0, 0.12, 0.05)));
  const auto off = [&] {  // of bones' middles
    double sum = 0;
    for (std::size_t j = 1; j < places.size(); ++j)
      sum += room.off_centre((places[j] + places[static_cast<std::size_t>(skeleton[j].parent)]) * 0.5);
    return sum;
  };
  const double before = off();
  refine_joints(embedding, places);
  EXPECT_LT(off(), 0.8 * before);
  EXPECT_NEAR(places[4].x - embedding.plane.x, embedding.plane.x - places[5].x, 1e-9);
}

TEST(AutoSkeleton, BadInputGivesFinitePlaces) {
  std::mt19937 random(3);
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Body soup, huge = cross_body(), tiny = cross_body(), long_one = cross_body();
  for (std::uint32_t i = 0; i < 600; ++i) {
    soup.positions.emplace_back(share(), share(), share());
    soup.indices.push_back(i);
  }
  for (glm::dvec3& p : huge.positions) p *= 1e29;
  for (glm::dvec3& p : tiny.positions) p *= 1e-40;
  for (glm::dvec3& p : long_one.positions) p.x *= 1e6;
  long_one.positions.emplace_back(-1e29, 0, 0);  // of no triangle
  for (const Body* const body : {&soup, &huge, &tiny, &long_one}) {
    const AutoSkeleton made = auto_skeleton(body->positions, body->indices, cross());
    EXPECT_EQ(made.places.size(), made.failure == RigFailure::none ? cross().size() : 0U);
    for (const glm::dvec3& p : made.places) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
}

TEST(AutoSkeleton, TheSameEveryTime) {
  const Body body = cross_body();
  const AutoSkeleton first = auto_skeleton(body.positions, body.indices, cross());
  const AutoSkeleton second = auto_skeleton(body.positions, body.indices, cross());
  ASSERT_EQ(first.places.size(), cross().size());
  for (std::size_t j = 0; j < first.places.size(); ++j) EXPECT_EQ(first.places[j], second.places[j]);
}

}  // namespace
}  // namespace marrow::deform
