// The elastic deformer: its equations by hand, its lattice by volume, and what must hold in any pose.
#include "deform/elastic/elastic.h"

#include <limits>

#include <gtest/gtest.h>

#include "deform/elastic/body.h"
#include "deform/look/folds.h"
#include "deform/surface.h"
#include "disk/thread_pool.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

constexpr std::size_t kFew = 500;  // cells

Positions posed(const Elastic& elastic, const Pose& pose) {
  Positions out;
  elastic.pose(pose, out);
  return out;
}

// A closed box whose left half follows the first joint and whose right half the second.
void add_box(const glm::dvec3& low, const glm::dvec3& high, const std::vector<Influence>& influences,
             SkinnedMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t k = 0; k < 8; ++k) {
    mesh.positions.emplace_back(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
    mesh.influences.push_back(influences);
  }
  for (const int i :
       {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5})
    mesh.indices.push_back(first + static_cast<std::uint32_t>(i));
}

// (4 1; 1 3) x = (1, 2) has x = (1, 7) / 11; and -1 2 -1 with 1 at all places is what i (n + 1 - i) / 2 gives.
TEST(Elastic, FactorsSolveWhatIsKnown) {
  std::vector<Four> x = {{{1, 4, 0, 5}}, {{2, 1, 0, 4}}};
  Factor(2, {{0, 0, 3}, {0, 0, 1}, {1, 0, 1}, {1, 1, 3}}).solve(x);
  EXPECT_NEAR(x[0].v[0], 1.0 / 11, 1e-7);
  EXPECT_NEAR(x[1].v[0], 7.0 / 11, 1e-7);
  EXPECT_NEAR(x[0].v[1], 1, 1e-7);
  EXPECT_NEAR(x[1].v[1], 0, 1e-7);
  EXPECT_EQ(x[0].v[2], 0);
  // All ones and one more on the diagonal: x = b - Σ b / (n + 1).
  std::vector<MatrixEntry> full;
  for (std::uint32_t i = 0; i < 6; ++i)
    for (std::uint32_t k = 0; k <= i; ++k) full.push_back({i, k, i == k ? 2.0 : 1.0});
  std::vector<Four> numbers;
  for (std::uint32_t i = 0; i < 6; ++i) numbers.push_back({{static_cast<float>(i), 0, 0, 0}});
  Factor(6, full).solve(numbers);
  for (std::uint32_t i = 0; i < 6; ++i) EXPECT_NEAR(numbers[i].v[0], i - 15.0 / 7, 1e-5);
  constexpr std::uint32_t kLong = 40;
  std::vector<MatrixEntry> chain;
  for (std::uint32_t i = 0; i < kLong; ++i) {
    chain.push_back({i, i, 2});
    if (i > 0) chain.push_back({i, i - 1, -1});
  }
  std::vector<Four> ones(kLong, {{1, 1, 1, 1}});
  Factor(kLong, chain).solve(ones);
  for (std::uint32_t i = 0; i < kLong; ++i) EXPECT_NEAR(ones[i].v[3], (i + 1) * (kLong - i) / 2.0, 1e-3) << i;
}

// Filled cells have the volume of the body, and of the voxels that its surface touches.
TEST(Elastic, LatticesFillBodies) {
  SkinnedMesh mesh;
  mesh.joint_count = 1;
  add_box({0, 0, 0}, {4, 2, 1}, {{0, 1}}, mesh);
  const Lattice lattice = make_lattice(mesh, kFew);
  double filled = 0;
  for (const Lattice::Cell& cell : lattice.cells) filled += static_cast<double>(cell.filled);
  const double voxel = lattice.side / 3, volume = filled * lattice.side * lattice.side * lattice.side;
  EXPECT_GE(volume, 8);
  EXPECT_LE(volume, (4 + 2 * voxel) * (2 + 2 * voxel) * (1 + 2 * voxel));
  for (std::size_t v = 0; v < 8; ++v) {
    ASSERT_NE(lattice.cell_of[v], Lattice::kNone);
    const glm::dvec3 at = lattice.to_lattice(mesh.positions[v]) - glm::dvec3(lattice.cells[lattice.cell_of[v]].at);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(at[i] >= 0 && at[i] <= 1);
  }
}

