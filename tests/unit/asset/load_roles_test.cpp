// load: what roles.gltf says is there, what is refused of roles, and how they are looked up.
#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "marrow/roles.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

// Of roles.gltf: eleven joints with roles, five pairs, two soles.
constexpr std::size_t kRoles = 12, kPairs = kRoles + 13 * 4, kSoles = kPairs + 5 * 4;

class LoadRoles : public ::testing::Test {
 protected:
  LoadRoles() : block_(test::golden_roles_copy()) {
    EXPECT_EQ(load(block_, file_), Status::ok);
    for (const File::Section& s : file_.sections())
      if (s.type == format::kTypes[format::kRoles]) base_ = s.offset;
    roles_ = file_.roles(0);
  }
  std::string name(std::uint32_t joint) const {
    return joint == kNoJoint ? "" : file_.text(file_.skeleton(0).names[joint]);
  }
  template <class T>
  void refuse(std::size_t offset, T value, const char* rule) {
    const test::DamageReport got = test::load_with(block_, base_ + offset, value);
    EXPECT_EQ(got.status, Status::bad_data) << rule;
    EXPECT_STREQ(got.error.rule, rule) << offset;
    EXPECT_LE(got.error.offset, base_ + offset) << rule;
    EXPECT_GT(got.error.offset + 16, base_ + offset) << rule;
    ++refused_;
  }

  test::AlignedBlock block_;
  File file_;
  Roles roles_;
  std::size_t base_ = 0;
  int refused_ = 0;
};

TEST_F(LoadRoles, AreWhatTheSourceSays) {
  const std::pair<Role, const char*> expected[] = {{Role::hips, "hips"},
                                                   {Role::spine, "spine"},
                                                   {Role::head, "head"},
                                                   {Role::left_upper_leg, "thigh.L"},
                                                   {Role::left_lower_leg, "shin.L"},
                                                   {Role::left_foot, "foot.L"},
                                                   {Role::left_toes, "toe.L"},
                                                   {Role::right_upper_leg, "thigh.R"},
                                                   {Role::right_lower_leg, "shin.R"},
                                                   {Role::right_foot, "foot.R"},
                                                   {Role::right_toes, "toe.R"},
                                                   {Role::tail, "tail"}};
  std::uint64_t there = 0;
  for (const auto& [role, joint] : expected) {
    EXPECT_EQ(name(joint_of(roles_, role)), joint) << role_name(role);
    EXPECT_EQ(role_of(roles_, joint_of(roles_, role)), role);
    there |= std::uint64_t{1} << static_cast<unsigned>(role);
  }
  for (std::uint32_t r = 0; r < kRoleCount; ++r)
    if ((there >> r & 1) == 0) EXPECT_EQ(joint_of(roles_, static_cast<Role>(r)), kNoJoint) << r;
  ASSERT_EQ(roles_.roles.size, 13u);  // two of them of the tail
  EXPECT_EQ(role_of(roles_, file_.find_joint(file_.skeleton(0), "tail.001")), Role::tail);
  EXPECT_EQ(role_of(roles_, file_.find_joint(file_.skeleton(0), "bag one")), Role::none);
  EXPECT_EQ(role_of(roles_, 1000), Role::none);
}

TEST_F(LoadRoles, HavePairs) {
  const std::pair<const char*, const char*> expected[] = {
      {"thigh.L", "thigh.R"}, {"shin.L", "shin.R"}, {"foot.L", "foot.R"}, {"toe.L", "toe.R"}, {"bag one", "bag two"}};
  ASSERT_EQ(roles_.pairs.size, std::size(expected));
  const Skeleton skeleton = file_.skeleton(0);
  for (const auto& [left, right] : expected) {
    const std::uint32_t l = file_.find_joint(skeleton, left), r = file_.find_joint(skeleton, right);
    EXPECT_EQ(mirror_of(roles_, l), r) << left;
    EXPECT_EQ(mirror_of(roles_, r), l) << left;
  }
  for (const char* const alone : {"hips", "spine", "head", "tail"})
    EXPECT_EQ(mirror_of(roles_, file_.find_joint(skeleton, alone)), kNoJoint) << alone;
}

