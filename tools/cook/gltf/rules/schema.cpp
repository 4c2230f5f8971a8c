// Walks a document along the schema tables and refuses the first property that is not what glTF 2.0 says.
#include "cook/gltf/rules/schema.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_set>

#include "cook/gltf/rules/schema_tables.h"

namespace marrow::cook::gltf {
namespace {

// More elements than this in one collection is an attack or a mistake, and would cost gigabytes before it is found out.
constexpr std::size_t kLongestCollection = 200'000;

// Where the walk is; turned into text only when there is something to say.
struct Path {
  const Path* up = nullptr;
  std::string_view key = {};
  std::size_t index = 0;
  bool is_index = false;

  Path step(std::string_view name) const { return {this, name, 0, false}; }
  Path step(std::size_t number) const { return {this, {}, number, true}; }

  std::string text() const {
    if (up == nullptr) return {};
    return is_index ? under(up->text(), index) : under(up->text(), key);
  }
};

std::string shown(double number) {
  std::string text = Json(number).dump();
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

class Walker {
 public:
  Walker(Json& root, Report& report) : root_(root), report_(report) {}

  void check_object(Json& value, const Schema& schema, const Path& path) {
    if (!value.is_object()) wrong_kind(path, "an object");
    for (auto member = value.begin(); member != value.end();) {
      if (is_idle(*member, member.key(), schema)) {
        report_.mend(path.step(member.key()).text(), "empty-array",
                     "left out; a list such as /nodes has elements or is not there");
        member = value.erase(member);
        continue;
      }
      check_member(member.key(), *member, schema, path);
      ++member;
    }
    for (const Property& property : schema.properties) {
      if (property.required && !value.contains(property.name)) {
        report_.invalid(path.step(property.name).text(), "missing", "glTF 2.0 demands this property");
      }
    }
  }

 private:
  // An empty list that says as little as none would: exporters write them, though glTF 2.0 has none.
  static bool is_idle(const Json& value, const std::string& name, const Schema& schema) {
    const auto known = std::ranges::find(schema.properties, name, &Property::name);
    return value.is_array() && value.empty() && known != schema.properties.end() && is_list(known->kind) &&
           known->shortest == 1 && !known->required;
  }

  static bool is_list(Kind kind) {
    return kind == Kind::texts || kind == Kind::numbers || kind == Kind::indices || kind == Kind::index_maps ||
           kind == Kind::objects;
  }

  void check_member(const std::string& name, Json& value, const Schema& schema, const Path& path) {
    const auto known = std::ranges::find(schema.properties, name, &Property::name);
    if (known != schema.properties.end()) {
      check_property(value, *known, path.step(name));
    } else if (name == "name") {
      if (!value.is_string()) wrong_kind(path.step(name), "a string");
    } else if (name != "extras" && name != "extensions" && !schema.open) {
      report_.warn(path.step(name).text(), "unknown-property", "not a property of glTF 2.0; ignored");
    }
  }

  void check_property(Json& value, const Property& property, const Path& path) {
    switch (property.kind) {
      case Kind::boolean:
        if (!value.is_boolean()) wrong_kind(path, "true or false");
        break;
      case Kind::text:
        check_text(value, property, path);
        break;
      case Kind::texts:
        check_texts(value, property, path);
        break;
      case Kind::integer:
        check_integer(value, property.min, property.max, path);
        break;
      case Kind::number:
        check_number(value, property, path);
        break;
      case Kind::index:
        check_index(value, property, path);
        break;
      case Kind::index_map:
        check_index_map(value, property, path);
        break;
      case Kind::object:
        check_object(value, *property.schema, path);
        break;
      case Kind::object_map:
        if (!value.is_object()) wrong_kind(path, "an object");
        for (const auto& member : value.items())
          check_object(member.value(), *property.schema, path.step(member.key()));
        break;
      case Kind::indices:
        check_indices(value, property, path);
        break;
      case Kind::numbers:
      case Kind::index_maps:
      case Kind::objects:
        check_items(value, property, path);
        break;
    }
  }

  void check_items(Json& value, const Property& property, const Path& path) {
    check_length(value, property, path);
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (property.kind == Kind::numbers) check_number(value[i], property, path.step(i));
      if (property.kind == Kind::index_maps) check_target(value[i], property, path.step(i));
      if (property.kind == Kind::objects) check_object(value[i], *property.schema, path.step(i));
    }
  }

  void check_length(const Json& value, const Property& property, const Path& path) {
    if (!value.is_array()) wrong_kind(path, "an array, as /nodes is");
    // An animation that moves nothing, a mesh that draws nothing.
    if (value.empty() && property.kind == Kind::objects && property.shortest == 1) {
      report_.mend(path.text(), "empty-array", "glTF 2.0 demands an element");
      return;
    }
    if (value.size() < property.shortest || value.size() > property.longest) {
      report_.invalid(path.text(), "wrong number of items",
                      "it has " + std::to_string(value.size()) + "; export again");
    }
    if (value.size() > kLongestCollection) {
      report_.unsupported(path.text(), "too many items",
                          "at most " + std::to_string(kLongestCollection) + " are read; split the scene");
    }
  }

  void check_text(const Json& value, const Property& property, const Path& path) {
    if (!value.is_string()) wrong_kind(path, "a string");
    if (property.of.empty()) return;
    const auto& text = value.get_ref<const std::string&>();
    const std::string words = ' ' + std::string(property.of) + ' ';
    if (text.empty() || words.find(' ' + text + ' ') == std::string::npos) {
      report_.invalid(path.text(), "unknown value", "use one of: " + std::string(property.of));
    }
  }

  void check_texts(const Json& value, const Property& property, const Path& path) {
    check_length(value, property, path);
    std::unordered_set<std::string> seen;
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (!value[i].is_string()) wrong_kind(path.step(i), "a string");
      if (!seen.insert(value[i].get<std::string>()).second) {
        report_.mend(path.step(i).text(), "duplicate-entry", "listed twice; the second is ignored");
      }
    }
  }

