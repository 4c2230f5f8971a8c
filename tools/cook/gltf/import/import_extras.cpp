// Imports what artists wrote on nodes for the game.
#include <cmath>
#include <iterator>

#include "cook/gltf/import/import.h"

namespace marrow::cook::gltf {
namespace {

class Flattener {
 public:
  Flattener(Budget& budget, const Report& report, std::string where)
      : budget_(budget), report_(report), where_(std::move(where)) {}

  // path: of the keys so far, each behind a "/". The depth of documents is limited.
  void add(const Json& value, const std::string& path) {
    if (value.is_structured()) {
      std::size_t index = 0;
      for (const auto& [key, member] : value.items()) {
        std::string below = path;
        if (value.is_array()) {
          append_step(below, index++);
        } else {
          append_step(below, std::string_view(key));
        }
        budget_.take(below.size(), where_, report_);
        add(member, below);
      }
      return;
    }
    RawProperty property;
    property.name = path.empty() ? path : path.substr(1);
    if (value.is_boolean()) {
      property.type = PropertyType::boolean;
      property.number = value.get<bool>() ? 1 : 0;
    } else if (value.is_number()) {
      property.number = value.get<double>();
    } else if (value.is_string()) {
      property.type = PropertyType::text;
      property.text = value.get<std::string>();
    }
    const bool ends_early =
        property.name.find('\0') != std::string::npos || property.text.find('\0') != std::string::npos;
    if (value.is_null() || !std::isfinite(property.number) || ends_early) {
      ++dropped;
      return;
    }
    budget_.take(sizeof property + property.name.size() + property.text.size(), where_, report_);
    properties.push_back(std::move(property));
  }

  std::vector<RawProperty> properties;
  std::size_t dropped = 0;

 private:
  Budget& budget_;
  const Report& report_;
  std::string where_;
};

}  // namespace

void import_extras(const Document& document, std::vector<RawNode>& nodes, Budget& budget, Report& report) {
  for (std::size_t i = 0; i < document.node_extras.size(); ++i) {
    if (document.node_extras[i].is_null()) continue;
    const std::string where = pointer("nodes", i, "extras");
    Flattener flattener(budget, report, where);
    flattener.add(document.node_extras[i], "");
    nodes[i].extras = std::move(flattener.properties);
    nodes[i].dropped_extras = flattener.dropped;
  }
}

void add_properties(const Json& value, const std::string& name, const std::string& where, Budget& budget,
                    const Report& report, RawNode& node) {
  Flattener flattener(budget, report, where);
  flattener.add(value, '/' + name);
  node.extras.insert(node.extras.end(), std::make_move_iterator(flattener.properties.begin()),
                     std::make_move_iterator(flattener.properties.end()));
  node.dropped_extras += flattener.dropped;
}

}  // namespace marrow::cook::gltf
