#include "deform/helpers/helpers.h"

#include <limits>

#include <gtest/gtest.h>

#include "deform/helpers/closed_form.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

double apart(const Matrix& a, const Matrix& b) {
  double worst = 0;
  for (int c = 0; c < 4; ++c) worst = std::max(worst, glm::length(a[c] - b[c]));
  return worst;
}

// Two joints that share vertices all the way from one to the other, and a third.
SkinnedMesh strip(int vertices) {
  SkinnedMesh mesh;
  mesh.joint_count = 3;
  for (int v = 0; v < vertices; ++v) {
    const double t = (v + 0.5) / vertices;
    mesh.positions.emplace_back(v, 1, 0);
    mesh.influences.push_back({{0, 1 - t}, {1, t}});
  }
  return mesh;
}

std::vector<Pose> no_poses() {
  return {};
}

std::vector<glm::dvec3> places(const SkinnedMesh& mesh) {
  return std::vector<glm::dvec3>(mesh.joint_count, glm::dvec3(0));
}

TEST(Helpers, EndAtTheirJoints) {
  const Matrix first = matrix(turn(40, {1, 2, 3}), {1, 2, 3}, 1.5),
               second = matrix(turn(140, {3, -1, 0}), {0, 5, 1}, 0.7);
  for (const bool dual : {false, true}) {
    EXPECT_LT(apart(blended({0, 1, 0, {4, 5, 6}, dual}, first, second), first), 1e-12);
    EXPECT_LT(apart(blended({0, 1, 1, {4, 5, 6}, dual}, first, second), second), 1e-12);
  }
}

// A quarter turn about a joint at x = 2: half of it is an eighth about the same place.
TEST(Helpers, TurnHalfAboutTheJoint) {
  const glm::dvec3 centre(2, 0, 0);
  for (const bool dual : {false, true}) {
    EXPECT_LT(apart(blended({0, 1, 0.5, centre, dual}, about(centre, 0), about(centre, 90)), about(centre, 45)), 1e-12);
    EXPECT_LT(apart(blended({0, 1, 0.5, centre, dual}, about(centre, 20), about(centre, -70)), about(centre, -25)),
              1e-12);
    EXPECT_LT(apart(blended({0, 1, 0.5, centre, dual}, about(centre, 100), about(centre, -100)), about(centre, 180)),
              1e-12)
        << "the shorter way";
  }
}

// Joints that do not touch: each turns a quarter, about its own place. The dual quaternion's screw is by hand: the
// rotation of an eighth between none and a quarter, its translation 2 dual conj(real) with real = cos π/8.
TEST(Helpers, BlendDualQuaternions) {
  const Matrix still(1.0), lifted = matrix(turn(90, {0, 0, 1}), {0, 0, 2});
  const Matrix half = blended({0, 1, 0.5, {1, 2, 3}, true}, still, lifted);
  EXPECT_LT(apart(half, matrix(turn(45, {0, 0, 1}), {0, 0, 1})), 1e-12);
  // As a vertex that follows both alike.
  SkinnedMesh mesh;
  mesh.joint_count = 2;
  mesh.positions = {{1, 2, 3}};
  mesh.influences = {{{0, 0.25}, {1, 0.75}}};
  const Pose pose = {matrix(turn(70, {1, 0, 2}), {3, 2, 1}), matrix(turn(-30, {0, 1, 1}), {0, 1, 5})};
  const Positions want = at(dual_quaternions(mesh), pose);
  EXPECT_LT(
      glm::length(transform(blended({0, 1, 0.75, {5, -1, 2}, true}, pose[0], pose[1]), mesh.positions[0]) - want[0]),
      1e-12);
}

TEST(Helpers, MoveWithTheRoot) {
  const Pose pose = {matrix(turn(10, {1, 0, 0}), {1, 0, 0}, 1.2), matrix(turn(100, {0, 1, 1}), {0, 1, 0})};
  const Pose there = moved(turn(200, {1, 1, 0}), {7, 8, 9}, pose);
  for (const bool dual : {false, true}) {
    const Matrix between = blended({0, 1, 0.25, {1, 1, 1}, dual}, pose[0], pose[1]);
    EXPECT_LT(apart(blended({0, 1, 0.25, {1, 1, 1}, dual}, there[0], there[1]),
                    moved(turn(200, {1, 1, 0}), {7, 8, 9}, {between})[0]),
              1e-12);
  }
}

