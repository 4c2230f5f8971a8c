// Helpers of palettes against dual quaternions and centres of rotation in double precision.
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/bad_numbers.h"
#include "support/rig.h"

namespace marrow {
namespace {

using test::kInfinity;
using test::kNan;
using test::Map;
using test::Quat;
using test::Vec3;

Vec3 column(const Map& m, int c) {
  return {m.rows[0][c], m.rows[1][c], m.rows[2][c]};
}
Vec3 sum(const Vec3& a, double u, const Vec3& b, double v) {
  return {a[0] * u + b[0] * v, a[1] * u + b[1] * v, a[2] * u + b[2] * v};
}
Map map_of(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& t) {
  return {{{x[0], y[0], z[0], t[0]}, {x[1], y[1], z[1], t[1]}, {x[2], y[2], z[2], t[2]}}};
}
// Hamilton's product.
Quat times(const Quat& a, const Quat& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] + a[1] * b[3] + a[2] * b[0] - a[0] * b[2],
          a[3] * b[2] + a[2] * b[3] + a[0] * b[1] - a[1] * b[0], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}
Quat conjugate(const Quat& q) {
  return {-q[0], -q[1], -q[2], q[3]};
}

// The turn of a matrix and what its columns are along the turn's axes, by Gram and Schmidt.
struct Parts {
  Vec3 axis[3];
  double along[3][3] = {};  // [axis][column]
};
Parts parts_of(const Map& m) {
  Parts out;
  out.axis[0] = test::normalised(column(m, 0));
  const Vec3 y = column(m, 1);
  out.axis[1] = test::normalised(sum(y, 1, out.axis[0], -test::dot(y, out.axis[0])));
  out.axis[2] = test::cross(out.axis[0], out.axis[1]);
  for (int a = 0; a < 3; ++a)
    for (int c = 0; c < 3; ++c) out.along[a][c] = test::dot(out.axis[a], column(m, c));
  return out;
}
// By the eigenvector of the greatest eigenvalue of K, by powers of it: I. Bar-Itzhack, New method for extracting the
// quaternion from a rotation matrix, 2000.
Quat quaternion_of(const Parts& p) {
  const auto r = [&](std::size_t i, std::size_t j) { return p.axis[j][i]; };
  double k[4][4] = {{r(0, 0) - r(1, 1) - r(2, 2), r(1, 0) + r(0, 1), r(2, 0) + r(0, 2), r(2, 1) - r(1, 2)},
                    {r(1, 0) + r(0, 1), r(1, 1) - r(0, 0) - r(2, 2), r(2, 1) + r(1, 2), r(0, 2) - r(2, 0)},
                    {r(2, 0) + r(0, 2), r(2, 1) + r(1, 2), r(2, 2) - r(0, 0) - r(1, 1), r(1, 0) - r(0, 1)},
                    {r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1), r(0, 0) + r(1, 1) + r(2, 2)}};
  // (K + 1) / 4 is q qᵀ: any column is along q; the one of the largest diagonal is long.
  std::size_t most = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    k[i][i] += 1;
    if (k[i][i] > k[most][most]) most = i;
  }
  return test::normalised(Quat{k[0][most], k[1][most], k[2][most], k[3][most]});
}

Vec3 inverse_point(const Map& m, const Vec3& p) {
  const Vec3 x = column(m, 0), y = column(m, 1), z = column(m, 2), v = test::minus(p, column(m, 3));
  const double volume = test::dot(x, test::cross(y, z));
  return {test::dot(v, test::cross(y, z)) / volume, test::dot(v, test::cross(z, x)) / volume,
          test::dot(v, test::cross(x, y)) / volume};
}

// What a helper is to be. centre: as the second joint sees it; null: dual quaternions about the joint's origin.
Map blended(const Map& a, const Map& b, const Map& bind, double share, const Vec3* centre) {
  const Parts p = parts_of(a), q = parts_of(b);
  Quat real[2] = {quaternion_of(p), quaternion_of(q)};
  double cosine = 0;
  for (std::size_t i = 0; i < 4; ++i) cosine += real[0][i] * real[1][i];
  if (cosine < 0)
    for (double& c : real[1]) c = -c;
  const Vec3 place = inverse_point(bind, centre == nullptr ? Vec3{0, 0, 0} : *centre);
  const Vec3 at[2] = {test::point(a, place), test::point(b, place)};
  const double shares[2] = {1 - share, share};
  Quat turn{0, 0, 0, 0}, dual{0, 0, 0, 0};
  for (std::size_t k = 0; k < 2; ++k) {
    const Quat half = times({at[k][0] / 2, at[k][1] / 2, at[k][2] / 2, 0}, real[k]);
    for (std::size_t i = 0; i < 4; ++i) {
      turn[i] += shares[k] * real[k][i];
      dual[i] += shares[k] * half[i];
    }
  }
  const double squared = turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3];
  const Quat twice = times(dual, conjugate(turn));
  const Vec3 moved = centre != nullptr ? sum(at[0], shares[0], at[1], shares[1])
                                       : Vec3{2 * twice[0] / squared, 2 * twice[1] / squared, 2 * twice[2] / squared};
  const Map r = test::from_trs({0, 0, 0}, test::normalised(turn), {1, 1, 1});
  Map m = map_of({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  for (int row = 0; row < 3; ++row)
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < 3; ++i)
        m.rows[row][c] += r.rows[row][i] * (shares[0] * p.along[i][c] + shares[1] * q.along[i][c]);
  const Vec3 t = test::minus(moved, test::point(m, place));
  return map_of(column(m, 0), column(m, 1), column(m, 2), t);
}