// Two boxes in neighbouring voxels, like fingers: one body if they follow one joint, two if each has its own.
TEST(Elastic, WhatFollowsOtherJointsDoesNotStick) {
  const auto boxes = [](double gap_at, double gap, std::uint32_t other) {
    SkinnedMesh mesh;
    mesh.joint_count = 2;
    add_box({0, 0, 0}, {8, gap_at - gap / 2, 1}, {{0, 1}}, mesh);
    add_box({0, gap_at + gap / 2, 0}, {8, 2, 1}, {{other, 1}}, mesh);
    return mesh;
  };
  const Lattice first = make_lattice(boxes(1, 0.01, 0), kFew);
  const double voxel = first.side / 3;
  const double border = first.origin.y + voxel * std::round((1 - first.origin.y) / voxel);
  for (const std::uint32_t other : {0u, 1u}) {
    const Lattice lattice = make_lattice(boxes(border, 0.6 * voxel, other), kFew);
    ASSERT_NEAR(lattice.side, first.side, 1e-12);
    std::vector<std::uint32_t> reached = {lattice.cell_of[0]};
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const std::uint32_t b : lattice.cells[reached[i]].beside)
        if (b != Lattice::kNone && std::ranges::find(reached, b) == reached.end()) reached.push_back(b);
    const bool hangs_together = std::ranges::find(reached, lattice.cell_of[8]) != reached.end();
    EXPECT_EQ(hangs_together, other == 0);
    EXPECT_EQ(reached.size() == lattice.cells.size(), other == 0);
  }
}

// Weights that are the same everywhere are so inside, too.
TEST(Elastic, NodesHaveTheWeightsOfVertices) {
  SkinnedMesh mesh = cylinder();
  for (std::vector<Influence>& vertex : mesh.influences) vertex = {{0, 0.25}, {1, 0.75}};
  const Lattice lattice = make_lattice(mesh, kFew);
  std::size_t counted = 0;
  for (const std::vector<Influence>& node : node_weights(lattice, mesh)) {
    ASSERT_EQ(node.size(), 2u);
    EXPECT_NEAR(node[1].weight, 0.75, 1e-4);
    ++counted;
  }
  EXPECT_GT(counted, 200u);
}

TEST(Elastic, BindPoseAndRigidMotionsAreExact) {
  const SkinnedMesh mesh = cylinder();
  const Elastic elastic(mesh, {}, kFew);
  EXPECT_LT(farthest(posed(elastic, cylinder_pose(0, 0)), mesh.positions), 1e-12);
  for (const double scale : {1.0, 0.01, 30.0, -2.0}) {
    const Matrix m = matrix(turn(77, {1, -2, 3}), {300, -20, 5}, scale);
    Positions expected;
    for (const glm::dvec3& p : mesh.positions) expected.push_back(transform(m, p));
    EXPECT_LT(farthest(posed(elastic, {m, m}), expected), 1e-11 * (300 + std::abs(scale))) << scale;
  }
}

// The same after a motion and a scale of the whole, up to single precision.
TEST(Elastic, MovesAndScalesWithTheRoot) {
  const SkinnedMesh mesh = cylinder();
  const Elastic elastic(mesh, {}, kFew);
  const Positions bent = posed(elastic, kBent);
  const Matrix m = matrix(turn(-50, {2, 1, 0}), {100, 20, 3}, 0.25);
  Pose pose = kBent;
  for (Matrix& joint : pose) {
    const glm::dvec3 to = transform(m, joint[3]);
    for (int c = 0; c < 3; ++c) joint[c] = linear_of(m) * joint[c];
    joint[3] = to;
  }
  Positions expected;
  for (const glm::dvec3& p : bent) expected.push_back(transform(m, p));
  EXPECT_LT(farthest(posed(elastic, pose), expected), 1e-5);
}

TEST(Elastic, GoesWithOneJointWhereNothingElsePulls) {
  const SkinnedMesh mesh = cylinder();
  const Positions bent = posed(Elastic(mesh, {}, kFew), kBent);
  std::size_t counted = 0;
  for (std::size_t v = 0; v < bent.size(); ++v) {
    if (std::abs(mesh.positions[v].x) < 4) continue;
    EXPECT_LT(glm::length(bent[v] - transform(kBent[mesh.influences[v][0].joint], mesh.positions[v])), 1e-4);
    ++counted;
  }
  EXPECT_GT(counted, 300u);
}

// A tube that is wrung to 170°: linear blending leaves it hardly a waist and turns triangles over.
TEST(Elastic, KeepsWhatTwistsWring) {
  const SkinnedMesh mesh = cylinder();
  const Pose wrung = cylinder_pose(0, 170 * kDegree);
  const Positions plain = at(ssd(mesh), wrung), now = posed(Elastic(mesh, {15, 0.1}, kFew), wrung);
  const double bind = volume(mesh.positions, mesh.indices);
  EXPECT_GT(volume(now, mesh.indices), 0.93 * bind);
  EXPECT_LT(volume(plain, mesh.indices), 0.92 * bind);
  double narrowest = 1, narrowest_plain = 1;
  for (std::size_t v = 0; v < 2000; ++v) {
    narrowest = std::min(narrowest, std::hypot(now[v].y, now[v].z));
    narrowest_plain = std::min(narrowest_plain, std::hypot(plain[v].y, plain[v].z));
  }
  EXPECT_LT(narrowest_plain, 0.2);
  EXPECT_GT(narrowest, 0.6);
  const FoldMeter meter(mesh);
  EXPECT_LT(meter.of(wrung, now).bend_rad, meter.of(wrung, plain).bend_rad);
}

