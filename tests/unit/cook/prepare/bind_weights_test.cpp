// Meshes that come without weights: which get some, from which joints, and what --smooth-weights and --paint do to
// them.
#include "cook/prepare/bind_weights.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <glm/matrix.hpp>

#include "common/hash.h"
#include "cook/options/options.h"
#include "cook/paint/paint_weights.h"
#include "cook/prepare/bind_bones.h"
#include "deform/weights/auto_weights.h"
#include "disk/cook_on_disk.h"
#include "disk/disk_files.h"
#include "unit/cook/options_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

namespace fs = std::filesystem;
using deform::WeightMethod;

// A bar of 2 × 2 × 8 along y, with vertices at whole numbers, whose UVs run with y from 0 below to 1 on top.
int bar(Builder& b, bool uvs = true) {
  std::vector<float> positions, coordinates;
  std::vector<std::uint16_t> indices;
  for (int y = 0; y <= 8; ++y) {
    for (const auto& [x, z] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      positions.insert(positions.end(), {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
      coordinates.insert(coordinates.end(), {0.5F, static_cast<float>(y) / 8});
    }
  }
  for (std::uint16_t y = 0; y < 8; ++y) {
    for (std::uint16_t i = 0; i < 4; ++i) {
      const auto a = static_cast<std::uint16_t>(y * 4 + i), c = static_cast<std::uint16_t>(y * 4 + (i + 1) % 4);
      for (const int v : {+a, c + 4, +c, +a, a + 4, c + 4}) indices.push_back(static_cast<std::uint16_t>(v));
    }
  }
  for (const int v : {0, 1, 2, 0, 2, 3, 32, 34, 33, 32, 35, 34}) indices.push_back(static_cast<std::uint16_t>(v));
  Json attributes = {{"POSITION", b.positions(positions)}};
  if (uvs) attributes["TEXCOORD_0"] = b.numbers<float>(kF32, "VEC2", 2, coordinates);
  b.root["meshes"].push_back(
      {{"name", "bar"},
       {"primitives",
        {{{"attributes", attributes}, {"indices", b.numbers<std::uint16_t>(kU16, "SCALAR", 1, indices)}}}}});
  return static_cast<int>(b.root["meshes"].size()) - 1;
}

// Joints "low" at (0, 0, 0), "high" at (0, 4, 0) and "end" at (0, 8, 0), and a skin of them with their inverse binds.
int bones(SceneDocument& d, bool skin = true) {
  const int low = d.node("low"), high = d.node("high", low, {0, 4, 0}), end = d.node("end", high, {0, 4, 0});
  if (!skin) return low;
  std::vector<float> inverse_bind;
  for (const float y : {0.0F, -4.0F, -8.0F})
    inverse_bind.insert(inverse_bind.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, y, 0, 1});
  const int matrices = d.b.numbers<float>(kF32, "MAT4", 16, inverse_bind);
  d.b.root["skins"].push_back({{"name", "rig"}, {"joints", {low, high, end}}, {"inverseBindMatrices", matrices}});
  return low;
}

void draw(SceneDocument& d, int node, int mesh, int skin = -1) {
  d.b.root["nodes"][static_cast<std::size_t>(node)]["mesh"] = mesh;
  if (skin >= 0) d.b.root["nodes"][static_cast<std::size_t>(node)]["skin"] = skin;
}

WeightOptions make(WeightMethod method = WeightMethod::geodesic) {
  WeightOptions options;
  options.make = method;
  return options;
}

double weight_of(const std::vector<RawInfluence>& vertex, std::uint32_t joint) {
  for (const RawInfluence& i : vertex)
    if (i.joint == joint) return static_cast<double>(i.weight);
  return 0;
}

// The bar's lower end goes with the lower joint and its upper half with those above.
void expect_bound(const RawPrimitive& primitive) {
  ASSERT_EQ(primitive.influences.size(), primitive.positions.size());
  for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
    double sum = 0;
    for (const RawInfluence& i : primitive.influences[v]) sum += static_cast<double>(i.weight);
    EXPECT_NEAR(sum, 1, 1e-6);
    EXPECT_LE(primitive.influences[v].size(), 4U);
    const double low = weight_of(primitive.influences[v], 0);
    if (v < 8) {
      EXPECT_GT(low, 0.9);
    }
    if (v >= 16 && v < 20) {
      EXPECT_NEAR(low, 0.5, 0.02);  // at the joint between them
    }
    if (v >= 28) {
      EXPECT_LT(low, 0.1);
    }
  }
}

