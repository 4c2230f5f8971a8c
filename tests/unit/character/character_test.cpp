// A character in one piece is what the stages make of it, called one by one.
#include "marrow/character.h"

#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/marrow.h"
#include "support/aligned.h"
#include "support/allocations.h"
#include "support/bad_numbers.h"
#include "support/golden.h"
#include "support/pose_file.h"

namespace marrow {
namespace {

using test::AlignedBlock;
using test::kNan;

// A loaded file with its animations and a character of it, each in memory of exactly the size asked for.
struct Loaded {
  explicit Loaded(AlignedBlock (*copy)(), const CharacterOptions& options = {.layers = 3, .animation_space = true})
      : block(copy()) {
    EXPECT_EQ(load(block, file), Status::ok);
    shared = std::make_unique<AlignedBlock>(animations_bytes(file, file));
    EXPECT_EQ(make_animations(file, file, *shared, animations), Status::ok);
    own = std::make_unique<AlignedBlock>(character_bytes(file, options));
    EXPECT_EQ(make_character(file, options, *own, character), Status::ok);
  }
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;

  AnimationLayer layer(const char* name, float time_s, float weight = 1) const {
    return {find_animation(animations, name), time_s, weight};
  }
  Status play(Span<const AnimationLayer> layers) {
    const Status status = pose_character(character, layers);
    return status == Status::ok ? finish_character(character) : status;
  }

