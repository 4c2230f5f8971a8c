// MESH: a geometry bound to joints.
#pragma once

#include "asset/sections/fields.h"
#include "asset/sections/kind.h"
#include "marrow/file.h"

namespace marrow::format {

enum MeshFlags : std::uint32_t { kDoubleSided = 1, kNextPart = 2, kHelpersHaveCentres = 4, kAllMeshFlags = 7 };

struct MeshHeader {
  std::uint32_t name;
  std::uint32_t material;
  std::uint32_t skeleton;
  std::uint32_t geometry;
  std::uint32_t joint_count;
  std::uint8_t flags;
  std::uint8_t lod_count;
  std::uint16_t helper_count;
  float base_colour[4];
  std::uint32_t target_count;
  std::uint32_t material_section;
};
static_assert(sizeof(MeshHeader) == 48);

inline constexpr std::uint64_t kCentreBytes = 3 * sizeof(float);

struct MeshLayout {
  Array<Affine> inverse_bind;
  Array<MeshTarget> targets;
  Array<std::uint16_t> joints;
  Array<Helper> helpers;
  Array<float> centres;
  Array<MeshLod> lods;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<MeshHeader> {
  using Type = MeshLayout;
};

inline constexpr const char* kNoGeometry = "no such geometry";

template <class V>
constexpr void fields(V& v, const MeshTarget& t) {
  v.name({"name"}, t.name);
  v.name({"channel"}, t.channel);
  v.finite({"weight"}, t.weight);
}

template <class V>
constexpr void fields(V& v, const Helper& h, std::uint32_t joint_count) {
  constexpr const char* kNoHelper = "a helper blends two joints of the mesh";
  v.below({"first"}, h.first, joint_count, kNoHelper);
  v.below({"second"}, h.second, joint_count, kNoHelper);
  v.inside({"share"}, h.share, 0.0f, 1.0f, kNoHelper);
}

template <class V>
constexpr void fields(V& v, const MeshLod& l) {
  v.section({"geometry"}, l.geometry, kGeometries, kNoGeometry);
  v.finite({"error_m"}, l.error_m);
  v.not_negative({}, l.error_m, "an error is not below 0");
}

template <class V>
constexpr void fields(V& v, const MeshHeader& h, MeshLayout& l) {
  v.name({"name", "offset into NAME"}, h.name);
  v.name({"material", "offset into NAME"}, h.material);
  v.skeleton({"skeleton", "which SKEL section"}, h.skeleton);
  v.section({"geometry", "which GEOM section; meshes may share one"}, h.geometry, kGeometries, kNoGeometry);
  v.range({"joint_count", "≥ 1; with helper_count the geometry's"}, h.joint_count, 1u, UINT32_MAX,
          "as many palette entries as the geometry");
  v.flags({"flags", "1 double-sided, 2 next part, 4 helpers have centres"}, h.flags, kAllMeshFlags, "unknown flag");
  v.any({"lod_count", "levels of detail beside the full mesh"}, h.lod_count);
  v.any({"helper_count", "≥ 1 with flag 4"}, h.helper_count);
  v.finite({"base_colour", "linear RGBA"}, h.base_colour);
  v.any({"target_count", "the geometry's; 0 without"}, h.target_count);
  v.range({"material_section", "0: the material has none; else 1 + which MATL section"}, h.material_section, 0u,
          v.count_of(kMaterials), "no such material");
  v.array({"inverse_bind", "affine map: joint_from_mesh in the bind pose", "joint_count"}, l.inverse_bind,
          h.joint_count, Floats::bounded);
  v.records({"targets", "u32 name and u32 channel, offsets into NAME, f32 weight", "target_count"}, l.targets,
            h.target_count, [&](const MeshTarget& t) { fields(v, t); });
  v.array({"joints", "palette entry → joint of the skeleton", "joint_count"}, l.joints, h.joint_count);
  if (h.helper_count != 0 || h.lod_count != 0) v.align();
  v.records({"helpers",
             "on a boundary of four bytes: u16 first, u16 second, palette entries below joint_count that differ; f32 "
             "share of the second, above 0 and below 1",
             "helper_count"},
            l.helpers, h.helper_count, [&](const Helper& helper) { fields(v, helper, h.joint_count); });
  v.array({"centres", "flag 4: a place a helper, as its second joint sees it", "3 × helper_count"}, l.centres,
          (h.flags & kHelpersHaveCentres) != 0 ? 3u * h.helper_count : 0u, Floats::bounded);
  v.records(
      {"lods",
       "on a boundary of four bytes, level 1 first: u32 geometry, which GEOM section, with the mesh's palette and "
       "its morph targets or none; f32 error_m, ≥ 0",
       "lod_count"},
      l.lods, h.lod_count, [&](const MeshLod& lod) { fields(v, lod); });
}

}  // namespace marrow::format
