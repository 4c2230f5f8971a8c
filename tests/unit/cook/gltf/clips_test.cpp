// Reading glTF: animations of joints and of numbers.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/cook/gltf/gltf_text.h"

namespace marrow::cook {
namespace {

// A clip of one channel of node 0.
std::string clip(const std::string& path, const std::string& times, const std::string& values,
                 const std::string& interpolation = "LINEAR") {
  return fmt::format(R"("/animations": [{{"channels": [{{"sampler": 0, "target": {{"node": 0, "path": "{}"}}}}],
                         "samplers": [{{"input": "=f32x1 {}", "output": "={}", "interpolation": "{}"}}]}}])",
                     path, times, values, interpolation);
}

TEST(GltfClips, KeysAsTheyStandAndAsTheyAreMended) {
  expect_rows("",
              {{"cubic splines keep their tangents: in-tangent, value, out-tangent",
                clip("translation", "0.5 2", "f32x3 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18", "CUBICSPLINE"),
                R"("clips/0/channels/0": {"interpolation": "cubic", "path": "translation", "times_s": [0.5, 2]},
                       "clips/0/channels/0/values/#": 6, "clips/0/channels/0/values/1": [4, 5, 6, 0],
                       "clips/0/channels/0/values/5": [16, 17, 18, 0])"},
               {"tangents of quaternions are not normalised",
                clip("rotation", "0 1", "f32x4 9 0 0 0 0 0 0 1 5 0 0 0 3 0 0 0 1 0 0 0 7 0 0 0", "CUBICSPLINE"),
                R"("warns only": [], "clips/0/channels/0/values/2": [5, 0, 0, 0])"},
               {"steps are kept", clip("scale", "0 1", "f32x3 1 1 1 2 2 2", "STEP"),
                R"("clips/0/channels/0/interpolation": "step")"},
               {"odd rotations are normalised", clip("rotation", "0 1", "f32x4 0 0 0 2 0 0 0 0"),
                R"("clips/0/channels/0/values": [[0, 0, 0, 1], [0, 0, 0, 1]], "warns": ["rotation-keys-not-unit"])"}});
}

// Just before another moment.
std::string before(float time_s) {
  return fmt::format("{:.9g}", std::nextafter(time_s, 0.0F));
}

