// What is promised and reported holds against the reference evaluator where it is hard: far from the origin, below
// large scales, with joints apart from where they were bound, with large morph targets, beside what draws nothing.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "cook/prepare/match_skeletons.h"
#include "marrow/clip_pack.h"
#include "road/cooked.h"
#include "road/reference.h"
#include "unit/cook/scene_document.h"

namespace marrow::test {
namespace {

using cook::Json;

// A document as a file, while it lives.
class SourceFile {
 public:
  explicit SourceFile(cook::SceneDocument& document, const std::string& name = "scene")
      : path((std::filesystem::temp_directory_path() / ("marrow_stated_" + std::to_string(::getpid()) + name + ".gltf"))
                 .string()) {
    std::ofstream(path) << document.text();
  }
  ~SourceFile() { std::filesystem::remove(path); }
  SourceFile(const SourceFile&) = delete;
  SourceFile& operator=(const SourceFile&) = delete;
  std::string path;
};

Json& node_of(cook::SceneDocument& d, int node) {
  return d.b.root["nodes"][static_cast<std::size_t>(node)];
}

// The last clip moves a node along a curve with `amount`, in 40 keys.
void sway(cook::SceneDocument& d, int node, const char* path, float amount) {
  std::vector<float> times, values;
  const std::vector<float> rest = node_of(d, node).contains("translation")
                                      ? node_of(d, node)["translation"].get<std::vector<float>>()
                                      : std::vector<float>{0, 0, 0};
  for (int k = 0; k < 40; ++k) {
    times.push_back(static_cast<float>(k) / 30);
    const float s = amount * std::sin(0.3F * static_cast<float>(k));
    if (std::string(path) == "rotation")
      values.insert(values.end(), {0, 0, std::sin(s), std::cos(s)});
    else
      values.insert(values.end(), {rest[0] + s, rest[1], rest[2]});
  }
  Json& animation = d.b.root["animations"].back();
  animation["channels"].push_back(
      {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
  const bool turns = std::string(path) == "rotation";
  const int input = d.b.times(times);
  animation["samplers"].push_back(
      {{"input", input}, {"output", d.b.numbers<float>(cook::kF32, turns ? "VEC4" : "VEC3", turns ? 4 : 3, values)}});
}

// A mesh of three vertices a joint that follow it and the next; `size` of one and of the bones.
void skin(cook::SceneDocument& d, const std::vector<int>& joints, float size, const std::vector<float>& bind = {}) {
  std::vector<float> places, weights;
  std::vector<std::uint8_t> follows;
  std::vector<std::uint16_t> corners;
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (int corner = 0; corner < 3; ++corner) {
      const auto x = static_cast<float>(corner), y = static_cast<float>(j);
      places.insert(places.end(), {size * (0.1F + 0.313F * x), size * (y + 0.7F * x * x), size * 0.0371F * x * y});
      const auto next = static_cast<std::uint8_t>(std::min(j + 1, joints.size() - 1));
      follows.insert(follows.end(), {static_cast<std::uint8_t>(j), next, 0, 0});
      weights.insert(weights.end(), {0.3171F, 0.6829F, 0, 0});
      corners.push_back(static_cast<std::uint16_t>(corners.size()));
    }
  Json attributes = {{"POSITION", d.b.positions(places)},
                     {"JOINTS_0", d.b.numbers<std::uint8_t>(cook::kU8, "VEC4", 4, follows)},
                     {"WEIGHTS_0", d.b.numbers<float>(cook::kF32, "VEC4", 4, weights)}};
  const int indices = d.b.numbers<std::uint16_t>(cook::kU16, "SCALAR", 1, corners);
  d.b.root["meshes"].push_back({{"primitives", {{{"attributes", attributes}, {"indices", indices}}}}});
  Json of = {{"joints", joints}};
  if (!bind.empty()) of["inverseBindMatrices"] = d.b.numbers<float>(cook::kF32, "MAT4", 16, bind);
  d.b.root["skins"].push_back(of);
  Json& body = node_of(d, d.node("body"));
  body["mesh"] = d.b.root["meshes"].size() - 1;
  body["skin"] = d.b.root["skins"].size() - 1;
}

// A chain of joints `bone` long, whose clip "sway" turns them; the first hangs on `parent`.
std::vector<int> chain(cook::SceneDocument& d, int parent, float bone) {
  std::vector<int> joints;
  for (const char* name : {"a", "b", "c"})
    joints.push_back(d.node(name, joints.empty() ? parent : joints.back(),
                            {bone * 0.1234567F, bone * 0.987654F, bone * 0.0543219F}));
  d.clip("sway");
  for (const int joint : joints) sway(d, joint, "rotation", 0.3F);
  return joints;
}

double farthest(const ReferencePose& want, const CookedPose& got) {
  EXPECT_EQ(want.positions.size(), got.positions.size());
  double worst = 0;
  for (std::size_t v = 0; v < std::min(want.positions.size(), got.positions.size()); ++v)
    worst = std::max(worst, length(minus(want.positions[v], got.positions[v])));
  return worst;
}

double rest_error(const Reference& reference, const Cooked& cooked) {
  return farthest(reference.rest(), cooked.pose(cooked.file().clip_count(), 0, Deformer::ssd));
}

// Of the first clip, which is the first animation's.
double clip_error(const Reference& reference, const Cooked& cooked) {
  constexpr int kTimes = 97;
  double worst = 0;
  for (int i = 0; i <= kTimes; ++i) {
    const auto time_s = static_cast<float>(reference.duration_s(0) * i / kTimes);
    worst =
        std::max(worst, farthest(reference.at(0, static_cast<double>(time_s)), cooked.pose(0, time_s, Deformer::ssd)));
  }
  return worst;
}

double stated(const Cooked& cooked, const char* list, const char* field) {
  return cooked.report()[list][0][field].get<double>();
}

cook::CookOptions lossless() {
  cook::CookOptions out;
  out.mesh.codec = cook::MeshCodec::none;
  out.clips.raw = true;
  return out;
}

// 4e-6 m is a step of a float 50 m away.
constexpr double kFloats = 2e-5;

// A skeleton in hundredths below a node of scale 100 that clips move, 50 m away.
struct Far {
  Far() {
    const int top = d.node("top", -1, {50, 0, 3});
    node_of(d, top)["scale"] = {100, 100, 100};
    const std::vector<int> joints = chain(d, top, 0.01F);
    sway(d, top, "translation", 0.5F);
    skin(d, joints, 0.01F);
  }
  cook::SceneDocument d;
};

TEST(StatedErrors, NothingIsRoundedOfARestPose) {
  Far far;
  const SourceFile file(far.d);
  const Reference reference(file.path);
  const Cooked plain(file.path, lossless());
  EXPECT_LE(rest_error(reference, plain), kFloats);
  EXPECT_LE(clip_error(reference, plain), kFloats);
  const Skeleton skeleton = plain.file().skeleton(0);
  ASSERT_EQ(skeleton.joint_count, 4u);
  EXPECT_EQ(skeleton.rest[0].translation[0][0], 50.0f);
  for (int j = 1; j < 4; ++j) {
    EXPECT_EQ(skeleton.rest[0].translation[0][j], 0.01F * 0.1234567F);
    EXPECT_EQ(skeleton.rest[0].translation[1][j], 0.01F * 0.987654F);
  }
  const Cooked packed(file.path, cook::CookOptions{});
  EXPECT_EQ(skeleton_hash(plain.file(), 0), skeleton_hash(packed.file(), 0)) << "the same bits, packed or not";
}

TEST(StatedErrors, ClipsAreCountedFromTheSourcesRest) {
  Far far;
  const SourceFile file(far.d);
  const Reference reference(file.path);
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  const Cooked cooked(file.path, options);
  EXPECT_EQ(cooked.report()["clips"][0]["codec"], "segments");
  const double said = stated(cooked, "clips", "max_vertex_error_m");
  EXPECT_LE(said, 1e-4);
  EXPECT_LE(clip_error(reference, cooked), 1.1 * said + kFloats);
  const Cooked all(file.path, cook::CookOptions{});
  EXPECT_LE(
      clip_error(reference, all),
      1.1 * (stated(all, "clips", "max_vertex_error_m") + stated(all, "meshes", "max_position_error_m")) + kFloats);
}

TEST(StatedErrors, WhatDrawsNothingDoesNotMeasureACharacter) {
  const auto cooked = [](bool is_there, const std::vector<std::string>& keep) {
    cook::SceneDocument d;
    const std::vector<int> joints = chain(d, -1, 1);
    if (is_there) {
      const int camera = d.node("camera", -1, {60, 3, 0});
      node_of(d, camera)["camera"] = 0;
      d.b.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
      sway(d, camera, "translation", 0.5F);
      sway(d, d.node("empty", camera, {90, 0, 0}), "rotation", 0.5F);
    }
    skin(d, joints, 1);
    const SourceFile file(d);
    cook::CookOptions options;
    options.mesh.codec = cook::MeshCodec::none;
    options.prepare.keep = keep;
    const Cooked out(file.path, options);
    const bool warns = std::ranges::any_of(out.report()["warnings"],
                                           [](const auto& warning) { return warning["rule"] == "motion-of-nothing"; });
    EXPECT_EQ(warns, is_there && keep.empty());
    EXPECT_LE(stated(out, "clips", "max_vertex_error_m"), 1e-4);
    EXPECT_LE(clip_error(Reference(file.path), out), 1.1e-4);
    return out.report();
  };
  const auto alone = cooked(false, {}), beside = cooked(true, {}), kept = cooked(true, {"camera", "empty"});
  EXPECT_EQ(beside["skeletons"][0]["joints"], 3);
  EXPECT_EQ(kept["skeletons"].size() + kept["skeletons"][0]["joints"].get<std::size_t>(), 6u) << "the same skeleton";
  EXPECT_EQ(alone["clips"][0]["memory_bytes"], beside["clips"][0]["memory_bytes"]);
}

// 200 units across: by default as a person in centimetres; a length that is given is that length.
TEST(StatedErrors, LengthsThatAreGivenAreNeverReinterpreted) {
  cook::SceneDocument d;
  skin(d, chain(d, -1, 100), 100);
  const SourceFile file(d);
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  EXPECT_GT(clip_error(Reference(file.path), Cooked(file.path, options)), 2e-3);
  options.clips.error.push_back({"", 1e-3, false});
  const Cooked strict(file.path, options);
  EXPECT_LE(stated(strict, "clips", "max_vertex_error_m"), 1e-3);
  EXPECT_LE(clip_error(Reference(file.path), strict), 1.1e-3 + 100 * 1e-6);
}

// Weights are rounded to twelve bits, 1.2e-4; bound 3 m from where they rest, a vertex moves by a third of a
// millimetre.
TEST(StatedErrors, RestCountsRoundedWeights) {
  cook::SceneDocument d;
  const std::vector<int> joints = chain(d, -1, 0.1F);
  std::vector<float> bind;
  for (const float apart : {0.0F, 3.0F, -4.0F})
    bind.insert(bind.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, apart, 2 * apart, 0, 1});
  skin(d, joints, 0.1F, bind);
  const SourceFile file(d);
  const Reference reference(file.path);
  for (const cook::MeshCodec codec : {cook::MeshCodec::draco, cook::MeshCodec::meshopt}) {
    cook::CookOptions options;
    options.mesh.codec = codec;
    const Cooked cooked(file.path, options);
    const double real = rest_error(reference, cooked), said = stated(cooked, "meshes", "max_position_error_m");
    EXPECT_GT(real, 1e-4) << "weights move it";
    EXPECT_LE(real, said + 2e-6);
    EXPECT_LE(said, 1.1 * real) << "measured, not only bounded";
  }
  EXPECT_EQ(stated(Cooked(file.path, lossless()), "meshes", "max_position_error_m"), 0);
}

// A target takes vertices 20 m away, and weights that are rounded by 1.2e-4 go with joints 3 and 4 m apart, one of them
// turned: the same rounding, on twenty metres more.
TEST(StatedErrors, TargetsCountRoundedWeights) {
  cook::SceneDocument d;
  const std::vector<int> joints = chain(d, -1, 0.1F);
  node_of(d, joints[1])["rotation"] = {0, 0, 0.6, 0.8};
  std::vector<float> bind;
  for (const float apart : {0.0F, 3.0F, -4.0F})
    bind.insert(bind.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, apart, 2 * apart, 0, 1});
  skin(d, joints, 0.1F, bind);
  std::vector<float> changes;
  for (int v = 0; v < 9; ++v) changes.insert(changes.end(), {20, 0.1F * static_cast<float>(v), 0});
  d.b.root["meshes"][0]["primitives"][0]["targets"].push_back({{"POSITION", d.b.positions(changes)}});
  d.b.root["meshes"][0]["weights"] = {0.5};
  const SourceFile file(d);
  const Reference reference(file.path);
  const Cooked cooked(file.path, cook::CookOptions{});
  const double position = stated(cooked, "meshes", "max_position_error_m");
  const double target = stated(cooked, "meshes", "max_target_error_m");
  const double alone = farthest(reference.rest({1}), cooked.pose(cooked.file().clip_count(), 0, Deformer::ssd, {1}));
  EXPECT_GT(alone, 1e-3) << "weights move it";
  EXPECT_LE(alone, position + target + kFloats);
  EXPECT_LE(rest_error(reference, cooked), position + kFloats);
  EXPECT_LE(target, 1.1 * alone) << "measured, not only bounded";
}

// Targets that take vertices 300 units away, weighed by a clip; 16 bits of that are 5 mm each.
struct Face {
  Face() {
    const int head = d.node("head");
    d.prop(head);
    d.clip("speak");
    Json& mesh = d.b.root["meshes"][0];
    for (const float far : {311.123F, 173.77F}) {
      std::vector<float> changes;
      for (int v = 0; v < 4; ++v)
        changes.insert(changes.end(), {far * std::sin(1.7F * static_cast<float>(v)),
                                       far * std::cos(2.3F * static_cast<float>(v)), far * 0.3333F});
      mesh["primitives"][0]["targets"].push_back({{"POSITION", d.b.positions(changes)}});
    }
    mesh["weights"] = {0.25, 0.125};
    std::vector<float> times, weights;
    for (int k = 0; k < 20; ++k) {
      times.push_back(static_cast<float>(k) / 10);
      weights.insert(weights.end(), {std::sin(0.4F * static_cast<float>(k)), 1.7F * std::cos(static_cast<float>(k))});
    }
    Json& animation = d.b.root["animations"][0];
    animation["channels"].push_back({{"sampler", 0}, {"target", {{"node", head}, {"path", "weights"}}}});
    const int input = d.b.times(times);
    animation["samplers"].push_back(
        {{"input", input}, {"output", d.b.numbers<float>(cook::kF32, "SCALAR", 1, weights)}});
  }
  cook::SceneDocument d;
};

TEST(StatedErrors, MorphTargetsAreReportedTruly) {
  Face face;
  const SourceFile file(face.d);
  const Reference reference(file.path);
  constexpr double kNoise = 600 * 2e-7;
  for (const cook::MeshCodec codec : {cook::MeshCodec::none, cook::MeshCodec::draco})
    for (const bool raw : {true, false}) {
      cook::CookOptions options;
      options.mesh.codec = codec;
      options.clips.raw = raw;
      const Cooked cooked(file.path, options);
      const std::uint32_t rest = cooked.file().clip_count();
      const double target = stated(cooked, "meshes", "max_target_error_m");
      const double position = stated(cooked, "meshes", "max_position_error_m");
      EXPECT_GT(target, 1e-3);
      for (const std::vector<float>& alone : {std::vector<float>{1, 0}, {0, 1}}) {
        const double real = farthest(reference.rest(alone), cooked.pose(rest, 0, Deformer::ssd, alone));
        EXPECT_LE(real, target + (codec == cook::MeshCodec::none ? 0 : position) + kNoise);
      }
      EXPECT_LE(rest_error(reference, cooked), position + (codec == cook::MeshCodec::none ? target : 0) + kNoise);
      const double real = clip_error(reference, cooked), said = stated(cooked, "clips", "max_vertex_error_m");
      EXPECT_GT(real, 1e-3);
      EXPECT_LE(real, said + (codec == cook::MeshCodec::none ? 0 : position) + kNoise) << raw;
      EXPECT_LE(said, 4 * real);
    }
}

// A body of three joints, of which the clip of 40 keys turns the second.
struct Swaying {
  Swaying() {
    joints = {d.node("a"), 0, 0};
    joints[1] = d.node("b", joints[0], {0, 1, 0});
    joints[2] = d.node("c", joints[1], {0, 1, 0});
    d.clip("sway");
    sway(d, joints[1], "rotation", 0.3F);
    skin(d, joints, 1);
  }
  // Another channel of the clip.
  void add(int node, const char* path, const char* interpolation, const std::vector<float>& times, int values) {
    Json& animation = d.b.root["animations"][0];
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back(
        {{"input", d.b.times(times)}, {"output", values}, {"interpolation", interpolation}});
  }
  cook::SceneDocument d;
  std::vector<int> joints;
};

cook::CookOptions clips_alone() {
  cook::CookOptions out;
  out.mesh.codec = cook::MeshCodec::none;
  return out;
}

// At these times of the first clip.
double farthest_at(const std::vector<float>& times_s, const Reference& reference, const Cooked& cooked) {
  double out = 0;
  for (const float time_s : times_s)
    out = std::max(out, farthest(reference.at(0, static_cast<double>(time_s)), cooked.pose(0, time_s, Deformer::ssd)));
  return out;
}

// A clip weighs two targets of ten metres by 7.5 each: what a joint's turn is off by counts fifteen times as far out as
// where one of them takes a vertex. The targets themselves are not rounded: all vertices go as far.
TEST(StatedErrors, ClipsAreMeasuredAsTheyWeighMorphTargets) {
  Swaying of;
  const float along = 10;
  for (int t = 0; t < 2; ++t) {
    std::vector<float> changes;
    for (int v = 0; v < 9; ++v) changes.insert(changes.end(), {along, 0, 0});
    of.d.b.root["meshes"][0]["primitives"][0]["targets"].push_back({{"POSITION", of.d.b.positions(changes)}});
  }
  const int body = static_cast<int>(of.d.b.root["nodes"].size()) - 1;
  of.add(body, "weights", "STEP", {0, 0.71F, 0.72F},
         of.d.b.numbers<float>(cook::kF32, "SCALAR", 1, {0, 0, 7.5F, 7.5F, 0, 0}));
  const SourceFile file(of.d);
  const Reference reference(file.path);
  cook::CookOptions options = clips_alone();
  options.clips.error.push_back({"", 0.1, false});
  const Cooked cooked(file.path, options);
  std::vector<float> times_s;
  for (int i = 0; i < 40; ++i) times_s.push_back(0.71F + 0.00025F * static_cast<float>(i));
  const double real = farthest_at(times_s, reference, cooked);
  const double said = stated(cooked, "clips", "max_vertex_error_m");
  EXPECT_GT(real, 0.005);
  EXPECT_LE(said, 0.1 + 15 * stated(cooked, "meshes", "max_target_error_m") + kFloats);
  EXPECT_LE(real, 1.1 * said + kFloats);
}

// A move of an arm in centimetres, its armature scaled to metres, for a character in metres: joints go where the move's
// own file takes them.
class OfAnotherUnit : public ::testing::Test {
 protected:
  OfAnotherUnit() {
    cook::SceneDocument d;
    skin(d, chain(d, d.node("armature"), 1), 1);
    character_file_ = std::make_unique<SourceFile>(d, "character");
    character_ = std::make_unique<Cooked>(character_file_->path, lossless());
  }
  // Cooked for the character.
  Cooked pack(const SourceFile& move) const {
    cook::CookOptions options;
    options.clips_only = true;
    options.mesh.codec = cook::MeshCodec::none;
    options.onto = std::make_shared<const cook::Character>(cook::read_character(character_file_->path));
    return Cooked(move.path, options);
  }
  static cook::SceneDocument move(const std::vector<float>& scale) {
    cook::SceneDocument d;
    const int armature = d.node("armature");
    node_of(d, armature)["scale"] = scale;
    const std::vector<int> joints = chain(d, armature, 100);
    sway(d, joints[0], "translation", 30);
    sway(d, joints[1], "translation", 10);
    return d;
  }

