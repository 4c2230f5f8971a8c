// Coded tracks at a time → local transforms; the part of `sample` that unpacks.
#pragma once

#include "marrow/file.h"

namespace marrow {

// Overwrites the lanes of `out` that the clip codes; `out` holds the rest pose. time_s is a number.
// Method: rotations are rest · q(m) with m = axis · tan(θ/4), the modified Rodrigues parameters (Shuster, "A survey of
// attitude representations", 1993), translations and scales rest + v; each component an integer times the track's step.
// Two neighbouring frames are unpacked and blended, rotations on the sphere.
void sample_coded(const CodedTracks& coded, std::uint32_t joint_count, float time_s, SoaTransform* out);

}  // namespace marrow
