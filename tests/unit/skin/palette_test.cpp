// build_palette against products in double precision.
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/rig.h"

namespace marrow {
namespace {

TEST(Palette, IsModelFromJointTimesBindThroughTheRemap) {
  test::Random random(7);
  std::vector<Affine> model_from_joint, bind;
  for (int i = 0; i < 5; ++i) {
    const test::Quat q = random.rotation();
    model_from_joint.push_back(test::to_affine(test::from_trs({1.0 * i, 2, -1}, q, {1, -2, 0.5})));
    const test::Quat r = random.rotation();
    bind.push_back(test::to_affine(test::from_trs({-3, 0.25, 0.5 * i}, r, {1, 1, 1})));
  }
  const std::vector<std::uint16_t> joints = {4, 0, 0, 3, 1};
  std::vector<Affine> out(6, Affine{});
  ASSERT_EQ(build_palette(joints, bind, model_from_joint, out), Status::ok);
  for (std::size_t i = 0; i < 5; ++i) {
    const test::Map want = test::to_map(model_from_joint[joints[i]]) * test::to_map(bind[i]);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) EXPECT_NEAR(static_cast<double>(out[i].rows[r][c]), want.rows[r][c], 1e-5) << i;
  }
  EXPECT_EQ(out[5].rows[0][0], 0.0f) << "only as many entries as joints are written";
}

TEST(Palette, OfAMeshIsTheSame) {
  const test::TestCharacter c = test::make_character(3, 9, 2, false);
  std::vector<Affine> model(9), whole(9), parts(9);
  ASSERT_EQ(local_to_model(c.skeleton.view(), c.skeleton.rest, model), Status::ok);
  const Mesh mesh = c.mesh.view();
  ASSERT_EQ(build_palette(mesh, model, whole), Status::ok);
  ASSERT_EQ(build_palette(c.mesh.joints, c.mesh.inverse_bind, model, parts), Status::ok);
  for (std::size_t i = 0; i < 9; ++i)
    for (int r = 0; r < 3; ++r)
      for (int k = 0; k < 4; ++k) EXPECT_EQ(whole[i].rows[r][k], parts[i].rows[r][k]);
}

// Signs of determinants, by hand.
TEST(Palette, TurnsInsideOutWhereItMirrors) {
  const auto scaled = [](float x, float y, float z) { return Affine{{{x, 0, 0, 5}, {0, y, 0, -6}, {0, 0, z, 7}}}; };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(turns_inside_out(scaled(1, 1, 1)));
  EXPECT_TRUE(turns_inside_out(scaled(-1, 1, 1)));
  EXPECT_FALSE(turns_inside_out(scaled(-1, 1, -2))) << "half a turn";
  EXPECT_TRUE(turns_inside_out(scaled(-1, -1, -1)));
  EXPECT_TRUE(turns_inside_out(scaled(1e-30f, -1e-30f, 1e-30f))) << "of floats the product would be 0";
  EXPECT_TRUE(turns_inside_out(scaled(1e30f, -1e30f, 1e30f)));
  EXPECT_FALSE(turns_inside_out(scaled(-1, 0, 1)));
  EXPECT_FALSE(turns_inside_out(scaled(-1, nan, 1)));
  // Two axes changed places.
  EXPECT_TRUE(turns_inside_out(Affine{{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}}}));
  EXPECT_TRUE(turns_inside_out(Affine{{{0, 0, 1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}}}));
  EXPECT_FALSE(turns_inside_out(Affine{{{0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}}})) << "a third of a turn";
}

TEST(Palette, TurnsInsideOutAsMostOfItDoes) {
  const Affine plain = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}, none = {};
  Affine mirrored = plain;
  mirrored.rows[0][0] = -1;
  const auto turns = [](const std::vector<Affine>& palette) { return turns_inside_out(Span<const Affine>(palette)); };
  EXPECT_FALSE(turns({}));
  EXPECT_TRUE(turns({mirrored}));
  EXPECT_FALSE(turns({mirrored, plain}));
  EXPECT_TRUE(turns({none, none, none, mirrored})) << "what has shrunk to a point has no say";
  EXPECT_TRUE(turns({plain, mirrored, mirrored}));
  EXPECT_FALSE(turns({mirrored, plain, plain}));
}

TEST(Palette, NoJointsIsNoWork) {
  EXPECT_EQ(build_palette(Span<const std::uint16_t>{}, {}, {}, {}), Status::ok);
}

}  // namespace
}  // namespace marrow