// A matrix without volume has no rotation: then numbers are blended.
TEST(Helpers, BlendNumbersWhereAVolumeIsLost) {
  const Matrix good = matrix(turn(40, {1, 2, 3}), {1, 2, 3}),
               point(glm::dvec3(0), glm::dvec3(0), glm::dvec3(0), {3, 2, 1});
  for (const bool dual : {false, true}) {
    EXPECT_LT(apart(blended({0, 1, 0.25, {4, 5, 6}, dual}, good, point), good * 0.75 + point * 0.25), 1e-12);
    EXPECT_LT(apart(blended({0, 1, 0.25, {4, 5, 6}, dual}, point, good), point * 0.75 + good * 0.25), 1e-12);
  }
}

TEST(Helpers, GiveTheirWeightsToTheirJoints) {
  const std::vector<Influence> out =
      on_joints({{1, 0.25}, {3, 0.5}, {4, 0.25}}, {{0, 1, 0.5, {}, true}, {1, 2, 0.75, {}, true}}, 3);
  ASSERT_EQ(out.size(), 3u);
  EXPECT_DOUBLE_EQ(out[0].weight, 0.25);
  EXPECT_DOUBLE_EQ(out[1].weight, 0.25 + 0.25 + 0.0625);
  EXPECT_DOUBLE_EQ(out[2].weight, 0.1875);
}

// Two joints, one helper: what is nearer to the helper goes to it, by hand.
TEST(ClosedForm, GoesToTheNearestHelper) {
  SkinnedMesh mesh = strip(4);
  const std::vector<Helper> helpers = {{0, 1, 0.5, {}, true}};
  const Likeness likeness(mesh, no_poses(), {});
  const ClosedForm form(mesh, helpers, likeness);
  const std::vector<std::vector<Influence>> want = {
      {{0, 0.75}, {3, 0.25}}, {{0, 0.25}, {3, 0.75}}, {{1, 0.25}, {3, 0.75}}, {{1, 0.75}, {3, 0.25}}};
  for (std::size_t v = 0; v < 4; ++v) {
    const std::vector<Influence> got = form.weights_of(v);
    ASSERT_EQ(got.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(got[i].joint, want[v][i].joint);
      EXPECT_NEAR(got[i].weight, want[v][i].weight, 1e-12);
    }
  }
  EXPECT_FALSE(form.weights_of(0, std::vector<std::uint32_t>{0}).has_value());
  EXPECT_FALSE(form.weights_of(0, std::vector<std::uint32_t>{1, 3}).has_value()) << "beyond the helper";
  EXPECT_TRUE(form.weights_of(0, std::vector<std::uint32_t>{0, 3}).has_value());
}

SkinnedMesh random_mesh(std::uint32_t joints, std::size_t vertices, std::mt19937& random) {
  const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
  SkinnedMesh mesh;
  mesh.joint_count = joints;
  for (std::size_t v = 0; v < vertices; ++v) {
    std::map<std::uint32_t, double> w;
    double sum = 0;
    const std::uint32_t count = 1 + below(6);
    for (std::uint32_t i = 0; i < count; ++i) w[below(joints)] = 1 + below(100);
    for (const auto& [j, x] : w) sum += x;
    std::vector<Influence>& to = mesh.influences.emplace_back();
    for (const auto& [j, x] : w) to.push_back({j, x / sum});
    mesh.positions.emplace_back(v, v % 3, 1);
  }
  return mesh;
}

std::vector<Pose> random_poses(std::uint32_t joints, int count, std::mt19937& random) {
  std::vector<Pose> out(static_cast<std::size_t>(count));
  for (Pose& pose : out)
    for (std::uint32_t j = 0; j < joints; ++j)
      pose.push_back(matrix(turn(static_cast<double>(random() % 180),
                                 {1 + static_cast<int>(random() % 3), static_cast<int>(random() % 3), 1}),
                            {0, 0, 0}));
  return out;
}

