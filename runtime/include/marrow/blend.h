// Blend: local poses of one skeleton → one local pose.
//
// Three functions, in the order in which a frame uses them: blend() averages, overlay() replaces parts, add() lays
// changes on top. All work on whole groups of four joints, allocate nothing and are thread-safe on different outputs.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// The largest weight of a layer; results stay far from the limits of float.
inline constexpr float kMaxBlendWeight = 1e6f;
// Where a joint's weights sum to less than this, its rest pose makes up the difference.
inline constexpr float kRestThreshold = 0.1f;

// A pose and how much of it.
struct BlendLayer {
  Span<const SoaTransform> pose = {};  // at least skeleton.soa_size()
  float weight = 1.0f;                 // 0 … kMaxBlendWeight in blend(), 0 … 1 in overlay()
  // A factor for each joint's weight, 0 … 1: below 0 and NaN count as 0, above 1 as 1. Empty: 1 for every joint;
  // else at least 4 · skeleton.soa_size() floats, in joint order, so that a group's factors are read at once.
  Span<const float> mask = {};
};

// out = Σ w x / Σ w for each joint, with w = weight · mask: translations and scales are averaged, rotations are summed
// as quaternions and normalised. Rotations must be unit quaternions; a sum in one hemisphere (see below) then never has
// length 0.
//
// Hemisphere: a layer's quaternion is negated where it points away from the sum of the layers before it. So two layers
// blend along the shorter arc, and no number of layers cancels out; the result's sign is arbitrary. Where Σ w is below
// `threshold`, the rest pose is added with the missing weight; so without layers the result is the rest pose. A single
// layer without a mask is copied bit for bit. Layers of weight 0 are not read. If no layer has a mask, and at most four
// layers have more than 1e-12 of the sum of weights (or of `threshold`, if that is greater), the other layers are not
// read either. The result is finite for poses with translations and scales up to 1e15.
//
// layers: any number; out: at least skeleton.soa_size(), and may be the pose of a layer. threshold: 1e-6 …
// kMaxBlendWeight.
// Errors: bad_argument if a span is too short, or a weight or the threshold is out of its range or not a number.
// Cost: 14 multiply-adds a layer and joint, a square root and a division, four joints at once.
MARROW_API Status blend(const Skeleton& skeleton, Span<const BlendLayer> layers, Span<SoaTransform> out,
                        float threshold = kRestThreshold);

// Replaces a part of `pose`: goes from pose to layer.pose by w = weight · mask, on the shorter arc. Where w is 0 the
// pose keeps its bits, where it is 1 it gets the layer's bits, whatever the other joints do.
// Errors: bad_argument if a span is too short, or the weight is not in 0 … 1.
MARROW_API Status overlay(const Skeleton& skeleton, const BlendLayer& layer, Span<SoaTransform> pose);

// The same with rotations in model space, so that a gun stays level while the hips below it sway: each joint's rotation
// in model space goes from the pose's to the layer's by w. Where w is 0 it stays, whatever the joints above do.
// Translations and scales are those of overlay(). The rotation of a joint in model space is here the product of those
// from its root down to it; scales have no part in it.
//
// scratch: at least skeleton.joint_count; what it holds is lost. Pose::model_from_joint serves before local_to_model().
// Errors: bad_argument if a span is too short, the weight is not in 0 … 1. Cost: that of
// overlay(), and about 150 operations a joint.
MARROW_API Status overlay_in_model_space(const Skeleton& skeleton, const BlendLayer& layer, Span<SoaTransform> pose,
                                         Span<Affine> scratch);

// Masks a joint and all that hangs on it, for layers that move a part of the body. Each of these joints gets its new
// value or keeps the one in the mask, whichever is greater; all other joints keep theirs. So several calls can build
// one mask: begin with zeros. falloff: over how many joints the mask grows. 0: `joint` has 1. 2: `joint` has 1/3, its
// children 2/3, and what is below those 1, so that a spine bends evenly into the layer.
//
// mask: at least 4 · skeleton.soa_size().
// Errors: bad_argument if `joint` is no joint or the mask is too short; nothing is written. Cost: for each joint with a
// higher index than `joint`, a walk up the hierarchy. Call it once a load.
MARROW_API Status mask_below(const Skeleton& skeleton, std::uint32_t joint, std::uint32_t falloff, Span<float> mask);

// A change, and how much of it.
struct AdditiveLayer {
  Span<const AdditiveTransform> change = {};  // at least skeleton.soa_size()
  float weight = 1.0f;                        // 0 … 1
  Span<const float> mask = {};                // as in BlendLayer
};

// out: the change from `reference` to `pose`: differences of translations, pose · reference⁻¹ of rotations, ratios of
// scales (1 where the reference is less than 1e-20). Rotations must be unit quaternions. For clips cooked as additive
// call sample_additive() instead: they hold their reference. Errors: bad_argument if a span is too short.
MARROW_API Status make_additive(const Skeleton& skeleton, Span<const SoaTransform> pose,
                                Span<const SoaTransform> reference, Span<AdditiveTransform> out);

// Adds the share w = weight · mask of a change to `pose`. Translation: + w Δ. Rotation: multiplied from the left by the
// normalised (1 - w) · identity + w · change. Scale: · (1 + w (ratio - 1)). Where w is 0 the pose keeps its bits.
// Errors: bad_argument if a span is too short, or the weight is not in 0 … 1.
MARROW_API Status add(const Skeleton& skeleton, const AdditiveLayer& layer, Span<SoaTransform> pose);

}  // namespace marrow