TEST(GltfClips, KeysThatCannotBePlayedAreDropped) {
  const std::string input = " /animations/0/samplers/0/input\"";
  expect_rows(
      "", {{"nobody sees before 0, and of a jump where it ends before it",
            clip("translation", "0 1e-45 1 1 2 9e30", "f32x3 0 0 0 1 0 0 2 0 0 3 0 0 4 0 0 5 0 0"),
            R"("clips/0/channels/0/times_s": [0, )" + before(1) + R"(, 1, 2],
           "clips/0/channels/0/values": [[1, 0, 0, 0], [2, 0, 0, 0], [3, 0, 0, 0], [4, 0, 0, 0]], "warns":
           ["keys-at-one-time)" +
                input + R"(, "keys-too-close)" + input + R"(, "keys-too-late)" + input + "]"},
           {"of several at one time the first and the last count; near each other, they stay; key 3 lies between",
            clip("translation", "0.5 0.5 1 1 1 " + before(2) + " 2", "f32x3 0 0 0 1 0 0 2 0 0 3 0 0 4 0 0 5 0 0 6 0 0",
                 "STEP"),
            R"("clips/0/channels/0/times_s": [)" + before(0.5F) + ", 0.5, " + before(1) + ", 1, " + before(2) + R"(, 2],
           "clips/0/channels/0/values": [[0,0,0,0], [1,0,0,0], [2,0,0,0], [4,0,0,0], [5,0,0,0], [6,0,0,0]],
           "warns": ["keys-too-close"])"}});
}

TEST(GltfClips, WhatMovesNothingIsLeftOut) {
  const std::string nothing = clip("pointer", "0 1", "f32x3 0 0 0 1 0 0");
  expect_rows(kTriangle, {{"alone", nothing,
                           R"("clips": [], "warns": ["channel-dropped /animations/0/channels/0/target/path",
                                                     "clip-dropped /animations/0"])"},
                          {"beside what moves", nothing + R"(, "/animations/0/channels/1": {"sampler": 0,
                                                               "target": {"node": 0, "path": "translation"}})",
                           R"("clips/#": 1, "clips/0/channels/#": 1)"}});
}

TEST(GltfNumbers, WeightsOfMorphTargets) {
  const std::string two = R"("/P/targets": [{"POSITION": 0}, {"POSITION": 0}], )";
  expect_rows(
      kTriangle,
      {{"are a number each",
        two +
            R"("/nodes/0/name": "face", "/meshes/0/weights": [0.25, 0.5], "/meshes/0/extras": {"targetNames": ["smile"]}, )" +
            clip("weights", "0 1 3", "f32x1 0 1 2 3 4 5", "STEP"),
        R"("clips/#": 1, "clips/0/channels": [], "clips/0/scalars/#": 2,
           "clips/0/scalars/0": {"name": "face.smile", "rest": 0.25, "interpolation": "step", "times_s": [0, 1, 3],
                                 "values": [0, 2, 4]},
           "clips/0/scalars/1": {"name": "face.weights[1]", "rest": 0.5, "values": [1, 3, 5]})"},
       {"the node's come first, and a node may have no name; normalised bytes: 255 is 1, 51 is 0.2",
        two + R"("/meshes/0/weights": [0.25, 0.5], "/nodes/0/weights": [0.75, 1], )" +
            clip("weights", "0", "u8x1n 255 51"),
        R"("clips/#": 1, "clips/0/scalars/#": 2, "clips/0/scalars/0":
           {"name": "nodes[0].weights[0]", "rest": 0.75, "values": [1]}, "clips/0/scalars/1": {"rest": 1},
           "clips/0/scalars/1/values ~1e-7": [0.2])"},
       {"a key of a spline: in-tangents of all targets, values of all, out-tangents of all",
        two + clip("weights", "0 1", "f32x1 1 2 3 4 5 6 7 8 9 10 11 12", "CUBICSPLINE"),
        R"("clips/#": 1, "clips/0/scalars/#": 2, "clips/0/scalars/0/values": [1, 3, 5, 7, 9, 11],
           "clips/0/scalars/1/values": [2, 4, 6, 8, 10, 12])"}});
}

std::string channel_to(const std::string& pointer) {
  return R"({"sampler": 0, "target": {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": ")" +
         pointer + R"("}}}})";
}

