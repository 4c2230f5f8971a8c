// load: what maps.toml says of roles.gltf is there, and what is refused of pose maps.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "marrow/clip_pack.h"
#include "marrow/pose_map.h"
#include "support/bad_numbers.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

// Hips and the left thigh in their groups; the spine and the head on it between two, and two that are farther off.
constexpr std::size_t kGroups = 32, kTurns = kGroups + 4 * 136, kPlaces = kTurns + 6 * 40, kSteps = kPlaces + 52;

class LoadPoseMaps : public ::testing::Test {
 protected:
  LoadPoseMaps() : block_(test::golden_maps_copy()) {
    EXPECT_EQ(load(block_, file_), Status::ok);
    for (const File::Section& s : file_.sections())
      if (s.type == format::kTypes[format::kPoseMaps]) base_ = s.offset;
    map_ = file_.pose_map(0);
  }
  std::string name(std::uint32_t joint) const { return file_.text(file_.skeleton(0).names[joint]); }
  template <class T>
  void refuse(std::size_t offset, T value, const char* rule) {
    const test::DamageReport got = test::load_with(block_, base_ + offset, value);
    EXPECT_EQ(got.status, Status::bad_data) << rule;
    EXPECT_STREQ(got.error.rule, rule) << offset;
    EXPECT_LE(got.error.offset, base_ + offset) << rule;
    EXPECT_GE(got.error.offset, base_) << rule;
    ++refused_;
  }

  test::AlignedBlock block_;
  File file_;
  PoseMap map_;
  std::size_t base_ = 0;
  int refused_ = 0;
};

TEST_F(LoadPoseMaps, AreWhatTheCookerWasTold) {
  ASSERT_EQ(file_.pose_map_count(), 1u);
  EXPECT_STREQ(map_.name, "roles");
  EXPECT_EQ(file_.find_pose_map("roles"), 0u);
  EXPECT_EQ(map_.skeleton, 0u);
  EXPECT_EQ(map_.rig_joint_count, 15u);
  EXPECT_EQ(map_.rig_hash, skeleton_hash(file_, 0)) << "the rig is the file itself";
  ASSERT_EQ(map_.groups.size, 4u);
  std::string turns;
  for (std::uint32_t j = 0; j < 15; ++j)
    if (const std::uint16_t from = map_.groups[j / 4].rig_joints[j % 4]; from != kNoJoint)
      turns += name(j) + "=" + name(from) + " ";
  for (const MappedTurn& t : map_.turns) turns += name(t.joint) + ":" + std::to_string(t.step_count) + " ";
  EXPECT_EQ(turns, "hips=hips thigh.L=thigh.R spine:0 spine:2 head:2 head:0 shin.L:2 toe.L:5 ");
  EXPECT_EQ(map_.turns[0].weight, 0.75f);
  EXPECT_EQ(map_.turns[1].weight, 0.25f);
  ASSERT_EQ(map_.places.size, 1u);
  EXPECT_EQ(name(map_.places[0].joint), "hips");
  EXPECT_EQ(map_.steps.size, 12u);
}

// Hips go as far as the rig's, in lengths of what the map takes for legs.
TEST_F(LoadPoseMaps, PutAPoseOn) {
  const Skeleton skeleton = file_.skeleton(0);
  std::vector<SoaTransform> rig(skeleton.rest, skeleton.rest + skeleton.soa_size()), out(rig.size());
  ASSERT_EQ(retarget_pose(map_, rig, skeleton, out), Status::ok);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(out[0].translation[c][0], skeleton.rest[0].translation[c][0], 1e-6);
  rig[0].translation[1][0] += 0.5f;
  rig[0].translation[2][0] += 0.25f;
  ASSERT_EQ(retarget_pose(map_, rig, skeleton, out), Status::ok);
  const double scale = (double{out[0].translation[1][0]} - 1) / 0.5;
  EXPECT_GT(scale, 0.25);
  EXPECT_NEAR(out[0].translation[0][0], 0, 1e-6);
  EXPECT_NEAR(out[0].translation[2][0], 0.25 * scale, 1e-6);
}

TEST_F(LoadPoseMaps, OfWhatThereIsNot) {
  EXPECT_EQ(file_.pose_map(1).turns.size, 0u);
  EXPECT_STREQ(file_.pose_map(1).name, "");
  EXPECT_EQ(file_.find_pose_map("no such"), 1u);
  EXPECT_EQ(file_.find_pose_map(nullptr), 1u);
  EXPECT_EQ(File().pose_map_count(), 0u);
}

TEST_F(LoadPoseMaps, ThatBreakARuleAreRefused) {
  using test::kInfinity, test::kNan;
  const char *const size = "section size differs from its counts",
                    *const unit = "a rotation that is no unit quaternion",
                    *const counts = "as many groups as the skeleton has, and steps as turns and places have",
                    *const far = "a number that is not finite, or beyond 1e12";
  refuse(0, std::uint32_t{100000}, "name outside the name section");
  refuse(4, std::uint32_t{1}, "no such skeleton");
  refuse(16, std::uint16_t{0}, "1 to 32767 joints");
  refuse(16, std::uint16_t{32768}, "1 to 32767 joints");
  refuse(18, std::uint16_t{3}, size);
  refuse(20, std::uint32_t{9}, size);
  refuse(20, std::uint32_t{0xFFFFFFFF}, size);
  refuse(24, std::uint32_t{0}, size);
  refuse(28, std::uint32_t{0x40000000}, size);
  refuse(kGroups, 1.0f, unit);
  refuse(kGroups + 64, kNan, unit);
  refuse(kGroups + 128, std::uint16_t{15}, "a joint outside the rig");
  refuse(kTurns, std::uint16_t{15}, "a joint outside the skeleton");
  refuse(kTurns + 5 * 40, std::uint16_t{0}, "turns and places ascend by joint");
  refuse(kTurns + 2, std::uint16_t{2}, counts);
  refuse(kTurns + 4, 0.0f, "a weight that is not 1e-6 to 1");
  refuse(kTurns + 4, 1.5f, "a weight that is not 1e-6 to 1");
  refuse(kTurns + 4, kNan, "a weight that is not 1e-6 to 1");
  refuse(kTurns + 8, 1.0f, unit);
  refuse(kTurns + 8, kNan, unit);
  refuse(kTurns + 24, kInfinity, unit);
  refuse(kPlaces, std::uint16_t{15}, "a joint outside the skeleton");
  refuse(kPlaces + 2, std::uint16_t{0}, "a place without a step");
  refuse(kPlaces + 2, std::uint16_t{2}, counts);
  refuse(kPlaces + 4, kNan, far);
  refuse(kPlaces + 48, 1.1e12f, far);
  refuse(kSteps, std::uint16_t{15}, "a joint outside the rig");
  EXPECT_EQ(refused_, 27);
}

}  // namespace
}  // namespace marrow
