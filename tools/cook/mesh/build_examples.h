// Spaces of example shapes: rules of the settings become functions of parameters over the targets of built meshes.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"

namespace marrow::cook {

// Meshes whose targets stand at the same places share a space, others get one each. A mesh that lacks some of the
// targets is as it is in those examples. Notes rules that fit no mesh, and parameters along which no example differs.
// Throws tools::Failure (usage) at a target that no mesh of the rule has, or that two rules drive, and at a rule whose
// functions cannot be solved for.
std::vector<BuiltExampleSpace> build_example_spaces(const std::vector<ShapeRule>& rules,
                                                    const std::vector<BuiltMesh>& meshes, Notes& notes);

}  // namespace marrow::cook