TEST(Elastic, GivesTheSameOnAnyNumberOfThreads) {
  const SkinnedMesh mesh = cylinder();
  const Positions one = posed(Elastic(mesh, {}, kFew), kBent);
  tools::set_thread_count(2);
  const tools::UseWork work({&tools::all_cores(), nullptr});
  const Elastic elastic(mesh, {}, kFew);
  std::vector<Positions> several(4);
  tools::for_each_in_parallel(several.size(), [&](std::size_t i) { elastic.pose(kBent, several[i]); });
  for (const Positions& p : several) EXPECT_EQ(farthest(p, one), 0);
}

// Of any size alike.
TEST(Elastic, TakesTinyAndEnormousMeshes) {
  const SkinnedMesh mesh = cylinder();
  const Positions expected = posed(Elastic(mesh, {}, kFew), kBent);
  for (const double size : {1.0 / 1048576, 1048576.0}) {
    SkinnedMesh other = mesh;
    for (glm::dvec3& p : other.positions) p *= size;
    Positions got = posed(Elastic(other, {}, kFew), kBent);
    for (glm::dvec3& p : got) p /= size;
    EXPECT_LT(farthest(got, expected), 1e-4) << size;
  }
}

// Where there is no body it is dual quaternions.
TEST(Elastic, IsDualQuaternionsWhereThereIsNoBody) {
  SkinnedMesh points = cylinder();
  points.indices.clear();
  EXPECT_EQ(farthest(posed(Elastic(points, {}, kFew), kBent), at(dual_quaternions(points), kBent)), 0);
  SkinnedMesh in_one_place = cylinder();
  for (glm::dvec3& p : in_one_place.positions) p = {1, 2, 3};
  EXPECT_EQ(farthest(posed(Elastic(in_one_place, {}, kFew), kBent), at(dual_quaternions(in_one_place), kBent)), 0);
  Positions none;
  Elastic(SkinnedMesh(), {}, kFew).pose({}, none);
  EXPECT_TRUE(none.empty());
  // A sheet is too thin to be one.
  SkinnedMesh sheet = cylinder();
  for (glm::dvec3& p : sheet.positions) p.z = 0;
  const Positions flat = posed(Elastic(sheet, {}, kFew), kBent);
  EXPECT_TRUE(is_finite(flat));
  EXPECT_LT(farthest(flat, at(dual_quaternions(sheet), kBent)), 0.3);
}

TEST(Elastic, TakesOpenMeshes) {
  SkinnedMesh open = cylinder();
  open.indices.resize(open.indices.size() - 300);
  EXPECT_LT(farthest(posed(Elastic(open, {}, kFew), kBent), posed(Elastic(cylinder(), {}, kFew), kBent)), 0.05);
}

TEST(Elastic, TakesAnyPose) {
  SkinnedMesh mesh = cylinder();
  mesh.joint_count = 3;  // the last without vertices
  const Elastic elastic(mesh, {}, kFew);
  const double infinite = std::numeric_limits<double>::infinity();
  Pose pose = kBent;
  pose.emplace_back(std::nan(""));
  EXPECT_LT(farthest(posed(elastic, pose), posed(Elastic(cylinder(), {}, kFew), kBent)), 1e-12);
  // Of what is not finite as of dual quaternions: those that follow the other joint alone stay.
  pose[1][3].x = infinite;
  const Positions broken = posed(elastic, pose), as = at(dual_quaternions(mesh), pose);
  EXPECT_EQ(broken[0], as[0]);
  EXPECT_FALSE(is_finite(broken));
  std::size_t counted = 0;
  for (const Matrix& second : {Matrix(0.0), matrix(turn(180, {0, 1, 0}), {}), matrix(turn(0, {0, 1, 0}), {}, -1),
                               matrix(turn(30, {0, 1, 0}), {1e5, 0, 0}), matrix(turn(30, {1, 1, 0}), {}, 1e-7),
                               Matrix{{1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, 0}}}) {
    pose[1] = second;
    EXPECT_TRUE(is_finite(posed(elastic, pose))) << counted;
    ++counted;
  }
  EXPECT_EQ(counted, 6u);
}

