// How much faster surfaces go from one frame to the next than the joints under them: what jumps.
#pragma once

#include <optional>
#include <vector>

#include "commands/compare/contestants.h"

namespace marrow::tools {

// Of each deformer, the truth behind them: deform::largest_jump() in three frames at 60 a second, metres, around some
// of the moments that the first round holds out, those in which plain skinning is farthest off. None: no clip says what
// is between, or a deformer is not finite there.
std::vector<std::optional<double>> largest_jumps(const Study& study, const std::vector<Trained>& deformers,
                                                 const deform::Deformer& truth,
                                                 const std::vector<double>& plain_error_of_pose);

}  // namespace marrow::tools
