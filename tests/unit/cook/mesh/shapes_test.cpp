// Spaces of example shapes from settings to files: which meshes get one, what is refused, and what a clip makes of it.
#include <cmath>
#include <fstream>
#include <sstream>

#include "common/shape_weights.h"
#include "cook/mesh/build_examples.h"
#include "disk/settings.h"
#include "support/golden.h"
#include "support/places.h"
#include "unit/cook/loaded_cook.h"

namespace marrow::cook {
namespace {

CookOptions options_with(const std::string& toml) {
  CookOptions out = to_options(parse_settings("marrow.toml", toml).defaults);
  out.mesh.codec = MeshCodec::none;
  return out;
}

std::string golden_settings() {
  std::ifstream stream(test::in_golden("shapes.toml"));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

TEST(Shapes, GiveTheGoldenBytes) {
  CookOptions options = options_with(golden_settings());
  options.clips.raw = options.mesh.keep_vertex_order = true;
  const Result cooked = cook_file(test::in_golden("face.gltf"), options);
  const test::AlignedBlock golden = test::golden_shapes_copy();
  ASSERT_EQ(cooked.file.size(), golden.size());
  for (std::size_t i = 0; i < golden.size(); ++i) ASSERT_EQ(cooked.file[i], golden.data()[i]) << "byte " << i;
}

// A packed file unpacks to the same sections, and one without shapes is what it was.
TEST(Shapes, GoThroughPackedFiles) {
  CookOptions options = options_with(golden_settings());
  options.mesh.codec = MeshCodec::draco;
  const LoadedCook packed(cook_file(test::in_golden("face.gltf"), options));
  ExampleSpace space;
  ASSERT_EQ(packed.file.example_space_count(), 1u);
  ASSERT_EQ(packed.file.example_space(0, space), Status::ok);
  EXPECT_STREQ(space.name, "moods");
  EXPECT_EQ(space.example_count, 4u);
  options.shapes.clear();
  EXPECT_EQ(LoadedCook(cook_file(test::in_golden("face.gltf"), options)).file.example_space_count(), 0u);
}

BuiltMesh mesh(const std::string& name, const std::vector<std::string>& targets) {
  BuiltMesh out;
  out.name = name;
  for (const std::string& t : targets) out.targets.push_back({t, name + '.' + t, 0});
  return out;
}

ShapeRule rule(const std::string& of, const std::vector<std::string>& targets) {
  ShapeRule out;
  out.name = "face";
  out.mesh = of;
  out.parameters = {{"p", 0}};
  out.origin = {"marrow.toml", "1:1", false};
  for (std::size_t i = 0; i < targets.size(); ++i)
    out.examples.push_back({targets[i], {static_cast<float>(i)}, std::to_string(i) + ":5"});
  return out;
}

TEST(Shapes, MeshesWithTheSameTargetsShareASpace) {
  Notes notes;
  const std::vector<BuiltMesh> meshes = {mesh("head", {"blink", "smile"}), mesh("cap", {}),
                                         mesh("head", {"blink", "smile"}), mesh("lashes", {"blink"}),
                                         mesh("teeth", {"smile", "blink"})};
  const std::vector<BuiltExampleSpace> spaces = build_example_spaces({rule("", {"", "smile", "blink"})}, meshes, notes);
  ASSERT_EQ(spaces.size(), 3u);
  EXPECT_TRUE(notes.warnings.empty());
  // In the order of where the targets are: lashes lack the smile.
  EXPECT_EQ(spaces[0].meshes, (std::vector<std::uint32_t>{3}));
  EXPECT_EQ(spaces[0].targets, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(spaces[1].meshes, (std::vector<std::uint32_t>{4}));
  EXPECT_EQ(spaces[2].meshes, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(spaces[2].targets, (std::vector<std::uint32_t>{0, 1}));
  // Of the middle example of three on a line the constant is 1/3; it is the smile, column 1 of the head, 0 of the
  // teeth.
  EXPECT_NEAR(spaces[2].linear[1], 1.0 / 3, 1e-6);
  EXPECT_NEAR(spaces[1].linear[0], 1.0 / 3, 1e-6);
  EXPECT_NEAR(spaces[0].linear[0], -1.0 / 6, 1e-6) << "the blink is the last";
  EXPECT_EQ(build_example_spaces({rule("lashes", {"", "blink"})}, meshes, notes).size(), 1u);
}

TEST(Shapes, WhatDoesNotFitIsRefusedWhereItIs) {
  const std::vector<BuiltMesh> meshes = {mesh("head", {"blink", "smile"}), mesh("cap", {})};
  const struct {
    std::vector<ShapeRule> rules;
    const char *where, *says;
  } cases[] = {
      {{rule("", {"", "smlie", "blink"})}, "1:5", "no morph target \"smlie\": did you mean \"smile\"?"},
      {{rule("head", {"", "blink", "open"})}, "2:5", "no morph target \"open\""},
      {{rule("cap", {"", "blink"})}, "1:5", "no morph target \"blink\": the mesh has none"},
      {{rule("", {"", "smile"}), rule("head", {"smile", "blink"})}, "1:1", "the target \"smile\" is driven twice"},
  };
  for (const auto& c : cases) {
    Notes notes;
    try {
      build_example_spaces(c.rules, meshes, notes);
      ADD_FAILURE() << c.says;
    } catch (const tools::Failure& f) {
      EXPECT_EQ(f.code(), tools::Exit::usage);
      EXPECT_EQ(f.file(), "marrow.toml");
      EXPECT_EQ(f.where(), c.where) << f.what();
      EXPECT_NE(std::string(f.what()).find(c.says), std::string::npos) << f.what();
    }
  }
}

TEST(Shapes, WhatFitsNothingOrSpansLittleIsNoted) {
  Notes notes;
  const std::vector<BuiltMesh> meshes = {mesh("head", {"blink", "smile"})};
  EXPECT_TRUE(build_example_spaces({rule("", {"", "wave"}), rule("hand", {"", "fist"})}, meshes, notes).empty());
  ASSERT_EQ(notes.warnings.size(), 2u);
  EXPECT_EQ(notes.warnings[0].rule, "shape-unused");
  ShapeRule flat = rule("", {"", "smile"});
  flat.parameters.push_back({"q", 0});
  for (ShapeExample& e : flat.examples) e.at.push_back(3);
  EXPECT_EQ(build_example_spaces({flat}, meshes, notes).size(), 1u);
  ASSERT_EQ(notes.warnings.size(), 3u);
  EXPECT_EQ(notes.warnings[2].rule, "shape-flat");
  EXPECT_NE(notes.warnings[2].text.find("span 1 of 2"), std::string::npos) << notes.warnings[2].text;
}

// A character that plays "speak", 0.75 s in: the weights are those of where the clip's channels have the parameters.
TEST(Shapes, AClipDrivesTheParameters) {
  const LoadedCook cooked(cook_file(test::in_golden("face.gltf"), options_with(golden_settings())));
  const File& file = cooked.file;
  const CharacterOptions options{.layers = 2};
  tools::AlignedBytes shared(animations_bytes(file, file)), own(character_bytes(file, options));
  Animations animations;
  marrow::Character character;
  ASSERT_EQ(make_animations(file, file, {shared.data(), shared.size()}, animations), Status::ok);
  ASSERT_EQ(make_character(file, options, {own.data(), own.size()}, character), Status::ok);
  tools::ShapeWeights examples(file);
  const Clip clip = file.clip(0);
  std::vector<float> values(clip.channels.size);
  ASSERT_EQ(sample_channels(clip, 0.75f, values), Status::ok);
  const float mood = values[file.find_channel(clip, "mood")], glow = values[file.find_channel(clip, "head.glow")];
  ASSERT_NE(mood, 0);
  float expected[2];
  ASSERT_EQ(evaluate_examples(examples.spaces()[0], {{mood, glow}}, expected), Status::ok);
  const AnimationLayer layers[] = {{animations.all.data, 0.75f, 1}};
  ASSERT_EQ(pose_character(character, layers), Status::ok);
  examples.write(layers, character);
  for (std::size_t t = 0; t < 2; ++t) EXPECT_EQ(character.meshes[0].weights[t], expected[t]);
  EXPECT_EQ(finish_character(character), Status::ok);
  // Half of it, by the rule of blend(): a layer of 0.05 with a default of as much again.
  const AnimationLayer little[] = {{animations.all.data, 0.75f, 0.05f}};
  EXPECT_NEAR(examples.parameter(0, 0, little), 0.5 * static_cast<double>(mood), 1e-6);
  EXPECT_NEAR(examples.parameter(0, 1, little), 0.5 * static_cast<double>(glow) + 0.5 * 0.5, 1e-6);
}

// Bounds hold what the shapes do: the blink moves a corner by half a metre, which no channel of its own does here.
TEST(Shapes, BoundsHoldWhatTheyDo) {
  const char* const far = R"(
[[shapes]]
name = "far"
parameters = ["head.glow"]
examples = [{ at = [0] }, { at = [0.125], target = "blink" }]
)";
  const LoadedCook plain(cook_file(test::in_golden("face.gltf"), options_with("")));
  const LoadedCook cooked(cook_file(test::in_golden("face.gltf"), options_with(far)));
  const Bounds before = plain.file.bounds(0, 0), after = cooked.file.bounds(0, 0);
  ASSERT_FALSE(after.is_empty());
  EXPECT_GT(after.radius_m, before.radius_m + 0.5f);
}

}  // namespace
}  // namespace marrow::cook
