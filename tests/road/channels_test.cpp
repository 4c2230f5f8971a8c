// Morph weights from glTF to the runtime, on every model, against the reference evaluator.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "disk/cook_on_disk.h"
#include "marrow/sample.h"
#include "road/cooked.h"
#include "road/models.h"
#include "road/reference.h"
#include "support/aligned.h"

namespace marrow::test {
namespace {

constexpr int kMoments = 101;
// What leaving out and rounding keys may cost (docs/cooking/clips.md), and float's rounding in times, weights and their
// sum.
constexpr double kShare = 0x1p-17 + 0x1p-20;

struct Compared {
  std::size_t channels = 0, values = 0, keys = 0, source_keys = 0;
};

double largest_of(const SourceChannel& c) {
  double largest = 0;
  for (const Quat& v : c.values) largest = std::max(largest, std::fabs(v[0]));
  return largest;
}

// Returns how many of the animation's weights the clip has: each is in the clip of its mesh's skeleton.
std::size_t compare(const File& file, const Clip& clip, const SourceAnimation& animation, Compared& total) {
  std::size_t found = 0;
  std::vector<float> out(clip.channels.size);
  std::set<std::string> names;
  for (const SourceWeight& w : animation.weights) {
    const std::uint32_t i = file.find_channel(clip, w.name.c_str());
    if (i == clip.channels.size) continue;
    ++found;
    if (!names.insert(w.name).second) continue;  // the first of that name is found
    EXPECT_EQ(clip.channels[i].rest, static_cast<float>(w.rest)) << w.name;
    EXPECT_LE(w.channel.times_s.back(), static_cast<double>(clip.duration_s));
    total.keys += clip.channels[i].key_count;
    total.source_keys += w.channel.times_s.size();
    ++total.channels;
    for (int m = 0; m < kMoments; ++m, ++total.values) {
      const float time_s = clip.duration_s * static_cast<float>(m - 2) / (kMoments - 5);  // and beyond both ends
      EXPECT_EQ(sample_channels(clip, time_s, out), Status::ok);
      const double want = sample_channel(w.channel, static_cast<double>(time_s))[0];
      EXPECT_NEAR(static_cast<double>(out[i]), want, kShare * largest_of(w.channel)) << w.name << " at " << time_s;
    }
  }
  return found;
}

class Weights : public ::testing::TestWithParam<std::string> {};

TEST_P(Weights, AgreeWithTheReference) {
  const Source source = read_source(GetParam());
  Compared compared[2];
  for (const bool raw : {true, false}) {
    cook::CookOptions options;
    options.mesh.codec = cook::MeshCodec::none;
    options.clips.raw = raw;
    const cook::Result cooked = cook::cook_file(GetParam(), options);
    const AlignedBlock block(cooked.file.data(), cooked.file.size());
    File file;
    ASSERT_EQ(load(block, file), Status::ok);
    std::uint32_t clip = 0;
    for (const SourceAnimation& animation : source.animations) {
      if (animation.channels.empty() && animation.weights.empty()) continue;
      ASSERT_LT(clip, file.clip_count());
      const std::uint32_t behind = next_animation(file, clip);
      std::size_t found = 0;
      for (; clip < behind; ++clip) found += compare(file, file.clip(clip), animation, compared[raw ? 0 : 1]);
      EXPECT_GE(found, animation.weights.size());
    }
  }
  EXPECT_EQ(compared[0].channels, compared[1].channels);
  EXPECT_EQ(compared[0].keys, compared[0].source_keys) << "raw keeps every key";
  EXPECT_LE(compared[1].keys, compared[1].source_keys);
  if (compared[0].channels == 0) GTEST_SKIP() << "no morph weights are animated";
  EXPECT_EQ(compared[0].values, compared[0].channels * kMoments);
  std::printf("%-28s %3zu channels, %6zu keys, %6zu without those on lines\n",
              std::filesystem::path(GetParam()).stem().c_str(), compared[0].channels, compared[0].keys,
              compared[1].keys);
}

// Only models with animated weights; that there are any is the next test.
std::vector<std::string> models_with_weights() {
  std::vector<std::string> out;
  for (const std::string& path : models()) {
    const Source source = read_source(path);
    if (std::any_of(source.animations.begin(), source.animations.end(),
                    [](const SourceAnimation& a) { return !a.weights.empty(); }))
      out.push_back(path);
  }
  return out;
}

INSTANTIATE_TEST_SUITE_P(Models, Weights, ::testing::ValuesIn(models_with_weights()));

TEST(Weights, SomeModelHasThem) {
  EXPECT_GE(models_with_weights().size(), 1u);
}

}  // namespace
}  // namespace marrow::test
