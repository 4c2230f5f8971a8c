// What `marrow info` says of graphs of behaviour.
#pragma once

#include <nlohmann/json.hpp>

#include "common/load_mrw.h"

namespace marrow::tools {

// Adds "graphs": name, bytes, nodes, parameters with their kinds and ranges, clips that are wanted and whether the file
// has them. Throws Failure (invalid) if one is damaged.
void describe_graphs(const std::string& path, const LoadedFile& loaded, nlohmann::ordered_json& description);

// The same as lines of text.
void print_graphs(const nlohmann::ordered_json& description);

}  // namespace marrow::tools
