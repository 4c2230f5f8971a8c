// Joint limits: what artists wrote on nodes becomes what lies in the file.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Of each of the built skeletons its limits, ascending by joint. Notes nodes with limits that are no joints.
std::vector<std::vector<JointLimit>> build_limits(const RawScene& scene, const BuiltScene& built, Notes& notes);

// The same, into the skeletons of `built`.
void set_limits(const RawScene& scene, BuiltScene& built, Notes& notes);

}  // namespace marrow::cook
