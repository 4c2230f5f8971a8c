// Reading glTF: animations of joints and of numbers.
#include "cook/gltf/read.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "unit/cook/gltf/document.h"

namespace marrow::cook {
namespace {

TEST(GltfClips, CubicSplinesKeepTheirTangents) {
  Builder b;
  // In-tangent, value, out-tangent.
  const std::vector<float> numbers = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18};
  b.channel(b.times({0.5F, 2}), b.numbers<float>(kF32, "VEC3", 3, numbers), "translation", "CUBICSPLINE");
  const RawScene scene = read(b);
  const RawChannel& channel = scene.clips.at(0).channels.at(0);
  EXPECT_EQ(channel.interpolation, RawInterpolation::cubic_spline);
  EXPECT_EQ(channel.path, RawPath::translation);
  EXPECT_EQ(channel.times_s, (std::vector<float>{0.5F, 2}));
  ASSERT_EQ(channel.values.size(), 6U);
  EXPECT_EQ(channel.values[1], glm::vec4(4, 5, 6, 0));
  EXPECT_EQ(channel.values[5], glm::vec4(16, 17, 18, 0));
}

TEST(GltfClips, QuaternionTangentsAreNotNormalised) {
  Builder b;
  const std::vector<float> numbers = {9, 0, 0, 0, 0, 0, 0, 1, 5, 0, 0, 0, 3, 0, 0, 0, 1, 0, 0, 0, 7, 0, 0, 0};
  b.channel(b.times({0, 1}), b.numbers<float>(kF32, "VEC4", 4, numbers), "rotation", "CUBICSPLINE");
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.clips[0].channels[0].values[2], glm::vec4(5, 0, 0, 0));
}

TEST(GltfClips, StepIsKept) {
  Builder b;
  b.channel(b.times({0, 1}), b.numbers<float>(kF32, "VEC3", 3, {1, 1, 1, 2, 2, 2}), "scale", "STEP");
  EXPECT_EQ(read(b).clips[0].channels[0].interpolation, RawInterpolation::step);
}

TEST(GltfClips, KeysThatCannotBePlayedAreDropped) {
  Builder b;
  const int times = b.times({0, 1e-45F, 1, 1, 2, 9e30F});
  std::vector<float> values;
  for (int i = 0; i < 6; ++i) values.insert(values.end(), {static_cast<float>(i), 0, 0});
  b.channel(times, b.numbers<float>(kF32, "VEC3", 3, values), "translation");
  const RawScene scene = read(b);
  const RawChannel& channel = scene.clips[0].channels[0];
  EXPECT_EQ(channel.times_s, (std::vector<float>{0, std::nextafter(1.0F, 0.0F), 1, 2})) << "nobody sees before 0";
  EXPECT_EQ(channel.values[0].x, 1);
  EXPECT_EQ(channel.values[1].x, 2) << "where it ends before the jump";
  EXPECT_EQ(channel.values[2].x, 3);
  EXPECT_EQ(channel.values[3].x, 4);
  EXPECT_TRUE(warns(scene, "keys-at-one-time", "/animations/0/samplers/0/input"));
  EXPECT_TRUE(warns(scene, "keys-too-close", "/animations/0/samplers/0/input"));
  EXPECT_TRUE(warns(scene, "keys-too-late", "/animations/0/samplers/0/input"));
}

// Of several keys at one time the first and the last count; near each other, they stay where they are.
TEST(GltfClips, KeysAtOneTimeAreAJump) {
  Builder b;
  const float near = std::nextafter(2.0F, 0.0F);
  const int times = b.times({0.5F, 0.5F, 1, 1, 1, near, 2});
  std::vector<float> values;
  for (int i = 0; i < 7; ++i) values.insert(values.end(), {static_cast<float>(i), 0, 0});
  b.channel(times, b.numbers<float>(kF32, "VEC3", 3, values), "translation", "STEP");
  const RawScene scene = read(b);
  const RawChannel& channel = scene.clips[0].channels[0];
  EXPECT_EQ(channel.times_s,
            (std::vector<float>{std::nextafter(0.5F, 0.0F), 0.5F, std::nextafter(1.0F, 0.0F), 1, near, 2}));
  std::vector<float> kept;
  for (const glm::vec4& value : channel.values) kept.push_back(value.x);
  EXPECT_EQ(kept, (std::vector<float>{0, 1, 2, 4, 5, 6}));
  EXPECT_TRUE(warns(scene, "keys-too-close")) << "key 3 lies between";
}

