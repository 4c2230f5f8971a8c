// The two forms of a pose that stages hand on: local transforms in groups of four joints, and model-space matrices.
#pragma once

#include <cstddef>
#include <cstdint>

#include "marrow/api.h"
#include "marrow/span.h"
#include "marrow/status.h"

namespace marrow {

// Local transforms (parent_from_joint = translate · rotate · scale) of four consecutive joints, one lane a joint.
// Rotations are unit quaternions. Lanes past the last joint hold the identity.
struct alignas(16) SoaTransform {
  float translation[3][4];  // x, y, z; metres
  float rotation[4][4];     // x, y, z, w
  float scale[3][4];        // x, y, z
};
static_assert(sizeof(SoaTransform) == 160);

// The change from one pose to another, not a pose: a type of its own, so that one is not taken for the other.
// translation: difference; rotation: of the parent's axes, w ≥ 0; scale: ratio.
struct AdditiveTransform {
  SoaTransform change;  // of four joints
};
static_assert(sizeof(AdditiveTransform) == sizeof(SoaTransform));

// An affine map, three rows of four: out = rows · (x, y, z, 1). What palettes and files hold: 48 bytes a joint.
struct alignas(16) Affine {
  float rows[3][4];  // the last column is the translation
};
static_assert(sizeof(Affine) == 48);

// How many elements of SoaTransform hold a pose of `joint_count` joints.
constexpr std::size_t soa_count(std::size_t joint_count) {
  return (joint_count + 3) / 4;
}

// The local transform of one joint.
struct JointTransform {
  float translation[3] = {0, 0, 0};  // metres
  float rotation[4] = {0, 0, 0, 1};  // a unit quaternion x, y, z, w
  float scale[3] = {1, 1, 1};        // along the joint's axes
};

// Reads and sets the transform of joint `joint` in a local pose; for a few joints a frame. What is set goes in as it
// is. Errors: bad_argument if the joint is beyond the pose; nothing is written.
MARROW_API Status get_joint(Span<const SoaTransform> local, std::uint32_t joint, JointTransform& out);
MARROW_API Status set_joint(Span<SoaTransform> local, std::uint32_t joint, const JointTransform& transform);

}  // namespace marrow
