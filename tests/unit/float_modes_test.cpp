// Games set the processor to modes that a library does not choose: denormal numbers as zero, or another rounding.
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include <gtest/gtest.h>

#include "marrow/marrow.h"
#include "support/aligned.h"
#include "support/golden.h"
#include "support/rig.h"

namespace marrow {
namespace {

using test::AlignedBlock;

// Denormal arguments and results are zero while this lives.
class DenormalsAreZero {
 public:
  DenormalsAreZero() : before_(get()) { set(before_ | kBits); }
  ~DenormalsAreZero() { set(before_); }
  DenormalsAreZero(const DenormalsAreZero&) = delete;
  DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr std::uint64_t kBits = 0x8040;  // flush to zero, denormals are zero
  static std::uint64_t get() {
    return _mm_getcsr();
  }
  static void set(std::uint64_t mode) {
    _mm_setcsr(static_cast<unsigned>(mode));
  }
#elif defined(__aarch64__)
  static constexpr std::uint64_t kBits = std::uint64_t{1} << 24;  // FZ
  static std::uint64_t get() {
    std::uint64_t mode = 0;
    asm volatile("mrs %0, fpcr" : "=r"(mode));
    return mode;
  }
  static void set(std::uint64_t mode) {
    asm volatile("msr fpcr, %0" ::"r"(mode));
  }
#else
#error "how are denormals made zero here?"
#endif
  std::uint64_t before_;
};

class Rounding {
 public:
  explicit Rounding(int mode) { EXPECT_EQ(std::fesetround(mode), 0); }
  ~Rounding() { std::fesetround(FE_TONEAREST); }
  Rounding(const Rounding&) = delete;
  Rounding& operator=(const Rounding&) = delete;
};

// Whether 2⁻¹³⁰ and half of 2⁻¹²⁶ are more than nothing.
bool has_denormals() {
  volatile float denormal = 0x1p-130f, smallest = 0x1p-126f;
  const volatile float doubled = denormal * 0x1p20f, half = smallest * 0.5f;
  return doubled > 0 && half > 0;
}

void append(const std::vector<Affine>& matrices, std::vector<float>& out) {
  const std::size_t at = out.size();
  out.resize(at + matrices.size() * 12);
  static_assert(sizeof(Affine) == 48);
  if (!matrices.empty()) std::memcpy(&out[at], matrices.data(), matrices.size() * sizeof(Affine));
}

// At forty-one moments of the clip: each joint's matrix, and the palettes of the meshes.
void append_poses(const Skeleton& skeleton, const Clip& clip, const std::vector<Mesh>& meshes,
                  std::vector<float>& out) {
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> model(skeleton.joint_count);
  for (int moment = 0; moment <= 40; ++moment) {
    EXPECT_EQ(sample(skeleton, clip, clip.duration_s * static_cast<float>(moment) / 40, local), Status::ok);
    EXPECT_EQ(local_to_model(skeleton, local, model), Status::ok);
    append(model, out);
    for (const Mesh& mesh : meshes) {
      std::vector<Affine> palette(mesh.palette_size());
      EXPECT_EQ(build_palette(mesh, model, palette), Status::ok);
      append(palette, out);
    }
  }
}

std::vector<float> poses_of(const test::TestCharacter& c) {
  std::vector<float> out;
  append_poses(c.skeleton.view(), c.clip.view(), {c.mesh.view()}, out);
  return out;
}

std::vector<float> poses_of(const File& file) {
  std::vector<float> out;
  for (std::uint32_t c = 0; c < file.clip_count(); ++c) {
    const Clip clip = file.clip(c);
    std::vector<Mesh> meshes;
    for (std::uint32_t m = 0; m < file.mesh_count(); ++m)
      if (file.mesh(m).skeleton == clip.skeleton) meshes.push_back(file.mesh(m));
    append_poses(file.skeleton(clip.skeleton), clip, meshes, out);
  }
  return out;
}

// A creature whose bones' lengths are denormal numbers.
test::TestCharacter minute_character() {
  constexpr float kLess = 0x1p-128f;
  test::TestCharacter c = test::make_character(57, 40, 8, false);
  for (SoaTransform& t : c.skeleton.rest)
    for (auto& axis : t.translation)
      for (float& x : axis) x *= kLess;
  for (const Track& track : c.clip.tracks) {
    if (track.path != TrackPath::translation) continue;
    const std::size_t keys = track.interpolation == Interpolation::cubic_spline ? 3 : 1;
    for (std::size_t i = 0; i < keys * 3 * track.key_count; ++i) c.clip.values[track.first_value + i] *= kLess;
  }
  return c;
}

// Every character that is tested here, one after the other.
std::vector<std::vector<float>> all_poses() {
  std::vector<std::vector<float>> out;
  for (const std::uint64_t seed : {51u, 52u, 53u}) out.push_back(poses_of(test::make_character(seed, 67, 8, false)));
  out.push_back(poses_of(minute_character()));
  for (const auto copy :
       {test::golden_copy, test::golden_coded_copy, test::golden_uneven_copy, test::golden_half_joint_copy,
        test::golden_centres_copy, test::golden_limits_copy, test::golden_lod_copy}) {
    const AlignedBlock block(copy());
    File file;
    EXPECT_EQ(load(block, file), Status::ok);
    out.push_back(poses_of(file));
  }
  return out;
}

TEST(FloatModes, DenormalsAsZeroHardlyMatter) {
  ASSERT_TRUE(has_denormals());
  const std::vector<std::vector<float>> want = all_poses();
  std::vector<std::vector<float>> got;
  {
    const DenormalsAreZero mode;
    ASSERT_FALSE(has_denormals()) << "the mode is not in effect";
    got = all_poses();
  }
  ASSERT_TRUE(has_denormals());
  int changed = 0;
  ASSERT_EQ(got.size(), want.size());
  for (std::size_t c = 0; c < want.size(); ++c) {
    ASSERT_EQ(got[c].size(), want[c].size());
    ASSERT_GT(want[c].size(), 200u) << c;
    float worst = 0;
    for (std::size_t i = 0; i < want[c].size(); ++i) {
      ASSERT_TRUE(std::isfinite(got[c][i])) << c;
      worst = std::max(worst, std::abs(got[c][i] - want[c][i]));
      changed += got[c][i] != want[c][i];
    }
    EXPECT_LE(worst, 1e-6f) << c;
  }
  EXPECT_GT(changed, 100) << "no character has denormals";
}

TEST(FloatModes, OtherRoundingsGiveFinitePalettes) {
  const std::vector<std::vector<float>> nearest = all_poses();
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::vector<std::vector<float>> got;
    {
      const Rounding rounding(mode);
      got = all_poses();
    }
    ASSERT_EQ(got.size(), nearest.size());
    int changed = 0;
    for (std::size_t c = 0; c < got.size(); ++c) {
      ASSERT_EQ(got[c].size(), nearest[c].size());
      for (std::size_t i = 0; i < got[c].size(); ++i) {
        ASSERT_TRUE(std::isfinite(got[c][i])) << mode << ", character " << c;
        changed += got[c][i] != nearest[c][i];
      }
    }
    EXPECT_GT(changed, 1000) << mode << ": the mode is not in effect";
  }
}

}  // namespace
}  // namespace marrow
