// Skeletons for --auto-skeleton, as their text says, see docs/cooking/skeletons.md.
#pragma once

#include <string>
#include <string_view>

#include "deform/rig/auto_skeleton.h"

namespace marrow::cook {

// What is built in, by its name; empty: no such.
std::string_view builtin_template(std::string_view name);

// Throws tools::Failure (usage), located.
deform::SkeletonTemplate parse_template(const std::string& path, std::string_view text);

}  // namespace marrow::cook
