// load: what springs.gltf says of springs is there, and what is refused of them.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "marrow/springs.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

// Of springs.gltf: where the records of its section stand.
constexpr std::size_t kHair = 16, kRibbon = kHair + 32, kJoints = kRibbon + 32, kColliders = kJoints + 3 * 28;

class LoadSprings : public ::testing::Test {
 protected:
  LoadSprings() : block_(test::golden_springs_copy()) {
    EXPECT_EQ(load(block_, file_), Status::ok);
    for (const File::Section& s : file_.sections())
      if (s.type == format::kTypes[format::kSprings]) base_ = s.offset;
  }
  // Expects a refusal that names the record of the changed field, or the section's head.
  template <class T>
  void refuse(std::size_t offset, T value, const char* rule) {
    const test::DamageReport got = test::load_with(block_, base_ + offset, value);
    EXPECT_EQ(got.status, Status::bad_data) << rule;
    EXPECT_NE(std::string(got.error.rule == nullptr ? "" : got.error.rule).find(rule), std::string::npos)
        << offset << ": " << got.error.rule << ", not " << rule;
    EXPECT_LE(got.error.offset, base_ + offset) << rule;
    EXPECT_GT(got.error.offset + 36, base_ + offset) << rule;
    ++refused_;
  }

  test::AlignedBlock block_;
  File file_;
  std::size_t base_ = 0;
  int refused_ = 0;
};

TEST_F(LoadSprings, AreWhatTheSourceSays) {
  ASSERT_EQ(file_.spring_count(0), 2u);
  EXPECT_EQ(file_.spring_count(1), 0u);
  const Skeleton skeleton = file_.skeleton(0);
  const SpringChain hair = file_.spring(0, 0), ribbon = file_.spring(0, 1);
  const auto name = [&](const SpringChain& c, std::size_t i) {
    return std::string(file_.text(skeleton.names[c.joints[i].joint]));
  };
  ASSERT_EQ(hair.joints.size, 2u);
  EXPECT_EQ(name(hair, 0), "hair");
  EXPECT_EQ(name(hair, 1), "hair lower");
  EXPECT_EQ(hair.tip[1], -0.0625f);  // where "hair end" is, which is no joint
  EXPECT_EQ(hair.joints[0].radius_m, 0.03125f);
  EXPECT_EQ(hair.joints[0].gravity, 0.0f);
  EXPECT_GT(hair.joints[1].gravity, 0.0f);
  ASSERT_EQ(ribbon.joints.size, 1u);
  EXPECT_EQ(name(ribbon, 0), "ribbon");
  EXPECT_EQ(ribbon.tip[1], -0.25f);
  EXPECT_EQ(ribbon.joints[0].frequency_hz, 0.0f);  // no stiffness: a rope
  EXPECT_EQ(hair.colliders, 1u);
  EXPECT_EQ(ribbon.colliders, 3u);
  const Span<const SpringCollider> colliders = file_.spring_colliders(0);
  ASSERT_EQ(colliders.size, 2u);
  EXPECT_STREQ(file_.text(skeleton.names[colliders[0].joint]), "head");
  EXPECT_EQ(colliders[0].from[2], 0.5f);
  EXPECT_EQ(colliders[0].to[2], 0.5f);
  EXPECT_EQ(colliders[0].radius_m, 0.125f);
  EXPECT_STREQ(file_.text(skeleton.names[colliders[1].joint]), "head");  // "back" is no joint
  EXPECT_EQ(colliders[1].from[1], -0.5f);
  EXPECT_EQ(colliders[1].from[2], -0.25f);
  EXPECT_EQ(colliders[1].to[1], 0.0f);
  EXPECT_EQ(skeleton.joint_count, 4u);
  EXPECT_EQ(file_.spring(0, 2).joints.size, 0u);
  EXPECT_TRUE(file_.spring_colliders(1).empty());
  EXPECT_EQ(File().spring_count(0), 0u);
}

TEST_F(LoadSprings, AreGoodForMakeSprings) {
  const SpringChain chains[] = {file_.spring(0, 0), file_.spring(0, 1)};
  const Skeleton skeleton = file_.skeleton(0);
  test::AlignedBlock memory(springs_bytes(skeleton, chains));
  Springs springs;
  EXPECT_EQ(make_springs(skeleton, chains, memory, springs), Status::ok);
}

TEST_F(LoadSprings, RefusesWhatBreaksARule) {
  ASSERT_NE(base_, 0u);
  const float nan = std::nanf("");
  refuse(0, std::uint32_t{1}, "no such skeleton");
  refuse(4, std::uint32_t{0}, "section size");
  refuse(8, std::uint32_t{4}, "section size");
  refuse(12, std::uint32_t{0xFFFFFFFF}, "section size");
  refuse(kHair, std::uint64_t{4}, "a collider that is not there");
  refuse(kHair, ~std::uint64_t{0}, "a collider that is not there");
  refuse(kRibbon + 8, std::uint32_t{1}, "chains share out the joints");
  refuse(kHair + 12, std::uint32_t{0}, "chains share out the joints");
  refuse(kRibbon + 12, std::uint32_t{2}, "chains share out the joints");
  refuse(kHair + 16, nan, "a tip that is not finite");
  refuse(kHair + 20, 2e6f, "a tip that is not finite");
  refuse(kRibbon + 20, 0.0f, "a chain without a bone");
  refuse(kHair + 28, std::uint32_t{1}, "reserved must be 0");
  refuse(kJoints, std::uint16_t{4}, "a joint outside the skeleton");
  refuse(kJoints + 28, std::uint16_t{0}, "below the one before it");
  refuse(kJoints + 28, std::uint16_t{1}, "below the one before it");  // itself
  refuse(kJoints + 28, std::uint16_t{2}, "below the one before it");  // beside it
  refuse(kJoints + 4, -1.0f, "a setting out of its range");
  refuse(kJoints + 4, 15.1f, "a setting out of its range");
  refuse(kJoints + 8, -0.1f, "a setting out of its range");
  refuse(kJoints + 8, 1.6f, "a setting out of its range");
  refuse(kJoints + 12, -10.1f, "a setting out of its range");
  refuse(kJoints + 12, 10.1f, "a setting out of its range");
  refuse(kJoints + 16, nan, "a setting out of its range");
  refuse(kJoints + 16, -0.1f, "a setting out of its range");
  refuse(kJoints + 16, 50.1f, "a setting out of its range");
  refuse(kJoints + 20, HUGE_VALF, "a setting out of its range");
  refuse(kJoints + 20, -0.1f, "a setting out of its range");
  refuse(kJoints + 24, -0.1f, "a setting out of its range");
  refuse(kJoints + 24, 1.1f, "a setting out of its range");
  refuse(kColliders, std::uint16_t{4}, "a joint outside the skeleton");
  refuse(kColliders + 2, std::uint16_t{1}, "reserved must be 0");
  refuse(kColliders + 4, nan, "a collider that is not finite");
  refuse(kColliders + 16, 2e6f, "a collider that is not finite");
  refuse(kColliders + 28, -0.5f, "a collider that is not finite");
  EXPECT_EQ(refused_, 35);
}

TEST_F(LoadSprings, StandBehindLimitsAndBeforeNames) {
  const Span<const File::Section> sections = file_.sections();
  ASSERT_GT(sections.size, 2u);
  EXPECT_EQ(sections[sections.size - 2].type, format::four_characters("SPRI"));
  EXPECT_EQ(sections[sections.size - 1].type, format::four_characters("NAME"));
}

}  // namespace
}  // namespace marrow
