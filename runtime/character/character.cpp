// The stages of marrow.h, called in their order for every skeleton and mesh of a file.
#include "marrow/character.h"

#include <cstring>

#include "character/layer_rules.h"
#include "character/sample_animation.h"
#include "core/check.h"
#include "core/memory.h"
#include "core/off_boundary.h"
#include "core/zone.h"
#include "marrow/local_to_model.h"
#include "marrow/palette.h"
#include "marrow/sample.h"
#include "marrow/skin.h"
#include "math/finite.h"
#include "pose/fits.h"
#include "pose/sample_coded.h"
#include "pose/sample_state.h"

namespace marrow {
namespace {

// Frames are kept of clips that turn all joints, and move or scale the joints of a few groups.
constexpr std::size_t kOtherPairs = 4;

// For each layer a pose, and what sample_cached() keeps.
void take_layers(std::uint32_t layers, Memory& memory, CharacterSkeleton& s) {
  const std::size_t size = s.pose.skeleton.soa_size();
  s.sampled = memory.take<SoaTransform>(std::uint64_t{layers} * size);
  s.caches = memory.take<SampleCache>(layers);
  const Span<FramePair> pairs = memory.take<FramePair>(std::uint64_t{layers} * (size + kOtherPairs));
  if (pairs.empty()) return;  // it is only counted
  for (std::uint32_t i = 0; i < layers; ++i) {
    SampleCache cache;
    cache.memory = {reinterpret_cast<std::byte*>(pairs.data + i * (size + kOtherPairs)),
                    (size + kOtherPairs) * sizeof(FramePair)};
    s.caches[i] = cache;
  }
}

void take_skeletons(const File& file, const CharacterOptions& options, Memory& memory, Character& out) {
  out.skeletons = memory.take<CharacterSkeleton>(file.skeleton_count());
  std::size_t largest = 0;
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s) {
    const Skeleton skeleton = file.skeleton(s);
    const std::size_t size = skeleton.soa_size();
    CharacterSkeleton made;
    made.pose.skeleton = skeleton;
    made.pose.local = memory.take<SoaTransform>(size);
    made.pose.model_from_joint = memory.take<Affine>(skeleton.joint_count);
    take_layers(options.layers, memory, made);
    if (size > largest) largest = size;
    if (!out.skeletons.empty()) out.skeletons[s] = made;
  }
  out.blended = memory.take<BlendLayer>(options.layers);
  out.change = memory.take<AdditiveTransform>(largest);
}

void take_meshes(const File& file, const CharacterOptions& options, Memory& memory, Character& out) {
  out.meshes = memory.take<CharacterMesh>(file.mesh_count());
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    CharacterMesh made;
    made.mesh = file.mesh(m, options.level);
    made.first_target = out.target_count;
    out.target_count += static_cast<std::uint32_t>(file.mesh(m).targets.size);
    made.weights = memory.take<float>(made.mesh.targets.size);
    if (options.skin) {
      made.palette = memory.take<Affine>(made.mesh.palette_size());
      if (options.animation_space) made.coordinates = memory.take<float>(as_coordinate_count(made.mesh.geometry));
      made.vertices = memory.take<std::byte>(morphed_bytes(made.mesh.geometry));
    }
    if (!out.meshes.empty()) out.meshes[m] = made;
  }
}

void lay_out(const File& file, const CharacterOptions& options, Memory& memory, Character& out) {
  take_skeletons(file, options, memory, out);
  take_meshes(file, options, memory, out);
}

Status make_vertices(CharacterMesh& m) {
  const Geometry bind = m.mesh.geometry;
  Status status = make_morphed(bind, m.vertices, m.morphed);
  if (status == Status::ok && !m.coordinates.empty()) status = as_coordinates(bind, m.coordinates);
  m.mesh.geometry = m.morphed.geometry;
  return status;
}

// first_joint: where the skeleton begins in masks.
Status sample_skeleton(Character& c, std::uint32_t index, std::size_t first_joint, Span<const AnimationLayer> layers) {
  const CharacterSkeleton& s = c.skeletons[index];
  const Skeleton& skeleton = s.pose.skeleton;
  const std::size_t size = skeleton.soa_size();
  std::size_t averaged = 0, over = layers.size;  // those from the front, these from the back
  for (std::size_t i = 0; i < layers.size; ++i) {
    const AnimationLayer& layer = layers[i];
    const Span<SoaTransform> sampled(s.sampled.data + i * size, size);
    BlendLayer& blended = c.blended[layer.mask.empty() ? averaged++ : --over];
    blended = {sampled, layer.weight, {}};
    if (!layer.mask.empty()) blended.mask = {layer.mask.data + first_joint, 4 * size};
    if (layer.weight == 0.0f) continue;  // nobody reads it
    const Status status =
        sample_animation(skeleton, *layer.animation, layer.time_s, index, c.change, sampled, s.caches[i]);
    if (status != Status::ok) return status;
  }
  Status status = blend(skeleton, {c.blended.data, averaged}, s.pose.local);
  for (std::size_t i = layers.size; i-- > averaged && status == Status::ok;)
    status = overlay(skeleton, c.blended[i], s.pose.local);
  return status;
}

