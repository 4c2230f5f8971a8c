// What the cooker reports about looks and nodes.
#pragma once

#include <nlohmann/json.hpp>

#include "cook/scene/built.h"

namespace marrow::cook {

// Adds "materials" and "images".
void report_looks(const BuiltScene& built, nlohmann::ordered_json& report);
// Adds "nodes" and "keep".
void report_nodes(const BuiltScene& built, nlohmann::ordered_json& report);

}  // namespace marrow::cook