// A document of numbers in extras, one animation whose only sampler drives `pointers`.
Builder pointing(const std::vector<std::string>& pointers) {
  std::string channels;
  for (const std::string& to : pointers) channels += (channels.empty() ? "" : ", ") + channel_to(to);
  return changed(document_of(kTriangle), R"("/extensionsUsed": ["KHR_animation_pointer"], "/extras": {"wind": 3},
    "/asset/extras": {"mood": 2}, "/scenes/0/extras": {"fog": 0.125}, "/nodes/0/name": "hero",
    "/nodes/0/translation": [1, 2, 3], "/nodes/0/extras": {"health": 0.5, "a/b~c": 4, "list": [7, {"deep": 8}],
      "text": "x", "on": true, "huge": 1e300},
    "/animations": [{"samplers": [{"input": "=f32x1 0 2", "output": "=f32x1 1 5"}], "channels": [)" +
                                             channels + "]}]");
}

TEST(GltfNumbers, PointersToNumbersInExtras) {
  expect_rows(pointing({"/nodes/0/extras/health", "/nodes/0/extras/a~1b~0c", "/nodes/0/extras/list/0",
                        "/nodes/0/extras/list/1/deep", "/scenes/0/extras/fog", "/asset/extras/mood", "/extras/wind"}),
              {{"all", "", R"("warns only": [], "clips/#": 1, "clips/0/scalars": [
                  {"name": "hero.health", "rest": 0.5, "times_s": [0, 2], "values": [1, 5]},
                  {"name": "hero.a/b~c", "rest": 4, "times_s": [0, 2], "values": [1, 5]},
                  {"name": "hero.list[0]", "rest": 7, "times_s": [0, 2], "values": [1, 5]},
                  {"name": "hero.list[1].deep", "rest": 8, "times_s": [0, 2], "values": [1, 5]},
                  {"name": "scenes[0].fog", "rest": 0.125, "times_s": [0, 2], "values": [1, 5]},
                  {"name": "mood", "rest": 2, "times_s": [0, 2], "values": [1, 5]},
                  {"name": "wind", "rest": 3, "times_s": [0, 2], "values": [1, 5]}])"}});
}

TEST(GltfNumbers, OtherPointersAreLeftOutAndSaid) {
  for (const char* to : {"",
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
                         "/animations/0/extras/x"})
    expect_rows(pointing({to}),
                {{to, "", R"("clips": [], "warns": ["channel-dropped /animations/0/channels/0/target/path"])"}});
}

// What KHR_animation_pointer says of a node, and what glTF 2.0 says itself, are the same clip.
TEST(GltfPointers, NodesMayBePointedAt) {
  Builder plain = changed(skinned(), R"("/P/targets": [{"POSITION": "=f32x3 0 0 1 0 0 1 0 0 1 0 0 1"}],
    "/animations/0/samplers": [{"input": 5, "output": 6}, {"input": 5, "output": "=f32x3 0 1 0 0 2 0"},
      {"input": 5, "output": "=f32x3 1 1 1 2 2 2"}, {"input": 5, "output": "=f32x1 0 0.5"}, {"input": 5, "output": 6,
      "interpolation": "STEP"}],
    "/animations/0/channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}},
      {"sampler": 1, "target": {"node": 2, "path": "translation"}},
      {"sampler": 2, "target": {"node": 1, "path": "scale"}}, {"sampler": 3, "target": {"node": 0, "path": "weights"}}])");
  std::string change = R"("/extensionsUsed": ["KHR_animation_pointer"])";
  std::size_t c = 0;
  for (const char* to : {"/nodes/2/rotation", "/nodes/2/translation", "/nodes/1/scale", "/nodes/0/weights"}) {
    change += fmt::format(R"(, "/animations/0/channels/{0}": {1}, "/animations/0/channels/{0}/sampler": {0})", c,
                          channel_to(to));
    ++c;
  }
  const Json clips = facts_of(read(plain))["clips"];
  ASSERT_EQ(clips[0]["channels"].size(), 3U);
  const std::string more = R"(, "/animations/0/channels/4": {"sampler": 0, "target": {"node": 2, "path": "rotation"}})";
  expect_rows(plain, {{"the same clip", change, R"("warns only": [], "clips": )" + clips.dump() + R"(, "clips/#": 1,
                  "clips/0/channels/#": 3, "clips/0/scalars/#": 1, "clips/0/scalars/0/values": [0, 0.5])"},
                      {"a property is driven once, whoever says so",
                       change + more + R"(, "/animations/0/channels/4/sampler": 4)",
                       "invalid /animations/0/channels/4/target: animated twice"},
                      {"the same again says nothing else", change + more,
                       R"("clips/0/channels/#": 3, "warns": ["channel-twice /animations/0/channels/4/target"])"}});
}

TEST(GltfNumbers, MistakesAreRefused) {
  expect_rows(
      pointing({"/extras/wind", "/extras/wind"}),
      {{"the same twice", "", R"("clips/0/scalars/#": 1, "warns": ["channel-twice /animations/0/channels/1/target"])"},
       {"twice, otherwise", R"("/animations/0/samplers/1": "@/animations/0/samplers/0",
                   "/animations/0/samplers/1/interpolation": "STEP", "/animations/0/channels/1/sampler": 1)",
        "invalid /animations/0/channels/1/target: animated twice"}});
  const std::string target = "/animations/0/channels/0/target/extensions/KHR_animation_pointer";
  const std::string sampler = "invalid /animations/0/channels/0/sampler: ";
  expect_rows(
      pointing({"/extras/wind"}),
      {{"vectors", R"("/animations/0/samplers/0/output": "=f32x3 1 2 3 4 5 6")", sampler + "wrong output accessor"},
       {"fewer", R"("/animations/0/samplers/0/output": "=f32x1 1")", sampler + "differ in count"},
       {"no pointer", '"' + target + R"(": {})", "invalid " + target + "/pointer: missing"},
       {"a number", '"' + target + R"(/pointer": 7)", "invalid " + target + "/pointer: wrong type"},
       {"no sampler", R"("/animations/0/channels/0/sampler": 9)", sampler + "reference to nothing"}});
}

}  // namespace
}  // namespace marrow::cook
