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
// What the root may have of VRM: VRM, VRMC_vrm and VRMC_springBone.
extern const Schema kRootExtensionsSchema;

// Rows of the tables.
constexpr Property index_of(std::string_view name, std::string_view collection, bool required = false) {
  return {.name = name, .kind = Kind::index, .required = required, .of = collection};
}

constexpr Property count_of(std::string_view name, double min, bool required = false) {
  return {.name = name, .kind = Kind::integer, .required = required, .min = min, .max = kLargestInteger};
}

constexpr Property text(std::string_view name, bool required = false, std::string_view words = {}) {
  return {.name = name, .kind = Kind::text, .required = required, .of = words};
}

constexpr Property object(std::string_view name, const Schema& schema, bool required = false) {
  return {.name = name, .kind = Kind::object, .required = required, .schema = &schema};
}

constexpr Property objects(std::string_view name, const Schema& schema, bool required = false) {
  return {.name = name, .kind = Kind::objects, .required = required, .schema = &schema};
}

constexpr Property numbers(std::string_view name, std::size_t shortest, std::size_t longest) {
  return {.name = name, .kind = Kind::numbers, .shortest = shortest, .longest = longest};
}

constexpr Property flag(std::string_view name) {
  return {.name = name, .kind = Kind::boolean};
}

}  // namespace marrow::cook::gltf