// Whatever helpers there are: the weights are SSD's, there are never more, all are positive, and none of the bases that
// a random search finds costs less.
TEST(ClosedForm, IsTheArtistsWeightsAndTheCheapest) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    const SkinnedMesh mesh = random_mesh(8, 40, random);
    const Likeness likeness(mesh, random_poses(8, 10, random), {});
    const std::vector<Helper> helpers = choose_helpers(mesh, likeness, places(mesh), 20, false, 4);
    const ClosedForm form(mesh, helpers, likeness);
    const auto cost = [&](const std::vector<Influence>& weights) {
      double out = 0;
      for (const Influence& i : weights)
        if (const Helper* h = i.joint < 8 ? nullptr : &helpers[i.joint - 8]; h == nullptr) {
          out += i.weight;
        } else {
          const double s = h->share;
          out += i.weight * ((1 - s) * (1 - s) + s * s + 2 * s * (1 - s) * likeness.of(h->first, h->second));
        }
      return out;
    };
    for (std::size_t v = 0; v < mesh.influences.size(); ++v) {
      const std::vector<Influence> got = form.weights_of(v);
      EXPECT_LE(got.size(), mesh.influences[v].size());
      for (const Influence& i : got) EXPECT_GT(i.weight, 0);
      const std::vector<Influence> back = on_joints(got, helpers, 8);
      ASSERT_EQ(back.size(), mesh.influences[v].size());
      for (std::size_t i = 0; i < back.size(); ++i)
        EXPECT_NEAR(back[i].weight, mesh.influences[v][i].weight, 1e-9) << v;
      // Any subset of what it may follow is no cheaper.
      const std::vector<std::uint32_t> all = form.entries_of(v);
      for (int trial = 0; trial < 30; ++trial) {
        std::vector<std::uint32_t> some;
        for (const std::uint32_t entry : all)
          if (random() % 2 == 0) some.push_back(entry);
        const std::optional<std::vector<Influence>> other = form.weights_of(v, some);
        if (!other) continue;
        EXPECT_GE(cost(*other), cost(got) - 1e-9);
        for (const Influence& i : *other) EXPECT_TRUE(std::ranges::binary_search(some, i.joint));
      }
    }
  }
}

// Twisted by up to 170°, a helper at a half leaves under a quarter of linear blend skinning's error, quarters under a
// tenth; the closed form is never worse.
TEST(ClosedForm, KeepsACylinderRound) {
  const SkinnedMesh mesh = cylinder();
  const Deformer truth = dual_quaternions(mesh), plain = ssd(mesh);
  double before = 1;
  for (const std::size_t most : {std::size_t{1}, std::size_t{3}}) {
    const Likeness likeness(mesh, no_poses(), {});
    const std::vector<Helper> helpers = choose_helpers(mesh, likeness, places(mesh), most, false, 4);
    ASSERT_EQ(helpers.size(), most);
    const ClosedForm form(mesh, helpers, likeness);
    Coordinates coordinates;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      coordinates.push_back(lift(form.weights_of(v), mesh.positions[v]));
    const Deformer ours = animation_space(coordinates);
    double squares = 0, of_ssd = 0;
    for (double twist = -170; twist <= 170; twist += 10) {
      const Pose pose = cylinder_pose(twist / 3 * kDegree, twist * kDegree);
      Pose extended = pose;
      append_helpers(helpers, extended);
      const Positions want = at(truth, pose), got = at(ours, extended), linear = at(plain, pose);
      double here = 0, there = 0;
      for (std::size_t v = 0; v < want.size(); ++v) {
        here += glm::dot(got[v] - want[v], got[v] - want[v]);
        there += glm::dot(linear[v] - want[v], linear[v] - want[v]);
      }
      EXPECT_LE(here, there * (1 + 1e-9) + 1e-20) << twist;
      squares += here;
      of_ssd += there;
    }
    const double share = std::sqrt(squares / of_ssd);
    EXPECT_LT(share, most == 1 ? 0.36 : 0.13);
    EXPECT_LT(share, before / 2);
    before = share;
  }
}

// Σ (a b)² without poses; a pair that no pose turns apart comes last.
TEST(ChooseHelpers, WhereMostVerticesShareMost) {
  SkinnedMesh mesh = strip(8);
  for (int v = 0; v < 5; ++v) {
    mesh.positions.emplace_back(20 + v, 1, 0);
    mesh.influences.push_back({{1, 0.5}, {2, 0.5}});
  }
  const std::vector<Helper> two = choose_helpers(mesh, Likeness(mesh, no_poses(), {}), places(mesh), 2, false, 4);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].second, 1u);
  EXPECT_EQ(two[1].second, 2u);
  EXPECT_EQ(two[1].share, 0.5);
  EXPECT_EQ(choose_helpers(mesh, Likeness(mesh, no_poses(), {}), places(mesh), 1, false, 4).at(0).first, 1u)
      << "5 / 16 against 0.27";
  const Pose stiff = {matrix(turn(0, {1, 0, 0}), {0, 0, 0}), matrix(turn(90, {1, 0, 0}), {0, 0, 0}),
                      matrix(turn(90, {1, 0, 0}), {0, 0, 0})};
  const std::vector<Helper> where = choose_helpers(mesh, Likeness(mesh, {stiff}, {}), places(mesh), 3, false, 4);
  ASSERT_EQ(where.size(), 3u);
  for (const Helper& h : where) EXPECT_EQ(h.first, 0u);
  EXPECT_EQ(where[0].share, 0.25);
  EXPECT_EQ(where[2].share, 0.75);
  EXPECT_TRUE(choose_helpers(mesh, Likeness(mesh, no_poses(), {}), places(mesh), 0, false, 4).empty());
}

