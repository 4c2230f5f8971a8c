// load: what roles.gltf says of its walk is there, and what is refused of motions.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "marrow/clip_motion.h"
#include "support/bad_numbers.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

constexpr std::uint32_t kStand = 0, kWalk = 1;
// Of the walk: two keys of the root, four events, two marks.
constexpr std::size_t kRoot = 32, kEvents = kRoot + 2 * 32, kMarks = kEvents + 4 * 16;

class LoadMotions : public ::testing::Test {
 protected:
  LoadMotions() : block_(test::golden_roles_copy()) {
    EXPECT_EQ(load(block_, file_), Status::ok);
    for (const File::Section& s : file_.sections())
      if (s.type == format::kTypes[format::kMotions]) base_ = s.offset;  // the last is the walk's
    walk_ = file_.motion(kWalk);
  }
  template <class T>
  void refuse(std::size_t offset, T value, const char* rule) {
    const test::DamageReport got = test::load_with(block_, base_ + offset, value);
    EXPECT_EQ(got.status, Status::bad_data) << rule;
    EXPECT_STREQ(got.error.rule, rule) << offset;
    EXPECT_LE(got.error.offset, base_ + offset) << rule;
    EXPECT_GT(got.error.offset + 32, base_ + offset) << rule;
    ++refused_;
  }

  test::AlignedBlock block_;
  File file_;
  ClipMotion walk_;
  std::size_t base_ = 0;
  int refused_ = 0;
};

// The hips go 1 m in a second; a leg swings while the other stands, the left one first.
TEST_F(LoadMotions, AreWhatTheSourceDoes) {
  EXPECT_TRUE(is_valid(walk_));
  EXPECT_EQ(walk_.duration_s, 1.0f);
  EXPECT_NEAR(walk_.speed_m_s, 1, 0.001);
  EXPECT_NEAR(walk_.heading[0], 0, 1e-6);
  EXPECT_EQ(walk_.heading[1], 0.0f);
  EXPECT_NEAR(walk_.heading[2], 1, 1e-6);
  ASSERT_EQ(walk_.phase_marks.size, 2u);
  EXPECT_EQ(walk_.phase_marks[0], 0.0f);
  EXPECT_NEAR(walk_.phase_marks[1], 0.5, 1.5 / 60);
  ASSERT_EQ(walk_.root.size, 2u);
  EXPECT_EQ(walk_.root[1].time_s, 1.0f);
  EXPECT_NEAR(walk_.root[1].translation[2], 1, 1e-6);
  ASSERT_EQ(walk_.events.size, 4u);
  const ClipEvent& wag = walk_.events[file_.find_event(walk_, "wag")];
  EXPECT_EQ(wag.time_s, 0.5f);
  EXPECT_EQ(wag.until_s, 0.75f);
  EXPECT_EQ(wag.number, 2.0f);
  EXPECT_EQ(file_.find_event(walk_, "right_foot"), 3u);
  EXPECT_GT(walk_.events[3].until_s, walk_.duration_s);  // over the loop's end
}

// The poses have what the root has not.
TEST_F(LoadMotions, RootIsTakenOutOfThePoses) {
  const Clip clip = file_.clip(kWalk);
  for (const Track& track : clip.tracks)
    if (track.joint == 0 && track.path == TrackPath::translation)
      for (std::uint32_t k = 0; k < track.key_count; ++k)
        EXPECT_NEAR(clip.values[track.first_value + 3 * k + 2], 0, 1e-6) << k;
}

TEST_F(LoadMotions, OfAClipThatOnlyStands) {
  const ClipMotion stand = file_.motion(kStand);
  EXPECT_EQ(stand.duration_s, 1.0f);
  EXPECT_EQ(stand.speed_m_s, 0.0f);
  EXPECT_EQ(stand.root.size, 0u);
  EXPECT_EQ(stand.phase_marks.size, 0u);
  ASSERT_EQ(stand.events.size, 2u);
  EXPECT_STREQ(file_.text(stand.events[0].name), "left_foot");
  EXPECT_TRUE(is_within(stand.events[0], 0.3f, 1));
}

TEST_F(LoadMotions, OfWhatThereIsNot) {
  const ClipMotion none = file_.motion(2);
  EXPECT_EQ(none.duration_s, 0.0f);
  EXPECT_EQ(none.events.size, 0u);
  EXPECT_EQ(file_.find_event(none, "wag"), 0u);
  EXPECT_EQ(file_.find_event(walk_, "no such"), 4u);
  EXPECT_EQ(file_.find_event(walk_, nullptr), 4u);
  const test::AlignedBlock other = test::golden_coded_copy();
  File dance;
  ASSERT_EQ(load(other, dance), Status::ok);
  EXPECT_EQ(dance.motion(0).duration_s, dance.clip(0).duration_s);
  EXPECT_EQ(dance.motion(0).events.size, 0u);
}

TEST_F(LoadMotions, ThatBreakARuleAreRefused) {
  using test::kInfinity, test::kNan;
  refuse(0, std::uint32_t{2}, "no such clip");
  refuse(0, std::uint32_t{0}, "one section of motion a clip, in their order");
  refuse(4, -1.0f, "a speed is finite, and not negative");
  refuse(4, kNan, "a speed is finite, and not negative");
  refuse(8, 1.0f, "a heading is of length 1, or 0");
  refuse(20, std::uint32_t{3}, "section size differs from its counts");
  refuse(24, std::uint32_t{0x10000004}, "section size differs from its counts");
  refuse(kRoot + 20, 0.5f, "a root begins at the identity");
  refuse(kRoot + 32, 0.0f, "keys of a root ascend in their clip");
  refuse(kRoot + 32, 1.5f, "keys of a root ascend in their clip");
  refuse(kRoot + 32 + 4, 0.5f, "a rotation that is no unit quaternion");
  refuse(kRoot + 32 + 28, kInfinity, "a root beyond 1e12");
  refuse(kEvents, 0.9f, "an event is no longer than its clip");
  refuse(kEvents + 16, kNan, "events ascend in their clip");
  refuse(kEvents + 16 + 4, 1.5f, "an event is no longer than its clip");
  refuse(kEvents + 16 + 8, std::uint32_t{100000}, "name outside the name section");
  refuse(kEvents + 16 + 12, kInfinity, "an event's number is finite");
  refuse(kMarks, 1.0f, "phase marks go once round their clip");
  refuse(kMarks + 4, 0.0f, "phase marks go once round their clip");
  EXPECT_EQ(refused_, 19);
}

// A cycle may begin anywhere in the clip.
TEST_F(LoadMotions, MarksGoOnAtTheClipsStart) {
  std::vector<float> marks = {0.75f, 0.25f};
  EXPECT_EQ(test::load_with(block_, base_ + kMarks, 0.75f).status, Status::ok);
  walk_.phase_marks = marks;
  EXPECT_TRUE(is_valid(walk_));
  marks = {0.5f, 0.75f, 0.25f};
  walk_.phase_marks = marks;
  EXPECT_TRUE(is_valid(walk_));
  for (const std::vector<float>& bad : {std::vector<float>{0.5f, 0.25f, 0.75f}, {0.5f, 0.25f, 0.1f}, {0.5f, 0.5f}}) {
    walk_.phase_marks = bad;
    EXPECT_FALSE(is_valid(walk_));
  }
}

}  // namespace
}  // namespace marrow
