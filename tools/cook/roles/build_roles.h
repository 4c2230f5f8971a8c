// Which joint of a built skeleton is the left foot, the head, the tail: as a ROLE section has it.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Of each of the built skeletons: what the file says outright (VRM), what `rules` say, and what names and places of
// joints say where they agree. meshes: of all skeletons, without levels of detail. Notes what is in doubt, by joint.
// Throws tools::Failure (usage) for a rule of a joint that there is not.
std::vector<BuiltRoles> build_roles(const RawScene& scene, const BuiltScene& built, const std::vector<Mesh>& meshes,
                                    const std::vector<RoleRule>& rules, Notes& notes);

// The same, into the skeletons of `built`.
void find_roles(const RawScene& scene, const std::vector<Mesh>& meshes, const std::vector<RoleRule>& rules,
                BuiltScene& built, Notes& notes);

}  // namespace marrow::cook
