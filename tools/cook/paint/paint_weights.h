// Weights that an artist painted: grey-scale pictures in the place of a texture, or what `marrow view` saves.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cook/paint/paint_file.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// The scene with painted weights, of all meshes that are drawn with a skin, by one rule after the other; their
// files have been read. Throws as bind_weights(), read_painted() and paint_places().
RawScene paint_weights(RawScene scene, const std::vector<PaintRule>& rules, Notes& notes);

// Which painted vertex each place of a mesh takes its weights from; null: from none. A painted vertex goes to the place
// nearest to it, and to what cannot be told from that one after cooking, if it is no farther off than a thousandth of
// the mesh's longest side. places: all different, mesh space.
struct PaintMatch {
  std::vector<const PaintedVertex*> of_place;
  std::size_t off = 0;  // painted vertices that are on no place
};
PaintMatch match_painted(const deform::Positions& places, std::span<const PaintedVertex> painted);

// Meshes that are drawn with a skin and have the name of a painted one get its weights. A painted vertex goes to the
// scene's vertices nearest to it, if these are no farther than a thousandth of the mesh's longest side; what is that
// far from all of them is counted in a warning. path: of what was painted, for messages. must_fit: else what fits no
// mesh is a warning if none of it does. Throws tools::Failure (invalid) at the mesh or the joint that the scene has
// not.
void paint_places(RawScene& scene, const std::string& path, std::span<const PaintedMesh> painted, bool must_fit,
                  Notes& notes);

}  // namespace marrow::cook
