// How far the joints of a mesh turn: its range of motion, within the limits that the artist gave joints.
#pragma once

#include "cook/skin/deform_source.h"
#include "deform/motion/range_of_motion.h"

namespace marrow::cook {

// skeleton: the source's, with its limits. A limit is about the joint's rotation beside the joint above it in the bind
// pose, or at rest where that one is not in the skin.
deform::RangeOfMotion range_of_motion(const DeformSource& source, const BuiltSkeleton& skeleton);

// A line for each reason that joints were left out for, with their names. "moves_as_one", which is no fault, is not
// among them.
std::vector<std::string> left_out_of_motion(const DeformSource& source, const BuiltSkeleton& skeleton,
                                            const std::vector<deform::LeftOut>& left_out);

}  // namespace marrow::cook
