// What a skinned vertex costs phones' GPUs, by their compilers: from the table that tools/gpu_cost.sh writes.
#pragma once

#include <optional>

#include "marrow/file.h"

namespace marrow::tools {

enum class GpuDeformer { rigid, ssd, as, psd };

// Static models of the compilers, not times. Each of the path that is cheaper there: palettes in a uniform block or in
// a texture; position and varying shader together.
struct VertexCost {
  double mali_cycles = 0;             // Mali-G57
  double adreno_instructions = 0;     // Adreno 660
  double videocore_instructions = 0;  // V3D 4.2
  bool spills = false;                // on one of them
};

// Of a vertex that is drawn with all that the geometry has of normals, tangents and morph targets, by the program that
// its largest number of influences takes. surface_normals: animation space draws the deformed surface's own normals
// where the geometry can, which is the default of `marrow render`. Of a pose space: with normals alone, and as if one
// example moved the vertex. Nothing where the table has no such program, or the geometry no pose space.
std::optional<VertexCost> vertex_cost(const Geometry& geometry, GpuDeformer deformer, bool surface_normals = true);

}  // namespace marrow::tools
