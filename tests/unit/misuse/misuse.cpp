#include "unit/misuse/misuse.h"

#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

namespace marrow::test {

Misuse::Misuse(const char* function, std::uint64_t seed)
    : function_(function), round_(seed), random_(seed), careless_(random_.below(3) != 0) {}

bool Misuse::is_bad() {
  const bool bad = careless_ && random_.below(8) == 0;
  if (bad) ++bad_, fine_ = false, wrong_ = nullptr;
  return bad;
}

bool Misuse::must_refuse(const char* what) {
  wrong_ = what;
  return true;
}

float Misuse::bad_number(float good) {
  using Limits = std::numeric_limits<float>;
  const float bad[] = {Limits::quiet_NaN(),
                       Limits::infinity(),
                       -Limits::infinity(),
                       Limits::denorm_min(),
                       -Limits::denorm_min(),
                       1e30f,
                       -1e30f,
                       Limits::max(),
                       Limits::lowest(),
                       -good,
                       0,
                       1,
                       -1,
                       1e-30f,
                       1e15f,
                       2147483648.0f};
  return bad[random_.below(std::size(bad))];
}

float Misuse::number(float good) {
  return is_bad() ? bad_number(good) : good;
}

std::uint32_t Misuse::index(std::uint32_t good) {
  const std::uint32_t bad[] = {0, good + 1, good - 1, 0xFFFF, 0xFFFFFFFF, 0x80000000, 1000};
  return is_bad() ? bad[random_.below(std::size(bad))] : good;
}

Span<std::byte> Misuse::memory(std::size_t bytes, std::size_t boundary, Length length) {
  const bool short_of_one = is_bad() && bytes > 0;
  if (short_of_one && length == Length::exact) must_refuse("memory short of a byte");
  const bool off = is_bad() && boundary > 1 && bytes > 0 && must_refuse("memory off its boundary");
  const std::size_t size = bytes - (short_of_one ? 1 : 0);
  return {own<std::byte>(size, off ? boundary / 2 : 0), size};
}

// Of memory that is as long as it must be.
void Misuse::take_shape(std::size_t size, std::size_t boundary, Length length) {
  shape_ = is_bad() ? static_cast<Shape>(1 + random_.below(6)) : Shape::good;
  if (shape_ == Shape::good || shape_ == Shape::numbers) return;
  if (size == 0 || (shape_ == Shape::off_boundary && boundary < 2)) {
    shape_ = Shape::good;
  } else if (shape_ == Shape::longer) {
    fine_ = length != Length::any;
  } else if (shape_ == Shape::null || shape_ == Shape::off_boundary || length == Length::exact ||
             (length == Length::exact_or_none && shape_ == Shape::shorter && size > 1)) {
    must_refuse(shape_ == Shape::null           ? "a list at null"
                : shape_ == Shape::off_boundary ? "a list off its boundary"
                                                : "a list that is too short");
  }
}

void Misuse::stays(const std::size_t& calls) {
  calls_ = &calls;
  calls_before_ = calls;
}

void Misuse::expect_finite() {
  for (const Watched& w : watched_) {
    for (std::size_t i = 0; w.is_floats && i + sizeof(float) <= w.before.size(); i += sizeof(float)) {
      float f = 0;
      std::memcpy(&f, w.at + i, sizeof f);
      ASSERT_TRUE(std::isfinite(f)) << function_ << ": float " << i / sizeof(float);
    }
  }
}

bool Misuse::same_behind(const Watched& w, std::size_t first) const {
  return first >= w.before.size() || std::memcmp(w.at + first, w.before.data() + first, w.before.size() - first) == 0;
}

void Misuse::expect_what_must_come(Status status, const std::vector<CallError>& heard) {
  const std::string told = heard.empty() ? "" : ": " + heard[0].condition;
  if (bad_ == 1 && wrong_ != nullptr) {
    EXPECT_EQ(status, Status::bad_argument) << function_ << " took " << wrong_;
  }
  if (!may_fail_ && (bad_ == 0 || (bad_ == 1 && fine_))) {
    EXPECT_EQ(status, Status::ok) << function_ << told;
  }
}

void Misuse::returned(Status status) {
  const std::vector<CallError> heard = errors_.take();
  gave_status_ = true;
  expect_what_must_come(status, heard);
  if (status != Status::bad_argument) {
    EXPECT_TRUE(heard.empty()) << function_ << " told of a bad call that it did not refuse: " << heard[0].condition;
    ++(status == Status::ok ? ok_ : refused_);
    if (status == Status::ok && !garbage_) expect_finite();
    for (const Watched& w : watched_)
      EXPECT_TRUE(bad_ > 1 || same_behind(w, w.written)) << function_ << " wrote behind what it was to write";
    return;
  }
  ++refused_;
  ++told_;
  ASSERT_EQ(heard.size(), 1u) << function_;
  EXPECT_EQ(heard[0].function, function_);
  EXPECT_GT(heard[0].condition.size(), 3u) << function_ << " does not say why";
  EXPECT_TRUE(calls_ == nullptr || *calls_ == calls_before_) << function_ << " calls GL, and refuses then";
  for (const Watched& w : watched_)
    EXPECT_TRUE(same_behind(w, 0)) << function_ << " refused (" << heard[0].condition << "), but wrote";
}

void Misuse::returned(float value) {
  ++ok_;
  EXPECT_TRUE(std::isfinite(value)) << function_;
}

MisuseStage::MisuseStage()
    : creature(make_character(41, 20, 3, true)),
      smaller_skeleton({{}, {0}, {1}}),
      skeleton(creature.skeleton.view()),
      smaller(smaller_skeleton.view()),
      clip(creature.clip.view()),
      mesh(creature.mesh.view()),
      pose(creature.skeleton.rest),
      other(pose),
      joints(skeleton.joint_count),
      palette(mesh.palette_size()) {
  EXPECT_EQ(sample(skeleton, clip, 0.5f, other), Status::ok);
  EXPECT_EQ(local_to_model(skeleton, pose, joints), Status::ok);
  EXPECT_EQ(build_palette(mesh, joints, palette), Status::ok);
}

const MisuseStage& stage() {
  static const MisuseStage made;
  return made;
}

}  // namespace marrow::test