double apart(const Affine& got, const Map& want) {
  double worst = 0;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) {
      const double d = std::fabs(static_cast<double>(got.rows[r][c]) - want.rows[r][c]);
      worst = d <= worst ? worst : d;  // NaN is far
    }
  return worst;
}
// Joints of a palette; every scale is between the two.
struct Rig {
  std::vector<std::uint16_t> joints;
  std::vector<Affine> bind, scene;
  std::vector<Helper> helpers;
  std::vector<float> centres;

  Rig(std::uint64_t seed, std::size_t count, double least_scale, double most_scale, double most_angle_rad = 3.0) {
    test::Random random(seed);
    const auto some = [&](double most) { return random.between(-most, most); };
    const Quat all = random.rotation();
    for (std::size_t i = 0; i < count; ++i) {
      joints.push_back(static_cast<std::uint16_t>(i));
      bind.push_back(test::to_affine(test::from_trs({some(1), some(1), some(1)}, random.rotation(), {1, 1, 1})));
      const Vec3 axis = {some(1), some(1), some(1)};
      const auto size = [&] { return random.between(least_scale, most_scale); };
      const Map pose = test::from_trs({some(2), some(2), some(2)}, test::axis_angle(axis, some(most_angle_rad / 2)),
                                      {size(), size(), size()});
      // The pose on top of the bind pose, so that turns between entries are those of the pose.
      const Map whole = test::from_trs({0, 0, 0}, all, {1, 1, 1}) * pose * inverse_of(bind.back());
      scene.push_back(test::to_affine(whole));
    }
    for (std::size_t i = 0; i + 1 < count; ++i) {
      constexpr float kShares[] = {0.25f, 0.5f, 0.75f, 1.0f / 3};
      const auto a = static_cast<std::uint16_t>(i), b = static_cast<std::uint16_t>(i + 1);
      helpers.push_back({i % 2 == 0 ? a : b, i % 2 == 0 ? b : a, kShares[i % 4]});
      for (int c = 0; c < 3; ++c) centres.push_back(static_cast<float>(some(1)));
    }
  }
  static Map inverse_of(const Affine& a) {
    const Map m = test::to_map(a);
    const Vec3 o = inverse_point(m, {0, 0, 0}), x = inverse_point(m, {1, 0, 0}), y = inverse_point(m, {0, 1, 0}),
               z = inverse_point(m, {0, 0, 1});
    return map_of(test::minus(x, o), test::minus(y, o), test::minus(z, o), o);
  }
  std::vector<Affine> palette(bool about_centres) const {
    std::vector<Affine> out(joints.size() + helpers.size());
    const Span<const float> none;
    EXPECT_EQ(build_palette(joints, bind, scene, out, helpers, about_centres ? Span<const float>(centres) : none),
              Status::ok);
    return out;
  }
  Map want(std::size_t h, bool about_centres) const {
    const auto entry = [&](std::size_t i) { return test::to_map(scene[joints[i]]) * test::to_map(bind[i]); };
    const Helper& helper = helpers[h];
    const auto c = [&](std::size_t axis) { return static_cast<double>(centres[3 * h + axis]); };
    const Vec3 centre = {c(0), c(1), c(2)};
    return blended(entry(helper.first), entry(helper.second), test::to_map(bind[helper.second]),
                   static_cast<double>(helper.share), about_centres ? &centre : nullptr);
  }
};

double worst_of(const Rig& rig, bool about_centres) {
  const std::vector<Affine> got = rig.palette(about_centres);
  double worst = 0;
  for (std::size_t h = 0; h < rig.helpers.size(); ++h) {
    const double d = apart(got[rig.joints.size() + h], rig.want(h, about_centres));
    worst = d <= worst ? worst : d;
  }
  return worst;
}

