// What a page sets, as JSON.
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "page/viewer/show.h"

namespace marrow::tools {

// Members as src/viewer.ts's Settings has them, but `graph`, `goals` and `set`. Throws Failure (usage) for a name that
// is none of a table's; numbers are brought into their ranges.
void read_settings(const nlohmann::json& wanted, const Actor& actor, PageSettings& settings);

glm::vec3 point_of(const nlohmann::json& numbers);

// [{name, value}] of a graph's parameters; a trigger fires. Throws Failure (usage) for a name that is none.
void set_parameters_of(const nlohmann::json& values, Rehearsal& rehearsal);

}  // namespace marrow::tools
