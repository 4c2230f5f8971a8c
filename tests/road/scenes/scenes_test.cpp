// Whatever a scene is like, what is said about its errors is true: three hundred at random against the reference.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "road/scenes/random_scene.h"
#include "road/scenes/scene_measure.h"

namespace marrow::test {
namespace {

constexpr std::uint32_t kScenes = 300;

struct KindResult {
  std::size_t count = 0, refused = 0, broken = 0, coded = 0, compared = 0;
  SceneErrors worst;
  double largest = 0;
  std::uint32_t worst_number = 0;
};

void add(const SceneErrors& errors, const RandomScene& scene, KindResult& to) {
  ++to.count;
  to.refused += !errors.refused.empty();
  to.coded += errors.coded;
  to.compared += errors.compared;
  to.broken += errors.largest() > kMostRatio;
  SceneErrors& w = to.worst;
  w.lossless = std::max(w.lossless, errors.lossless);
  w.vertices = std::max(w.vertices, errors.vertices);
  w.joints = std::max(w.joints, errors.joints);
  w.promise = std::max(w.promise, errors.promise);
  w.rest = std::max(w.rest, errors.rest);
  if (errors.largest() < to.largest) return;
  to.largest = errors.largest();
  w.worst = errors.worst;
  to.worst_number = scene.number;
}

void print(const std::array<KindResult, kSceneKinds>& results) {
  std::printf("%-21s %3s %3s %3s %5s  real / said: %8s %8s %8s %8s %8s  worst\n", "kind", "n", "ref", "bad", "coded",
              "lossless", "vertices", "joints", "promise", "rest");
  for (std::size_t k = 0; k < kSceneKinds; ++k) {
    const KindResult& r = results[k];
    std::printf("%-21s %3zu %3zu %3zu %5zu               %8.3g %8.3g %8.3g %8.3g %8.3g  %u: %s\n",
                name_of(static_cast<SceneKind>(k)), r.count, r.refused, r.broken, r.coded, r.worst.lossless,
                r.worst.vertices, r.worst.joints, r.worst.promise, r.worst.rest, r.worst_number, r.worst.worst.c_str());
  }
}

// Which scenes: all, or MARROW_SCENES=FIRST-LAST, which prints the table as failures do.
struct Range {
  std::uint32_t first = 0, last = kScenes - 1;
  bool asked = false;
};

Range asked_for() {
  Range out;
  const char* const text = std::getenv("MARROW_SCENES");
  out.asked = text != nullptr && std::sscanf(text, "%u-%u", &out.first, &out.last) == 2;
  return out;
}

std::string described(const RandomScene& scene) {
  std::string out = "scene " + std::to_string(scene.number) + ", " + name_of(scene.kind);
  for (std::size_t k = 0; k < kSceneKinds; ++k)
    if (scene.has[k] && static_cast<SceneKind>(k) != scene.kind)
      out.append(" + ").append(name_of(static_cast<SceneKind>(k)));
  return out;
}

TEST(RandomScenes, AreAsGoodAsIsSaid) {
  std::array<KindResult, kSceneKinds> results;
  const Range range = asked_for();
  for (std::uint32_t number = range.first; number <= range.last; ++number) {
    const RandomScene scene = random_scene(number);
    const SceneErrors errors = measure(scene);
    add(errors, scene, results[static_cast<std::size_t>(scene.kind)]);
    EXPECT_LE(errors.largest(), kMostRatio) << described(scene) << ": " << errors.worst;
    // Nothing times a scale of 0 is more than 0: only such changes cannot be had.
    EXPECT_TRUE(errors.refused.empty() || scene.has[static_cast<std::size_t>(SceneKind::additive_over_zero)])
        << described(scene) << ": " << errors.refused;
  }
  if (range.asked || HasFailure()) print(results);
  if (range.asked) return;
  for (std::size_t k = 0; k < kSceneKinds; ++k) {
    EXPECT_GE(results[k].count, kScenes / kSceneKinds) << name_of(static_cast<SceneKind>(k));
    EXPECT_GE(results[k].compared, 4'000U) << name_of(static_cast<SceneKind>(k));
    EXPECT_GE(results[k].coded, 1U) << name_of(static_cast<SceneKind>(k));
  }
}

}  // namespace
}  // namespace marrow::test
