// A kind of section that no file has: all that a new kind needs, but for its line in kind.h.
#pragma once

#include "asset/sections/fields.h"
#include "marrow/file.h"

namespace marrow::format {

// Points of a cloth that hang on a joint.
struct ClothHeader {
  std::uint32_t name;
  std::uint32_t skeleton;
  std::uint32_t point_count;
  std::uint16_t joint;
  std::uint16_t reserved;
};
static_assert(sizeof(ClothHeader) == 16);

struct ClothThread {
  std::uint16_t first, second;
  float length_m;
};

struct ClothLayout {
  Array<float> points;
  Array<std::uint16_t> pinned;
  Array<ClothThread> threads;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<ClothHeader> {
  using Type = ClothLayout;
};

template <class V>
constexpr void fields(V& v, const ClothHeader& h, ClothLayout& l) {
  v.name({"name", "offset into NAME"}, h.name);
  v.skeleton({"skeleton", "which SKEL section"}, h.skeleton);
  v.range({"point_count", "1 … 1000"}, h.point_count, 1u, 1000u, "1 to 1000 points");
  v.joint({"joint", "below the skeleton's joint_count"}, h.joint, "a joint outside the skeleton");
  v.reserved(h.reserved);
  v.array({"points", "x y z each, in the joint's space", "f32 × 3 × point_count"}, l.points, 3 * h.point_count,
          Floats::bounded);
  v.array({"pinned", "1: stays with the joint", "point_count"}, l.pinned, h.point_count);
  v.align();
  v.records({"threads", "each point to the next", "point_count"}, l.threads, h.point_count, [&](const ClothThread& t) {
    v.below({"first"}, t.first, h.point_count, "a thread of no point");
    v.below({"second"}, t.second, h.point_count, "a thread of no point");
    v.finite({"length_m", "≥ 0"}, t.length_m);
    v.not_negative({}, t.length_m, "a length is not negative");
  });
}

}  // namespace marrow::format
