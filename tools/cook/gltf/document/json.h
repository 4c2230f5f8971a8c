// JSON text to a document tree, for text that nobody vouches for.
#pragma once

#include <nlohmann/json.hpp>

#include "cook/gltf/document/container.h"
#include "cook/gltf/document/findings.h"

namespace marrow::cook::gltf {

using Json = nlohmann::json;

// Strict RFC 8259, with two rules more: names in an object are unique (glTF 2.0, section 2.7) and nesting has a limit,
// so that later stages may recurse. The result is an object. A byte-order mark is skipped with a warning. Failures
// carry the byte offset in the file.
Json parse_json(const Container& container, Report& report);

}  // namespace marrow::cook::gltf
