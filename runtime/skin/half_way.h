// Half-joints: the matrix between those of a joint and its parent.
#pragma once

#include "marrow/pose.h"

namespace marrow {

// parent, joint: palette entries; bind: the joint's. See build_palette().
Affine half_way(const Affine& parent, const Affine& joint, const Affine& bind, float share);

}  // namespace marrow
