// Checks that a glTF document has the shape of one: kinds, ranges, lengths and references of every known property.
#pragma once

#include "cook/gltf/document/json.h"

namespace marrow::cook::gltf {

// After this every property that the tables in schema_tables.cpp name is absent or of its kind and in its range,
// and every index points at an existing element. Integers written as floats are turned into integers, empty
// lists are dropped where they may be, unknown properties are warned of. In a file without scenes nothing is mended.
void check_schema(Json& root, Report& report);

// Refuses glTF 1.0, whose documents have another shape, and what comes after 2.x.
void check_generation(const Json& root, const Report& report);

// Versions, and the extensions that the document uses or demands.
void check_asset_and_extensions(const Json& root, Report& report);

}  // namespace marrow::cook::gltf
