// --auto-skeleton: templates as text, what becomes of the file's own skeleton, and the built-in templates in bodies of
// capsules.
#include "cook/prepare/add_skeleton.h"

#include <filesystem>
#include <fstream>
#include <map>

#include <unistd.h>

#include <glm/geometric.hpp>

#include "cook/options/options.h"
#include "cook/prepare/bind_bones.h"
#include "cook/read_inputs.h"
#include "cook/retarget/plan/pair_rigs.h"
#include "cook/rig/read_template.h"
#include "deform/weights/auto_weights.h"
#include "disk/cook_on_disk.h"
#include "disk/disk_files.h"
#include "unit/cook/options_text.h"
#include "unit/cook/scene_document.h"
#include "unit/deform/bodies.h"

namespace marrow::cook {
namespace {

namespace fs = std::filesystem;
using test::Body;

// weighted: all of it on the first joint of a skin.
int add_mesh(Builder& b, const Body& body, bool weighted = false) {
  std::vector<float> positions;
  for (const glm::dvec3& p : body.positions)
    for (int i = 0; i < 3; ++i) positions.push_back(static_cast<float>(p[i]));
  Json attributes = {{"POSITION", b.positions(positions)}};
  if (weighted) {
    std::vector<float> weights;
    for (std::size_t v = 0; v < body.positions.size(); ++v) weights.insert(weights.end(), {1, 0, 0, 0});
    attributes["JOINTS_0"] =
        b.numbers<std::uint8_t>(kU8, "VEC4", 4, std::vector<std::uint8_t>(4 * body.positions.size(), 0));
    attributes["WEIGHTS_0"] = b.numbers<float>(kF32, "VEC4", 4, weights);
  }
  const int indices = b.numbers<std::uint16_t>(kU16, "SCALAR", 1, {body.indices.begin(), body.indices.end()});
  b.root["meshes"].push_back({{"name", "body"}, {"primitives", {{{"attributes", attributes}, {"indices", indices}}}}});
  return static_cast<int>(b.root["meshes"].size()) - 1;
}

SceneDocument document(const Body& body) {
  SceneDocument d;
  const auto at = static_cast<std::size_t>(d.node("body"));
  d.b.root["nodes"][at]["mesh"] = add_mesh(d.b, body);
  return d;
}

std::map<std::string, glm::dvec3> places_of(const RiggedScene& rigged) {
  const std::vector<glm::dmat4> rest = rest_of_nodes(rigged.scene);
  std::map<std::string, glm::dvec3> out;
  for (const int joint : rigged.made.joints)
    out[rigged.scene.nodes[to_index(joint)].name] = glm::dvec3(rest[to_index(joint)][3]);
  return out;
}

// Each joint that the body has within `worst` of where it is, on average within `mean`; shares of the height.
void expect_joints(const Body& body, const RiggedScene& rigged, double height, double mean, double worst) {
  const std::map<std::string, glm::dvec3> places = places_of(rigged);
  double sum = 0, count = 0;
  for (const auto& [name, place] : body.joints) {
    ASSERT_TRUE(places.contains(name)) << name;
    const double off = glm::length(places.at(name) - place) / height;
    EXPECT_LT(off, worst) << name;
    sum += off;
    ++count;
  }
  EXPECT_LT(sum / count, mean);
  ::testing::Test::RecordProperty("mean", std::to_string(sum / count));
}

RiggedScene rig(RawScene scene, const std::string& name) {
  Notes notes;
  RiggedScene out = add_skeleton(std::move(scene), name, parse_template(name, builtin_template(name)), notes);
  out.scene.warnings = notes.warnings;
  return out;
}

TEST(AddSkeleton, AHumanoidOfCapsules) {
  const Body body = test::humanoid_body();
  const RiggedScene rigged = rig(document(body).read(), "humanoid");
  EXPECT_EQ(rigged.made.joints.size(), 22U);
  EXPECT_TRUE(warns(rigged.scene, "skeleton-made"));
  EXPECT_FALSE(warns(rigged.scene, "skeleton-replaced"));
  expect_joints(body, rigged, 2, 0.045, 0.09);
}

TEST(AddSkeleton, AQuadrupedOfCapsules) {
  const Body body = test::quadruped_body();
  expect_joints(body, rig(document(body).read(), "quadruped"), 1, 0.06, 0.12);
}

// Half as big, elsewhere, and drawn by a node.
TEST(AddSkeleton, WhereANodeDrawsTheMesh) {
  Body body = test::humanoid_body();
  SceneDocument d = document(body);
  d.b.root["nodes"][0]["translation"] = {10, 3, -4};
  d.b.root["nodes"][0]["scale"] = {0.5, 0.5, 0.5};
  for (auto& [name, place] : body.joints) place = place * 0.5 + glm::dvec3(10, 3, -4);
  expect_joints(body, rig(d.read(), "humanoid"), 1, 0.045, 0.09);
}

CookOptions making(const std::string& name) {
  return cook::options_of("--mesh-codec none --auto-skeleton " + name);
}

TEST(AddSkeleton, TakesTheFilesPlace) {
  SceneDocument d;
  const int root = d.node("old root"), tip = d.node("old tip", root, {0, 1, 0});
  const auto at = static_cast<std::size_t>(d.node("body"));
  d.b.root["nodes"][at].update({{"mesh", add_mesh(d.b, test::humanoid_body(), true)}, {"skin", 0}});
  d.b.root["skins"].push_back({{"joints", {root, tip}}});
  d.clip("walk");
  d.turn(tip, {0, 1});
  const Result cooked = cook_scene(d.read(), making("humanoid"));
  const auto has = [&](const std::string& rule) {
    return std::ranges::any_of(cooked.report["warnings"], [&](const auto& w) { return w["rule"] == rule; });
  };
  EXPECT_TRUE(has("skeleton-replaced"));
  EXPECT_TRUE(has("clips-dropped"));
  EXPECT_TRUE(has("skeleton-made"));
  EXPECT_TRUE(has("weights-made"));
  EXPECT_EQ(cooked.report["clips"].size(), 0U);
  ASSERT_EQ(cooked.report["skeletons"].size(), 1U);
  EXPECT_EQ(cooked.report["skeletons"][0]["joints"], 22);
}

// A hand's vertices follow the hand, and a foot's the foot, all the way from the command's options.
TEST(AddSkeleton, BindsWhatItMade) {
  const Body body = test::humanoid_body();
  RiggedScene rigged = rig(document(body).read(), "humanoid");
  Notes notes;
  WeightOptions options;
  options.make = deform::WeightMethod::geodesic;
  const RawScene scene = bind_to(rigged.made, rigged.scene, options, notes);
  ASSERT_EQ(scene.skins.size(), 1U);
  const RawPrimitive& primitive = scene.meshes[0].primitives[0];
  ASSERT_EQ(primitive.influences.size(), primitive.positions.size());
  int checked = 0;
  for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
    const glm::vec3& p = primitive.positions[v];
    if (p.x < 0.68F && p.z < 0.18F) continue;
    const RawInfluence& most = *std::ranges::max_element(primitive.influences[v], {}, &RawInfluence::weight);
    const std::string& name = scene.nodes[to_index(scene.skins[0].joints[most.joint])].name;
    EXPECT_EQ(name, p.x >= 0.68F ? "LeftHand" : p.x > 0 ? "LeftToeBase" : "RightToeBase");
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(AddSkeleton, SameBytesEveryTime) {
  const Body body = test::quadruped_body();
  const Result first = cook_scene(document(body).read(), making("quadruped"));
  const Result second = cook_scene(document(body).read(), making("quadruped"));
  EXPECT_EQ(first.file, second.file);
  EXPECT_EQ(first.report["warnings"], second.report["warnings"]);
}

TEST(AddSkeleton, NamesThatMotionCaptureHas) {
  const std::vector<std::string> capture = {
      "mixamorig:Hips",         "mixamorig:Spine",       "mixamorig:Spine1",        "mixamorig:Spine2",
      "mixamorig:Neck",         "mixamorig:Head",        "mixamorig:LeftShoulder",  "mixamorig:LeftArm",
      "mixamorig:LeftForeArm",  "mixamorig:LeftHand",    "mixamorig:LeftUpLeg",     "mixamorig:LeftLeg",
      "mixamorig:LeftFoot",     "mixamorig:LeftToeBase", "mixamorig:RightShoulder", "mixamorig:RightArm",
      "mixamorig:RightForeArm", "mixamorig:RightHand",   "mixamorig:RightUpLeg",    "mixamorig:RightLeg",
      "mixamorig:RightFoot",    "mixamorig:RightToeBase"};
  std::vector<std::string> ours;
  for (const deform::TemplateJoint& joint : parse_template("humanoid", builtin_template("humanoid")))
    if (!joint.is_end) ours.push_back(joint.name);
  ASSERT_EQ(ours.size(), capture.size());
  for (const int other : pair_joints(ours, capture)) EXPECT_NE(other, kNone);
}

TEST(AddSkeleton, WhatIsRefused) {
  const auto expect = [](const Body& body, const std::string& rule) {
    SceneDocument d = document(body);
    expect_failure([&] { rig(d.read(), "humanoid"); }, Exit::invalid, "/meshes", rule);
  };
  Body flat, two, bar;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}};
  flat.indices = {0, 1, 2};
  expect(flat, "no-inside");
  for (const double x : {0.0, 3.0}) test::add_capsule({x, 0, 0}, {x, 2, 0}, 0.2, two);
  expect(two, "several-parts");
  test::add_capsule({0, 0, 0}, {0, 2, 0}, 0.2, bar);
  expect(bar, "template-does-not-fit");
  SceneDocument bare;
  bare.node("empty");
  expect_failure([&] { rig(bare.read(), "humanoid"); }, Exit::invalid, "/meshes", "no-meshes");
  RawScene huge = document(bar).read();
  huge.nodes[0].scale = glm::dvec3(1e30);  // which the reader lets nobody have
  expect_failure([&] { rig(huge, "humanoid"); }, Exit::invalid, "/meshes/0/primitives/0", "too-far-away");
}

TEST(SkeletonTemplate, BuiltIn) {
  const deform::SkeletonTemplate humanoid = parse_template("humanoid", builtin_template("humanoid"));
  const deform::SkeletonTemplate quadruped = parse_template("quadruped", builtin_template("quadruped"));
  EXPECT_EQ(humanoid.size(), 22U + 5U);
  EXPECT_EQ(quadruped.size(), 23U + 6U);
  for (const deform::SkeletonTemplate* const skeleton : {&humanoid, &quadruped}) {
    for (std::size_t j = 0; j < skeleton->size(); ++j) {
      const deform::TemplateJoint& joint = (*skeleton)[j];
      if (joint.mirror == deform::kNoJoint) {
        EXPECT_EQ(joint.place.x, 0);
        continue;
      }
      const deform::TemplateJoint& other = (*skeleton)[to_index(joint.mirror)];
      EXPECT_EQ(to_index(other.mirror), j);
      EXPECT_EQ(other.place, joint.place * glm::dvec3(-1, 1, 1));
    }
  }
  EXPECT_TRUE(builtin_template("dragon").empty());
}

TEST(SkeletonTemplate, MistakesAreLocated) {
  const std::string root = "[[joint]]\nname = \"a\"\nplace = [0, 0, 0]\n";
  const auto expect = [](const std::string& text, const std::string& where, const std::string& rule) {
    expect_failure([&] { parse_template("t.toml", text); }, Exit::usage, where, rule);
  };
  const auto below = [&](const std::string& text) { return root + "[[joint]]\n" + text; };
  expect("", "", "no joints");
  expect("joint = 3", "", "no joints");
  expect("joint = [3]", "1:10", "must be a table");
  expect("[[joint", "1:8", "no TOML");
  expect("speed = 1\n" + root, "1:1", "unknown key \"speed\"");
  expect(std::string(70000, '#'), "", "too large");
  expect("a" + std::string(40, '.') + "b = 1", "1:1", "too many parts");
  expect(root, "", "one height");
  expect(below("name = \"b\"\nplace = [0, 1, 0]\n"), "4:1", "second joint without a parent");
  expect("[[joint]]\nname = \"a\"\nparent = \"a\"\nplace = [0, 0, 0]\n", "3:10", "no joint above is called \"a\"");
  expect(below("name = \"a\"\nparent = \"a\"\nplace = [0, 1, 0]\n"), "4:1", "two joints are called \"a\"");
  expect(below("name = \"b\"\nparent = \"c\"\nplace = [0, 1, 0]\n"), "6:10", "no joint above is called \"c\"");
  expect(below("parent = \"a\"\nplace = [0, 1, 0]\n"), "4:1", "without a name");
  expect(below("name = \"b\"\nparent = \"a\"\n"), "4:1", "without a place");
  expect(below("name = 3\nparent = \"a\"\nplace = [0, 1, 0]\n"), "5:8", "\"name\" must be a name");
  for (const char* const place :
       {"[0, 1]", "[0, 1, 2, 3]", "3", "[0, nan, 0]", "[0, inf, 0]", "[0, 1e7, 0]", "[0, \"1\", 0]"})
    expect(below("name = \"b\"\nparent = \"a\"\nplace = " + std::string(place) + "\n"), "7:9", "must be three numbers");
  expect(below("name = \"b\"\nparent = \"a\"\nplace = [1, 1, 0]\n"), "4:1", "without a mirror");
  expect(below("name = \"b\"\nmirror = \"c\"\nparent = \"a\"\nplace = [-1, 1, 0]\n"), "4:1", "not on the left");
  expect(below("name = \"b\"\nparent = \"a\"\nplace = [0, 0, 0]\n"), "4:1", "at the place of the one above");
  expect(below("name = \"b\"\nparent = \"a\"\nplace = [0, 1, 0]\nlength = 3\n"), "8:1", "unknown key \"length\"");
  expect("[[joint]]\nname = \"a\"\nmirror = \"b\"\nplace = [1, 0, 0]\n", "1:1", "first joint has a mirror");
  const std::string aside = below("name = \"b\"\nmirror = \"c\"\nparent = \"a\"\nplace = [1, 1, 0]\n");
  expect(aside + "[[joint]]\nname = \"d\"\nparent = \"b\"\nplace = [0, 2, 0]\n", "9:1", "below one that has one");
  const std::string ended = below("name = \"b\"\nparent = \"a\"\nplace = [0, 1, 0]\nend = [0, 2, 0]\n");
  expect(ended + "[[joint]]\nname = \"d\"\nparent = \"b\"\nplace = [0, 3, 0]\n", "9:1", "both an end and a joint");
  std::string many = root, forks = root;
  for (int i = 0; i < 200; ++i)
    many += "[[joint]]\nname = \"j" + std::to_string(i) + "\"\nparent = \"" +
            (i == 0 ? "a" : "j" + std::to_string(i - 1)) + "\"\nplace = [0, " + std::to_string(i + 1) + ", 0]\n";
  for (int i = 0; i < 30; ++i)
    forks += "[[joint]]\nname = \"j" + std::to_string(i) + "\"\nparent = \"a\"\nplace = [0, " + std::to_string(i + 1) +
             ", 0]\n";
  expect(many, "512:1", "too many joints");
  expect(forks, "", "too many joints that branch");
}

TEST(SkeletonTemplate, OfAFileIsAnInput) {
  const std::string path = fs::temp_directory_path() / ("marrow-template-" + std::to_string(getpid()) + ".toml");
  const std::string text(builtin_template("humanoid"));
  std::ofstream(path) << text;
  std::vector<Read> reads;
  const auto read = [&](const std::string& name) {
    CookOptions options;
    options.prepare.auto_skeleton = name;
    tools::DiskFiles disk;
    read_named_files(options, disk, reads);
    return options.prepare.skeleton->size();
  };
  EXPECT_EQ(read(path), 27U);
  ASSERT_EQ(reads.size(), 1U);
  EXPECT_EQ(reads[0].bytes, text.size());
  EXPECT_EQ(read("humanoid"), 27U);
  EXPECT_EQ(reads.size(), 1U);
  fs::remove(path);
  expect_failure([&] { read(path); }, Exit::usage, "", "neither built in nor a file");
}

TEST(SkeletonOptions, AsText) {
  EXPECT_EQ(options_of("--auto-skeleton humanoid").prepare.auto_skeleton, "humanoid");
  EXPECT_EQ(options_of("--auto-skeleton a/b.toml").prepare.auto_skeleton, "a/b.toml");
  EXPECT_TRUE(options_of("--auto-skeleton none").prepare.auto_skeleton.empty());
  EXPECT_THROW(options_of("--auto-skeleton "), Failure);
  for (const std::string other : {" --clips-only", " --skeleton hero.mrw"}) {
    EXPECT_THROW(options_of("--auto-skeleton humanoid" + other), Failure) << other;
    EXPECT_NO_THROW(options_of("--auto-skeleton none" + other)) << other;
  }
}

}  // namespace
}  // namespace marrow::cook