// 1 to 12 helpers: full fours and what is left of them.
TEST(Helpers, BlendDualQuaternions) {
  for (std::size_t count = 2; count <= 13; ++count)
    for (std::uint64_t seed = 0; seed < 20; ++seed) EXPECT_LT(worst_of(Rig(seed, count, 1, 1), false), 4e-6) << count;
}

TEST(Helpers, TurnAboutCentres) {
  for (std::size_t count = 2; count <= 13; ++count)
    for (std::uint64_t seed = 0; seed < 20; ++seed) EXPECT_LT(worst_of(Rig(seed, count, 1, 1), true), 4e-6) << count;
}

TEST(Helpers, BlendStretchesLinearly) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    EXPECT_LT(worst_of(Rig(seed, 9, 0.5, 2), false), 3e-5) << seed;
    EXPECT_LT(worst_of(Rig(seed, 9, 0.5, 2), true), 3e-5) << seed;
    EXPECT_LT(worst_of(Rig(seed, 9, -1.5, -0.5), false), 3e-5) << seed << ", mirrored";
  }
}

// By hand: a joint at x = 2 bent by a quarter turn about z; half of it is an eighth about the same place.
TEST(Helpers, OfParentAndChildTurnAboutTheJoint) {
  const Affine one = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  const std::vector<Affine> bind = {one, {{{1, 0, 0, -2}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
  const std::vector<Affine> scene = {one, {{{0, -1, 0, 2}, {1, 0, 0, 0}, {0, 0, 1, 0}}}};
  const std::vector<std::uint16_t> joints = {0, 1};
  std::vector<Affine> out(3);
  ASSERT_EQ(build_palette(joints, bind, scene, out, std::vector<Helper>{{0, 1, 0.5f}}), Status::ok);
  const double h = std::sqrt(0.5);
  EXPECT_LT(apart(out[2], {{{h, -h, 0, 2 - 2 * h}, {h, h, 0, -2 * h}, {0, 0, 1, 0}}}), 1e-6);
}

// Of a joint at rest and one turned about itself, both at the origin.
Affine halves_of(const Affine& turned, float share = 0.5f) {
  const Affine one = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  const std::vector<Affine> bind = {one, one}, scene = {one, turned};
  const std::vector<std::uint16_t> joints = {0, 1};
  std::vector<Affine> out(3);
  EXPECT_EQ(build_palette(joints, bind, scene, out, std::vector<Helper>{{0, 1, share}}), Status::ok);
  return out[2];
}

TEST(Helpers, OfHalfATurnGoRoundThePositiveAxis) {
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-3, 4, 0}, Vec3{5, -3, -4}}) {
    Affine turned{};  // 2 n nᵀ - 1, to the last bit its own transpose
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c)
        turned.rows[r][c] = static_cast<float>(2 * axis[r] * axis[c] / test::dot(axis, axis) - (r == c ? 1 : 0));
    const Map quarter = test::from_trs({0, 0, 0}, test::axis_angle(axis, M_PI / 2), {1, 1, 1});
    EXPECT_LT(apart(halves_of(turned), quarter), 1e-6);
  }
}

TEST(Helpers, TurnTheShorterWayUpToHalfATurn) {
  test::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 axis = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double angle = random.between(-1, 1) * 179.9 / 180 * M_PI;
    const Affine turned = test::to_affine(test::from_trs({0, 0, 0}, test::axis_angle(axis, angle), {1, 1, 1}));
    EXPECT_LT(apart(halves_of(turned), test::from_trs({0, 0, 0}, test::axis_angle(axis, angle / 2), {1, 1, 1})), 2e-4);
    const double quarter = 2 * std::atan2(std::sin(angle / 2) / 4, (3 + std::cos(angle / 2)) / 4);  // not on the sphere
    EXPECT_LT(apart(halves_of(turned, 0.25f), test::from_trs({0, 0, 0}, test::axis_angle(axis, quarter), {1, 1, 1})),
              2e-4);
  }
}

// The GLES paths' bind matrices undo the quantisation of positions, too: the same helper, of the same places.
TEST(Helpers, AreTheSameWhereBindUndoesQuantisation) {
  const Map from_codes = {{{3e-5, 0, 0, -0.7}, {0, 7e-5, 0, 0.4}, {0, 0, 1e-6, 2}}};
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    for (const bool about_centres : {false, true}) {
      const Rig rig(seed, 8, seed % 2 == 0 ? 1 : 0.25, seed % 2 == 0 ? 1 : 3);
      Rig coded = rig;
      for (Affine& m : coded.bind) m = test::to_affine(test::to_map(m) * from_codes);
      const std::vector<Affine> plain = rig.palette(about_centres), got = coded.palette(about_centres);
      for (std::size_t i = rig.joints.size(); i < got.size(); ++i)
        for (const Vec3& code : {Vec3{0, 0, 0}, Vec3{65535, 0, 0}, Vec3{0, 65535, 0}, Vec3{0, 0, 65535}}) {
          const Vec3 a = test::point(test::to_map(plain[i]), test::point(from_codes, code));
          EXPECT_LT(test::length(test::minus(a, test::point(test::to_map(got[i]), code))), 2e-4) << seed;
        }
    }
  }
}