// In the place of the scene, with what is noted as its warnings.
void bind(RawScene& scene, const WeightOptions& options) {
  Notes notes{scene.warnings, {}};
  scene = bind_weights(scene, options, notes);
  scene.warnings = std::move(notes.warnings);
}

TEST(BindWeights, AMeshWithASkinGetsItsWeights) {
  for (const WeightMethod method : {WeightMethod::geodesic, WeightMethod::glow, WeightMethod::gaussian}) {
    SceneDocument d;
    bones(d);
    const int at = d.node("body", -1, {5, 6, 7});  // which a skin makes no difference to
    draw(d, at, bar(d.b), 0);
    RawScene scene = d.read();
    ASSERT_TRUE(warns(scene, "skin-without-weights"));
    bind(scene, make(method));
    ASSERT_EQ(scene.instances.size(), 1U);
    EXPECT_EQ(scene.instances[0].skin, 0);
    EXPECT_FALSE(warns(scene, "skin-without-weights"));
    EXPECT_TRUE(warns(scene, "weights-made", "/meshes/0"));
    expect_bound(scene.meshes[0].primitives[0]);
  }
}

// From (±1, 1, ±1): 1.414 to "low"'s bone, √11 to "high"'s lower end, √51 to "end"'s.
TEST(BindWeights, NearestByHand) {
  SceneDocument d;
  bones(d);
  draw(d, d.node("body"), bar(d.b), 0);
  RawScene scene = d.read();
  bind(scene, make(WeightMethod::nearest));
  const double low = 1 / std::sqrt(2.0), high = 1 / std::sqrt(11.0), end = 1 / std::sqrt(51.0);
  const std::vector<RawInfluence>& vertex = scene.meshes[0].primitives[0].influences[4];
  EXPECT_NEAR(weight_of(vertex, 0), low / (low + high + end), 1e-6);
  EXPECT_NEAR(weight_of(vertex, 1), high / (low + high + end), 1e-6);
  EXPECT_NEAR(weight_of(vertex, 2), end / (low + high + end), 1e-6);
}

// A mesh in other units, turned and moved by its node to where the bones are: at rest its skin leaves it there.
TEST(BindWeights, AMeshWithoutASkinGoesThroughItsNode) {
  SceneDocument d;
  const int armature = d.node("armature", -1, {10, 0, 0});
  bones(d);
  d.b.root["scenes"][0]["nodes"] = {armature};
  d.b.root["nodes"][static_cast<std::size_t>(armature)]["children"] = {1};
  const int body = d.skin("body", {1, 2, 3});  // it has weights, and makes the skin one in use
  const int mesh = bar(d.b);
  const int prop = d.node("prop", -1, {10, 0, 0});
  d.b.root["nodes"][static_cast<std::size_t>(prop)]["scale"] = {2, 1, 2};
  d.b.root["nodes"][static_cast<std::size_t>(prop)]["rotation"] = {0, 1, 0, 0};  // half a turn about y
  draw(d, prop, mesh);
  d.b.root["skins"].erase(0);
  d.b.root["nodes"][static_cast<std::size_t>(body)]["skin"] = 0;
  RawScene scene = d.read();
  bind(scene, make());
  expect_bound(scene.meshes[static_cast<std::size_t>(mesh)].primitives[0]);
  EXPECT_TRUE(warns(scene, "bound-at-rest"));  // that body's inverse binds are all the identity
  const RawInstance& bound = scene.instances.back();
  ASSERT_EQ(bound.skin, 1);
  const RawSkin& skin = scene.skins[1];
  ASSERT_EQ(skin.joints.size(), 3U);
  const std::vector<glm::dmat4> rest = rest_of_nodes(scene);
  for (std::size_t j = 0; j < 3; ++j) {
    const glm::dvec4 there =
        rest[static_cast<std::size_t>(skin.joints[j])] * skin.inverse_bind[j] * glm::dvec4(1, 3, 0.5, 1);
    expect_near(glm::dvec3(there), {10 - 2, 3, -1});
  }
  EXPECT_EQ(scene.meshes[0].primitives[0].influences[2].size(), 2U);  // as in the file
}

TEST(BindWeights, WithoutASkinNodesThatClipsMoveAreJoints) {
  SceneDocument d;
  const int low = bones(d, false);
  draw(d, d.node("body"), bar(d.b));
  d.clip("bend");
  d.turn(low, {0, 1});
  d.turn(low + 1, {0, 1});
  RawScene scene = d.read();
  bind(scene, make());
  ASSERT_EQ(scene.skins.size(), 1U);
  EXPECT_EQ(scene.skins[0].joints, (std::vector<int>{low, low + 1}));
  expect_near(glm::dvec3(scene.skins[0].inverse_bind[1][3]), {0, -4, 0});
  expect_bound(scene.meshes[0].primitives[0]);
  const Result cooked = cook_scene(d.read(), options_of("--auto-weights geodesic"));
  EXPECT_EQ(cooked.report["meshes"][0]["joints"], 2);
}

