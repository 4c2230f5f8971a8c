// The tables of glTF 2.0's objects that check_schema() walks by.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

namespace marrow::cook::gltf {

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