TEST(GltfClips, OddRotationsAreNormalised) {
  Builder b;
  b.channel(b.times({0, 1}), b.numbers<float>(kF32, "VEC4", 4, {0, 0, 0, 2, 0, 0, 0, 0}), "rotation");
  const RawScene scene = read(b);
  EXPECT_EQ(scene.clips[0].channels[0].values[0], glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(scene.clips[0].channels[0].values[1], glm::vec4(0, 0, 0, 1));
  EXPECT_TRUE(warns(scene, "rotation-keys-not-unit"));
}

TEST(GltfClips, WhatMovesNothingIsLeftOut) {
  Builder b;
  b.primitive({{"POSITION", b.curve(3)}});
  const int times = b.times({0, 1});
  const int move = b.numbers<float>(kF32, "VEC3", 3, {0, 0, 0, 1, 0, 0});
  b.channel(times, move, "pointer");
  RawScene scene = read(b);
  EXPECT_TRUE(scene.clips.empty());
  EXPECT_TRUE(warns(scene, "channel-dropped", "/animations/0/channels/0/target/path"));
  EXPECT_TRUE(warns(scene, "clip-dropped", "/animations/0"));
  b.channel(times, move, "translation");
  scene = read(b);
  ASSERT_EQ(scene.clips.size(), 1U);
  EXPECT_EQ(scene.clips[0].channels.size(), 1U);
}

// A triangle with two morph targets, drawn at node 0.
Builder morphing() {
  Builder b;
  const int positions = b.curve(3);
  b.primitive({{"POSITION", positions}})["targets"] = {{{"POSITION", positions}}, {{"POSITION", positions}}};
  return b;
}

TEST(GltfNumbers, WeightsAreATargetEach) {
  Builder b = morphing();
  b.root["nodes"][0]["name"] = "face";
  b.root["meshes"][0]["weights"] = {0.25, 0.5};
  b.root["meshes"][0]["extras"] = {{"targetNames", {"smile"}}};
  b.channel(b.times({0, 1, 3}), b.numbers<float>(kF32, "SCALAR", 1, {0, 1, 2, 3, 4, 5}), "weights", "STEP");
  const RawScene scene = read(b);
  ASSERT_EQ(scene.clips.size(), 1U);
  EXPECT_TRUE(scene.clips[0].channels.empty());
  ASSERT_EQ(scene.clips[0].scalars.size(), 2U);
  const RawScalar &smile = scene.clips[0].scalars[0], &other = scene.clips[0].scalars[1];
  EXPECT_EQ(smile.name, "face.smile");
  EXPECT_EQ(other.name, "face.weights[1]");
  EXPECT_EQ(smile.rest, 0.25F);
  EXPECT_EQ(other.rest, 0.5F);
  EXPECT_EQ(smile.interpolation, RawInterpolation::step);
  EXPECT_EQ(smile.times_s, (std::vector<float>{0, 1, 3}));
  EXPECT_EQ(smile.values, (std::vector<float>{0, 2, 4}));
  EXPECT_EQ(other.values, (std::vector<float>{1, 3, 5}));
}

TEST(GltfNumbers, TheNodesWeightsComeFirstAndANodeMayHaveNoName) {
  Builder b = morphing();
  b.root["meshes"][0]["weights"] = {0.25, 0.5};
  b.root["nodes"][0]["weights"] = {0.75, 1};
  // 255 is 1, 51 is 0.2: normalised bytes.
  b.channel(b.times({0}), b.numbers<std::uint8_t>(kU8, "SCALAR", 1, {255, 51}, {{"normalized", true}}), "weights");
  const RawScene scene = read(b);
  ASSERT_EQ(scene.clips.size(), 1U);
  ASSERT_EQ(scene.clips[0].scalars.size(), 2U);
  EXPECT_EQ(scene.clips[0].scalars[0].name, "nodes[0].weights[0]");
  EXPECT_EQ(scene.clips[0].scalars[0].rest, 0.75F);
  EXPECT_EQ(scene.clips[0].scalars[1].rest, 1);
  EXPECT_EQ(scene.clips[0].scalars[0].values, (std::vector<float>{1}));
  EXPECT_FLOAT_EQ(scene.clips[0].scalars[1].values[0], 0.2F);
}

// A key of a spline: in-tangents of all targets, values of all, out-tangents of all.
TEST(GltfNumbers, SplinesOfWeights) {
  Builder b = morphing();
  b.channel(b.times({0, 1}), b.numbers<float>(kF32, "SCALAR", 1, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}), "weights",
            "CUBICSPLINE");
  const RawScene scene = read(b);
  ASSERT_EQ(scene.clips.size(), 1U);
  ASSERT_EQ(scene.clips[0].scalars.size(), 2U);
  EXPECT_EQ(scene.clips[0].scalars[0].values, (std::vector<float>{1, 3, 5, 7, 9, 11}));
  EXPECT_EQ(scene.clips[0].scalars[1].values, (std::vector<float>{2, 4, 6, 8, 10, 12}));
}

