// What a command would cook, for whoever shares the work out.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "jobs/cooker.h"

namespace marrow::tools {

// As docs/cooking/many_machines.md has it: units, the longest first, each with its inputs' hashes, options, output,
// expected seconds and memory. Reads the scenes. history: see KnownTimes.
nlohmann::ordered_json plan_of(const std::vector<Order>& orders, const std::vector<std::string>& history);

}  // namespace marrow::tools
