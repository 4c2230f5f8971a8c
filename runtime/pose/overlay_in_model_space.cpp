// A layer whose rotations are those of model space. (M. Gregory, Game Engine Architecture, 3rd edition, section 12.6.)
#include <cstring>

#include "core/check.h"
#include "core/zone.h"
#include "marrow/blend.h"
#include "math/finite.h"
#include "math/joint.h"
#include "math/quaternion.h"

namespace marrow {
namespace {

// Of a joint in model space: of the pose, of the layer, and what they come to.
struct ModelRotations {
  float pose[4], layer[4], made[4];
};
static_assert(sizeof(ModelRotations) == sizeof(Affine));

float factor(const BlendLayer& layer, std::size_t joint) {
  if (layer.mask.empty()) return layer.weight;
  const float m = layer.mask[joint];
  return layer.weight * (!(m > 0) ? 0.0f : m < 1 ? m : 1.0f);
}

Rotation mixed(const Rotation& from, const Rotation& to, float w) {
  if (w == 0) return from;
  const Rotation q = from * (1.0f - w) + to * (dot(from, to) < 0 ? -w : w);
  return q * (1.0f / square_root(dot(q, q)));
}

bool turns(const ModelRotations& joint) {
  return std::memcmp(joint.pose, joint.made, sizeof joint.made) != 0;
}

}  // namespace

Status overlay_in_model_space(const Skeleton& skeleton, const BlendLayer& layer, Span<SoaTransform> pose,
                              Span<Affine> scratch) {
  MARROW_ZONE;
  const std::size_t groups = skeleton.soa_size(), joints = skeleton.joint_count;
  MARROW_REQUIRE(holds(pose, groups));
  MARROW_REQUIRE(holds(layer.pose, groups));
  MARROW_REQUIRE(within(layer.weight, 0.0f, 1.0f));
  MARROW_REQUIRE(layer.mask.empty() || holds(layer.mask, 4 * groups));
  MARROW_REQUIRE(holds(scratch, joints));
  const auto of = [&](std::size_t joint) -> ModelRotations& {
    return reinterpret_cast<ModelRotations*>(scratch.data)[joint];
  };
  for (std::size_t j = 0; j < joints; ++j) {
    Rotation base = rotation_of(pose, j), over = rotation_of(layer.pose, j);
    if (skeleton.parents[j] != kNoJoint) {
      const ModelRotations& parent = of(skeleton.parents[j]);
      base = rotation(parent.pose) * base;
      over = rotation(parent.layer) * over;
    }
    store(of(j).pose, base);
    store(of(j).layer, over);
    store(of(j).made, mixed(base, over, factor(layer, j)));
  }
  const Status status = overlay(skeleton, layer, pose);
  for (std::size_t j = 0; j < joints && status == Status::ok; ++j) {
    const bool is_root = skeleton.parents[j] == kNoJoint;
    if (factor(layer, j) == 0 && (is_root || !turns(of(skeleton.parents[j])))) continue;  // it keeps its bits
    Rotation local = rotation(of(j).made);
    if (!is_root) local = conjugate(rotation(of(skeleton.parents[j]).made)) * local;
    set_rotation(pose, j, local * (1.0f / square_root(dot(local, local))));
  }
  return status;
}

}  // namespace marrow