Json pointer_channel(int sampler, const char* to) {
  return {{"sampler", sampler},
          {"target", {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", to}}}}}}}};
}

// A document of numbers in extras, one animation whose only sampler drives `pointers`.
Builder pointing(const std::vector<const char*>& pointers) {
  Builder b;
  b.primitive({{"POSITION", b.curve(3)}});
  b.root["extensionsUsed"] = {"KHR_animation_pointer"};
  b.root["extras"] = {{"wind", 3}};
  b.root["asset"]["extras"] = {{"mood", 2}};
  b.root["nodes"][0].update(
      {{"name", "hero"},
       {"translation", {1, 2, 3}},
       {"extras",
        {{"health", 0.5}, {"a/b~c", 4}, {"list", {7, {{"deep", 8}}}}, {"text", "x"}, {"on", true}, {"huge", 1e300}}}});
  b.root["scenes"][0]["extras"] = {{"fog", 0.125}};
  b.root["animations"] = {
      {{"samplers", {{{"input", b.times({0, 2})}, {"output", b.numbers<float>(kF32, "SCALAR", 1, {1, 5})}}}},
       {"channels", Json::array()}}};
  for (const char* to : pointers) b.root["animations"][0]["channels"].push_back(pointer_channel(0, to));
  return b;
}

TEST(GltfNumbers, PointersToNumbersInExtras) {
  const struct {
    const char *pointer, *name;
    float rest;
  } cases[] = {{"/nodes/0/extras/health", "hero.health", 0.5F},
               {"/nodes/0/extras/a~1b~0c", "hero.a/b~c", 4},
               {"/nodes/0/extras/list/0", "hero.list[0]", 7},
               {"/nodes/0/extras/list/1/deep", "hero.list[1].deep", 8},
               {"/scenes/0/extras/fog", "scenes[0].fog", 0.125F},
               {"/asset/extras/mood", "mood", 2},
               {"/extras/wind", "wind", 3}};
  std::vector<const char*> pointers;
  for (const auto& c : cases) pointers.push_back(c.pointer);
  Builder b = pointing(pointers);
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.warnings.empty());
  ASSERT_EQ(scene.clips.size(), 1U);
  ASSERT_EQ(scene.clips[0].scalars.size(), 7U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(scene.clips[0].scalars[i].name, cases[i].name);
    EXPECT_EQ(scene.clips[0].scalars[i].rest, cases[i].rest);
    EXPECT_EQ(scene.clips[0].scalars[i].times_s, (std::vector<float>{0, 2}));
    EXPECT_EQ(scene.clips[0].scalars[i].values, (std::vector<float>{1, 5}));
  }
}

TEST(GltfNumbers, OtherPointersAreLeftOutAndSaid) {
  const std::vector<const char*> pointers = {"",
                                             "nodes/0/extras/health",
                                             "/",
                                             "/nodes/1/translation",
                                             "/nodes/00/translation",
                                             "/nodes/0/mesh",
                                             "/nodes/0/weights/0",
                                             "/nodes/0/translation/0",
                                             "/meshes/0/weights",
                                             "/nodes/0/extras",
                                             "/nodes/0/extras/none",
                                             "/nodes/0/extras/text",
                                             "/nodes/0/extras/on",
                                             "/nodes/0/extras/huge",
                                             "/nodes/0/extras/list",
                                             "/nodes/0/extras/list/2",
                                             "/nodes/0/extras/list/00",
                                             "/nodes/0/extras/list/-1",
                                             "/nodes/0/extras/list/99999999999999999999999",
                                             "/nodes/0/extras/health/x",
                                             "/nodes/0/extras/a~2b",
                                             "/nodes/0/extras/a~",
                                             "/nodes/1/extras/health",
                                             "/nodes/x/extras/health",
                                             "/asset/version/extras/x",
                                             "/animations/0/extras/x"};
  std::size_t dropped = 0;
  for (const char* to : pointers) {
    Builder b = pointing({to});
    const RawScene scene = read(b);
    dropped += warns(scene, "channel-dropped", "/animations/0/channels/0/target/path") && scene.clips.empty();
  }
  EXPECT_EQ(dropped, pointers.size());
}

// What KHR_animation_pointer says of a node, and what glTF 2.0 says itself, are the same clip.
TEST(GltfPointers, NodesMayBePointedAt) {
  const auto document = [](bool by_pointer) {
    Builder b = skinned();
    Json& primitive = b.root["meshes"][0]["primitives"][0];
    const int change = b.positions({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive["targets"] = {{{"POSITION", change}}};
    const int times = b.times({0, 1});
    b.channel(times, b.numbers<float>(kF32, "VEC3", 3, {0, 1, 0, 0, 2, 0}), "translation", "LINEAR", 2);
    b.channel(times, b.numbers<float>(kF32, "VEC3", 3, {1, 1, 1, 2, 2, 2}), "scale", "LINEAR", 1);
    b.channel(times, b.numbers<float>(kF32, "SCALAR", 1, {0, 0.5F}), "weights", "LINEAR", 0);
    if (by_pointer) {
      b.root["extensionsUsed"] = {"KHR_animation_pointer"};
      for (Json& channel : b.root["animations"][0]["channels"]) {
        const std::string to =
            "/nodes/" + channel["target"]["node"].dump() + '/' + channel["target"]["path"].get<std::string>();
        channel["target"] = {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", to}}}}}};
      }
    }
    return b;
  };
  Builder plain = document(false), pointing = document(true);
  const RawScene expected = read(plain), scene = read(pointing);
  EXPECT_TRUE(scene.warnings.empty());
  ASSERT_EQ(scene.clips.size(), 1U);
  ASSERT_EQ(scene.clips[0].channels.size(), 3U);
  ASSERT_EQ(scene.clips[0].scalars.size(), 1U);
  for (std::size_t c = 0; c < 3; ++c) {
    const RawChannel &ours = scene.clips[0].channels[c], &theirs = expected.clips[0].channels[c];
    EXPECT_EQ(ours.node, theirs.node);
    EXPECT_EQ(ours.path, theirs.path);
    EXPECT_EQ(ours.times_s, theirs.times_s);
    EXPECT_EQ(ours.values, theirs.values);
  }
  EXPECT_EQ(scene.clips[0].scalars[0].name, expected.clips[0].scalars[0].name);
  EXPECT_EQ(scene.clips[0].scalars[0].values, (std::vector<float>{0, 0.5F}));
  // A property is driven once, whoever says so.
  Builder twice = document(true), otherwise = document(true);
  otherwise.channel(5, 6, "rotation", "STEP", 2);
  expect_refused(otherwise.text(), Exit::invalid, "/animations/0/channels/4/target", "animated twice");
  // The same again says nothing else.
  twice.channel(5, 6, "rotation", "LINEAR", 2);
  const RawScene again = read(twice);
  EXPECT_TRUE(warns(again, "channel-twice", "/animations/0/channels/4/target"));
  EXPECT_EQ(again.clips.at(0).channels.size(), 3U);
}

TEST(GltfNumbers, MistakesAreRefused) {
  Builder twice = pointing({"/extras/wind", "/extras/wind"});
  EXPECT_EQ(read(twice).clips.at(0).scalars.size(), 1U);
  EXPECT_TRUE(warns(read(twice), "channel-twice", "/animations/0/channels/1/target"));
  Json& animation = twice.root["animations"][0];
  animation["samplers"].push_back(animation["samplers"][0]);
  animation["samplers"][1]["interpolation"] = "STEP";
  animation["channels"][1]["sampler"] = 1;
  expect_refused(twice.text(), Exit::invalid, "/animations/0/channels/1/target", "animated twice");
  Builder vectors = pointing({"/extras/wind"});
  vectors.root["animations"][0]["samplers"][0]["output"] = vectors.numbers<float>(kF32, "VEC3", 3, {1, 2, 3, 4, 5, 6});
  expect_refused(vectors.text(), Exit::invalid, "/animations/0/channels/0/sampler", "wrong output accessor");
  Builder fewer = pointing({"/extras/wind"});
  fewer.root["animations"][0]["samplers"][0]["output"] = fewer.numbers<float>(kF32, "SCALAR", 1, {1});
  expect_refused(fewer.text(), Exit::invalid, "/animations/0/channels/0/sampler", "differ in count");
  Builder no_pointer = pointing({"/extras/wind"});
  no_pointer.root["animations"][0]["channels"][0]["target"]["extensions"]["KHR_animation_pointer"] = Json::object();
  expect_refused(no_pointer.text(), Exit::invalid,
                 "/animations/0/channels/0/target/extensions/KHR_animation_pointer/pointer", "missing");
  Builder number = pointing({"/extras/wind"});
  number.root["animations"][0]["channels"][0]["target"]["extensions"]["KHR_animation_pointer"]["pointer"] = 7;
  expect_refused(number.text(), Exit::invalid,
                 "/animations/0/channels/0/target/extensions/KHR_animation_pointer/pointer", "wrong type");
  Builder no_sampler = pointing({"/extras/wind"});
  no_sampler.root["animations"][0]["channels"][0]["sampler"] = 9;
  expect_refused(no_sampler.text(), Exit::invalid, "/animations/0/channels/0/sampler", "reference to nothing");
}

}  // namespace
}  // namespace marrow::cook
