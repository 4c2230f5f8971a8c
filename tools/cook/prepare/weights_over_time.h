// Weights that clips move: from one joint to another, by a number that is no part of a joint.
//
// A weight over time is w(v, t) = Σ_b B_b(v) a_b(t): basis functions over the surface, and coefficients that clips
// animate. Each basis function becomes a joint, which vertices follow with the weight B_b; where the joint stands
// between the two that it is made of, a_b says. So it costs a frame what a joint costs, on every path.
#pragma once

#include <vector>

#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// The scene with what the rules say, one after the other. The weights of the joint `from` go to new joints below it,
// called from/channel, or from/channel[0], from/channel[1] … where there are several splines. A new joint moves as
// `from` where its channel is 0, as `to` where it is 1; between, its turn is that of the quaternions' weighted mean,
// its place and its scale are the weighted means. Keys: 60 a second, and where the channel has some. Notes clips of
// which none has the channel. Throws tools::Failure: usage (in the rule's place) for a joint that is not there, is not
// alone in its name, or no skin follows; invalid for a joint without volume or too far away; unsupported for too many
// keys.
RawScene weights_over_time(RawScene scene, const std::vector<WeightsOverTime>& rules, Notes& notes);

}  // namespace marrow::cook