  AlignedBlock block;
  File file;
  std::unique_ptr<AlignedBlock> shared, own;
  Animations animations;
  Character character;
};

struct Golden {
  const char* name;
  AlignedBlock (*copy)();
};
constexpr Golden kGolden[] = {{"tiny", test::golden_copy},
                              {"dance", test::golden_coded_copy},
                              {"face", test::golden_channels_copy},
                              {"stride", test::golden_uneven_copy},
                              {"elbow", test::golden_half_joint_copy},
                              {"centres", test::golden_centres_copy},
                              {"looks", test::golden_looks_copy},
                              {"lod", test::golden_lod_copy},
                              {"limits", test::golden_limits_copy}};

test::PosedMesh skin(const CharacterMesh& m, test::Deformer deformer) {
  const Geometry& g = m.mesh.geometry;
  test::PosedMesh out;
  out.positions.resize(std::size_t{g.slot_count} * 3);
  if (g.normals != nullptr) out.normals.resize(out.positions.size());
  if (g.normals != nullptr && g.tangents != nullptr) out.tangents.resize(std::size_t{g.slot_count} * 4);
  const SkinOutput to{out.positions, out.normals, out.tangents};
  EXPECT_EQ(deformer == test::Deformer::rigid ? skin_rigid(m.mesh, m.palette, to)
            : deformer == test::Deformer::ssd ? skin_ssd(m.mesh, m.palette, to)
                                              : skin_as(m.mesh, m.coordinates, m.palette, to),
            Status::ok);
  return out;
}

template <class T>
bool same_bits(const T* a, const T* b, std::size_t count) {
  return count == 0 || std::memcmp(a, b, count * sizeof(T)) == 0;
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && same_bits(a.data(), b.data(), a.size());
}

void expect_as_by_hand(const Loaded& l, std::uint32_t clip, float time_s, const std::string& where) {
  for (std::uint32_t m = 0; m < l.file.mesh_count(); ++m) {
    for (const auto deformer : {test::Deformer::rigid, test::Deformer::ssd, test::Deformer::as}) {
      const test::PosedMesh want = test::pose_mesh(l.file, clip, time_s, m, deformer);
      const test::PosedMesh got = skin(l.character.meshes[m], deformer);
      EXPECT_TRUE(same_bits(got.positions, want.positions)) << where << " mesh " << m;
      EXPECT_TRUE(same_bits(got.normals, want.normals)) << where << " mesh " << m;
      EXPECT_TRUE(same_bits(got.tangents, want.tangents)) << where << " mesh " << m;
    }
  }
}

TEST(Character, IsWhatTheStagesMakeOfIt) {
  for (const Golden& golden : kGolden) {
    Loaded l(golden.copy);
    expect_as_by_hand(l, l.file.clip_count(), 0, std::string(golden.name) + " as made");
    ASSERT_EQ(l.animations.all.size, l.file.clip_count());
    for (std::uint32_t c = 0; c < l.file.clip_count(); ++c) {
      EXPECT_EQ(l.animations.all[c].duration_s, l.file.clip(c).duration_s);
      if (l.file.clip(c).additive) continue;  // pose_mesh() lays them on the rest pose
      for (const float part : {1.0f, 0.4f, 0.0f}) {
        const float time_s = part * l.file.clip(c).duration_s;
        const AnimationLayer layer{&l.animations.all[c], time_s, 1};
        ASSERT_EQ(l.play({&layer, 1}), Status::ok);
        expect_as_by_hand(l, c, time_s, std::string(golden.name) + " clip " + std::to_string(c));
      }
    }
    ASSERT_EQ(l.play({}), Status::ok);
    expect_as_by_hand(l, l.file.clip_count(), 0, std::string(golden.name) + " at rest again");
  }
}

TEST(Character, LaysAdditiveClipsOnTheirReferenceAndMorphs) {
  Loaded l(test::golden_channels_copy);
  const Clip clip = l.file.clip(0);
  ASSERT_TRUE(clip.additive);
  ASSERT_NE(clip.reference, nullptr);
  const Skeleton skeleton = l.file.skeleton(0);
  std::vector<SoaTransform> want(clip.reference, clip.reference + skeleton.soa_size());
  std::vector<AdditiveTransform> change(want.size());
  ASSERT_EQ(sample_additive(skeleton, clip, 0.7f, change), Status::ok);
  ASSERT_EQ(add(skeleton, {change, 1.0f, {}}, want), Status::ok);
  const AnimationLayer layer{&l.animations.all[0], 0.7f, 1};
  ASSERT_EQ(l.play({&layer, 1}), Status::ok);
  EXPECT_TRUE(same_bits(l.character.skeletons[0].pose.local.data, want.data(), want.size()));

  std::vector<float> values(clip.channels.size);
  ASSERT_EQ(sample_channels(clip, 0.7f, values), Status::ok);
  for (std::uint32_t i = 0; i < l.file.mesh_count(); ++i) {
    const CharacterMesh& m = l.character.meshes[i];
    ASSERT_EQ(m.weights.size, 2u);
    AlignedBlock memory(morphed_bytes(l.file.mesh(i).geometry));
    MorphedGeometry morphed;
    ASSERT_EQ(make_morphed(l.file.mesh(i).geometry, memory, morphed), Status::ok);
    std::vector<float> weights;
    for (const MeshTarget& target : m.mesh.targets)
      weights.push_back(values[l.file.find_channel(clip, l.file.text(target.channel))]);
    EXPECT_TRUE(same_bits(m.weights.data, weights.data(), weights.size()));
    ASSERT_EQ(morph(weights, morphed), Status::ok);
    const std::size_t floats = 3 * std::size_t{m.mesh.geometry.slot_count};
    EXPECT_TRUE(same_bits(m.mesh.geometry.normals, morphed.geometry.normals, floats));
    std::vector<float> coordinates(m.coordinates.size);
    ASSERT_EQ(as_coordinates(morphed.geometry, coordinates), Status::ok);
    EXPECT_TRUE(same_bits(m.coordinates.data, coordinates.data(), coordinates.size()));
  }
}

TEST(Character, BlendsLayersAsBlendDoes) {
  Loaded l(test::golden_copy);
  const Skeleton skeleton = l.file.skeleton(0);
  std::vector<SoaTransform> wave(skeleton.soa_size()), point(wave.size()), want(wave.size());
  ASSERT_EQ(sample(skeleton, l.file.clip(l.file.find_clip("wave")), 0.3f, wave), Status::ok);
  ASSERT_EQ(sample(skeleton, l.file.clip(l.file.find_clip("point")), 0, point), Status::ok);
  const BlendLayer poses[] = {{wave, 0.25f, {}}, {point, 0.5f, {}}};
  ASSERT_EQ(blend(skeleton, {poses, 2}, want), Status::ok);
  // A layer of weight 0 is not looked at, whatever its time is.
  const AnimationLayer layers[] = {l.layer("wave", 0.3f, 0.25f), l.layer("point", kNan, 0), l.layer("point", 0, 0.5f)};
  ASSERT_EQ(l.play({layers, 3}), Status::ok);
  EXPECT_TRUE(same_bits(l.character.skeletons[0].pose.local.data, want.data(), want.size()));
}

// Layers with masks over the mean of those without, in their order, whatever stands between.
TEST(Character, LaysMaskedLayersOver) {
  Loaded l(test::golden_copy);
  const Skeleton skeleton = l.file.skeleton(0);
  std::vector<SoaTransform> wave(skeleton.soa_size()), point(wave.size()), want(wave.size());
  std::vector<float> some(4 * skeleton.soa_size()), all(some.size(), 1.0f);
  for (std::size_t j = 0; j < some.size(); ++j) some[j] = j % 2 == 0 ? 0.75f : 0.0f;
  ASSERT_EQ(sample(skeleton, l.file.clip(l.file.find_clip("wave")), 0.3f, wave), Status::ok);
  ASSERT_EQ(sample(skeleton, l.file.clip(l.file.find_clip("point")), 0, point), Status::ok);
  std::memcpy(want.data(), point.data(), point.size() * sizeof(SoaTransform));
  ASSERT_EQ(overlay(skeleton, {wave, 0.5f, all}, want), Status::ok);
  ASSERT_EQ(overlay(skeleton, {point, 1, some}, want), Status::ok);
  AnimationLayer half = l.layer("wave", 0.3f, 0.5f), over = l.layer("point", 0);
  half.mask = all;
  over.mask = some;
  ASSERT_EQ(l.play({half, l.layer("point", 0), over}), Status::ok);
  EXPECT_TRUE(same_bits(l.character.skeletons[0].pose.local.data, want.data(), want.size()));
  // Alone it lies over the rest pose.
  std::memcpy(want.data(), skeleton.rest, want.size() * sizeof(SoaTransform));
  ASSERT_EQ(overlay(skeleton, {point, 1, some}, want), Status::ok);
  ASSERT_EQ(l.play({&over, 1}), Status::ok);
  EXPECT_TRUE(same_bits(l.character.skeletons[0].pose.local.data, want.data(), want.size()));
  over.mask = {some.data(), some.size() - 1};
  EXPECT_EQ(l.play({&over, 1}), Status::bad_argument);
  over.mask = some;
  over.weight = 1.5f;
  EXPECT_EQ(l.play({&over, 1}), Status::bad_argument);
}

// Two skeletons of one kind: a mask of the second alone.
TEST(Character, MasksGoSkeletonAfterSkeleton) {
  Loaded first(test::golden_copy), second(test::golden_copy);
  CharacterSkeleton both[] = {first.character.skeletons[0], second.character.skeletons[0]};
  Character pair = first.character;
  pair.skeletons = both;
  pair.meshes = {};
  pair.target_count = 0;
  const std::uint32_t wave = first.file.find_clip("wave"), point = first.file.find_clip("point");
  const std::uint32_t waves[] = {wave, wave}, points[] = {point, point};
  const Animation waving{"", first.file, 1, waves, {}}, pointing{"", first.file, 1, points, {}};
  const Skeleton skeleton = first.file.skeleton(0);
  std::vector<float> mask(8 * skeleton.soa_size(), 0.0f);
  std::fill(mask.begin() + static_cast<std::ptrdiff_t>(mask.size() / 2), mask.end(), 1.0f);
  ASSERT_EQ(sample_character(pair, {{&waving, 0.3f}, {&pointing, 0, 1, mask}}), Status::ok);
  std::vector<SoaTransform> want(skeleton.soa_size());
  ASSERT_EQ(sample(skeleton, first.file.clip(wave), 0.3f, want), Status::ok);
  EXPECT_TRUE(same_bits(both[0].pose.local.data, want.data(), want.size()));
  ASSERT_EQ(sample(skeleton, first.file.clip(point), 0, want), Status::ok);
  EXPECT_TRUE(same_bits(both[1].pose.local.data, want.data(), want.size()));
  EXPECT_EQ(sample_character(pair, {{&pointing, 0, 1, {mask.data(), mask.size() - 1}}}), Status::bad_argument);
}

TEST(Character, MaskedLayersLeaveMorphTargetsAlone) {
  Loaded l(test::golden_channels_copy);
  const std::vector<float> all(4 * l.file.skeleton(0).soa_size(), 1.0f);
  AnimationLayer early = l.layer("speak", 0.2f, 0.5f), late = l.layer("speak", 0.7f);
  ASSERT_EQ(l.play({&early, 1}), Status::ok);
  const Span<float> weights = l.character.meshes[0].weights;
  const std::vector<float> before(weights.begin(), weights.end());
  late.mask = all;
  ASSERT_EQ(l.play({early, late}), Status::ok);
  EXPECT_EQ(std::vector<float>(weights.begin(), weights.end()), before);
}

TEST(Character, BlendsWeightsOfMorphTargets) {
  Loaded l(test::golden_channels_copy);
  const AnimationLayer early = l.layer("speak", 0.2f), late = l.layer("speak", 0.7f);
  ASSERT_GT(l.character.target_count, 0u);
  for (std::uint32_t m = 0; m < l.file.mesh_count(); ++m) {
    const Span<float> weights = l.character.meshes[m].weights;
    ASSERT_EQ(l.play({&early, 1}), Status::ok);
    const std::vector<float> a(weights.begin(), weights.end());
    ASSERT_EQ(l.play({&late, 1}), Status::ok);
    const std::vector<float> b(weights.begin(), weights.end());
    const AnimationLayer both[] = {l.layer("speak", 0.2f, 3), l.layer("speak", 0.7f, 1)};
    ASSERT_EQ(l.play({both, 2}), Status::ok);
    const AnimationLayer faint = l.layer("speak", 0.2f, 0.025f);
    for (std::size_t t = 0; t < weights.size; ++t) EXPECT_NEAR(weights[t], 0.75f * a[t] + 0.25f * b[t], 1e-6f);
    ASSERT_EQ(l.play({&faint, 1}), Status::ok);
    for (std::size_t t = 0; t < weights.size; ++t)  // a quarter of kRestThreshold
      EXPECT_NEAR(weights[t], 0.25f * a[t] + 0.75f * l.file.mesh(m).targets[t].weight, 1e-6f);
  }
}

TEST(Character, ExpressionsAreAddedToTheWeights) {
  Loaded l(test::golden_channels_copy);
  ASSERT_EQ(l.play({}), Status::ok);
  const AnimationLayer speak = l.layer("speak", 0.7f, 0.5f);
  const Span<float> weights = l.character.meshes[0].weights;
  const std::vector<float> before(weights.begin(), weights.end());
  ASSERT_EQ(add_expression(l.character, speak), Status::ok);
  ASSERT_EQ(add_expression(l.character, speak), Status::ok);
  const std::vector<float> after(weights.begin(), weights.end());
  const AnimationLayer whole = l.layer("speak", 0.7f, 1);
  ASSERT_EQ(l.play({&whole, 1}), Status::ok);
  float moved = 0;
  for (std::size_t t = 0; t < weights.size; ++t) {
    EXPECT_NEAR(after[t], weights[t], 1e-6f) << "twice a half";
    moved = std::max(moved, std::fabs(after[t] - before[t]));
  }
  EXPECT_GT(moved, 0.1f);
  EXPECT_EQ(add_expression(l.character, {nullptr, 0, 1}), Status::bad_argument);
  EXPECT_EQ(add_expression(l.character, {speak.animation, kNan, 1}), Status::bad_argument);
  EXPECT_EQ(add_expression(l.character, {speak.animation, 0, -1}), Status::bad_argument);
}

TEST(Character, IsFinishedWithWhatTheGameDidToItsJoints) {
  Loaded l(test::golden_coded_copy);
  const AnimationLayer dance{&l.animations.all[0], 0.5f, 1};
  ASSERT_EQ(pose_character(l.character, {&dance, 1}), Status::ok);
  const Pose& pose = l.character.skeletons[0].pose;
  std::vector<SoaTransform> local(pose.local.begin(), pose.local.end());
  std::vector<Affine> model(pose.model_from_joint.begin(), pose.model_from_joint.end());
  TwoBone reach;
  for (int c = 0; c < 3; ++c) reach.target[c] = 0.5f * (model[1].rows[c][3] + model[3].rows[c][3]);
  ASSERT_EQ(solve_two_bone({pose.skeleton, local, model}, {1, 2, 3}, reach), Status::ok);
  ASSERT_EQ(solve_two_bone(pose, {1, 2, 3}, reach), Status::ok);
  ASSERT_EQ(finish_character(l.character), Status::ok);
  const CharacterMesh& m = l.character.meshes[0];
  std::vector<Affine> palette(m.palette.size);
  ASSERT_EQ(build_palette(l.file.mesh(0), model, palette), Status::ok);
  EXPECT_TRUE(same_bits(m.palette.data, palette.data(), palette.size()));
}

TEST(Character, TakesLocalPosesFromAnyone) {
  Loaded l(test::golden_copy), other(test::golden_copy);
  const AnimationLayer wave = other.layer("wave", 0.7f);
  ASSERT_EQ(other.play({&wave, 1}), Status::ok);
  const Pose& to = l.character.skeletons[0].pose;
  const Pose& from = other.character.skeletons[0].pose;
  std::copy(from.local.begin(), from.local.end(), to.local.begin());
  ASSERT_EQ(local_to_model(l.character), Status::ok);
  ASSERT_EQ(finish_character(l.character), Status::ok);
  expect_as_by_hand(l, l.file.find_clip("wave"), 0.7f, "a copied pose");
}

TEST(Character, HasTheLevelAskedForAndNoVerticesUnlessWanted) {
  Loaded coarse(test::golden_lod_copy, {.level = 1, .animation_space = true});
  for (std::uint32_t m = 0; m < coarse.file.mesh_count(); ++m) {
    const Mesh want = coarse.file.mesh(m, 1);
    EXPECT_EQ(coarse.character.meshes[m].mesh.geometry.slot_count, want.geometry.slot_count);
    EXPECT_EQ(coarse.character.meshes[m].palette.size, want.palette_size());
  }
  EXPECT_LT(coarse.file.mesh(0, 1).geometry.slot_count, coarse.file.mesh(0).geometry.slot_count);

  Loaded bare(test::golden_channels_copy, {.skin = false, .animation_space = true}), whole(test::golden_channels_copy);
  EXPECT_LT(bare.own->size(), whole.own->size());
  const AnimationLayer to_bare = bare.layer("speak", 0.7f), to_whole = whole.layer("speak", 0.7f);
  ASSERT_EQ(bare.play({&to_bare, 1}), Status::ok);
  ASSERT_EQ(whole.play({&to_whole, 1}), Status::ok);
  for (std::uint32_t m = 0; m < bare.file.mesh_count(); ++m) {
    const CharacterMesh &a = bare.character.meshes[m], &b = whole.character.meshes[m];
    EXPECT_TRUE(a.palette.empty() && a.coordinates.empty());
    ASSERT_EQ(a.weights.size, b.weights.size);
    EXPECT_TRUE(same_bits(a.weights.data, b.weights.data, a.weights.size));
    EXPECT_EQ(a.mesh.geometry.skin, bare.file.mesh(m).geometry.skin) << "the file's own vertices";
  }
}

TEST(Character, PlaysClipsOfAPack) {
  Loaded l(test::golden_coded_copy);
  const AlignedBlock pack_block = test::golden_pack_copy();
  File pack;
  ASSERT_EQ(load(pack_block, pack), Status::ok);
  AlignedBlock memory(animations_bytes(l.file, pack));
  Animations from_pack;
  ASSERT_EQ(make_animations(l.file, pack, memory, from_pack), Status::ok);
  ASSERT_EQ(from_pack.all.size, pack.clip_count());
  const char* const name = pack.clip(0).name;
  const AnimationLayer layer{find_animation(from_pack, name), 0.9f, 1};
  ASSERT_NE(layer.animation, nullptr);
  ASSERT_EQ(l.play({&layer, 1}), Status::ok);
  expect_as_by_hand(l, l.file.find_clip(name), 0.9f, "of a pack");

  const Loaded stranger(test::golden_copy);
  AlignedBlock others(animations_bytes(stranger.file, pack));
  Animations none;
  EXPECT_EQ(make_animations(stranger.file, pack, others, none), Status::mismatch) << "fits no skeleton";
  AlignedBlock more(animations_bytes(stranger.file, l.file));
  EXPECT_EQ(make_animations(stranger.file, l.file, more, none), Status::mismatch) << "no pack";
  EXPECT_TRUE(none.all.empty());
}

// What is kept of a clip in a layer is not, once something else was played there.
TEST(Character, PlaysAClipAgainAfterAnotherPoseInItsLayer) {
  Loaded l(test::golden_coded_copy), fresh(test::golden_coded_copy);
  const Animation& dance = l.animations.all[0];
  ASSERT_GT(l.file.clip(0).coded.constant_count, 0u);  // joints that stand still, but not as at rest
  Animation rest = dance;
  const std::uint32_t none[] = {kNoClip};
  rest.clip_of_skeleton = none;
  ASSERT_EQ(l.play({{&dance, 0.3f}}), Status::ok);
  ASSERT_EQ(l.play({{&rest, 0}}), Status::ok);
  ASSERT_EQ(l.play({{&dance, 0.3f}}), Status::ok);
  ASSERT_EQ(fresh.play({{&fresh.animations.all[0], 0.3f}}), Status::ok);
  const Span<SoaTransform> got = l.character.skeletons[0].pose.local, want = fresh.character.skeletons[0].pose.local;
  EXPECT_TRUE(same_bits(got.data, want.data, want.size));
}

TEST(Character, FindsAnimationsByName) {
  const Loaded l(test::golden_copy);
  EXPECT_EQ(find_animation(l.animations, "point"), &l.animations.all[l.file.find_clip("point")]);
  EXPECT_STREQ(find_animation(l.animations, "point")->name, "point");
  EXPECT_STREQ(clip_of(*find_animation(l.animations, "point"), 0).name, "point");
  EXPECT_STREQ(clip_of(*find_animation(l.animations, "point"), 1).name, "");
  EXPECT_EQ(find_animation(l.animations, "sleep"), nullptr);
  EXPECT_EQ(find_animation({}, "point"), nullptr);
  Animation unnamed = l.animations.all[0];  // as C has one that it cleared
  unnamed.name = nullptr;
  EXPECT_EQ(find_animation({{&unnamed, 1}}, "point"), nullptr);
}

TEST(Character, RefusesMemoryThatDoesNotDo) {
  const AlignedBlock block = test::golden_channels_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  const CharacterOptions options{.animation_space = true};
  const std::size_t bytes = character_bytes(file, options), shared = animations_bytes(file, file);
  AlignedBlock memory(bytes + 16), animations_memory(shared + 16);
  Character character;
  Animations animations;
  EXPECT_EQ(make_character(file, options, {memory.data(), bytes - 1}, character), Status::bad_argument);
  EXPECT_EQ(make_character(file, options, {memory.data() + 4, bytes}, character), Status::bad_argument);
  EXPECT_EQ(make_character(file, options, {}, character), Status::bad_argument);
  CharacterOptions no_layers = options;
  no_layers.layers = 0;
  EXPECT_EQ(make_character(file, no_layers, {memory.data(), bytes}, character), Status::bad_argument);
  EXPECT_TRUE(character.skeletons.empty());
  EXPECT_EQ(make_animations(file, file, {animations_memory.data(), shared - 1}, animations), Status::bad_argument);
  EXPECT_EQ(make_animations(file, file, {animations_memory.data() + 4, shared}, animations), Status::bad_argument);
  EXPECT_TRUE(animations.all.empty());
}

TEST(Character, WritesWithinItsMemory) {
  for (const Golden& golden : kGolden) {
    const AlignedBlock block = golden.copy();
    File file;
    ASSERT_EQ(load(block, file), Status::ok);
    const CharacterOptions options{.layers = 5, .animation_space = true};
    const std::size_t bytes = character_bytes(file, options), shared = animations_bytes(file, file);
    std::vector<SoaTransform> fives((bytes + shared) / sizeof(SoaTransform) + 2);
    std::memset(fives.data(), 5, fives.size() * sizeof(SoaTransform));
    auto* const first = reinterpret_cast<std::byte*>(fives.data());
    Animations animations;
    Character character;
    ASSERT_EQ(make_character(file, options, {first, bytes}, character), Status::ok);
    for (std::size_t i = 0; i < shared; ++i) ASSERT_EQ(first[bytes + i], std::byte{5}) << golden.name;
    const AlignedBlock elsewhere(shared);
    ASSERT_EQ(make_animations(file, file, {const_cast<std::byte*>(elsewhere.data()), shared}, animations), Status::ok);
    std::vector<AnimationLayer> layers;
    if (!animations.all.empty()) layers.assign(5, {&animations.all[0], 0.3f, 1});
    ASSERT_EQ(pose_character(character, layers), Status::ok);
    ASSERT_EQ(finish_character(character), Status::ok);
    for (std::size_t i = 0; i < shared; ++i) ASSERT_EQ(first[bytes + i], std::byte{5}) << golden.name;
  }
}

TEST(Character, RefusesBadLayers) {
  Loaded l(test::golden_channels_copy, {.layers = 1});
  const AnimationLayer good = l.layer("speak", 0.5f);
  const AnimationLayer two[] = {good, good};
  EXPECT_EQ(l.play({two, 2}), Status::bad_argument) << "more than it has room for";
  const auto refused = [&](const AnimationLayer& layer) { return l.play({&layer, 1}) == Status::bad_argument; };
  EXPECT_TRUE(refused(l.layer("sing", 0)));
  EXPECT_TRUE(refused({good.animation, kNan, 1}));
  EXPECT_TRUE(refused({good.animation, 0, -1}));
  EXPECT_TRUE(refused({good.animation, 0, kNan}));
  Animation wrong = *good.animation;
  wrong.clip_of_skeleton.size -= 1;
  EXPECT_TRUE(refused({&wrong, 0, 1})) << "of a character with fewer skeletons";
  wrong = *good.animation;
  wrong.channels.size -= 1;
  EXPECT_TRUE(refused({&wrong, 0, 1})) << "of a character with fewer morph targets";
  const std::vector<std::uint32_t> beyond(good.animation->clip_of_skeleton.size, l.file.clip_count());
  wrong = *good.animation;
  wrong.clip_of_skeleton = beyond;
  EXPECT_TRUE(refused({&wrong, 0, 1})) << "no such clip";
  const std::vector<std::uint32_t> channels(good.animation->channels.size, 1000);
  wrong = *good.animation;
  wrong.channels = channels;
  EXPECT_TRUE(refused({&wrong, 0, 1})) << "no such channel";
  EXPECT_EQ(l.play({&good, 1}), Status::ok);
  l.character.meshes[0].weights[0] = kNan;
  EXPECT_EQ(finish_character(l.character), Status::bad_argument);
}

TEST(Character, AThousandFramesAllocateNothing) {
  Loaded l(test::golden_channels_copy);
  int failures = 0;
  const std::size_t before = test::allocation_count();
  for (int frame = 0; frame < 1000; ++frame) {
    const float time_s = static_cast<float>(frame) / 1000;
    const AnimationLayer layers[] = {l.layer("speak", time_s, 0.5f), l.layer("speak", 1 - time_s, 0.5f)};
    failures += l.play({layers, 2}) != Status::ok;
  }
  EXPECT_EQ(test::allocation_count() - before, 0u);
  EXPECT_EQ(failures, 0);
}

}  // namespace
}  // namespace marrow
