// What `marrow info` says of materials, images and kept nodes.
#pragma once

#include <nlohmann/json.hpp>

#include "marrow/file.h"

namespace marrow::tools {

// Adds "materials" and "images"; "nodes" with their properties.
void describe_looks(const File& file, nlohmann::ordered_json& description);
void describe_nodes(const File& file, nlohmann::ordered_json& description);

// The same as lines of text.
void print_looks(const nlohmann::ordered_json& description);
void print_nodes(const nlohmann::ordered_json& description);

}  // namespace marrow::tools
