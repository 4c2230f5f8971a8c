// Roles of joints in a file, for `marrow info`.
#pragma once

#include <nlohmann/json.hpp>

#include "marrow/file.h"

namespace marrow::tools {

// {"roles": [{"role", "joint"}], "missing": [role], "pairs": [[left, right]], "soles": [{"joint", "place"}]}, joints by
// name. Missing are roles but tail that no joint has, none of them where no role is known.
nlohmann::ordered_json describe_roles(const File& file, std::uint32_t skeleton);

// "52 joints with roles, 24 pairs, 2 soles"; empty where no role is known.
std::string summary_of_roles(const nlohmann::ordered_json& roles);

// All of it, of each skeleton of a description.
void print_roles(const nlohmann::ordered_json& description);

}  // namespace marrow::tools
