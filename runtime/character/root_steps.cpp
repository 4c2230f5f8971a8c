// How layers of animations move their character.
#include "character/layer_rules.h"
#include "core/check.h"
#include "marrow/character.h"
#include "marrow/roles.h"
#include "motion/motion_rules.h"

namespace marrow {
namespace {

// Where the hips of an animation's motion stand in masks; without hips its first joint.
std::size_t hips_in_masks(const Character& c, std::uint32_t skeleton) {
  if (skeleton >= c.skeletons.size) skeleton = 0;
  const std::uint16_t hips = joint_of(c.file.roles(skeleton), Role::hips);
  std::size_t first = 0;
  for (std::uint32_t s = 0; s < skeleton; ++s) first += 4 * c.skeletons[s].pose.skeleton.soa_size();
  return hips == kNoJoint ? first : first + hips;
}

// What a mask leaves of a layer at the hips. Factors are as BlendLayer says.
float share_of(const Character& c, const AnimationLayer& layer) {
  const float factor = layer.mask[hips_in_masks(c, layer.animation->motion_skeleton)];
  return layer.weight * (!(factor > 0) ? 0 : factor < 1 ? factor : 1);
}

Status mix(const RigidStep& step, float weight, float whole, RigidStep& into) {
  const RigidStep steps[] = {into, step};
  const float weights[] = {whole, weight};
  return blend_root_steps(steps, weights, into);
}

}  // namespace

Status step_layer(const Playback& before, const Playback& after, AnimationLayer& layer) {
  MARROW_REQUIRE(layer.animation != nullptr);
  MARROW_REQUIRE(holds(layer.animation->motion.root));
  MARROW_REQUIRE_GOOD(check_step(layer.animation->motion, before, after));
  RigidStep step;
  const Status status = root_step(layer.animation->motion, before, after, step);
  if (status != Status::ok) return status;
  layer.time_s = clip_time(after);
  layer.step = step;
  return Status::ok;
}

Status character_root_step(const Character& character, Span<const AnimationLayer> layers, RigidStep& out) {
  MARROW_REQUIRE_GOOD(check_layers(character, layers));
  RigidStep made;
  float whole = 0;
  for (const AnimationLayer& layer : layers) {
    if (!layer.mask.empty() || layer.weight == 0.0f) continue;
    const Status status = mix(layer.step, layer.weight, whole < kMaxBlendWeight ? whole : kMaxBlendWeight, made);
    if (status != Status::ok) return status;
    whole += layer.weight;
  }
  for (const AnimationLayer& layer : layers) {
    const float share = layer.mask.empty() ? 0 : share_of(character, layer);
    const Status status = share > 0 ? mix(layer.step, share, 1 - share, made) : Status::ok;
    if (status != Status::ok) return status;
  }
  out = made;
  return Status::ok;
}

}  // namespace marrow
