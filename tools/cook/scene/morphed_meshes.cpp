#include "cook/scene/morphed_meshes.h"

#include <algorithm>
#include <bit>

#include <glm/geometric.hpp>

#include "cook/scene/views.h"

namespace marrow::cook {
namespace {

// How far a target takes a vertex at weight 1, in the mesh's units.
double reach_of(const Geometry& g, const MorphTarget& target) {
  if ((target.attributes & kMorphsPositions) == 0) return 0;
  const std::size_t attributes = static_cast<std::size_t>(std::popcount(target.attributes));
  double longest = 0;
  for (std::size_t b = 0; b < target.block_count; ++b) {
    const std::int16_t* const record = g.target_records + 12 * (target.first_record + b * attributes);
    for (int lane = 0; lane < 4; ++lane)
      longest = std::max(longest, glm::length(glm::dvec3(record[lane], record[lane + 4], record[lane + 8])));
  }
  return longest * static_cast<double>(target.position_step);
}

}  // namespace

std::vector<MorphedMesh> morphed_meshes(const File& file) {
  std::vector<MorphedMesh> out;
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    const Mesh mesh = file.mesh(i);
    if (mesh.targets.empty()) continue;
    MorphedMesh& morphed = out.emplace_back(MorphedMesh{mesh, {}});
    for (std::size_t t = 0; t < mesh.targets.size; ++t)
      morphed.targets.push_back({file.text(mesh.targets[t].channel), static_cast<double>(mesh.targets[t].weight),
                                 reach_of(mesh.geometry, mesh.geometry.targets[t]), 0});
  }
  return out;
}

std::vector<MorphedMesh> morphed_meshes(const std::vector<BuiltMesh>& meshes,
                                        const std::vector<BuiltGeometry>& geometries) {
  std::vector<MorphedMesh> out;
  for (const BuiltMesh& built : meshes) {
    if (built.targets.empty()) continue;
    const BuiltGeometry& geometry = geometries[built.geometry];
    MorphedMesh& morphed = out.emplace_back(MorphedMesh{view(built, geometry), {}});
    const Geometry& g = morphed.mesh.geometry;
    for (std::size_t t = 0; t < built.targets.size(); ++t)
      morphed.targets.push_back({built.targets[t].channel, static_cast<double>(built.targets[t].rest),
                                 reach_of(g, g.targets[t]), geometry.error.targets[t]});
  }
  return out;
}

}  // namespace marrow::cook
