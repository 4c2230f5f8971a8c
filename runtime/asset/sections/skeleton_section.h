// SKEL: a skeleton. SREF: what a clip pack says of the skeleton that its clips were made for.
#pragma once

#include "asset/sections/fields.h"
#include "marrow/file.h"

namespace marrow::format {

struct SkeletonHeader {
  std::uint32_t name;
  std::uint32_t joint_count;
  std::uint32_t root_count;
  std::uint32_t reserved;
};
static_assert(sizeof(SkeletonHeader) == 16);

struct SkeletonLayout {
  Array<Affine> roots;
  Array<SoaTransform> rest;
  Array<std::uint32_t> names;
  Array<std::uint16_t> parents;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<SkeletonHeader> {
  using Type = SkeletonLayout;
};

template <class V>
constexpr void fields(V& v, const SkeletonHeader& h, SkeletonLayout& l) {
  v.name({"name", "offset into NAME"}, h.name);
  v.range({"joint_count", "1 … 32767"}, h.joint_count, 1u, kMaxJoints, "1 to 32767 joints");
  v.range({"root_count", "1 … joint_count"}, h.root_count, 1u, h.joint_count, "1 root to as many as joints");
  v.reserved(h.reserved);
  v.array({"model_from_root", "affine map: the product of all nodes above the root", "root_count"}, l.roots,
          h.root_count, Floats::bounded);
  v.array({"rest", "four joints' transforms, see below", "⌈joint_count / 4⌉"}, l.rest, soa_count(h.joint_count));
  v.array({"names", "offsets into NAME", "joint_count"}, l.names, h.joint_count);
  v.array({"parents", "65535 for joints below root_count, else less than the joint's own number and never descending",
           "joint_count"},
          l.parents, h.joint_count);
}

struct ReferenceHeader {
  std::uint32_t name;
  std::uint32_t joint_count;
  std::uint64_t hash;
};
static_assert(sizeof(ReferenceHeader) == 16);
static_assert(offsetof(SkeletonHeader, joint_count) == offsetof(ReferenceHeader, joint_count));

struct ReferenceLayout {
  Array<std::uint32_t> names, rest_hashes;
  Array<std::uint16_t> parents;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<ReferenceHeader> {
  using Type = ReferenceLayout;
};

template <class V>
constexpr void fields(V& v, const ReferenceHeader& h, ReferenceLayout& l) {
  v.name({"name", "of the skeleton; offset into NAME"}, h.name);
  v.range({"joint_count", "1 … 32767"}, h.joint_count, 1u, kMaxJoints, "1 to 32767 joints");
  v.any({"hash", "of all joints, see below"}, h.hash);
  v.array({"names", "offsets into NAME", "joint_count"}, l.names, h.joint_count);
  v.array({"rest_hashes", "of each joint's rest pose", "joint_count"}, l.rest_hashes, h.joint_count);
  v.array({"parents", "as SKEL's: at least one root, roots first, else breadth-first", "joint_count"}, l.parents,
          h.joint_count);
}

}  // namespace marrow::format
