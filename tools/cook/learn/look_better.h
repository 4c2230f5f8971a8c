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

}  // namespace marrow::cook
