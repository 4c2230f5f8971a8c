// Runs that become longer: when they do, by hand, and that no vertex notices, to the bit.
#include <bit>
#include <map>

#include <gtest/gtest.h>

#include "cook/geometry/owned_streams.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

using cook::OwnedStreams;

struct Influences {
  std::vector<std::int32_t> joints, weights;  // ascending; of all but the last
  std::size_t count = 1;                      // vertices alike
};

// Positions are 0; weights of 8 bits.
OwnedStreams mesh_of(const std::vector<Influences>& vertices, std::uint32_t influences) {
  OwnedStreams out;
  out.mesh.joint_count = 60;
  out.mesh.influences = influences;
  out.add(StreamKind::position, 3, 14);
  out.add(StreamKind::joints, influences, 15);
  out.add(StreamKind::weights, influences - 1, 8).step = 1.0f / 255;
  for (const Influences& f : vertices)
    for (std::size_t i = 0; i < f.count; ++i, ++out.mesh.vertex_count) {
      out.values[0].insert(out.values[0].end(), 3, 0);
      for (std::size_t j = 0; j < influences; ++j) {
        out.values[1].push_back(f.joints[std::min(j, f.joints.size() - 1)]);
        if (j + 1 < influences) out.values[2].push_back(j < f.weights.size() ? f.weights[j] : 0);
      }
    }
  return out;
}

template <class T>
std::vector<T> row(const std::vector<T>& all, std::size_t v, std::size_t width) {
  return {all.begin() + static_cast<std::ptrdiff_t>(v * width),
          all.begin() + static_cast<std::ptrdiff_t>((v + 1) * width)};
}
std::vector<std::int32_t> joints_of(OwnedStreams& s, std::size_t v) {
  return row(*s.values_of(StreamKind::joints), v, s.mesh.influences);
}
std::vector<std::int32_t> weights_of(OwnedStreams& s, std::size_t v) {
  return row(*s.values_of(StreamKind::weights), v, s.mesh.influences - 1);
}

using Numbers = std::vector<std::int32_t>;

// Apart they cost 2 (1 + 1) + 1 each, 10; together 3 (1 + 1) + 1, 7.
TEST(MergeRuns, TwoThatFillABlockTogetherBecomeOne) {
  OwnedStreams s = mesh_of({{{4, 9}, {200}, 3}, {{7, 9}, {31}, 1}}, 3);
  cook::merge_runs(s);
  for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(joints_of(s, v), (Numbers{4, 7, 9}));
  EXPECT_EQ(weights_of(s, 0), (Numbers{200, 0}));
  EXPECT_EQ(weights_of(s, 3), (Numbers{0, 31}));
}

// Apart 2 (1 + 1) + 1 each, 10; together 3 (2 + 1) + 1, 10.
TEST(MergeRuns, TwoFullBlocksStayApart) {
  OwnedStreams s = mesh_of({{{4, 9}, {200}, 4}, {{7, 9}, {31}, 4}}, 3);
  const auto before = s.values;
  cook::merge_runs(s);
  EXPECT_EQ(s.values, before);
}

// Its 2 (1 + 1) + 1 go, and no block comes: 40 and 3 vertices take 11 blocks, but the 40 alone 10.
TEST(MergeRuns, AShortOneGoesToASupersetsRun) {
  OwnedStreams s = mesh_of({{{4, 5, 9}, {100, 50}, 39}, {{5, 9}, {255}, 1}, {{9}, {}, 60}}, 3);
  cook::merge_runs(s);
  EXPECT_EQ(joints_of(s, 0), (Numbers{4, 5, 9}));
  EXPECT_EQ(joints_of(s, 39), (Numbers{4, 5, 9}));
  EXPECT_EQ(weights_of(s, 39), (Numbers{0, 255}));
  EXPECT_EQ(joints_of(s, 40), (Numbers{9, 9, 9})) << "fifteen blocks would cost a matrix more each";
  EXPECT_EQ(weights_of(s, 40), (Numbers{0, 0}));
}

TEST(MergeRuns, OthersLastJointIsNone) {
  OwnedStreams s = mesh_of({{{4, 9}, {200}, 1}, {{4, 8}, {31}, 1}, {{4}, {}, 1}}, 3);
  const auto before = s.values;
  cook::merge_runs(s);
  EXPECT_EQ(s.values, before) << "whose weight is what the others leave";
}

TEST(MergeRuns, NoVertexFollowsMoreThanTheMeshAllows) {
  OwnedStreams s = mesh_of({{{4, 9}, {200}, 1}, {{7, 9}, {31}, 1}}, 2);
  const auto before = s.values;
  cook::merge_runs(s);
  EXPECT_EQ(s.values, before);
}