  std::unique_ptr<SourceFile> character_file_;
  std::unique_ptr<Cooked> character_;
};

TEST_F(OfAnotherUnit, MovesAreBroughtToTheCharactersScale) {
  cook::SceneDocument d = move({0.01F, 0.01F, 0.01F});
  const SourceFile file(d, "move");
  const Cooked moves = pack(file);
  EXPECT_TRUE(
      std::ranges::any_of(moves.report()["warnings"], [](const auto& w) { return w["rule"] == "unit-differs"; }));
  const Reference reference(file.path);
  const Skeleton skeleton = character_->file().skeleton(0);
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> scene(skeleton.joint_count);
  for (int i = 0; i < 30; ++i) {
    const float time_s = 0.0437F * static_cast<float>(i);
    ASSERT_EQ(sample(skeleton, moves.file().clip(0), time_s, local), Status::ok);
    ASSERT_EQ(local_to_model(skeleton, local, scene), Status::ok);
    const std::vector<Map> want = reference.nodes_at(0, static_cast<double>(time_s));
    for (std::size_t j = 0; j < 3; ++j)
      for (int r = 0; r < 3; ++r)
        EXPECT_NEAR(static_cast<double>(scene[j].rows[r][3]), want[j + 1].rows[r][3], 1.1e-4) << i << ' ' << j;
  }
}

TEST_F(OfAnotherUnit, UnevenScalesAndUnitsWithoutOneAreRefused) {
  cook::SceneDocument uneven = move({0.01F, 0.02F, 0.01F}), bare = move({1, 1, 1});
  const SourceFile uneven_file(uneven, "uneven"), bare_file(bare, "bare");
  cook::expect_failure([&] { pack(uneven_file); }, tools::Exit::invalid, "/nodes/1", "another scale above the joints");
  cook::expect_failure([&] { pack(bare_file); }, tools::Exit::invalid, "/nodes/2", "another unit");
}

}  // namespace
}  // namespace marrow::test
