// What an exporter leaves instead of 0: it is 0 in the file, so that no product of it is denormal.
#include <cmath>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cook/scene/matrices.h"
#include "support/places.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

template <class T>
std::size_t count_below(float least, const T* first, std::size_t count) {
  const float* const numbers = reinterpret_cast<const float*>(first);
  std::size_t out = 0;
  for (std::size_t i = 0; i < count * sizeof(T) / sizeof(float); ++i)
    out += numbers[i] != 0 && std::fabs(numbers[i]) < least;
  return out;
}

// Of a clip at even moments.
std::size_t count_sampled(float least, const File& file, const Clip& clip, int moments) {
  const Skeleton skeleton = file.skeleton(clip.skeleton);
  std::vector<SoaTransform> pose(skeleton.soa_size());
  std::size_t out = 0;
  for (int i = 0; i <= moments; ++i) {
    const float time_s = clip.duration_s * static_cast<float>(i) / static_cast<float>(moments);
    EXPECT_EQ(sample(skeleton, clip, time_s, pose), Status::ok);
    out += count_below(least, pose.data(), pose.size());
  }
  return out;
}

TEST(TinyNumbers, AreZeroInTheFile) {
  SceneDocument d;
  const std::vector<int> joints = d.character("Ada", 0);
  Json& bone = d.b.root["nodes"][static_cast<std::size_t>(joints[1])];
  bone["translation"] = {1e-20, 0.5, -1e-32};
  bone["rotation"] = {0, 1e-19, 0, 1};
  d.clip("turn");
  d.keys(joints[1], "rotation", {0, 1}, {1e-20F, 0, 0, 1, 0.6F, -1e-18F, 0, 0.8F});
  d.clip("move");
  d.keys(joints[1], "translation", {0, 1}, {1e-20F, 0.5F, 0, 1e-17F, 0.5F, 1});
  d.clip("grow");
  d.keys(joints[1], "scale", {0, 1}, {1, 1, 1e-16F, 1, 1, 1});
  for (const bool raw : {false, true})
    for (const std::string codec : {"none", "meshopt"}) {
      const std::string options = "--mesh-codec " + codec + (raw ? " --clip-codec raw" : "");
      const LoadedCook cooked(cook_scene(d.read(), options_of(options)));
      const Skeleton skeleton = cooked.file.skeleton(0);
      EXPECT_EQ(count_below(1e-15F, skeleton.rest, skeleton.soa_size()), 0u);
      ASSERT_EQ(cooked.file.clip_count(), 3u);
      for (std::uint32_t c = 0; c < 2; ++c)
        EXPECT_EQ(count_sampled(1e-15F, cooked.file, cooked.file.clip(c), 1), 0u) << c;
      if (raw) EXPECT_EQ(count_sampled(1e-15F, cooked.file, cooked.file.clip(2), 1), 1u) << "scales are the artist's";
    }
}

TEST(TinyNumbers, OfMatricesAreZeroBesideTheirScale) {
  glm::dmat4 m(1.0);
  m[0] = {1e-17, 100, 6e-15, 0};
  m[1] = {1e-19, 2e-18, 1e-3, 0};
  m[2] = {1e-20, 1e-19, 1e-36, 0};
  m[3] = {1e-16, 1, -1e-20, 1};
  const Affine a = to_affine(m);
  const float expected[3][4] = {{0, 0, 1e-20F, 0}, {100, 2e-18F, 1e-19F, 1}, {6e-15F, 1e-3F, 0, 0}};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) EXPECT_EQ(a.rows[r][c], expected[r][c]) << r << ' ' << c;
}

// Between two keys a number may pass through 0, and is tiny for a moment; its square is no denormal number even so.
TEST(TinyNumbers, AreNotInPosesOfPab) {
  const std::filesystem::path path = std::filesystem::path(test::assets_folder()) / "pab.glb";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "not there: " << path;
  const LoadedCook cooked(cook_file(path.string(), options_of("--mesh-codec meshopt --images none --clip-error 1mm")));
  const Skeleton skeleton = cooked.file.skeleton(0);
  EXPECT_EQ(count_below(1e-15F, skeleton.rest, skeleton.soa_size()), 0u);
  for (std::uint32_t m = 0; m < cooked.file.mesh_count(); ++m)
    EXPECT_EQ(count_below(1e-15F, cooked.file.mesh(m).inverse_bind, cooked.file.mesh(m).joint_count), 0u);
  std::size_t passing = 0;
  for (std::uint32_t c = 0; c < cooked.file.clip_count(); ++c) {
    passing += count_sampled(1e-15F, cooked.file, cooked.file.clip(c), 300);
    EXPECT_EQ(count_sampled(1e-19F, cooked.file, cooked.file.clip(c), 300), 0u) << c;
  }
  EXPECT_LT(passing, 100u) << "of a million numbers";
}

}  // namespace
}  // namespace marrow::cook
