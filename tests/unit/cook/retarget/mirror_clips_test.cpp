// Clips with left and right exchanged: against reflections in double precision.
#include "cook/retarget/mirror_clips.h"

#include "common/failure.h"
#include "cook/skeleton/build_skeletons.h"
#include "unit/cook/retarget/raw_rig.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

// Mirrored places; rotations at rest are not.
const std::vector<RawRigBone> kBody = {{"hips", -1, {0, 1, 0}},
                                       {"left_leg", 0, {0.1, 0.9, 0}},
                                       {"right_leg", 0, {-0.1, 0.9, 0}},
                                       {"left_foot", 1, {0.12, 0.1, 0.03}},
                                       {"right_foot", 2, {-0.12, 0.1, 0.03}},
                                       {"head", 0, {0, 1.6, 0.05}}};

struct Body {
  RawScene scene;
  BuiltScene built;
};

Body body(RawInterpolation interpolation) {
  Body out{raw_rig(kBody, 4), {}};
  RawClip& clip = out.scene.clips.emplace_back();
  clip.name = "walk";
  const int values = interpolation == RawInterpolation::cubic_spline ? 9 : 3;
  for (int n = 1; n <= 6; ++n) {
    RawChannel turn{n, RawPath::rotation, interpolation, {0, 0.5F, 1}, {}};
    RawChannel place{n, RawPath::translation, interpolation, {0, 0.5F, 1}, {}};
    for (int i = 0; i < values; ++i) {
      const glm::dquat q = some_turn(3 * n + 0.4 * i);
      turn.values.emplace_back(q.x, q.y, q.z, q.w);
      place.values.emplace_back(0.1 * i, 0.2 * n, 0.3 - 0.05 * i, 0);
    }
    out.scene.clips[0].channels.push_back(turn);
    if (n == 1 || n == 3 || n == 4) out.scene.clips[0].channels.push_back(place);
  }
  out.built = build_skeletons(out.scene);
  const std::vector<std::string>& names = out.built.skeletons.at(0).joint_names;
  const auto joint = [&](const char* name) {
    return static_cast<std::uint16_t>(std::ranges::find(names, name) - names.begin());
  };
  out.built.skeletons[0].roles.pairs = {{joint("left_leg"), joint("right_leg")},
                                        {joint("left_foot"), joint("right_foot")}};
  return out;
}

TEST(MirrorClips, PlacesAreReflected) {
  Body b = body(RawInterpolation::linear);
  const RawScene got = with_mirrored_clips(b.scene, b.built, {{"walk_mirrored", "walk", {}}});
  ASSERT_EQ(got.clips.size(), 2u);
  EXPECT_EQ(got.clips[1].name, "walk_mirrored");
  const int other[] = {0, 1, 3, 2, 5, 4, 6};
  for (std::size_t key = 0; key < 3; ++key) {
    const RawPose from = raw_pose(got, &got.clips[0], key), to = raw_pose(got, &got.clips[1], key);
    const RawPose rest = raw_pose(got, nullptr, 0);
    for (std::size_t n = 1; n <= 6; ++n) {
      const auto mirror = static_cast<std::size_t>(other[n]);
      glm::dvec3 place = from.places[mirror];
      place.x = -place.x;
      EXPECT_LE(glm::length(place - to.places[n]), 1e-6) << key << ' ' << n;
      // What it has turned since rest, reflected.
      const glm::dmat3 reflection(-1, 0, 0, 0, 1, 0, 0, 0, 1);
      const glm::dmat3 since_rest =
          glm::mat3_cast(from.turns[mirror]) * glm::transpose(glm::mat3_cast(rest.turns[mirror]));
      const glm::dmat3 expected = reflection * since_rest * reflection * glm::mat3_cast(rest.turns[n]);
      const glm::dmat3 off = glm::transpose(expected) * glm::mat3_cast(to.turns[n]);
      EXPECT_NEAR(off[0][0] + off[1][1] + off[2][2], 3, 1e-9) << key << ' ' << n;
    }
  }
}

TEST(MirrorClips, TwiceIsTheSame) {
  for (const RawInterpolation interpolation :
       {RawInterpolation::step, RawInterpolation::linear, RawInterpolation::cubic_spline}) {
    Body b = body(interpolation);
    b.scene.clips[0].channels.push_back({4, RawPath::scale, RawInterpolation::linear, {0}, {{1, 2, 3, 0}}});
    const RawScene got = with_mirrored_clips(b.scene, b.built, {{"mirrored", "walk", {}}, {"again", "mirrored", {}}});
    ASSERT_EQ(got.clips.size(), 3u);
    const RawClip &first = got.clips[0], &again = got.clips[2];
    ASSERT_EQ(first.channels.size(), again.channels.size());
    for (std::size_t c = 0; c < first.channels.size(); ++c) {
      EXPECT_EQ(first.channels[c].node, again.channels[c].node);
      EXPECT_EQ(first.channels[c].interpolation, again.channels[c].interpolation);
      EXPECT_EQ(first.channels[c].times_s, again.channels[c].times_s);
      for (std::size_t i = 0; i < first.channels[c].values.size(); ++i)
        EXPECT_LE(glm::length(first.channels[c].values[i] - again.channels[c].values[i]), 1e-6F) << c << ' ' << i;
    }
  }
}

TEST(MirrorClips, WhatDoesNotFitIsSaid) {
  const Body b = body(RawInterpolation::linear);
  const auto mirror = [&](const MirrorRule& rule) { with_mirrored_clips(b.scene, b.built, {rule}); };
  expect_failure([&] { mirror({"a", "wlak", {}}); }, tools::Exit::usage, "", "no clip \"wlak\"");
  expect_failure([&] { mirror({"walk", "walk", {}}); }, tools::Exit::usage, "", "there is a clip \"walk\" already");
  const RawScene same = with_mirrored_clips(b.scene, b.built, {{"a", "wlak", {"marrow.toml", "1:1", false}}});
  EXPECT_EQ(same.clips.size(), 1u);
  BuiltScene without = b.built;
  without.skeletons[0].roles = {};
  expect_failure(
      [&] {
        with_mirrored_clips(b.scene, without, {{"a", "walk", {}}});
      },
      tools::Exit::invalid, "/nodes/1", "no joints that mirror each other");
}

}  // namespace
}  // namespace marrow::cook