// Two nodes draw one mesh: each has a skin of its own, so the mesh becomes two.
TEST(BindWeights, AMeshDrawnTwiceIsBoundTwice) {
  SceneDocument d;
  bones(d);
  const int mesh = bar(d.b);
  draw(d, d.node("one"), mesh);
  draw(d, d.node("two", -1, {0, 4, 0}), mesh);
  RawScene scene = d.read();
  bind(scene, make());
  ASSERT_EQ(scene.meshes.size(), 2U);
  EXPECT_NE(scene.instances[0].mesh, scene.instances[1].mesh);
  EXPECT_NE(scene.instances[0].skin, scene.instances[1].skin);
  expect_bound(scene.meshes[0].primitives[0]);
  EXPECT_LT(weight_of(scene.meshes[1].primitives[0].influences[8], 0), 0.1);  // it begins where the upper joint is
}

TEST(BindWeights, WhatFollowsAJointIsLeftAlone) {
  SceneDocument d;
  const int low = bones(d);
  d.prop(low + 2);
  draw(d, d.node("body"), bar(d.b), 0);
  RawScene scene = d.read();
  bind(scene, make());
  EXPECT_EQ(scene.instances[0].skin, kNone);
  EXPECT_EQ(scene.instances[1].skin, 0);
}

TEST(BindWeights, NothingToBind) {
  SceneDocument weighted;
  weighted.character("hero", 0);
  RawScene scene = weighted.read();
  expect_failure([&] { bind(scene, make()); }, Exit::usage, "", "every mesh has weights already");
  WeightOptions of_many = make();
  of_many.make_origin.must_fit = false;
  bind(scene, of_many);
  EXPECT_TRUE(warns(scene, "rule-fits-nothing"));

  SceneDocument still;
  still.prop(still.node("rock"));
  scene = still.read();
  expect_failure([&] { bind(scene, make()); }, Exit::invalid, "", "neither a skin nor nodes that clips move");
  WeightOptions smooth;
  smooth.smooth_steps = 3;
  expect_failure([&] { bind(scene, smooth); }, Exit::usage, "", "no mesh has weights to smooth");

  SceneDocument two;
  two.character("one", 0);
  two.character("other", 2);
  two.prop(two.node("rock"));
  scene = two.read();
  expect_failure([&] { bind(scene, make()); }, Exit::usage, "", "several skins");
}

// All of the bar hangs on the joint at its upper end, by its file; bound anew it is as if that had not been said.
TEST(BindWeights, RebindingReplacesTheFilesWeights) {
  const auto document = [](bool weighted) {
    SceneDocument d;
    bones(d);
    draw(d, d.node("body"), bar(d.b), 0);
    if (!weighted) return d.read();
    std::vector<std::uint8_t> joints;
    std::vector<float> weights;
    for (int v = 0; v < 36; ++v) {
      joints.insert(joints.end(), {2, 0, 0, 0});
      weights.insert(weights.end(), {1, 0, 0, 0});
    }
    Json& attributes = d.b.root["meshes"][0]["primitives"][0]["attributes"];
    const int of_joints = d.b.numbers<std::uint8_t>(kU8, "VEC4", 4, joints);
    const int of_weights = d.b.numbers<float>(kF32, "VEC4", 4, weights);
    attributes.update({{"JOINTS_0", of_joints}, {"WEIGHTS_0", of_weights}});
    return d.read();
  };
  RawScene bare = document(false), rebound = document(true), kept = document(true);
  bind(bare, make());
  WeightOptions options = make();
  expect_failure([&] { bind(kept, options); }, Exit::usage, "", "every mesh has weights already");
  options.rebind = true;
  bind(rebound, options);
  EXPECT_TRUE(warns(rebound, "weights-made", "/meshes/0"));
  expect_bound(rebound.meshes[0].primitives[0]);
  const auto &ours = rebound.meshes[0].primitives[0].influences, &theirs = bare.meshes[0].primitives[0].influences;
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t v = 0; v < ours.size(); ++v)
    for (const std::uint32_t joint : {0U, 1U, 2U}) EXPECT_EQ(weight_of(ours[v], joint), weight_of(theirs[v], joint));
}

