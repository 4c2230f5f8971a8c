// Which joints a vertex is worth following. Internal to tools/deform.
#pragma once

#include "deform/fit/training.h"

namespace marrow::deform {

// Of each vertex's candidates at most `most` joints, and those of `kept` whatever their number: by backward
// elimination, the joint next whose loss costs least by the training. What those carry that go is given to those that
// stay, in proportion to their w, so that the bind pose stays; where none of them has any, the lift of `kept` is taken.
//
// One inversion of a 4n × 4n matrix for each distinct set of n candidates, one of 4 × 4 and a rank-4 update of the
// former for each joint that goes.
Coordinates choose_joints(const Coordinates& candidates, const SkinnedMesh& kept, std::size_t most,
                          const Training& training);

}  // namespace marrow::deform
