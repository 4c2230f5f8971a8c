// What a cooked file has, for a page.
#pragma once

#include <nlohmann/json.hpp>

#include "stage/actor.h"

namespace marrow::tools {

// As src/viewer.ts's About has it.
nlohmann::ordered_json about(Actor& actor);

}  // namespace marrow::tools
