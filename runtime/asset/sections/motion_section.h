// LIMI: how far the joints of a skeleton may turn. SPRI: its spring bones. BNDS: what its meshes reach in its clips.
#pragma once

#include "asset/sections/fields.h"
#include "asset/sections/kind.h"
#include "asset/spring_rules.h"
#include "marrow/file.h"

namespace marrow::format {

inline constexpr const char* kOutside = "a joint outside the skeleton";

struct LimitHeader {
  std::uint32_t skeleton;
  std::uint32_t limit_count;
};
static_assert(sizeof(LimitHeader) == 8);

struct LimitLayout {
  Array<JointLimit> limits;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<LimitHeader> {
  using Type = LimitLayout;
};

// is_valid() of file.h has the other rules.
template <class V>
constexpr void fields(V& v, const JointLimit& l) {
  v.joint({"joint", "below the skeleton's joint_count"}, l.joint, kOutside);
  v.any({"kind", "0 none, 1 hinge, 2 cone, 3 euler"}, l.kind);
  v.any({"order", "0 xyz, 1 xzy, 2 yxz, 3 yzx, 4 zxy, 5 zyx; 0 but for euler"}, l.order);
  v.any({"limit_from_parent", "unit quaternion x, y, z, w"}, l.limit_from_parent);
  v.any({"joint_from_limit", "unit quaternion"}, l.joint_from_limit);
  v.any({"angles",
         "middle, −1 … 1, and half_width, 0 … 1, as tangents of a quarter of the angle; what the kind does not use is "
         "0: of none all, of a hinge the second and third, of a cone the middles of those. A cone's second and third "
         "half_width are at most tan(170° / 4); euler's second angle is within ±90°"},
        l.angles);
  v.any({"speed", "radians a second, 0 … 10¹⁸; 0: any"}, l.rate.speed);
  v.any({"acceleration", "radians per second squared, 0 … 10¹⁸; 0: any"}, l.rate.acceleration);
}

template <class V>
constexpr void fields(V& v, const LimitHeader& h, LimitLayout& l) {
  v.only_of_skeleton({"skeleton", "which SKEL section"}, h.skeleton,
                     "one section of limits a skeleton, in their order");
  v.range({"limit_count", "≥ 1"}, h.limit_count, 1u, UINT32_MAX, "a section of limits without one");
  v.records({"limits", "ascending strictly by joint", "limit_count"}, l.limits, h.limit_count,
            [&](const JointLimit& limit) { fields(v, limit); });
}

struct SpringHeader {
  std::uint32_t skeleton;
  std::uint32_t chain_count;
  std::uint32_t joint_count;
  std::uint32_t collider_count;
};
static_assert(sizeof(SpringHeader) == 16);

struct SpringRecord {
  std::uint64_t colliders;  // as in SpringChain
  std::uint32_t first_joint;
  std::uint32_t joint_count;
  float tip[3];
  std::uint32_t reserved;
};
static_assert(sizeof(SpringRecord) == 32);

// How many joints a bone may pass over, so that the way up to the joint before it has a bound.
inline constexpr std::uint32_t kLongestSpringBone = 255;

struct SpringLayout {
  Array<SpringRecord> chains;
  Array<SpringJoint> joints;
  Array<SpringCollider> colliders;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<SpringHeader> {
  using Type = SpringLayout;
};

template <class V>
constexpr void fields(V& v, const SpringRecord& r) {
  v.any({"colliders", "bit *i*, lowest first: it stays out of collider *i*; none from collider_count on"}, r.colliders);
  v.any({"first_joint", "joints of the chains before it"}, r.first_joint);
  v.any({"joint_count", "≥ 1; with a tip of 0 ≥ 2"}, r.joint_count);
  v.near(
      {"tip",
       "where the last joint's bone ends, in that joint's space, each within ±10⁶; 0: that joint only ends the chain"},
      r.tip, kFarthestSpringPoint_m, "a tip that is not finite, or beyond 1e6");
  v.reserved(r.reserved);
}

// good_settings() of asset/spring_rules.h has the rules.
template <class V>
constexpr void fields(V& v, const SpringJoint& j) {
  v.any({"joint", "below the skeleton's joint_count"}, j.joint);
  v.any({"most_pull", "1/s²; 0: without a limit"}, j.most_pull);
  v.any({"frequency_hz", "0 … 15"}, j.frequency_hz);
  v.any({"damping_ratio", "0 … 1.5"}, j.damping_ratio);
  v.any({"gravity", "−10 … 10"}, j.gravity);
  v.any({"drag", "0 … 50, 1/s"}, j.drag);
  v.any({"radius_m", "0 … 10⁶"}, j.radius_m);
  v.any({"weight", "0 … 1"}, j.weight);
}

template <class V>
constexpr void fields(V& v, const SpringCollider& c) {
  constexpr const char* kNotNear = "a collider that is not finite, or beyond 1e6";
  v.joint({"joint", "below the skeleton's joint_count"}, c.joint, kOutside);
  v.reserved(c.reserved);
  v.near({"from", "in the joint's space, each within ±10⁶"}, c.from, kFarthestSpringPoint_m, kNotNear);
  v.near({"to", "as `from`, and the same for a sphere"}, c.to, kFarthestSpringPoint_m, kNotNear);
  v.within({"radius_m", "0 … 10⁶"}, c.radius_m, 0.0f, kFarthestSpringPoint_m, kNotNear);
}

template <class V>
constexpr void fields(V& v, const SpringHeader& h, SpringLayout& l) {
  v.only_of_skeleton({"skeleton", "which SKEL section"}, h.skeleton,
                     "one section of springs a skeleton, in their order");
  v.range({"chain_count", "≥ 1"}, h.chain_count, 1u, UINT32_MAX, "a section of springs without a chain");
  v.range({"joint_count", "of all chains; at most the skeleton's"}, h.joint_count, 0u, v.joint_count(),
          "more joints than the skeleton has");
  v.range({"collider_count", "0 … 64"}, h.collider_count, 0u, kMaxSpringColliders, "at most 64 colliders");
  v.records({"chains", "", "chain_count"}, l.chains, h.chain_count, [&](const SpringRecord& r) { fields(v, r); });
  v.records({"joints", "chain by chain", "joint_count"}, l.joints, h.joint_count,
            [&](const SpringJoint& j) { fields(v, j); });
  v.records({"colliders", "", "collider_count"}, l.colliders, h.collider_count,
            [&](const SpringCollider& c) { fields(v, c); });
}

// Of clips and meshes of the skeleton, in their order.
struct BoundsHeader {
  std::uint32_t skeleton;
  std::uint32_t clip_count;
  std::uint32_t mesh_count;
};
static_assert(sizeof(BoundsHeader) == 12);

// What a mesh reaches in a clip: integers times 2^exponent. The sphere is about the box's centre.
struct BoundsCodes {
  std::int8_t exponent;
  std::int8_t box_min[3];
  std::int8_t box_max[3];
  std::uint8_t radius;
};
static_assert(sizeof(BoundsCodes) == 8);
inline constexpr int kLeastBoundsExponent = -100, kMostBoundsExponent = 100;

struct BoundsLayout {
  Array<BoundsCodes> codes;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<BoundsHeader> {
  using Type = BoundsLayout;
};

template <class V>
constexpr void fields(V& v, const BoundsCodes& c) {
  v.any({"exponent", "−100 … 100"}, c.exponent);
  v.any({"box_min"}, c.box_min);
  v.any({"box_max", "≥ box_min"}, c.box_max);
  v.any({"radius"}, c.radius);
}

template <class V>
constexpr void fields(V& v, const BoundsHeader& h, BoundsLayout& l) {
  v.only_of_skeleton({"skeleton", "which SKEL section"}, h.skeleton,
                     "one section of bounds a skeleton, in their order");
  v.range({"clip_count", "1 … as many as CLIP sections"}, h.clip_count, 1u, v.count_of(kClips),
          "1 to as many as clips");
  v.range({"mesh_count", "1 … as many as MESH sections"}, h.mesh_count, 1u, v.count_of(kMeshes),
          "1 to as many as meshes");
  v.records({"bounds", "clip by clip, in each mesh by mesh: of the clips and meshes of the skeleton, in their order",
             "clip_count × mesh_count"},
            l.codes, std::uint64_t{h.clip_count} * h.mesh_count, [&](const BoundsCodes& c) { fields(v, c); });
}

}  // namespace marrow::format