// Hidden joints, and what nobody should do: entries that stay finite, and helpers beside them that do not notice.
TEST(Helpers, OfWhatHasNoVolumeAreStraightBlends) {
  const Rig plain(5, 9, 1, 1);
  const std::vector<Affine> before = plain.palette(false);
  const auto flat = [](float x, float y, float z) { return Affine{{{x, 0, 0, 3}, {0, y, 0, 4}, {0, 0, z, 5}}}; };
  for (const Affine& pose :
       {flat(0, 0, 0), flat(1e-20f, 1e-20f, 1e-20f), flat(0, 1, 1), flat(1, 0, 0), flat(0, 0, 2)}) {
    Rig rig = plain;
    rig.bind[4] = flat(1, 1, 1);
    rig.scene[4] = pose;
    const std::vector<Affine> got = rig.palette(false);
    for (std::size_t h = 0; h < rig.helpers.size(); ++h) {
      const Helper& helper = rig.helpers[h];
      const Affine &a = got[helper.first], &b = got[helper.second], &out = got[9 + h];
      if (helper.first != 4 && helper.second != 4) {
        EXPECT_LT(apart(out, test::to_map(before[9 + h])), 1e-5) << h;
        continue;
      }
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c)
          EXPECT_EQ(out.rows[r][c], a.rows[r][c] * (1 - helper.share) + b.rows[r][c] * helper.share) << h;
    }
  }
}

TEST(Helpers, OfFiniteEntriesAreFinite) {
  test::Random random(17);
  constexpr float kNumbers[] = {0, -0.0f, 1, -1, 1e-30f, -1e-20f, 1e-12f, 1e-6f, -1e-3f, 1e3f, -1e6f, 1e12f, -1e12f, 3};
  const auto some = [&] { return kNumbers[random.below(std::size(kNumbers))]; };
  for (int round = 0; round < 5000; ++round) {
    Rig rig(1, 6, 1, 1);
    for (std::vector<Affine>* const maps : {&rig.bind, &rig.scene})
      for (Affine& m : *maps)
        for (auto& row : m.rows)
          for (float& n : row)
            if (random.below(3) != 0) n = some();
    for (float& n : rig.centres) n = some();
    for (const bool about_centres : {false, true})
      for (const Affine& m : rig.palette(about_centres))
        for (const auto& row : m.rows)
          for (const float n : row) ASSERT_TRUE(std::isfinite(n)) << round;
  }
}

TEST(Helpers, OfWhatIsNotFiniteSpoilNoOthers) {
  for (const float bad : {kNan, kInfinity, -kInfinity, 3e38f}) {
    for (int number = 0; number < 12; ++number) {
      Rig rig(6, 9, 1, 1);
      const std::vector<Affine> before = rig.palette(true);
      rig.scene[4].rows[number / 4][number % 4] = bad;
      const std::vector<Affine> got = rig.palette(true);
      for (std::size_t h = 0; h < rig.helpers.size(); ++h) {
        if (rig.helpers[h].first == 4 || rig.helpers[h].second == 4) continue;
        EXPECT_LT(apart(got[9 + h], test::to_map(before[9 + h])), 1e-5) << bad << " " << number;
      }
    }
  }
}

TEST(Helpers, AreRefusedWhereTheyBlendNothing) {
  const Rig rig(1, 3, 1, 1);
  std::vector<Affine> out(4);
  const auto status = [&](Helper helper, std::size_t centres) {
    return build_palette(rig.joints, rig.bind, rig.scene, out, {&helper, 1}, {rig.centres.data(), centres});
  };
  EXPECT_EQ(status({0, 1, 0.5f}, 0), Status::ok);
  EXPECT_EQ(status({0, 1, 0.5f}, 3), Status::ok);
  EXPECT_EQ(status({0, 1, 0.5f}, 2), Status::bad_argument);
  EXPECT_EQ(status({1, 1, 0.5f}, 0), Status::bad_argument);
  EXPECT_EQ(status({3, 1, 0.5f}, 0), Status::bad_argument);
  EXPECT_EQ(status({1, 3, 0.5f}, 0), Status::bad_argument);
  for (const float share : {0.0f, 1.0f, -0.5f, 2.0f, kNan, kInfinity})
    EXPECT_EQ(status({0, 1, share}, 0), Status::bad_argument) << share;
}

}  // namespace
}  // namespace marrow
