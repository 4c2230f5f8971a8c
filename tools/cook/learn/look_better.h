// What is learnt of a body must not look worse than plain skinning, in clips or beyond.
#pragma once

#include <vector>

#include "cook/learn/learn.h"

namespace marrow::cook {

// What a fit has learnt gives way to the closed form, smoothly, where it looks or jumps worse than that and than linear
// blend skinning: in `clips`, in the source's range of motion and its frames in a row.
// form: over the helpers that `out` has.
void keep_from_looking_worse(const DeformSource& source, const deform::ClosedForm& form,
                             const std::vector<deform::Pose>& clips, Learnt& out);

// The connected parts of a mesh whose vertices all have the same weights, as a plate or a button, move as one: all take
// what the vertex next to the middle has learnt. Else each vertex is off by something else, and the part is skewed.
void move_stiff_parts_as_one(const deform::SkinnedMesh& mesh, Learnt& out);

}  // namespace marrow::cook