// Inverse binds of zeros: no bone is anywhere.
TEST(BindWeights, InverseBindsThatCannotBeInverted) {
  SceneDocument d;
  bones(d);
  draw(d, d.node("body"), bar(d.b), 0);
  RawScene scene = d.read();
  for (glm::dmat4& m : scene.skins[0].inverse_bind) m = glm::dmat4(0.0);
  expect_failure([&] { bind(scene, make()); }, Exit::invalid, "/skins/0", "no-bones");
}

// The quad 0 1 2, 1 3 2 of SceneDocument::skin(): vertex 0 has neighbours 1 and 2 and goes half of the way to their
// mean.
TEST(BindWeights, SmoothingTakesTheFilesWeightsToo) {
  SceneDocument d;
  const int root = d.node("a");
  d.skin("rig", {root, d.node("b", root)});
  RawScene scene = d.read();
  const RawPrimitive before = scene.meshes[0].primitives[0];
  const double w1 = weight_of(before.influences[1], 0), w2 = weight_of(before.influences[2], 0);
  const double expected = 0.5 * weight_of(before.influences[0], 0) + 0.25 * (w1 + w2);
  WeightOptions options;
  options.smooth_steps = 1;
  bind(scene, options);
  EXPECT_NEAR(weight_of(scene.meshes[0].primitives[0].influences[0], 0), expected, 1e-6);
}

