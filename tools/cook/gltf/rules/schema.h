// Checks that a glTF document has the shape of one: kinds, ranges, lengths and references of every known property.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

#include "cook/gltf/document/findings.h"
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

// The tables that check_schema() walks by, in schema_tables.cpp.
enum class Kind {
  boolean,
  text,
  texts,  // array of distinct strings
  integer,
  number,
  numbers,     // array
  index,       // into the root collection `of`
  indices,     // array of distinct ones
  index_map,   // an object whose members are indices, such as a primitive's attributes
  index_maps,  // array of them
  object,      // of `schema`
  objects,     // array of them
  object_map,  // an object whose members are objects of `schema`, called as the file likes
};

inline constexpr double kLargestFloat = std::numeric_limits<float>::max();
inline constexpr double kLargestInteger = 9007199254740992.0;  // every integer up to here is exact in a double
inline constexpr std::size_t kAnyLength = std::numeric_limits<std::size_t>::max();

struct Schema;

struct Property {
  std::string_view name;
  Kind kind;
  bool required = false;
  double min = -kLargestFloat;
  double max = kLargestFloat;
  std::size_t shortest = 1;  // arrays: items
  std::size_t longest = kAnyLength;
  std::string_view of = {};  // collection of an index; allowed words of a text, separated by spaces
  const Schema* schema = nullptr;
};

// Every object may also have `name`, `extensions` and `extras`.
struct Schema {
  std::span<const Property> properties;
  bool open = false;  // members beyond the table are someone else's business
};

extern const Schema kRootSchema;

}  // namespace marrow::cook::gltf
