// Multi-weight enveloping and pose space out of what a better deformer does in the character's own poses.
#pragma once

#include "cook/build.h"
#include "cook/skin/deform_source.h"

namespace marrow::cook {

// The joint whose frame multi-weights are meant in: of those that vertices follow the nearest to the skeleton's root.
std::uint32_t multi_weight_root(const DeformSource& source);

// Fits what `options` ask for to the influences that the file will keep, once animation space has been learnt; writes
// binding.deformers and the report. Adds a warning for each that is not shipped, as it does not beat SSD in poses left
// out. grid: of positions.
void learn_deformers(RawScene& scene, const RawMesh& mesh, const RawSkin& skin, const BuiltScene& built,
                     const CookOptions& options, MeshGrid grid, SkinBinding& binding, LearnReport& report);

// Joints that a palette must have for a vertex beside those that it follows.
std::vector<std::uint32_t> joints_of_deformers(const BoundDeformers& deformers, const BoundVertex& vertex);

// What build_geometry() takes of a primitive; joint j, if the palette has it, is entry entry_of[j] of palette_size.
DeformerData deformer_data(const SkinBinding& binding, std::size_t primitive,
                           const std::vector<std::uint16_t>& entry_of, std::size_t palette_size);

}  // namespace marrow::cook