// A joint that swells by a half: its end is as it says, and the body goes over to it evenly.
TEST(Elastic, FollowsJointsThatScale) {
  const SkinnedMesh mesh = cylinder();
  const Positions now = posed(Elastic(mesh, {}, kFew), {Matrix(1.0), matrix(turn(0, {1, 0, 0}), {}, 1.5)});
  std::size_t counted = 0;
  for (std::size_t v = 0; v < 2000; ++v) {
    const double radius = std::hypot(now[v].y, now[v].z);
    if (mesh.positions[v].x > 4) {
      EXPECT_LT(glm::length(now[v] - mesh.positions[v] * 1.5), 1e-3);
    }
    EXPECT_GT(radius, 0.97);
    EXPECT_LT(radius, 1.53);
    ++counted;
  }
  EXPECT_EQ(counted, 2000u);
}

// Clothes a hair over skin that follow other joints go as dual quaternions say, and so does what is close to them.
TEST(Elastic, KeepsFromBodiesWhoseWeightsAreOthers) {
  SkinnedMesh mesh = cylinder();
  const auto skin = static_cast<std::uint32_t>(mesh.positions.size());
  const std::size_t triangles = mesh.indices.size();
  for (std::uint32_t v = 0; v < skin; ++v) {
    mesh.positions.push_back(mesh.positions[v] * glm::dvec3(1.001, 1.01, 1.01));
    mesh.influences.push_back({{mesh.positions[v].x < 3 ? 1u : 0u, 1}});
  }
  for (std::size_t i = 0; i < triangles; ++i) mesh.indices.push_back(mesh.indices[i] + skin);
  const Elastic elastic(mesh, {}, kFew);
  const Positions now = posed(elastic, kBent), as = at(dual_quaternions(mesh), kBent);
  std::size_t counted = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (elastic.rig_shares()[v] < 1) continue;
    EXPECT_LT(glm::length(now[v] - as[v]), 1e-9);
    ++counted;
  }
  EXPECT_GT(counted, 500u);
}

// A few vertices that follow the other joint: the body draws them back. What it has been shown it leaves to the joints,
// and what is round that partly; what it has not it does not know.
TEST(Elastic, LeavesToJointsWhatIsPulledFromThem) {
  SkinnedMesh mesh = cylinder();
  std::vector<std::uint32_t> few;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec3& p = mesh.positions[v];
    if (std::abs(p.x + 3) > 0.15 || p.y < 0.95) continue;
    mesh.influences[v] = {{1, 1}};
    few.push_back(v);
  }
  ASSERT_GT(few.size(), 2u);
  Elastic elastic(mesh, {}, kFew);
  const auto pulled = [&] {
    const Positions now = posed(elastic, kBent), as = at(dual_quaternions(mesh), kBent);
    double out = 0;
    for (const std::uint32_t v : few) out = std::max(out, glm::length(now[v] - as[v]));
    return out;
  };
  const auto partly = [&] {
    return std::ranges::count_if(elastic.rig_shares(), [](double share) { return share > 0.05 && share < 0.95; });
  };
  const double most = 0.02 * diagonal(mesh);
  ASSERT_GT(pulled(), most);
  const auto before = partly();
  EXPECT_EQ(elastic.look_at({cylinder_pose(0, 0)}), 0u);
  EXPECT_GE(elastic.look_at({kBent}), few.size());
  EXPECT_LT(pulled(), most);
  EXPECT_GT(partly(), before + 10) << "no seam";
}

// A box in the skin that follows both joints alike: the body bends it, joints do not. Once seen it keeps its shape, and
// its middle stays where the body has it.
TEST(Elastic, KeepsStiffPartsInShape) {
  SkinnedMesh mesh = cylinder();
  const std::size_t first = mesh.positions.size();
  add_box({-0.4, 0.8, -0.3}, {0.4, 1.1, 0.3}, {{0, 0.5}, {1, 0.5}}, mesh);
  Elastic elastic(mesh, {}, kFew);
  const auto largest_stretch = [&](const Positions& now) {
    double out = 0;
    for (std::size_t a = first; a < now.size(); ++a)
      for (std::size_t b = first; b < a; ++b)
        out = std::max(out,
                       std::abs(glm::length(now[a] - now[b]) / glm::length(mesh.positions[a] - mesh.positions[b]) - 1));
    return out;
  };
  const auto middle = [&](const Positions& now) {
    glm::dvec3 out(0);
    for (std::size_t v = first; v < now.size(); ++v) out += now[v] / 8.0;
    return out;
  };
  const Positions before = posed(elastic, kBent);
  ASSERT_GT(largest_stretch(before), 0.02);
  elastic.look_at({kBent});
  const Positions after = posed(elastic, kBent);
  EXPECT_LT(largest_stretch(after), 1e-9);
  EXPECT_LT(glm::length(middle(after) - middle(before)), 1e-9);
  for (std::size_t v = 0; v < first; ++v) EXPECT_EQ(after[v], before[v]) << v;
}

}  // namespace
}  // namespace marrow::deform