  void check_number(const Json& value, const Property& property, const Path& path) {
    if (!value.is_number()) wrong_kind(path, "a number");
    check_range(value.get<double>(), property.min, property.max, path);
  }

  void check_range(double number, double min, double max, const Path& path) {
    if (number >= min && number <= max) return;
    report_.invalid(path.text(), "out of range",
                    shown(number) + " is not between " + shown(min) + " and " + shown(max));
  }

  void check_integer(Json& value, double min, double max, const Path& path) {
    if (!value.is_number()) wrong_kind(path, "an integer");
    const double number = value.get<double>();
    check_range(number, min, max, path);
    if (value.is_number_integer()) return;
    if (number != std::floor(number)) wrong_kind(path, "an integer");
    value = static_cast<std::int64_t>(number);  // 1.0 is a legal spelling of 1
  }

  void check_index(Json& value, const Property& property, const Path& path) {
    if (property.of.empty()) return check_integer(value, 0, std::numeric_limits<std::int32_t>::max(), path);
    check_integer(value, -kLargestInteger, kLargestInteger, path);
    const auto collection = root_.find(property.of);
    const std::size_t size = collection == root_.end() || !collection->is_array() ? 0 : collection->size();
    const double number = value.get<double>();
    if (number < 0 || number >= static_cast<double>(size)) {
      report_.invalid(path.text(), "reference to nothing",
                      "there is no /" + std::string(property.of) + '/' + shown(number) + "; export again");
    }
  }

  void check_indices(Json& value, const Property& property, const Path& path) {
    check_length(value, property, path);
    std::unordered_set<std::int64_t> seen;
    for (std::size_t i = 0; i < value.size(); ++i) {
      check_index(value[i], property, path.step(i));
      if (!seen.insert(value[i].get<std::int64_t>()).second) {
        report_.invalid(path.step(i).text(), "listed twice", "the elements must be distinct; export again");
      }
    }
  }

  void check_target(Json& value, const Property& property, const Path& path) {
    if (value.is_object() && value.empty())
      report_.mend(path.text(), "empty-target", "the morph target moves nothing; kept, so that its weight has a place");
    else
      check_index_map(value, property, path);
  }

  void check_index_map(Json& value, const Property& property, const Path& path) {
    if (!value.is_object()) wrong_kind(path, "an object");
    if (value.empty()) report_.invalid(path.text(), "empty object", "it needs a member; export again");
    for (auto member = value.begin(); member != value.end(); ++member) {
      check_index(*member, property, path.step(member.key()));
    }
  }

  [[noreturn]] void wrong_kind(const Path& path, const std::string& expected) {
    report_.invalid(path.up == nullptr ? "@0" : path.text(), "wrong type", "it must be " + expected);
  }

  Json& root_;
  Report& report_;
};

}  // namespace

void check_schema(Json& root, Report& report) {
  if (!root.contains("scenes")) report.mend_nothing("as the file has no scene; give it one or export again");
  Walker(root, report).check_object(root, kRootSchema, Path{});
}

}  // namespace marrow::cook::gltf
