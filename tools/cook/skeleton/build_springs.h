// Spring bones: chains of nodes become chains of joints.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Of each of the built skeletons its springs. Notes colliders that hang on no joint.
std::vector<BuiltSprings> build_springs(const RawScene& scene, const BuiltScene& built, Notes& notes);

// The same, into the skeletons of `built`.
void set_springs(const RawScene& scene, BuiltScene& built, Notes& notes);

}  // namespace marrow::cook