TEST(ChooseHelpers, DividesAPairIntoAsManyPartsAsItMay) {
  const SkinnedMesh mesh = strip(64);
  const Likeness likeness(mesh, no_poses(), {});
  const auto count = [&](std::size_t most, int parts) {
    return choose_helpers(mesh, likeness, places(mesh), most, false, parts).size();
  };
  EXPECT_EQ(count(9, 2), 1u);
  EXPECT_EQ(count(9, 4), 3u);
  EXPECT_EQ(count(6, 8), 3u) << "eighths are seven";
  const std::vector<Helper> eighths = choose_helpers(mesh, likeness, places(mesh), 9, false, 8);
  ASSERT_EQ(eighths.size(), 7u);
  for (std::size_t h = 0; h < 7; ++h) EXPECT_EQ(eighths[h].share, static_cast<double>(h + 1) / 8);
}

TEST(ChooseHelpers, AboutTheMeanOfCentresOfRotation) {
  const SkinnedMesh mesh = cylinder();
  const std::vector<Helper> helpers = choose_helpers(mesh, Likeness(mesh, no_poses(), {}), places(mesh), 1, true, 4);
  ASSERT_EQ(helpers.size(), 1u);
  ASSERT_FALSE(helpers[0].by_dual_quaternions);
  EXPECT_LT(glm::length(helpers[0].centre), 0.1) << "on the axis, where the joint is";
}

TEST(ChooseHelpers, AsksNothingOfAMeshWithoutPairs) {
  SkinnedMesh mesh = strip(10);
  for (auto& influences : mesh.influences) influences = {{2, 1.0}};
  const Likeness likeness(mesh, no_poses(), {});
  EXPECT_TRUE(choose_helpers(mesh, likeness, places(mesh), 9, true, 4).empty());
  const std::vector<Helper> none;
  EXPECT_EQ(ClosedForm(mesh, none, likeness).weights_of(3).at(0).joint, 2u);
  EXPECT_TRUE(choose_helpers({}, Likeness({}, no_poses(), {}), {}, 9, true, 4).empty());
}

// 300 joints and as many pairs of one vertex each, all in one place.
TEST(ChooseHelpers, TakesManyPairsOfOneVertex) {
  SkinnedMesh mesh;
  mesh.joint_count = 300;
  for (std::uint32_t j = 0; j < 300; ++j) {
    mesh.positions.emplace_back(1, 2, 3);
    mesh.influences.push_back({{std::min(j, (j + 1) % 300), 0.5}, {std::max(j, (j + 1) % 300), 0.5}});
  }
  const std::vector<Helper> helpers = choose_helpers(mesh, Likeness(mesh, no_poses(), {}), places(mesh), 41, true, 4);
  EXPECT_EQ(helpers.size(), 41u);
  for (const Helper& h : helpers) EXPECT_TRUE(std::isfinite(glm::length(h.centre)));
}

TEST(Likeness, IsTheMeanOverPosesThatAreFinite) {
  const SkinnedMesh mesh = strip(3);
  const Pose turned = {matrix(turn(0, {1, 0, 0}), {0, 0, 0}), matrix(turn(120, {1, 0, 0}), {0, 0, 0}),
                       matrix(turn(0, {1, 0, 0}), {0, 0, 0})};
  Pose broken = turned;
  broken[2][3][0] = std::numeric_limits<double>::infinity();
  const Pose same(3, Matrix(1.0));
  const Likeness likeness(mesh, {turned, same, broken}, {});
  EXPECT_NEAR(likeness.of(1, 0), (0.5 + 1) / 2 * 0.966, 1e-12) << "cos 60° and cos 0°, times cos 15°";
  EXPECT_EQ(likeness.of(2, 2), 1);
  EXPECT_EQ(Likeness(mesh, {broken}, {}).of(0, 1), 0.5);
}

// A chain of joints 0, 1 and 2, joint 3 on joint 0 too, and joint 4 on none.
TEST(Likeness, IsLessForEachStepThroughTheSkeleton) {
  SkinnedMesh mesh;
  mesh.joint_count = 5;
  mesh.positions = {{0, 0, 0}};
  mesh.influences = {{{0, 0.2}, {1, 0.2}, {2, 0.2}, {3, 0.2}, {4, 0.2}}};
  const Likeness likeness(mesh, {Pose(5, Matrix(1.0))}, {-1, 0, 1, 0, -1});
  const std::pair<std::uint32_t, std::uint32_t> at[] = {{0, 1}, {0, 2}, {1, 3}, {2, 3}, {1, 4}};
  const int steps[] = {1, 2, 2, 3, 1};
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(likeness.of(at[i].first, at[i].second), std::pow(0.966, steps[i]), 1e-12) << i;
}

}  // namespace
}  // namespace marrow::deform
