// load: rotations have a length, so that no blend of them comes to nothing.
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "marrow/marrow.h"
#include "support/damage.h"
#include "support/golden.h"

namespace marrow {
namespace {

struct Quaternion4 {
  float q[4];
};
constexpr const char *kNoUnit = "a rotation that is no unit quaternion",
                     *kFar = "a LINEAR rotation in the hemisphere of the one before it";

class LoadRotations : public ::testing::Test {
 protected:
  LoadRotations() : block_(test::golden_copy()) { EXPECT_EQ(load(block_, file_), Status::ok); }
  std::size_t offset_of(const void* p) const {
    return static_cast<std::size_t>(static_cast<const std::byte*>(p) - block_.data());
  }
  void refuse(std::size_t offset, Quaternion4 q, const char* rule, float last = 0) {
    const test::DamageReport got = test::load_with(block_, offset, q);
    EXPECT_EQ(got.status, Status::bad_data) << q.q[0] << ' ' << q.q[3] << ' ' << last;
    EXPECT_STREQ(got.error.rule, rule);
    ++refused_;
  }
  // The first track of rotations with at least two keys.
  const Track* turning(Interpolation how) const {
    for (std::uint32_t c = 0; c < file_.clip_count(); ++c)
      for (const Track& t : file_.clip(c).tracks)
        if (t.path == TrackPath::rotation && t.interpolation == how && t.key_count > 1) {
          values_ = file_.clip(c).values + t.first_value;
          return &t;
        }
    return nullptr;
  }

  test::AlignedBlock block_;
  File file_;
  mutable const float* values_ = nullptr;
  int refused_ = 0;
};

// Squares that add up to less than a half, in any lane, past the last joint too.
TEST_F(LoadRotations, OfRestPoses) {
  const SoaTransform* const rest = file_.skeleton(0).rest;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    SoaTransform changed = *rest;
    const auto set = [&](float x, float w) {
      for (auto& component : changed.rotation) component[lane] = 0;
      changed.rotation[0][lane] = x;
      changed.rotation[3][lane] = w;
      return test::load_with(block_, offset_of(rest), changed);
    };
    for (const auto& [x, w] : {std::pair(0.0f, 0.0f), std::pair(0.0f, 0.7071f), std::pair(-0.49f, 0.5f)}) {
      const test::DamageReport got = set(x, w);
      EXPECT_EQ(got.status, Status::bad_data) << lane << ' ' << x << ' ' << w;
      EXPECT_STREQ(got.error.rule, kNoUnit);
      EXPECT_EQ(got.error.offset, offset_of(rest->rotation)) << "where the four joints' rotations are";
    }
    for (const auto& [x, w] : {std::pair(0.0f, 0.7072f), std::pair(-0.51f, 0.5f), std::pair(1.0f, 0.0f)})
      EXPECT_EQ(set(x, w).status, Status::ok) << lane << ' ' << x << ' ' << w;
  }
}

TEST_F(LoadRotations, OfKeys) {
  for (const Interpolation how : {Interpolation::linear, Interpolation::step}) {
    const Track* const t = turning(how);
    if (t == nullptr) {
      ASSERT_EQ(how, Interpolation::step) << "the golden file has LINEAR ones";
      continue;
    }
    for (std::uint32_t k = 0; k < t->key_count; ++k) {
      refuse(offset_of(values_ + 4 * k), {{0, 0, 0, 0}}, kNoUnit);
      refuse(offset_of(values_ + 4 * k), {{0.5f, 0, 0.49f, 0}}, kNoUnit);
    }
  }
  EXPECT_GE(refused_, 4);
}

// What lies between a key and one against it would be nothing.
TEST_F(LoadRotations, OfKeysThatFaceEachOther) {
  const Track* const t = turning(Interpolation::linear);
  ASSERT_NE(t, nullptr);
  const float* const a = values_;
  const std::size_t second = offset_of(a + 4);
  refuse(second, {{-a[0], -a[1], -a[2], -a[3]}}, kFar);
  // Along the first and across it: products of -0.26 and -0.24.
  const float across[4] = {-a[1], a[0], -a[3], a[2]};
  const auto at = [&](float product) {
    const float rest = std::sqrt(1 - product * product);
    Quaternion4 out;
    for (int c = 0; c < 4; ++c) out.q[c] = product * a[c] + rest * across[c];
    return out;
  };
  refuse(second, at(-0.26f), kFar);
  const test::DamageReport near = test::load_with(block_, second, at(-0.24f));
  EXPECT_STRNE(near.error.rule, kFar) << "near enough to the first, whatever the third says of it";
  Track step = *t;
  step.interpolation = Interpolation::step;
  Quaternion4 turned;
  for (int c = 0; c < 4; ++c) turned.q[c] = -a[c];
  std::memcpy(block_.data() + second, &turned, sizeof turned);
  EXPECT_EQ(test::load_with(block_, offset_of(t), step).status, Status::ok) << "nothing lies between keys of STEP";
}

// The shortest that load, between keys as far apart as load, blended in every share: all are of unit length.
TEST_F(LoadRotations, TheShortestThatLoadBlend) {
  const Track* const t = turning(Interpolation::linear);
  ASSERT_NE(t, nullptr);
  const Skeleton skeleton = file_.skeleton(0);
  constexpr float kShort = 0.70711f, kAcross = 0.6125f, kAgainst = -0.3535f;  // products of 1/2 and -1/4
  for (std::uint32_t k = 0; k < t->key_count; ++k) {
    const Quaternion4 key = k % 2 == 0 ? Quaternion4{{kShort, 0, 0, 0}} : Quaternion4{{kAgainst, kAcross, 0, 0}};
    std::memcpy(block_.data() + offset_of(values_ + 4 * k), &key, sizeof key);
  }
  auto* const rest = reinterpret_cast<SoaTransform*>(block_.data() + offset_of(skeleton.rest));
  for (auto& component : rest->rotation)
    for (float& x : component) x = 0;
  for (float& y : rest->rotation[1]) y = -kShort;
  test::forge_checksum(block_.data(), block_.size());
  File file;
  DataError error;
  ASSERT_EQ(load(block_, file, &error), Status::ok) << error.rule;
  ASSERT_TRUE(test::has_finite_palettes(file));
  std::vector<SoaTransform> pose(skeleton.soa_size()), out(skeleton.soa_size());
  const std::vector<SoaTransform> still(skeleton.rest, skeleton.rest + skeleton.soa_size());
  int checked = 0;
  for (int step = 0; step <= 20; ++step)
    for (const float share : {0.01f, 0.5f, 0.99f}) {
      const Clip clip = file.clip(0);
      ASSERT_EQ(sample(skeleton, clip, clip.duration_s * static_cast<float>(step) / 20, pose), Status::ok);
      ASSERT_EQ(blend(skeleton, {{pose, 1 - share, {}}, {still, share, {}}}, out), Status::ok);
      const std::size_t lane = t->joint % 4;
      double squares = 0;
      for (const auto& component : out[t->joint / 4].rotation)
        squares += static_cast<double>(component[lane]) * static_cast<double>(component[lane]);
      EXPECT_NEAR(squares, 1, 1e-5) << step << ' ' << share;
      ++checked;
    }
  EXPECT_EQ(checked, 63);
}

}  // namespace
}  // namespace marrow
