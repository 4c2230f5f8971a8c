// Skeletons for --auto-skeleton, as their text says, see docs/cooking/skeletons.md.
#pragma once

#include <string>
#include <string_view>

#include "cook/scene/raw.h"
#include "deform/rig/skeleton_template.h"

namespace marrow::cook {

// What is built in, by its name; empty: no such.
std::string_view builtin_template(std::string_view name);

// Throws tools::Failure (usage), located.
deform::SkeletonTemplate parse_template(const std::string& path, std::string_view text);

// One that is built in, or else the file of that path, of which `reads` then says what was read. Throws likewise, and
// as tools::read_file() does.
deform::SkeletonTemplate read_template(const std::string& name, std::vector<RawRead>& reads);

}  // namespace marrow::cook
