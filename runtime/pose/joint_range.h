// Local to model for a range of joints, for callers that know which joints have changed.
#pragma once

#include "marrow/file.h"

namespace marrow {

// local_to_model() for joints `first` … `end` - 1, whose parents' matrices are done; checks nothing.
void transform_joints(const Skeleton& skeleton, const SoaTransform* local, std::uint32_t first, std::uint32_t end,
                      Affine* out);

}  // namespace marrow