// A grey-scale PNG, its data stored and not compressed: four pixels at most a row keep the arithmetic in view.
std::string png(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& grey) {
  std::string raw;
  for (std::size_t y = 0; y * width < grey.size(); ++y) {
    raw += '\0';
    for (std::size_t x = 0; x < width; ++x) raw += static_cast<char>(grey[y * width + x]);
  }
  const auto number = [](std::uint32_t n) {
    std::string s;
    for (int shift = 24; shift >= 0; shift -= 8) s += static_cast<char>(n >> shift & 255);
    return s;
  };
  const auto chunk = [&](const std::string& type, const std::string& data) {
    std::uint32_t crc = 0xFFFFFFFF;
    for (const char c : type + data) {
      crc ^= static_cast<std::uint8_t>(c);
      for (int i = 0; i < 8; ++i) crc = crc & 1 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
    }
    return number(static_cast<std::uint32_t>(data.size())) + type + data + number(~crc);
  };
  std::uint32_t a = 1, b = 0;
  for (const char c : raw) {
    a = (a + static_cast<std::uint8_t>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint16_t>(raw.size());
  const auto little = [](unsigned n) {
    return std::string{static_cast<char>(n & 255), static_cast<char>(n >> 8 & 255)};
  };
  const std::string zlib =
      std::string("\x78\x01\x01", 3) + little(size) + little(size ^ 0xFFFFU) + raw + number(b << 16 | a);
  return std::string("\x89PNG\r\n\x1a\n", 8) +
         chunk("IHDR", number(width) + number(height) + std::string("\x08\0\0\0\0", 5)) + chunk("IDAT", zlib) +
         chunk("IEND", "");
}

class Paint : public ::testing::Test {
 protected:
  Paint() : folder_(fs::temp_directory_path() / ("marrow_paint_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
    bones(d_);
    draw(d_, d_.node("body"), bar(d_.b), 0);
  }
  ~Paint() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  // Upper half black, lower half white.
  std::string mask() const { return write("mask.png", png(1, 4, {0, 0, 255, 255})); }
  static WeightOptions painting(const std::string& joint, const std::string& file) {
    WeightOptions options = make(WeightMethod::nearest);
    options.paint.push_back(rule(joint, file));
    return options;
  }
  // As it has been read.
  static PaintRule rule(const std::string& joint, const std::string& file) {
    CookOptions options;
    options.prepare.weights.paint.push_back({joint, file});
    return with_named_files(options).prepare.weights.paint[0];
  }

  fs::path folder_;
  SceneDocument d_;
};

// v is 0 above. In rows of 4: v = 1/4 lies on the border of rows 0 and 1 (0), 1/2 of rows 1 and 2 (half), 3/4 of rows 2
// and 3 (1), 3/8 and 5/8 in the middle of rows 1 and 2, and 0 and 1 where the picture is repeated, between 3 and 0.
TEST_F(Paint, AMaskIsReadAtTheUvs) {
  RawScene plain = d_.read(), scene = d_.read();
  bind(plain, make(WeightMethod::nearest));
  bind(scene, painting("end", mask()));
  const double expected[9] = {0.5, 0, 0, 0, 0.5, 1, 1, 1, 0.5};
  for (std::size_t y = 0; y <= 8; ++y) {
    const auto& vertex = scene.meshes[0].primitives[0].influences[y * 4];
    const auto& before = plain.meshes[0].primitives[0].influences[y * 4];
    EXPECT_NEAR(weight_of(vertex, 2), expected[y], 1e-6) << y;
    const double others = weight_of(before, 0) + weight_of(before, 1);
    EXPECT_NEAR(weight_of(vertex, 0), weight_of(before, 0) / others * (1 - expected[y]), 1e-6) << y;
  }
}

TEST_F(Paint, TwoMasksOverOneAreScaledDown) {
  WeightOptions options = painting("end", write("a.png", png(1, 1, {255})));
  options.paint.push_back(rule("low", write("b.png", png(1, 1, {85}))));  // a third
  RawScene scene = d_.read();
  bind(scene, options);
  for (const auto& vertex : scene.meshes[0].primitives[0].influences) {
    EXPECT_NEAR(weight_of(vertex, 2), 0.75, 1e-6);
    EXPECT_NEAR(weight_of(vertex, 0), 0.25, 1e-6);
  }
}

TEST_F(Paint, AVertexWithoutAnotherJointKeepsThePainted) {
  RawScene scene = d_.read();
  WeightOptions options = painting("low", mask());
  options.make.reset();
  scene.instances[0].skin = 0;
  scene.meshes[0].primitives[0].influences.assign(36, {{0, 1}});
  bind(scene, options);
  for (const auto& vertex : scene.meshes[0].primitives[0].influences) EXPECT_EQ(weight_of(vertex, 0), 1.0);
}

TEST_F(Paint, WhatCannotBePainted) {
  RawScene scene = d_.read();
  expect_failure([&] { bind(scene, painting("tail", mask())); }, Exit::usage, "", "is called \"tail\"");
  scene = d_.read();
  const std::string text = write("text.png", "no picture"), huge = write("huge.png", png(8193, 1, {}));
  expect_failure([&] { bind(scene, painting("low", text)); }, Exit::invalid, "paint low", "no PNG");
  scene = d_.read();
  expect_failure([&] { bind(scene, painting("low", huge)); }, Exit::invalid, "paint low", "no PNG");
  scene = d_.read();
  EXPECT_THROW(bind(scene, painting("low", folder_ / "missing.png")), Failure);
  SceneDocument bare;
  bones(bare);
  draw(bare, bare.node("body"), bar(bare.b, false), 0);
  scene = bare.read();
  expect_failure([&] { bind(scene, painting("low", mask())); }, Exit::usage, "", "has UVs");
  scene = bare.read();
  WeightOptions of_many = painting("tail", mask());
  of_many.paint[0].origin.must_fit = false;
  bind(scene, of_many);
  EXPECT_TRUE(warns(scene, "rule-fits-nothing"));
}

TEST_F(Paint, AMaskIsAnInput) {
  const std::string file = write("bar.gltf", d_.text());
  CookOptions options;
  options.prepare.weights = make(WeightMethod::nearest);
  options.prepare.weights.paint.push_back({"end", mask()});
  const Result result = cook_file(file, options);
  ASSERT_EQ(result.reads.size(), 2U);
  EXPECT_EQ(fs::path(result.reads[1].name).filename(), "mask.png");
  EXPECT_EQ(result.reads[1].bytes, fs::file_size(folder_ / "mask.png"));
  EXPECT_EQ(result.reads[1].hash, tools::hash_of(tools::DiskFiles().read(mask(), kMostBytes)));
}

TEST(WeightOptions, AsText) {
  const auto given = [](const std::string& text) { return options_of(text).prepare.weights; };
  EXPECT_FALSE(given("--auto-weights none").any());
  EXPECT_EQ(given("--auto-weights geodesic").make, WeightMethod::geodesic);
  EXPECT_EQ(given("--auto-weights glow").make, WeightMethod::glow);
  EXPECT_TRUE(given("--auto-weights nearest --rebind").rebind);
  EXPECT_EQ(given("--smooth-weights 12").smooth_steps, 12);
  EXPECT_EQ(given("--paint a=b=c.png").paint.at(0).joint, "a=b");
  EXPECT_EQ(given("--paint a=b=c.png").paint.at(0).file, "c.png");
  for (const char* bad : {"--rebind", "--auto-weights magic", "--smooth-weights 1.5", "--smooth-weights -1",
                          "--smooth-weights 1e9", "--paint =mask.png", "--paint head", "--paint head="})
    EXPECT_THROW(given(bad), Failure) << bad;
}

}  // namespace
}  // namespace marrow::cook
