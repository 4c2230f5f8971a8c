// Examples that an artist gives: which poses and places they yield, what a fit makes of them, and what is refused.
#include "cook/learn/examples.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/failure.h"
#include "cook/clip/build_clips.h"
#include "cook/gltf/read.h"
#include "cook/skeleton/build_skeletons.h"
#include "disk/cook_on_disk.h"
#include "support/places.h"
#include "unit/cook/gltf/document.h"

namespace marrow::cook {
namespace {

const std::string kElbow = test::in_golden("elbow.gltf");
constexpr float kStep_s = 0.25f;  // between its keys
constexpr double kBulge_m = 0.1;

// A file that is gone with the object.
class ExampleFile {
 public:
  explicit ExampleFile(const Json& document) : path(::testing::TempDir() + "marrow_examples_test.gltf") {
    std::ofstream(path) << document.dump();
  }
  ExampleFile(const ExampleFile&) = delete;
  ExampleFile& operator=(const ExampleFile&) = delete;
  ~ExampleFile() { std::filesystem::remove(path); }

  const std::string path;
};

Json elbow() {
  return Json::parse(std::ifstream(kElbow));
}

int add_floats(Json& document, const char* type, std::size_t components, const std::vector<float>& values) {
  const std::string uri =
      "data:application/octet-stream;base64," + base64(std::as_bytes(std::span(values.data(), values.size())));
  document["buffers"].push_back({{"byteLength", values.size() * 4}, {"uri", uri}});
  document["bufferViews"].push_back({{"buffer", document["buffers"].size() - 1}, {"byteLength", values.size() * 4}});
  Json accessor = {{"bufferView", document["bufferViews"].size() - 1},
                   {"componentType", kF32},
                   {"type", type},
                   {"count", values.size() / components}};
  for (std::size_t c = 0; c < components; ++c) {
    float low = values[c], high = values[c];
    for (std::size_t i = c; i < values.size(); i += components) {
      low = std::min(low, values[i]);
      high = std::max(high, values[i]);
    }
    accessor["min"].push_back(low);
    accessor["max"].push_back(high);
  }
  document["accessors"].push_back(accessor);
  return static_cast<int>(document["accessors"].size()) - 1;
}

// How far the elbow is bent at each key, in half turns.
std::vector<float> bends() {
  const RawScene scene = read_gltf(kElbow);
  std::vector<float> out;
  for (const glm::vec4& q : scene.clips.at(0).channels.at(0).values)
    out.push_back(2 * std::acos(std::min(1.0f, std::abs(q.w))) / 3.14159265f);
  return out;
}

// The elbow with a corrective shape that moves all vertices by kBulge_m along z, the more the more it is bent.
Json bulging_elbow() {
  Json out = elbow();
  std::vector<float> shape;
  for (int v = 0; v < 28; ++v) shape.insert(shape.end(), {0, 0, static_cast<float>(kBulge_m)});
  out["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", add_floats(out, "VEC3", 3, shape)}}};
  const int weights = add_floats(out, "SCALAR", 1, bends());
  out["animations"][0]["samplers"].push_back({{"input", 5}, {"output", weights}});
  out["animations"][0]["channels"].push_back({{"sampler", 1}, {"target", {{"node", 2}, {"path", "weights"}}}});
  return out;
}

// The elbow, ready for examples.
struct Character {
  Character() : scene(read_gltf(kElbow)) {
    Notes notes;
    built = build_skeletons(scene);
    built.clips = build_raw_clips(scene, built, {});
    source = deform_source(scene.meshes[0], scene.skins[0], bind_to_skin(scene.meshes[0], notes), built);
  }
  std::vector<ShownPose> read(const Json& document) const {
    const ExampleFile file(document);
    return read_examples(read_gltf(file.path), {scene, scene.meshes[0], scene.skins[0], built, source});
  }
  RawScene scene;
  BuiltScene built;
  DeformSource source;
};

TEST(Examples, CorrectiveShapesCountBeforeSkinning) {
  const Character character;
  const std::vector<ShownPose> shown = character.read(bulging_elbow());
  ASSERT_GT(shown.size(), 80u);
  const std::vector<float> keys = bends();
  const std::vector<double> bent(keys.begin(), keys.end());
  for (const ShownPose& e : shown) {
    EXPECT_EQ(e.clip_name, "bend");
    // Joint 0 stands still; by glTF 2.0 section 3.7.3.3 a vertex is Σ w M (v + target).
    EXPECT_EQ(e.pose[0], deform::Matrix(1.0));
    const double at = e.time_s / static_cast<double>(kStep_s);
    const auto key = std::min(static_cast<std::size_t>(at), bent.size() - 2);
    const double part = at - static_cast<double>(key), weight = bent[key] * (1 - part) + bent[key + 1] * part;
    const glm::dvec3 bulge(0, 0, kBulge_m * weight);
    for (std::size_t v = 0; v < e.positions.size(); ++v) {
      glm::dvec3 want(0);
      for (const deform::Influence& i : character.source.mesh.influences[v])
        want += deform::transform(e.pose[i.joint], character.source.mesh.positions[v] + bulge) * i.weight;
      ASSERT_LT(glm::length(e.positions[v] - want), 1e-6) << e.time_s;
    }
  }
  EXPECT_NE(shown[40].pose[1], shown.front().pose[1]);
}

