// NODE: a node of the source that is kept although it is no joint.
#pragma once

#include "asset/sections/fields.h"
#include "marrow/file.h"

namespace marrow::format {

struct NodeHeader {
  std::uint32_t name;
  std::uint32_t skeleton;
  std::uint32_t property_count;
  std::uint16_t joint;
  std::uint16_t reserved;
  Affine joint_from_node;
};
static_assert(sizeof(NodeHeader) == 64);

struct NodeLayout {
  Array<Property> properties;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<NodeHeader> {
  using Type = NodeLayout;
};

template <class V>
constexpr void fields(V& v, const Property& p) {
  v.text({"name", "offset into NAME; of nested ones the keys with `/` between them, escaped as in a JSON pointer"},
         p.name);
  v.range({"type", "0 number, 1 boolean, 2 text"}, p.type, PropertyType::number, PropertyType::text,
          "unknown type of a property");
  v.reserved(p.reserved);
  v.any({"number", "finite; of a boolean 0 or 1"}, p.number);
  v.any({"text", "instead of the number: offset into NAME; the four bytes behind it are 0"}, p.text);
}

template <class V>
constexpr void fields(V& v, const NodeHeader& h, NodeLayout& l) {
  v.name({"name", "offset into NAME"}, h.name);
  v.skeleton({"skeleton", "which SKEL section"}, h.skeleton);
  v.any({"property_count"}, h.property_count);
  if (h.joint != kNoJoint)
    v.joint({"joint", "below the skeleton's joint_count: the nearest at or above the node; 65535: none"}, h.joint,
            "a joint outside the skeleton");
  v.reserved(h.reserved);
  v.bounded({"joint_from_node", "affine map; without a joint model_from_node"}, h.joint_from_node);
  v.records({"properties", "", "property_count"}, l.properties, h.property_count,
            [&](const Property& p) { fields(v, p); });
}

}  // namespace marrow::format
