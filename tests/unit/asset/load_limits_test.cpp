// load: what limits.gltf says is there, and what is refused of limits.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "marrow/limits.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

class LoadLimits : public ::testing::Test {
 protected:
  LoadLimits() : block_(test::golden_limits_copy()) {
    EXPECT_EQ(load(block_, file_), Status::ok);
    for (const File::Section& s : file_.sections())
      if (s.type == format::kTypes[format::kLimits]) base_ = s.offset;
  }
  // Expects a refusal at the section's head or within the limit of the changed field.
  template <class T>
  void refuse(std::size_t offset, T value, const char* what) {
    const test::DamageReport got = test::load_with(block_, base_ + offset, value);
    EXPECT_EQ(got.status, Status::bad_data) << what;
    EXPECT_LE(got.error.offset, base_ + offset) << what << ": " << got.error.rule;
    EXPECT_GT(got.error.offset + sizeof(JointLimit), base_ + offset) << what << ": " << got.error.rule;
    ++refused_;
  }

  test::AlignedBlock block_;
  File file_;
  std::size_t base_ = 0;
  int refused_ = 0;
};

TEST_F(LoadLimits, AreWhatTheSourceSays) {
  ASSERT_EQ(file_.skeleton_count(), 1u);
  const Skeleton skeleton = file_.skeleton(0);
  const char* const names[] = {"hip", "knee", "tail", "ankle"};  // breadth-first
  const LimitKind kinds[] = {LimitKind::cone, LimitKind::hinge, LimitKind::none, LimitKind::euler};
  ASSERT_EQ(skeleton.limits.size, 4u);
  for (std::uint16_t i = 0; i < 4; ++i) {
    EXPECT_EQ(skeleton.limits[i].joint, i);
    EXPECT_STREQ(file_.text(skeleton.names[i]), names[i]);
    EXPECT_EQ(skeleton.limits[i].kind, kinds[i]);
    EXPECT_TRUE(is_valid(skeleton.limits[i]));
  }
  const JointLimit &hip = skeleton.limits[0], &knee = skeleton.limits[1], &tail = skeleton.limits[2],
                   &ankle = skeleton.limits[3];
  EXPECT_NEAR(hip.angles[0].middle, std::tan(5 * kDegree / 4), 1e-7);
  EXPECT_NEAR(hip.angles[0].half_width, std::tan(25 * kDegree / 4), 1e-7);
  EXPECT_NEAR(hip.angles[1].half_width, std::tan(70 * kDegree / 4), 1e-7);
  EXPECT_NEAR(hip.angles[2].half_width, std::tan(40 * kDegree / 4), 1e-7);
  EXPECT_NEAR(hip.rate.speed, 360 * kDegree, 1e-6);
  EXPECT_NEAR(hip.rate.acceleration, 3600 * kDegree, 1e-5);
  EXPECT_NEAR(knee.angles[0].middle, std::tan(75 * kDegree / 4), 1e-7);
  EXPECT_NEAR(tail.rate.speed, 90 * kDegree, 1e-6);
  EXPECT_EQ(tail.rate.acceleration, 0);
  EXPECT_EQ(ankle.order, AxisOrder::zxy);
  EXPECT_NEAR(ankle.angles[1].half_width, std::tan(45 * kDegree / 4), 1e-7);  // x is the second
  EXPECT_NEAR(ankle.angles[2].middle, std::tan(-5 * kDegree / 4), 1e-7);      // y the third
  // From zero, not from the rest, which is a turn by 73.7° about x: 28.7° too far.
  const float rest[4] = {0.6f, 0, 0, 0.8f};
  EXPECT_NEAR(limit_excess(ankle, rest), 2 * std::atan(0.75) - 45 * kDegree, 1e-5);
  // The knee bends about x of its own axes.
  const float bent[4] = {1, 0, 0, 0}, back[4] = {-0.6f, 0, 0, 0.8f};
  EXPECT_NEAR(limit_excess(knee, bent), 30 * kDegree, 1e-5);
  EXPECT_NEAR(limit_excess(knee, back), 2 * std::atan(0.75), 1e-5);
  // The hip swings to 70° about x, across, and to 40° about z.
  const float about_x[4] = {0.6f, 0, 0, 0.8f}, about_z[4] = {0, 0, 0.6f, 0.8f};
  EXPECT_NEAR(limit_excess(hip, about_x), 2 * std::atan(0.75) - 70 * kDegree, 1e-5);
  EXPECT_NEAR(limit_excess(hip, about_z), 2 * std::atan(0.75) - 40 * kDegree, 1e-5);
}

TEST_F(LoadLimits, RefusesWhatBreaksARule) {
  ASSERT_NE(base_, 0u);
  const float nan = std::nanf("");
  refuse(0, std::uint32_t{1}, "a skeleton that is not there");
  refuse(4, std::uint32_t{0}, "no limits");
  refuse(4, std::uint32_t{3}, "a limit fewer than there are bytes");
  refuse(4, std::uint32_t{0xFFFFFFFF}, "limits beyond the section");
  const std::size_t hip = 8, knee = hip + 68, tail = knee + 68, ankle = tail + 68;
  refuse(knee, std::uint16_t{0}, "joints that do not ascend");
  refuse(ankle, std::uint16_t{4}, "a joint outside the skeleton");
  refuse(hip + 2, std::uint8_t{4}, "an unknown kind");
  refuse(hip + 3, std::uint8_t{1}, "an order without use");
  refuse(ankle + 3, std::uint8_t{6}, "an unknown order");
  for (const std::size_t q : {std::size_t{4}, std::size_t{20}}) {
    refuse(hip + q, nan, "a rotation that is not a number");
    refuse(hip + q, 2.0f, "a rotation that is not unit");
  }
  refuse(knee + 36, 1.5f, "a middle beyond half a turn");
  refuse(knee + 36, nan, "a middle that is not a number");
  refuse(knee + 40, -0.1f, "a width below 0");
  refuse(knee + 40, 1.1f, "a width above a turn");
  refuse(knee + 48, 0.1f, "a second angle of a hinge");
  refuse(tail + 40, 0.1f, "an angle of no limit");
  refuse(hip + 44, 0.1f, "a cone aside of its axis");
  refuse(hip + 48, 0.92f, "a cone beyond 170°");
  refuse(ankle + 48, 0.42f, "a second angle beyond 90°");
  refuse(ankle + 44, -0.3f, "a second angle beyond -90°");
  refuse(tail + 60, -1.0f, "a speed below 0");
  refuse(tail + 60, nan, "a speed that is not a number");
  refuse(tail + 64, HUGE_VALF, "an acceleration that is not finite");
  EXPECT_EQ(refused_, 26);
}

TEST_F(LoadLimits, StandBehindNodesAndBeforeNames) {
  const Span<const File::Section> sections = file_.sections();
  ASSERT_GT(sections.size, 2u);
  EXPECT_EQ(sections[sections.size - 2].type, format::four_characters("LIMI"));
  EXPECT_EQ(sections[sections.size - 1].type, format::four_characters("NAME"));
}

}  // namespace
}  // namespace marrow
