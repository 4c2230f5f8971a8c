// What an option may be set to: one table that reading, --help and printing share.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace marrow::tools {

// One of a table's entries. Tables whose entries say more have structs of their own with these two members.
template <class Value>
struct Named {
  const char* name;
  Value value;
};

// nullopt if the table has no such name.
template <class Table>
constexpr auto value_of(const Table& table, std::string_view name) {
  std::optional<decltype(std::begin(table)->value)> out;
  for (const auto& entry : table)
    if (name == entry.name) out = entry.value;
  return out;
}

// "" if the table has no such value.
template <class Table, class Value>
constexpr const char* name_of(const Table& table, const Value& value) {
  for (const auto& entry : table)
    if (entry.value == value) return entry.name;
  return "";
}

// In the table's order.
template <class Table>
std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> out;
  for (const auto& entry : table) out.emplace_back(entry.name);
  return out;
}

}  // namespace marrow::tools
