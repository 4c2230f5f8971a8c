// Public structs may be filled in by name: what is left out draws no warning, and is what it is by default.
#include <gtest/gtest.h>

#include "marrow/gles3_crowd.h"
#include "marrow/gles3_self_test.h"
#include "marrow/marrow.h"

#pragma GCC diagnostic error "-Wmissing-field-initializers"

namespace marrow {
namespace {

// Of each struct that C has: tools/c_api writes the rows.
TEST(Designated, MembersMayBeLeftOut) {
  int structs = 0;
#define STRUCT(Type, member)                                       \
  {                                                                \
    [[maybe_unused]] const ::marrow::Type filled = {.member = {}}; \
    ++structs;                                                     \
  }
#include "bad_calls.h"
#include "gles3_bad_calls.h"
#undef STRUCT
  EXPECT_GT(structs, 90);
}

// What is not 0, false or empty.
TEST(Designated, WhatIsLeftOutIsTheDefault) {
  using namespace gles3;
  EXPECT_EQ(BlendLayer().weight, 1);
  EXPECT_EQ(FootGround().normal[1], 1);
  EXPECT_EQ(FeetFrame().weight, 1);
  EXPECT_EQ(JointLimit().limit_from_parent[3], 1);
  EXPECT_EQ(LimitDescription().zero[3], 1);
  EXPECT_EQ(IkGoal().rotation[3], 1);
  EXPECT_EQ(IkOptions().max_iterations, 16);
  EXPECT_EQ(TwoBone().soft, 1);
  EXPECT_EQ(Aim().weight, 1);
  EXPECT_EQ(SpringJoint().weight, 1);
  EXPECT_EQ(SpringFrame().weight, 1);
  EXPECT_EQ(JointTransform().rotation[3], 1);
  EXPECT_EQ(ProgramSet().role_count, 1u);
  EXPECT_EQ(SkinnerOptions().instances, 1u);
  EXPECT_EQ(CrowdInstance().b.clip, kNoClip);
  EXPECT_TRUE(CrowdMeshOptions().ssd && SelfTestOptions().ssd);
}

}  // namespace
}  // namespace marrow
