// Imports what artists wrote on nodes for the game, and joint limits, which stand in the same place.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>

#include "cook/gltf/import/import.h"
#include "marrow/limits.h"

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

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

// One `limits` object. What is wrong ends the reading: nothing else would say so before the game.
class LimitReader {
 public:
  LimitReader(const Json& limits, std::string where, const Report& report)
      : limits_(limits), where_(std::move(where)), report_(report) {}

  RawLimit read() const {
    RawLimit out;
    LimitDescription& d = out.description;
    allow(limits_, where_, {"hinge", "cone", "euler", "zero", "speed", "acceleration"});
    if (limits_.contains("hinge") + limits_.contains("cone") + limits_.contains("euler") > 1)
      report_.invalid(where_, "several kinds of limit", "give one of hinge, cone and euler");
    if (limits_.contains("hinge")) read_hinge(limits_["hinge"], under(where_, "hinge"), d);
    if (limits_.contains("cone")) read_cone(limits_["cone"], under(where_, "cone"), d);
    if (limits_.contains("euler")) read_euler(limits_["euler"], under(where_, "euler"), d);
    out.zero_is_given = limits_.contains("zero");
    if (out.zero_is_given) read_direction(limits_["zero"], under(where_, "zero"), d.zero);
    d.rate = {read_rate("speed"), read_rate("acceleration")};
    if (d.kind == LimitKind::none && d.rate.speed == 0 && d.rate.acceleration == 0)
      report_.invalid(where_, "a limit of nothing", "give one of hinge, cone and euler, or a speed or an acceleration");
    return out;
  }

 private:
  void allow(const Json& object, const std::string& where, std::initializer_list<const char*> names) const {
    if (!object.is_object()) report_.invalid(where, "an object is expected", "see docs/limits.schema.json");
    for (const auto& [key, value] : object.items())
      if (std::find(names.begin(), names.end(), key) == names.end())
        report_.invalid(under(where, key), "unknown property of a limit", "see docs/limits.schema.json");
  }

  // Values that floats hold, each -most … most; `where` is the list's.
  template <std::size_t N>
  void read_numbers(const Json& list, const std::string& where, double most, double (&out)[N]) const {
    if (!list.is_array() || list.size() != N)
      report_.invalid(where, std::to_string(N) + " numbers are expected", "see docs/limits.schema.json");
    for (std::size_t i = 0; i < N; ++i) {
      if (!list[i].is_number()) report_.invalid(under(where, i), "a number is expected", "see docs/limits.schema.json");
      out[i] = list[i].get<double>();
      if (!(std::fabs(out[i]) <= most))
        report_.invalid(under(where, i), "a number out of range", "at most " + std::to_string(std::lround(most)));
    }
  }

  const Json& member(const Json& object, const std::string& where, const char* name) const {
    if (!object.contains(name)) report_.invalid(where, std::string("no ") + name, "see docs/limits.schema.json");
    return object[name];
  }

  template <std::size_t N>
  void read_direction(const Json& list, const std::string& where, float (&out)[N]) const {
    double numbers[N];
    read_numbers(list, where, 1e3, numbers);
    double squared = 0;
    for (std::size_t i = 0; i < N; ++i) squared += numbers[i] * numbers[i];
    if (!(squared > 1e-6)) report_.invalid(where, "a direction without length", "give one of about 1");
    for (std::size_t i = 0; i < N; ++i) out[i] = static_cast<float>(numbers[i] / std::sqrt(squared));
  }

  void read_axes(const Json& object, const std::string& where, LimitDescription& d) const {
    read_direction(member(object, where, "axis"), under(where, "axis"), d.axis);
    read_direction(member(object, where, "across"), under(where, "across"), d.across);
    double along = 0;
    for (int i = 0; i < 3; ++i) along += static_cast<double>(d.axis[i]) * static_cast<double>(d.across[i]);
    if (std::fabs(along) > 0.999)
      report_.invalid(under(where, "across"), "across lies along axis", "give a direction about perpendicular to it");
  }

