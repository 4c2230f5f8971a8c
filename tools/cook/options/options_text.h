// Options as tables of TOML.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "cook/options/options.h"

namespace marrow::cook {

// No marrow.toml is larger.
inline constexpr std::size_t kLargestSettings = 64 * 1024;

// The options of a table, without the key `but`. Every key, type and value is checked, and what goes together. Throws
// tools::Failure (usage) at "LINE:COLUMN".
Options options_of(const std::string& path, const toml::table& table, std::string_view but);

// A string or a list of them. Throws likewise.
std::vector<Value> strings_of(const std::string& path, const std::string& name, const toml::node& node);

}  // namespace marrow::cook
