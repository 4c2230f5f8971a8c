// A primitive's vertices on their way to the file: numbers, welded, ordered, encoded, and decoded as the runtime will.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cook/geometry/owned_streams.h"
#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// One primitive's vertices: quantised, welded, in an order that GPUs like, encoded, decoded again. Throws
// tools::Failure (internal), without a place, if that is not what was encoded. deformers: of the primitive's vertices
// and bindings, a palette entry being a joint of those.
BuiltGeometry build_geometry(const RawPrimitive& primitive, const std::vector<Binding>& bindings,
                             std::size_t joint_count, const MeshGrid& grid, const MeshOptions& options,
                             const DeformerData& deformers = {});
// Of a primitive in parts: quantised as a whole, so that parts still touch where they do, and the rest part by part.
struct GeometryPart {
  std::vector<std::uint32_t> vertices, indices;  // as PrimitivePart's
  std::vector<std::uint16_t> entries;            // of the palette, ascending
};
std::vector<BuiltGeometry> build_geometries(const RawPrimitive& primitive, const std::vector<Binding>& bindings,
                                            std::size_t joint_count, const std::vector<GeometryPart>& parts,
                                            const MeshGrid& grid, const MeshOptions& options,
                                            const DeformerData& deformers);

}  // namespace marrow::cook
