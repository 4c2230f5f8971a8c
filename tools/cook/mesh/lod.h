// Levels of detail: the mesh with fewer triangles, and with fewer joints a vertex.
#pragma once

#include <cstddef>
#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/skin/skin_binding.h"

namespace marrow::cook {

// A mesh at one level, as if the source had it so.
struct MeshLevel {
  std::vector<RawPrimitive> primitives;
  std::vector<std::vector<BoundVertex>> vertices;   // of each primitive; none without a skin
  std::vector<std::vector<std::uint32_t>> part_of;  // as SkinBinding's; none without a skin
  // Of the full mesh's vertices from the nearest of this level, over all clips; without clips over poses made up.
  double rms_error_m = 0, max_error_m = 0;
};

// One a rule. Every vertex is one of the mesh's own, so that what moves it, how it looks and its morph targets are as
// they were; joints are some of those that it had. Where a primitive is in parts, each part's triangles are its own at
// every level; a part that has lost them all keeps one without area. skin, binding: null for a mesh that hangs on a
// node. Notes where there are more triangles than a rule asks for.
std::vector<MeshLevel> make_levels(const RawMesh& mesh, const RawSkin* skin, const SkinBinding* binding,
                                   const BuiltScene& built, const std::vector<LodRule>& rules, Notes& notes);

}  // namespace marrow::cook
