// Which joints a vertex is worth following. Internal to tools/deform.
#pragma once

#include "deform/fit/training.h"
#include "deform/helpers/closed_form.h"

namespace marrow::deform {

// Of each vertex's candidates, which are joints and helpers, at most `most`, and more only where fewer cannot make up
// its weights: by backward elimination, that next whose loss costs least by the training. Below `most` those go on
// going whose loss costs less than `unseen`, mean squares over poses in diagonals. is_lift: the candidates are the lift
// of closed-form weights, and so is the result. Else what those carry that go is given to those that stay, in
// proportion to their w, so that the bind pose stays; where none of them has any, the lift is taken.
//
// One inversion of a 4n × 4n matrix for each distinct set of n candidates, one of 4 × 4 and a rank-4 update of the
// former for each joint that goes.
Coordinates choose_joints(const Coordinates& candidates, const ClosedForm& weights, bool is_lift, std::size_t most,
                          double unseen, const Training& training);

}  // namespace marrow::deform
