// is_valid of motions made by hand: each rule, broken once.
#include "marrow/clip_motion.h"

#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "support/bad_numbers.h"

namespace marrow {
namespace {

struct TestMotion {
  std::vector<ClipEvent> events = {{0, 0, 1, 2}, {0.5f, 1.25f, 3, 0}, {1, 1, 0, -1}};
  std::vector<float> marks = {0.125f, 0.5f};
  std::vector<RootKey> root = {{0, {0, 0, 0, 1}, {0, 0, 0}}, {1, {0, 0.6f, 0, 0.8f}, {0, 0, 1.5f}}};
  float duration_s = 1, speed_m_s = 1.5f, heading[3] = {0, 0, 1};

  bool valid() const {
    return is_valid(ClipMotion{.duration_s = duration_s,
                               .speed_m_s = speed_m_s,
                               .heading = {heading[0], heading[1], heading[2]},
                               .events = events,
                               .phase_marks = marks,
                               .root = root});
  }
};

TEST(ClipMotion, ThatKeepsTheRulesIsValid) {
  EXPECT_TRUE(is_valid(ClipMotion{}));
  EXPECT_TRUE(TestMotion().valid());
}

TEST(ClipMotion, ThatBreaksARuleIsNot) {
  using test::kInfinity, test::kNan;
  const std::vector<std::function<void(TestMotion&)>> faults = {
      [](TestMotion& m) { m.duration_s = -1; },
      [](TestMotion& m) { m.duration_s = kNan; },
      [](TestMotion& m) { m.duration_s = kInfinity; },
      [](TestMotion& m) { m.duration_s = 0.9f; },
      [](TestMotion& m) { m.speed_m_s = -1; },
      [](TestMotion& m) { m.speed_m_s = kInfinity; },
      [](TestMotion& m) { m.heading[0] = 1; },
      [](TestMotion& m) { m.heading[2] = kNan; },
      [](TestMotion& m) { m.events[0].time_s = 0.75f; },
      [](TestMotion& m) { m.events[2].time_s = 1.1f; },
      [](TestMotion& m) { m.events[0].time_s = kNan; },
      [](TestMotion& m) { m.events[1].until_s = 0.25f; },
      [](TestMotion& m) { m.events[1].until_s = 1.75f; },
      [](TestMotion& m) { m.events[1].until_s = kNan; },
      [](TestMotion& m) { m.events[1].number = kInfinity; },
      [](TestMotion& m) { m.marks[0] = 0.5f; },
      [](TestMotion& m) { m.marks[0] = -0.1f; },
      [](TestMotion& m) { m.marks[1] = 1; },
      [](TestMotion& m) { m.marks[1] = kNan; },
      [](TestMotion& m) {
        m.marks.clear();
        for (int i = 0; i < 65; ++i) m.marks.push_back(static_cast<float>(i) / 128);
      },
      [](TestMotion& m) { m.root[0].translation[1] = 0.1f; },
      [](TestMotion& m) { m.root[0].rotation[0] = 0.1f; },
      [](TestMotion& m) { m.root[1].time_s = 0; },
      [](TestMotion& m) { m.root[1].time_s = 1.5f; },
      [](TestMotion& m) { m.root[1].time_s = kNan; },
      [](TestMotion& m) { m.root[1].rotation[3] = 0.9f; },
      [](TestMotion& m) { m.root[1].rotation[3] = kNan; },
      [](TestMotion& m) { m.root[1].translation[0] = 2e12f; },
  };
  for (std::size_t i = 0; i < faults.size(); ++i) {
    TestMotion m;
    faults[i](m);
    EXPECT_FALSE(m.valid()) << "fault " << i;
  }
  EXPECT_FALSE(is_valid(ClipMotion{.duration_s = 1, .events = {nullptr, 1}}));
  EXPECT_FALSE(is_valid(ClipMotion{.duration_s = 1, .phase_marks = {nullptr, 1}}));
  EXPECT_FALSE(is_valid(ClipMotion{.duration_s = 1, .root = {nullptr, 1}}));
}

}  // namespace
}  // namespace marrow
