// [[shapes]] of marrow.toml: spaces of example shapes (docs/cooking/deformers.md).
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "cook/options/options.h"

namespace marrow::cook {

// A value a table, each with its shape. path: of the settings, for messages. Throws tools::Failure (usage) at what is
// wrong.
std::vector<Value> read_shapes(const std::string& path, const toml::node& node);

// A [[shapes]] table that read_shapes() reads as this.
std::string text_of_shape(const ShapeRule& rule);

}  // namespace marrow::cook