// Both feet stand at (±0.125, 0, 0.125), below the toes; the left one is turned over about x.
TEST_F(LoadRoles, HaveSoles) {
  ASSERT_EQ(roles_.soles.size, 2u);
  const JointSole* const left = sole_of(roles_, joint_of(roles_, Role::left_foot));
  const JointSole* const right = sole_of(roles_, joint_of(roles_, Role::right_foot));
  ASSERT_NE(left, nullptr);
  ASSERT_NE(right, nullptr);
  const float expected[2][3] = {{0, 0.0625f, -0.125f}, {0, -0.0625f, 0.125f}};
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(left->place[c], expected[0][c], 1e-6f);
    EXPECT_NEAR(right->place[c], expected[1][c], 1e-6f);
  }
  EXPECT_EQ(sole_of(roles_, joint_of(roles_, Role::head)), nullptr);
}

TEST_F(LoadRoles, OfOtherSkeletonsAreEmpty) {
  EXPECT_TRUE(file_.roles(1).roles.empty());
  EXPECT_TRUE(File().roles(0).roles.empty());
  EXPECT_EQ(joint_of({}, Role::head), kNoJoint);
  EXPECT_EQ(mirror_of({}, 0), kNoJoint);
  EXPECT_EQ(sole_of({}, 0), nullptr);
}

TEST_F(LoadRoles, RefusesWhatBreaksARule) {
  ASSERT_NE(base_, 0u);
  const float nan = std::nanf("");
  refuse(0, std::uint32_t{1}, "no such skeleton");
  refuse(4, std::uint16_t{0}, "section size differs from its counts");
  refuse(4, std::uint16_t{0xFFFF}, "section size differs from its counts");
  refuse(6, std::uint16_t{0xFFFF}, "section size differs from its counts");
  refuse(8, std::uint16_t{3}, "section size differs from its counts");
  refuse(10, std::uint16_t{1}, "reserved must be 0");
  refuse(kRoles, std::uint16_t{15}, "a joint outside the skeleton");
  refuse(kRoles + 2, std::uint8_t{0}, "no role");
  refuse(kRoles + 2, std::uint8_t{58}, "no role");
  refuse(kRoles + 3, std::uint8_t{1}, "reserved must be 0");
  refuse(kRoles + 4, std::uint16_t{0}, "roles ascend by joint");
  refuse(kRoles + 6, std::uint8_t{2}, "a role of two joints");  // hips
  refuse(kPairs, std::uint16_t{15}, "a joint outside the skeleton");
  refuse(kPairs + 2, std::uint16_t{15}, "a joint outside the skeleton");
  refuse(kPairs + 2, std::uint16_t{2}, "a joint in two pairs");  // with itself
  refuse(kPairs + 4, std::uint16_t{2}, "pairs ascend by their left joints");
  refuse(kPairs + 6, std::uint16_t{2}, "a joint in two pairs");
  refuse(kSoles, std::uint16_t{15}, "a joint outside the skeleton");
  refuse(kSoles, std::uint16_t{0}, "a sole of what is no foot or hand");
  refuse(kSoles + 2, std::uint16_t{1}, "reserved must be 0");
  refuse(kSoles + 16, std::uint16_t{11}, "soles ascend by joint");
  refuse(kSoles + 4, nan, "a sole that is not finite, or beyond 1e6");
  refuse(kSoles + 8, 1.1e6f, "a sole that is not finite, or beyond 1e6");
  refuse(kSoles + 12, -HUGE_VALF, "a sole that is not finite, or beyond 1e6");
  EXPECT_EQ(refused_, 24);
}

TEST(RoleNames, AreThoseOfTheEnum) {
  std::set<std::string> names;
  for (std::uint32_t r = 0; r < kRoleCount; ++r) {
    const auto role = static_cast<Role>(r);
    EXPECT_EQ(find_role(role_name(role)), role);
    names.insert(role_name(role));
  }
  EXPECT_EQ(names.size(), kRoleCount);
  EXPECT_STREQ(role_name(Role::left_upper_leg), "left_upper_leg");
  EXPECT_STREQ(role_name(Role::right_hand), "right_hand");
  EXPECT_STREQ(role_name(Role::left_thumb_metacarpal), "left_thumb_metacarpal");
  EXPECT_STREQ(role_name(Role::right_little_distal), "right_little_distal");
  EXPECT_STREQ(role_name(Role::tail), "tail");
  EXPECT_STREQ(role_name(static_cast<Role>(58)), "none");
  EXPECT_STREQ(role_name(static_cast<Role>(255)), "none");
  for (const char* const none : {"", "left foot", "LEFT_FOOT", "leftFoot", "none"})
    EXPECT_EQ(find_role(none), Role::none) << none;
  EXPECT_EQ(find_role(nullptr), Role::none);
}

}  // namespace
}  // namespace marrow
