// [[shapes]] of marrow.toml: spaces of example shapes (docs/cooking/deformers.md).
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "options/options.h"

namespace marrow::cook {

// "LINE:COLUMN".
std::string place(const toml::source_region& region);

// A value a table, each with its shape. path: of the settings, for messages. Throws tools::Failure (usage) at what is
// wrong.
std::vector<Value> read_shapes(const std::string& path, const toml::node& node);

}  // namespace marrow::cook
