// Whether JSON is what docs/*.schema.json say.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace marrow::test {

// As much of JSON Schema as docs/*.schema.json use; a keyword that it does not know is an error.
class Schema {
 public:
  using Json = nlohmann::json;
  explicit Schema(Json root) : root_(std::move(root)) {}
  bool accepts(const Json& value) const { return fits(root_, value); }

 private:
  bool fits(const Json& schema, const Json& value) const {
    for (const auto& [keyword, rule] : schema.items())
      if (!fits(schema, keyword, rule, value)) return false;
    return true;
  }
  bool fits(const Json& schema, const std::string& keyword, const Json& rule, const Json& value) const {
    const auto count = [&] {
      std::size_t n = 0;
      for (const Json& one : rule) n += fits(one, value);
      return n;
    };
    if (keyword == "$ref") return fits(root_.at(Json::json_pointer(rule.get<std::string>().substr(1))), value);
    if (keyword == "oneOf") return count() == 1;
    if (keyword == "anyOf") return count() > 0;
    if (keyword == "not") return !fits(rule, value);
    if (keyword == "type") return is_a(rule, value);
    if (keyword == "enum") return std::find(rule.begin(), rule.end(), value) != rule.end();
    if (keyword == "minimum") return !value.is_number() || value >= rule;
    if (keyword == "maximum") return !value.is_number() || value <= rule;
    if (keyword == "exclusiveMinimum") return !value.is_number() || value > rule;
    if (keyword == "minItems") return !value.is_array() || value.size() >= rule;
    if (keyword == "maxItems") return !value.is_array() || value.size() <= rule;
    if (keyword == "minLength") return !value.is_string() || value.get<std::string>().size() >= rule;
    if (keyword == "minProperties") return !value.is_object() || value.size() >= rule;
    if (keyword == "maxProperties") return !value.is_object() || value.size() <= rule;
    if (keyword == "items")
      return !value.is_array() || std::all_of(value.begin(), value.end(), [&](const Json& v) { return fits(rule, v); });
    if (keyword == "required")
      return !value.is_object() || std::all_of(rule.begin(), rule.end(), [&](const Json& name) {
        return value.contains(name.get<std::string>());
      });
    if (keyword == "dependentRequired")
      return std::all_of(rule.items().begin(), rule.items().end(), [&](const auto& one) {
        return !value.contains(one.key()) || fits(schema, "required", one.value(), value);
      });
    if (keyword == "properties" || keyword == "additionalProperties") return members_fit(schema, keyword, rule, value);
    const bool silent = keyword == "$schema" || keyword == "title" || keyword == "description" || keyword == "$defs";
    EXPECT_TRUE(silent) << keyword;
    return true;
  }
  static bool is_a(const std::string& type, const Json& value) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "null") return value.is_null();
    if (type == "integer") return value.is_number_integer();
    EXPECT_EQ(type, "number");
    return value.is_number();
  }
  bool members_fit(const Json& schema, const std::string& keyword, const Json& rule, const Json& value) const {
    if (!value.is_object()) return true;
    for (const auto& [name, member] : value.items()) {
      const bool known = schema.contains("properties") && schema["properties"].contains(name);
      if (keyword == "properties" && known && !fits(rule[name], member)) return false;
      if (keyword != "additionalProperties" || known) continue;
      if (rule.is_object() ? !fits(rule, member) : rule == false) return false;
    }
    return true;
  }

  Json root_;
};

}  // namespace marrow::test
