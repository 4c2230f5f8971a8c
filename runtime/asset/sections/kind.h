// The kinds of sections.
#pragma once

#include <cstddef>
#include <cstdint>

namespace marrow::format {

inline constexpr std::uint32_t four_characters(const char (&s)[5]) {
  std::uint32_t type = 0;
  for (int i = 3; i >= 0; --i) type = type << 8 | static_cast<std::uint8_t>(s[i]);
  return type;
}

// Every kind of section, a line each, in the order of a file: the number that packed records have, which no later
// version may change; its name here; its type in the file; the header that describes it, void where load() does not
// look into it; the last codec that it may have. Every kind but names may occur any number of times.
#define MARROW_SECTION_KINDS(KIND)                 \
  KIND(0, kSkeletons, "SKEL", SkeletonHeader, 0)   \
  KIND(1, kReferences, "SREF", ReferenceHeader, 0) \
  KIND(2, kClips, "CLIP", ClipHeader, 1)           \
  KIND(3, kGeometries, "GEOM", GeometryHeader, 0)  \
  KIND(4, kMeshes, "MESH", MeshHeader, 0)          \
  KIND(5, kMaterials, "MATL", MaterialHeader, 0)   \
  KIND(6, kImages, "IMAG", ImageHeader, 0)         \
  KIND(7, kNodes, "NODE", NodeHeader, 0)           \
  KIND(9, kLimits, "LIMI", LimitHeader, 0)         \
  KIND(11, kSprings, "SPRI", SpringHeader, 0)      \
  KIND(13, kRoles, "ROLE", RoleHeader, 0)          \
  KIND(14, kMotions, "MOTN", MotionHeader, 0)      \
  KIND(15, kPoseMaps, "PMAP", PoseMapHeader, 0)    \
  KIND(12, kExamples, "SHAP", void, 0)             \
  KIND(16, kGraphs, "GRPH", void, 0)               \
  KIND(10, kBounds, "BNDS", BoundsHeader, 0)       \
  KIND(8, kNames, "NAME", void, 0)

enum Kind : std::uint32_t {
#define MARROW_KIND(number, name, type, header, last_codec) name = number,
  MARROW_SECTION_KINDS(MARROW_KIND)
#undef MARROW_KIND
};
#define MARROW_KIND(number, name, type, header, last_codec) +1
inline constexpr std::uint32_t kKindCount = 0 MARROW_SECTION_KINDS(MARROW_KIND);
#undef MARROW_KIND

// By kind.
struct SectionTypes {
  std::uint32_t of[kKindCount] = {};
  constexpr SectionTypes() {
#define MARROW_KIND(number, name, type, header, last_codec) of[number] = four_characters(type);
    MARROW_SECTION_KINDS(MARROW_KIND)
#undef MARROW_KIND
  }
  constexpr std::uint32_t operator[](std::size_t kind) const {
    return of[kind];
  }
};
inline constexpr SectionTypes kTypes;

}  // namespace marrow::format