TEST(Examples, APosedMeshIsTakenWhereItStands) {
  const Character character;
  Json document = elbow();
  document.erase("animations");
  document.erase("skins");
  Json& node = document["nodes"][2];
  node.erase("skin");
  node["translation"] = {0, 0, 3};
  node["extras"] = {{"marrow.clip", "bend"}, {"marrow.time", 1.25}};
  const std::vector<ShownPose> shown = character.read(document);
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].time_s, 1.25);
  for (std::size_t v = 0; v < shown[0].positions.size(); ++v)
    EXPECT_LT(glm::length(shown[0].positions[v] - character.source.mesh.positions[v] - glm::dvec3(0, 0, 3)), 1e-12);
  EXPECT_NE(shown[0].pose[1], deform::Matrix(1.0));
}

TEST(Examples, AreFollowed) {
  const ExampleFile file(bulging_elbow());
  CookOptions options;
  options.learn.animation_space = AnimationSpace::fit;
  options.learn.truth = Truth::examples;
  options.learn.examples_file = file.path;
  const Result cooked = cook_file(kElbow, options);
  const auto& learnt = cooked.report["meshes"][0]["animation_space"];
  EXPECT_EQ(learnt["kind"], "fit");
  EXPECT_EQ(learnt["truth"], "examples");
  EXPECT_EQ(learnt["made_up_poses"], 0);
  EXPECT_GT(learnt["poses"], 80);
  // The bulge grows as the elbow bends, so a linear model can follow it well.
  EXPECT_LT(learnt["held_out_share"], 0.6);
  // A cache and a depfile must know of it.
  ASSERT_EQ(cooked.reads.size(), 2u);
  EXPECT_NE(cooked.reads[1].name.find("marrow_examples_test.gltf"), std::string::npos);
}

TEST(Examples, WhatIsWrongIsNamed) {
  const Character character;
  const auto refusal = [&](const Json& document) -> std::string {
    try {
      (void)character.read(document);
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), Exit::invalid);
      return failure.where() + " " + failure.rule();
    }
    return "none";
  };
  Json few = elbow();
  few["accessors"][0]["count"] = few["accessors"][1]["count"] = few["accessors"][2]["count"] = 27;
  few["meshes"][0]["primitives"][0].erase("indices");
  EXPECT_EQ(refusal(few), "/meshes/0/primitives/0 other-vertices");
  Json strange = elbow();
  strange["nodes"][1]["name"] = "forearm";
  EXPECT_EQ(refusal(strange), "/skins no-such-joint");
  Json still = elbow();
  still.erase("animations");
  EXPECT_EQ(refusal(still), "/animations no-example");
  Json posed = still;
  posed.erase("skins");
  posed["nodes"][2].erase("skin");
  EXPECT_EQ(refusal(posed), "/nodes no-example");
  posed["nodes"][2]["extras"] = {{"marrow.clip", "bend"}};
  EXPECT_EQ(refusal(posed), "/nodes/2/extras half-a-moment");
  posed["nodes"][2]["extras"]["marrow.time"] = 2.8;
  EXPECT_EQ(refusal(posed), "/nodes/2/extras no-such-time");
  posed["nodes"][2]["extras"] = {{"marrow.clip", "wave"}, {"marrow.time", 1}};
  EXPECT_EQ(refusal(posed), "/nodes/2/extras no-such-clip");
}

// What is shown of a pose says nothing of another.
TEST(Examples, NothingIsKnownOfOtherPoses) {
  const Character character;
  const std::vector<ShownPose> shown = character.read(bulging_elbow());
  const deform::Deformer truth = as_shown(character.source.mesh, shown);
  deform::Positions out;
  truth(shown[7].pose, out);
  EXPECT_EQ(out, shown[7].positions);
  truth({deform::Matrix(1.0), deform::Matrix(1.0)}, out);
  EXPECT_EQ(out, character.source.mesh.positions);
  truth({deform::Matrix(1.0), deform::Matrix(2.0)}, out);
  ASSERT_EQ(out.size(), character.source.mesh.positions.size());
  EXPECT_TRUE(std::isnan(out[0].x));
}

}  // namespace
}  // namespace marrow::cook