TEST(MergeRuns, WhatTheOtherDeformersHaveGoesAlong) {
  OwnedStreams s = mesh_of({{{4, 9}, {200}, 1}, {{7, 9}, {31}, 1}}, 3);
  for (int j = 0; j < 3; ++j) {
    s.add(StreamKind::residual, 4, 6).target = static_cast<std::uint32_t>(j);
    s.values.back() = {1 + j, 2, 3, 4, 11 + j, 12, 13, 14};
    if (j == 2) s.values.back() = {32, 32, 32, 32, 32, 32, 32, 32};
  }
  for (int j = 0; j < 3; ++j) {
    s.add(StreamKind::multi_weight, 12, 0).target = static_cast<std::uint32_t>(j);
    s.values.back() = Numbers(24, j == 2 ? 0 : 70 + j);
  }
  cook::merge_runs(s);
  EXPECT_EQ(row(s.values[3], 0, 4), (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(row(s.values[4], 0, 4), (Numbers{32, 32, 32, 32})) << "of joint 7";
  EXPECT_EQ(row(s.values[5], 0, 4), (Numbers{2, 2, 3, 4}));
  EXPECT_EQ(row(s.values[3], 1, 4), (Numbers{32, 32, 32, 32})) << "of joint 4";
  EXPECT_EQ(row(s.values[4], 1, 4), (Numbers{11, 12, 13, 14}));
  EXPECT_EQ(row(s.values[5], 1, 4), (Numbers{12, 12, 13, 14}));
  EXPECT_EQ(row(s.values[7], 0, 12), Numbers(12, 0));
  EXPECT_EQ(row(s.values[8], 0, 12), Numbers(12, 71));
  EXPECT_EQ(row(s.values[6], 1, 12), Numbers(12, 0));
  EXPECT_EQ(row(s.values[7], 1, 12), Numbers(12, 70));
}

// One number of the blended matrix, as skin.h says: the last joint's, and each other's difference from it by its
// weight.
float blended(OwnedStreams& s, std::size_t v, const std::vector<float>& of_joint) {
  const Numbers joints = joints_of(s, v), weights = weights_of(s, v);
  std::size_t count = 1;
  while (count < joints.size() && joints[count] != joints[count - 1]) ++count;
  const float last = of_joint[static_cast<std::size_t>(joints[count - 1])];
  float sum = last;
  for (std::size_t j = 0; j + 1 < count; ++j)
    sum += static_cast<float>(weights[j]) * (1.0f / 255) * (of_joint[static_cast<std::size_t>(joints[j])] - last);
  return sum;
}

std::size_t run_count(OwnedStreams& s) {
  std::map<Numbers, int> sets;
  for (std::size_t v = 0; v < s.mesh.vertex_count; ++v) ++sets[joints_of(s, v)];
  return sets.size();
}

TEST(MergeRuns, EveryVertexGoesWhereItWentToTheBit) {
  Random random(7);
  std::size_t merged = 0;
  for (int round = 0; round < 40; ++round) {
    const std::uint32_t influences = 2 + random.below(7);
    std::vector<Influences> vertices;
    for (int i = 0; i < 60; ++i) {
      Influences& f = vertices.emplace_back();
      const std::uint32_t first = random.below(20), count = 1 + random.below(influences);
      for (std::uint32_t j = 0; f.joints.size() < count; ++j)
        if (j + 1 >= count || random.below(2) == 0) f.joints.push_back(static_cast<std::int32_t>(first + j));
      for (std::int32_t left = 255; f.weights.size() + 1 < f.joints.size(); left -= f.weights.back())
        f.weights.push_back(static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(left) + 1)));
      f.count = 1 + random.below(random.below(4) == 0 ? 60 : 6);
    }
    OwnedStreams s = mesh_of(vertices, influences), before = s;
    std::vector<float> of_joint;
    for (int j = 0; j < 60; ++j) of_joint.push_back(static_cast<float>(random.between(-2, 2)));
    cook::merge_runs(s);
    EXPECT_LE(run_count(s), run_count(before));
    merged += run_count(before) - run_count(s);
    for (std::size_t v = 0; v < s.mesh.vertex_count; ++v)
      ASSERT_EQ(std::bit_cast<std::uint32_t>(blended(s, v, of_joint)),
                std::bit_cast<std::uint32_t>(blended(before, v, of_joint)))
          << "round " << round << " vertex " << v;
  }
  EXPECT_GT(merged, 500u);
}

// A mesh without weights, and one whose vertices follow one joint each.
TEST(MergeRuns, NothingToMerge) {
  OwnedStreams s;
  s.mesh.vertex_count = 1;
  s.add(StreamKind::position, 3, 14);
  s.values[0] = {1, 2, 3};
  cook::merge_runs(s);
  EXPECT_EQ(s.values[0], (Numbers{1, 2, 3}));
  s.add(StreamKind::joints, 1, 15);
  s.values[1] = {5};
  cook::merge_runs(s);
  EXPECT_EQ(s.values[1], Numbers{5});
}

}  // namespace
}  // namespace marrow::test
