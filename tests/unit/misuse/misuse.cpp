#include "unit/misuse/misuse.h"

#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

namespace marrow::test {

Misuse::Misuse(const char* function, std::uint64_t seed)
    : function_(function), round_(seed), random_(seed), careless_(random_.below(3) != 0) {}

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

Span<std::byte> Misuse::memory(std::size_t bytes) {
  const bool short_of_one = is_bad() && bytes > 0, off = is_bad();
  const std::size_t size = bytes - (short_of_one ? 1 : 0);
  return {own<std::byte>(size, off ? 8 : 0), size};
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

void Misuse::returned(Status status) {
  const std::vector<CallError> heard = errors_.take();
  if (status != Status::bad_argument) {
    EXPECT_TRUE(heard.empty()) << function_ << " told of a bad call that it did not refuse: " << heard[0].condition;
    ++(status == Status::ok ? ok_ : refused_);
    if (status == Status::ok && !garbage_) expect_finite();
    return;
  }
  ++refused_;
  ASSERT_EQ(heard.size(), 1u) << function_;
  EXPECT_EQ(heard[0].function, function_);
  for (const Watched& w : watched_)
    EXPECT_TRUE(w.before.empty() || std::memcmp(w.at, w.before.data(), w.before.size()) == 0)
        << function_ << " refused (" << heard[0].condition << "), but wrote";
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
