// Characters in one piece.
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "marrow/outfit.h"
#include "support/golden.h"
#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

// A file with its animations, and a character of it.
struct Whole {
  explicit Whole(AlignedBlock (*copy)()) : block(copy()) {
    EXPECT_EQ(load(block, file), Status::ok);
    shared = std::make_unique<AlignedBlock>(animations_bytes(file, file));
    EXPECT_EQ(make_animations(file, file, *shared, animations), Status::ok);
    own = std::make_unique<AlignedBlock>(character_bytes(file, options));
    EXPECT_EQ(make_character(file, options, *own, character), Status::ok);
  }
  AlignedBlock block;
  File file;
  std::unique_ptr<AlignedBlock> shared, own;
  Animations animations;
  CharacterOptions options{.animation_space = true};
  Character character;
};

const Whole& face() {
  static const Whole made(golden_channels_copy);
  return made;
}
const Whole& dance() {
  static const Whole made(golden_coded_copy);
  return made;
}

CharacterOptions options_of(Misuse& m) {
  return {m.truth(true) ? 2u : m.index(2) % 4, m.index(0), m.truth(true), m.truth(true)};
}

const Animation* animation_of(Misuse& m, const Animations& own) {
  return m.pointer(m.either(&own.all[0], &dance().animations.all[0]));
}

std::size_t own_soa_size() {
  return face().file.skeleton(0).soa_size();
}

// Two layers, or more than there is room for.
std::vector<AnimationLayer> layers_of(Misuse& m, const Animations& own) {
  std::vector<AnimationLayer> layers(m.truth(true) ? 2 : 3);
  for (AnimationLayer& layer : layers) layer = {animation_of(m, own), m.number(0.3f), m.number(0.5f), {}};
  const std::vector<float> mask(4 * own_soa_size(), 0.5f);
  layers.back().mask = m.in(mask, Length::exact_or_none);
  return layers;
}

// Poses by weights and local transforms that the game may have set itself.
void misuse_poses(Misuse& m, Character& character) {
  for (CharacterMesh& mesh : character.meshes)
    for (float& weight : mesh.weights) weight = m.number(0.5f);
}

}  // namespace

std::vector<MisuseRow> rows_of_characters() {
  return {
      {"find_weight_channels",
       [](Misuse& m) {
         const File& file = face().file;
         const Span<std::uint32_t> out = m.out<std::uint32_t>(file.mesh(0).targets.size);
         m.returned(find_weight_channels(m.either(file, dance().file), m.either(file.mesh(0), Mesh{}), file,
                                         m.either(file.clip(0), dance().file.clip(0)), out));
       }},
      {"sample_channels",
       [](Misuse& m) {
         const Clip clip = m.either(face().file.clip(0), Clip{});
         const Span<float> out = m.out<float>(face().file.clip(0).channels.size);
         m.returned(sample_channels(clip, m.number(0.5f), out));
       }},
      {"animations_bytes",
       [](Misuse& m) {
         (void)animations_bytes(m.either(face().file, File{}), m.either(face().file, dance().file));
         m.returned_ok();
       }},
      {"make_animations",
       [](Misuse& m) {
         const File& file = m.either(face().file, dance().file);
         const File clips = m.either(file, face().file);
         Animations& out = m.one(Animations{});
         m.returned(make_animations(file, clips, m.memory(animations_bytes(file, clips)), out));
       }},
      {"find_animation",
       [](Misuse& m) {
         (void)find_animation(m.either(face().animations, Animations{}), m.pointer("no such"));
         m.returned_ok();
       }},
      {"clip_of",
       [](Misuse& m) {
         (void)clip_of(m.either(face().animations.all[0], Animation{}), m.index(0));
         m.returned_ok();
       }},
      {"character_bytes",
       [](Misuse& m) {
         (void)character_bytes(m.either(face().file, File{}), options_of(m));
         m.returned_ok();
       }},
      {"make_character",
       [](Misuse& m) {
         const CharacterOptions options = options_of(m);
         const File& file = m.either(face().file, dance().file);
         Character& out = m.one(Character{});
         m.returned(make_character(file, options, m.memory(character_bytes(file, options)), out));
       }},
      {"sample_character",
       [](Misuse& m) {
         Whole whole(golden_channels_copy);
         const std::vector<AnimationLayer> layers = layers_of(m, whole.animations);
         m.returned(sample_character(whole.character, layers));
       }},
      {"pose_character",
       [](Misuse& m) {
         Whole whole(golden_channels_copy);
         const std::vector<AnimationLayer> layers = layers_of(m, whole.animations);
         m.returned(pose_character(whole.character, layers));
       }},
      {"local_to_model",
       [](Misuse& m) {
         Whole whole(golden_channels_copy);
         Character none;
         m.never_refuses();
         m.returned(local_to_model(m.truth(true) ? whole.character : none));
       }},
      {"step_layer",
       [](Misuse& m) {
         Whole whole(golden_channels_copy);
         AnimationLayer& layer = m.one(AnimationLayer{m.pointer(&whole.animations.all[0])});
         m.returned(step_layer({.time_s = m.number(0.0f)}, {.time_s = m.number(0.1f)}, layer));
       }},
      {"character_root_step",
       [](Misuse& m) {
         Whole whole(golden_channels_copy);
         const std::vector<AnimationLayer> layers = layers_of(m, whole.animations);
         RigidStep& out = m.one(RigidStep{});
         m.returned(character_root_step(whole.character, layers, out));
       }},
      {"add_expression",
       [](Misuse& m) {
         Whole whole(golden_channels_copy);
         const std::vector<AnimationLayer> layers = layers_of(m, whole.animations);
         m.returned(add_expression(whole.character, layers.empty() ? AnimationLayer{} : layers.back()));
       }},
      {"finish_character",
       [](Misuse& m) {
         Whole whole(golden_channels_copy);
         misuse_poses(m, whole.character);
         m.returned(finish_character(whole.character));
       }},
      {"outfit_bytes",
       [](Misuse& m) {
         (void)outfit_bytes(m.either(face().file, File{}));
         m.returned_ok();
       }},
      {"make_outfit",
       [](Misuse& m) {
         const File& outfit = m.either(dance().file, face().file);
         Outfit& out = m.one(Outfit{});
         m.returned(make_outfit(m.either(dance().file, face().file), outfit, m.memory(outfit_bytes(outfit)), out));
       }},
      {"follow_body",
       [](Misuse& m) {
         Whole worn(golden_coded_copy);
         const Skeleton skeleton = worn.file.skeleton(0);
         std::vector<std::uint16_t> joints;
         for (std::uint16_t j = 0; j < skeleton.joint_count; ++j)
           joints.push_back(m.truth(false) ? kNoJoint : static_cast<std::uint16_t>(m.index(j)));
         if (m.round() % 2 == 0) {
           const OutfitSkeleton one{m.index(0), m.in(joints)};
           const Outfit outfit{{&one, m.truth(true) ? 1u : 0u}};
           m.returned(follow_body(outfit, m.either(dance().character, face().character), worn.character));
           return;
         }
         const Span<const Affine> body = dance().character.skeletons[0].pose.model_from_joint;
         const Span<const SoaTransform> local = dance().character.skeletons[0].pose.local;
         m.returned(follow_body(skeleton, m.in(joints), m.in(body), m.in(local), m.out<Affine>(skeleton.joint_count)));
       }},
  };
}

}  // namespace marrow::test