// Means by the rule of blend(): defaults join in below the threshold.
Status sample_weights(Span<const AnimationLayer> layers, CharacterMesh& m) {
  float total = 0;
  for (const AnimationLayer& layer : layers) total += layer.mask.empty() ? layer.weight : 0;
  const float rest = total < kRestThreshold ? kRestThreshold - total : 0.0f;
  for (std::size_t t = 0; t < m.weights.size; ++t) m.weights[t] = rest / (total + rest) * m.mesh.targets[t].weight;
  for (const AnimationLayer& layer : layers) {
    if (layer.weight == 0.0f || !layer.mask.empty()) continue;
    const Status status = add_weights(*layer.animation, layer.time_s, layer.weight / (total + rest), m);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

BadCall check_animation(const Character& c, const Animation* animation) {
  MARROW_CHECK(animation != nullptr);
  MARROW_CHECK(animation->clip_of_skeleton.size == c.skeletons.size);
  MARROW_CHECK(animation->channels.size == c.target_count);
  for (std::size_t s = 0; s < c.skeletons.size; ++s) {
    const std::uint32_t clip = animation->clip_of_skeleton[s];
    if (clip == kNoClip) continue;
    MARROW_CHECK(clip < animation->clips.clip_count());
    MARROW_CHECK(fits(animation->clips.clip(clip), c.skeletons[s].pose.skeleton));
  }
  for (const CharacterMesh& m : c.meshes) {
    const std::uint32_t clip = animation->clip_of_skeleton[m.mesh.skeleton];
    if (clip == kNoClip || m.weights.empty()) continue;
    const std::size_t channels = animation->clips.clip(clip).channels.size;
    for (std::size_t t = 0; t < m.weights.size; ++t) {
      const std::uint32_t channel = animation->channels[m.first_target + t];
      MARROW_CHECK(channel == kNoChannel || channel < channels);
    }
  }
  return {};
}

// Of all skeletons, each up to a multiple of four.
std::size_t masked_joints(const Character& c) {
  std::size_t joints = 0;
  for (const CharacterSkeleton& s : c.skeletons) joints += 4 * s.pose.skeleton.soa_size();
  return joints;
}

Status sample_layers(Character& character, Span<const AnimationLayer> layers) {
  std::size_t first_joint = 0;
  for (std::uint32_t s = 0; s < character.skeletons.size; ++s) {
    const Status status = sample_skeleton(character, s, first_joint, layers);
    if (status != Status::ok) return status;
    first_joint += 4 * character.skeletons[s].pose.skeleton.soa_size();
  }
  for (CharacterMesh& m : character.meshes) {
    const Status status = sample_weights(layers, m);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

}  // namespace

BadCall check_layer(const Character& c, const AnimationLayer& layer) {
  MARROW_CHECK(within(layer.weight, 0.0f, layer.mask.empty() ? kMaxBlendWeight : 1.0f));
  MARROW_CHECK(layer.mask.empty() || holds(layer.mask, masked_joints(c)));
  MARROW_CHECK(layer.weight == 0 || layer.time_s == layer.time_s);  // else it is not read
  return check_animation(c, layer.animation);
}

BadCall check_layers(const Character& c, Span<const AnimationLayer> layers) {
  MARROW_CHECK(holds(layers) && layers.size <= c.options.layers);
  for (const AnimationLayer& layer : layers)
    if (const BadCall bad = check_layer(c, layer)) return bad;
  return {};
}

std::size_t character_bytes(const File& file, const CharacterOptions& options) {
  Memory counted;
  Character unused;
  lay_out(file, options, counted, unused);
  return counted.whole();
}

Status make_character(const File& file, const CharacterOptions& options, Span<std::byte> memory, Character& out) {
  MARROW_ZONE;
  MARROW_REQUIRE(options.layers > 0);
  MARROW_REQUIRE(holds(memory, character_bytes(file, options)));
  MARROW_REQUIRE_GOOD(check_boundary(memory.data));
  Memory taken{memory.data};
  Character made;
  made.file = file;
  made.options = options;
  lay_out(file, options, taken, made);
  for (CharacterMesh& m : made.meshes) {
    const Status status = options.skin ? make_vertices(m) : Status::ok;
    if (status != Status::ok) return status;
  }
  Status status = pose_character(made, {});
  if (status == Status::ok) status = finish_character(made);
  if (status == Status::ok) out = made;
  return status;
}

Status sample_character(Character& character, Span<const AnimationLayer> layers) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_layers(character, layers));
  return sample_layers(character, layers);
}

Status local_to_model(Character& character) {
  MARROW_ZONE;
  for (const CharacterSkeleton& s : character.skeletons) {
    const Status status = local_to_model(s.pose.skeleton, s.pose.local, s.pose.model_from_joint);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

Status pose_character(Character& character, Span<const AnimationLayer> layers) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_layers(character, layers));
  const Status status = sample_layers(character, layers);
  return status == Status::ok ? local_to_model(character) : status;
}

Status add_expression(Character& character, const AnimationLayer& expression) {
  MARROW_REQUIRE_GOOD(check_layer(character, expression));
  for (CharacterMesh& m : character.meshes) {
    if (expression.weight == 0.0f) break;
    const Status status = for_each_weight(
        *expression.animation, expression.time_s, m, true,
        [&](std::size_t t, float weight, float rest) { m.weights[t] += expression.weight * (weight - rest); });
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

Status finish_character(Character& character) {
  MARROW_ZONE;
  if (!character.options.skin) return Status::ok;
  for (const CharacterMesh& m : character.meshes) MARROW_REQUIRE(all_finite(m.weights.data, m.weights.size));
  for (CharacterMesh& m : character.meshes) {
    Status status = build_palette(m.mesh, character.skeletons[m.mesh.skeleton].pose.model_from_joint, m.palette);
    if (status == Status::ok && !m.weights.empty()) status = morph(m.weights, m.morphed);
    if (status == Status::ok && !m.coordinates.empty()) status = morph_coordinates(m.morphed, m.coordinates);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

}  // namespace marrow
