#include "options/shape_settings.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

#include "common/failure.h"
#include "marrow/example_space.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::cook {
namespace {

constexpr double kFarthest = 1e6, kNearest = 1e-6;  // of points of a space

class ShapeReader {
 public:
  explicit ShapeReader(const std::string& path) : path_(path) {}

  [[noreturn]] void fail(const toml::node& node, const std::string& rule, const std::string& advice) const {
    throw tools::Failure(tools::Exit::usage, path_, place(node.source()), tools::printable(rule),
                         tools::printable(advice));
  }

  ShapeRule read(const toml::node& node) const {
    const toml::table& table = table_of(node, "a shape", {"name", "mesh", "parameters", "examples"});
    ShapeRule rule;
    rule.origin = {path_, place(table.source()), false};
    rule.name = text(needed(table, "a shape", "name"), "name");
    if (const toml::node* const mesh = table.get("mesh")) rule.mesh = text(*mesh, "mesh");
    for (const toml::node& parameter : list(needed(table, "a shape", "parameters"), "parameters"))
      add_parameter(parameter, rule.parameters);
    if (rule.parameters.empty()) fail(node, "a shape without parameters", "parameters = [\"joy\"]");
    const toml::array& examples = list(needed(table, "a shape", "examples"), "examples");
    for (const toml::node& example : examples) add_example(example, rule);
    if (rule.examples.size() < 2)
      fail(examples, "less than two examples", "give each shape its place, { target = \"smile\", at = [1] }");
    if (std::ranges::all_of(rule.examples, [](const ShapeExample& e) { return e.target.empty(); }))
      fail(examples, "no example has a target", "{ target = \"smile\", at = [1] }");
    return rule;
  }

 private:
  const toml::table& table_of(const toml::node& node, const char* what, std::vector<std::string> keys) const {
    const toml::table* const table = node.as_table();
    if (table == nullptr)
      fail(node, fmt::format("{} must be a table", what), fmt::format("with {}", fmt::join(keys, ", ")));
    for (const auto& [key, value] : *table) {
      if (std::ranges::find(keys, key.str()) != keys.end()) continue;
      throw tools::Failure(tools::Exit::usage, path_, place(key.source()),
                           tools::printable(fmt::format("{} has no \"{}\"", what, key.str())),
                           tools::suggestion(key.str(), keys));
    }
    return *table;
  }

  const toml::node& needed(const toml::table& table, const char* what, const char* key) const {
    const toml::node* const found = table.get(key);
    if (found == nullptr) fail(table, fmt::format("{} without \"{}\"", what, key), "give it");
    return *found;
  }

  std::string text(const toml::node& node, const char* key) const {
    const auto* const text = node.as_string();
    if (text == nullptr || text->get().empty())
      fail(node, fmt::format("\"{}\" must be a string", key), "quote it, and leave it out rather than empty");
    return text->get();
  }

  const toml::array& list(const toml::node& node, const char* key) const {
    const toml::array* const array = node.as_array();
    if (array == nullptr) fail(node, fmt::format("\"{}\" must be a list", key), "write [ ]");
    return *array;
  }

  float number(const toml::node& node) const {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value || !(std::fabs(*value) <= kFarthest)) fail(node, "no number up to 1e6", "write 0.5");
    return static_cast<float>(*value);
  }

  // "joy", or { name = "joy", default = 0.5 }.
  void add_parameter(const toml::node& node, std::vector<ShapeParameter>& to) const {
    ShapeParameter made;
    if (node.is_string()) {
      made.name = text(node, "name");
    } else {
      const toml::table& table = table_of(node, "a parameter", {"name", "default"});
      made.name = text(needed(table, "a parameter", "name"), "name");
      if (const toml::node* const rest = table.get("default")) made.rest = number(*rest);
    }
    if (std::ranges::any_of(to, [&](const ShapeParameter& p) { return p.name == made.name; }))
      fail(node, fmt::format("a second parameter \"{}\"", made.name), "a name each");
    if (to.size() == kMaxExampleParameters) fail(node, "more than 8 parameters", "make two spaces of it");
    to.push_back(std::move(made));
  }

  void add_example(const toml::node& node, ShapeRule& rule) const {
    const toml::table& table = table_of(node, "an example", {"target", "at"});
    ShapeExample made;
    made.where = place(table.source());
    if (const toml::node* const target = table.get("target")) made.target = text(*target, "target");
    const toml::array& at = list(needed(table, "an example", "at"), "at");
    for (const toml::node& coordinate : at) made.at.push_back(number(coordinate));
    if (made.at.size() != rule.parameters.size())
      fail(at, fmt::format("{} numbers for {} parameters", made.at.size(), rule.parameters.size()),
           "a number a parameter, in their order");
    for (const ShapeExample& other : rule.examples)
      if (distance(made.at, other.at) < kNearest)
        fail(node, "an example at the place of another", fmt::format("the other is at {}; move one", other.where));
    if (rule.examples.size() == kMaxExamples) fail(node, "more than 64 examples", "make two spaces of it");
    rule.examples.push_back(std::move(made));
  }

  static double distance(const std::vector<float>& a, const std::vector<float>& b) {
    double squared = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double along = static_cast<double>(a[i]) - static_cast<double>(b[i]);
      squared += along * along;
    }
    return std::sqrt(squared);
  }

  std::string path_;
};

// The same for the same shape, wherever it stands.
std::string canonical(const ShapeRule& rule) {
  const auto text = [](const std::string& s) { return fmt::format("{} {}", s.size(), s); };
  std::string out = text(rule.name) + " mesh " + text(rule.mesh);
  for (const ShapeParameter& p : rule.parameters) out += fmt::format(" by {} {}", text(p.name), p.rest);
  for (const ShapeExample& e : rule.examples) out += fmt::format(" {} at {}", text(e.target), fmt::join(e.at, " "));
  return out;
}

}  // namespace

std::string place(const toml::source_region& region) {
  return std::to_string(region.begin.line) + ':' + std::to_string(region.begin.column);
}

std::vector<Value> read_shapes(const std::string& path, const toml::node& node) {
  const ShapeReader reader(path);
  const toml::array* const array = node.as_array();
  if (array == nullptr) reader.fail(node, "\"shapes\" must be a list of tables", "write [[shapes]]");
  std::vector<Value> out;
  for (const toml::node& element : *array) {
    ShapeRule rule = reader.read(element);
    const RuleOrigin origin = rule.origin;
    out.push_back({canonical(rule), origin, std::make_shared<const ShapeRule>(std::move(rule))});
  }
  return out;
}

}  // namespace marrow::cook