  // Degrees, least and most.
  void read_angles(const Json& list, const std::string& where, double most, int i, LimitDescription& d) const {
    double degrees[2];
    read_numbers(list, where, most, degrees);
    if (degrees[0] > degrees[1]) report_.invalid(where, "the least angle is above the most", "least first");
    d.least_rad[i] = static_cast<float>(degrees[0] * kDegree);
    d.most_rad[i] = static_cast<float>(degrees[1] * kDegree);
  }

  void read_hinge(const Json& hinge, const std::string& where, LimitDescription& d) const {
    d.kind = LimitKind::hinge;
    allow(hinge, where, {"axis", "angle"});
    read_direction(member(hinge, where, "axis"), under(where, "axis"), d.axis);
    // The angle is measured from `zero`, so any direction across will do: of the axis that is farthest from along.
    std::size_t least = 0;
    for (std::size_t i = 1; i < 3; ++i) least = std::fabs(d.axis[i]) < std::fabs(d.axis[least]) ? i : least;
    for (std::size_t i = 0; i < 3; ++i) d.across[i] = i == least ? 1.0f : 0.0f;
    read_angles(member(hinge, where, "angle"), under(where, "angle"), 360, 0, d);
  }

  void read_cone(const Json& cone, const std::string& where, LimitDescription& d) const {
    d.kind = LimitKind::cone;
    allow(cone, where, {"axis", "across", "swing", "twist"});
    read_axes(cone, where, d);
    double swing[2];
    read_numbers(member(cone, where, "swing"), under(where, "swing"), 170, swing);
    for (int i = 0; i < 2; ++i) {
      if (swing[i] < 0) report_.invalid(under(where, "swing", i), "a swing below 0", "it goes both ways");
      d.most_rad[i + 1] = std::min(static_cast<float>(swing[i] * kDegree), kWidestSwing_rad);
      d.least_rad[i + 1] = -d.most_rad[i + 1];
    }
    read_angles(member(cone, where, "twist"), under(where, "twist"), 360, 0, d);
  }

  void read_euler(const Json& euler, const std::string& where, LimitDescription& d) const {
    d.kind = LimitKind::euler;
    allow(euler, where, {"order", "x", "y", "z", "axis", "across"});
    if (euler.contains("axis") || euler.contains("across")) read_axes(euler, where, d);
    constexpr const char* kOrders[] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
    const Json& order = member(euler, where, "order");
    std::size_t found = 0;
    while (found < 6 && order != kOrders[found]) ++found;
    if (found == 6) report_.invalid(under(where, "order"), "unknown order of axes", "xyz, xzy, yxz, yzx, zxy or zyx");
    d.order = static_cast<AxisOrder>(found);
    for (int i = 0; i < 3; ++i) {
      const std::string axis(1, kOrders[found][i]);
      read_angles(member(euler, where, axis.c_str()), under(where, axis), i == 1 ? 90 : 360, i, d);
    }
  }

  float read_rate(const char* name) const {
    if (!limits_.contains(name)) return 0;
    const std::string where = under(where_, name);
    if (!limits_[name].is_number()) report_.invalid(where, "a number is expected", "see docs/limits.schema.json");
    const double rate = limits_[name].get<double>();
    if (!(rate > 0 && rate <= 1e9)) report_.invalid(where, "a rate out of range", "above 0, at most 1000000000");
    return std::max(static_cast<float>(rate * kDegree), 1e-9f);
  }

  const Json& limits_;
  std::string where_;
  const Report& report_;
};

}  // namespace

void import_limits(const Document& document, std::vector<RawNode>& nodes, const Report& report) {
  for (std::size_t i = 0; i < document.node_limits.size(); ++i) {
    if (document.node_limits[i].is_null()) continue;
    nodes[i].limit =
        LimitReader(document.node_limits[i], pointer("nodes", i, "extras", "marrow", "limits"), report).read();
  }
}

}  // namespace marrow::cook::gltf
