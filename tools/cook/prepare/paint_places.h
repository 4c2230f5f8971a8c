// Painted weights on their way to a scene's vertices.
#pragma once

#include <span>
#include <string>

#include "cook/prepare/paint_file.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Meshes that are drawn with a skin and have the name of a painted one get its weights. A painted vertex goes to the
// scene's vertices nearest to it, if these are no farther than a thousandth of the mesh's longest side; what is that
// far from all of them is counted in a warning. path: of what was painted, for messages. must_fit: else what fits no
// mesh is a warning if none of it does. Throws tools::Failure (invalid) at the mesh or the joint that the scene has
// not.
void paint_places(RawScene& scene, const std::string& path, std::span<const PaintedMesh> painted, bool must_fit,
                  Notes& notes);

}  // namespace marrow::cook
