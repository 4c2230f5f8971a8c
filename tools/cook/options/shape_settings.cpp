#include "cook/options/shape_settings.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

#include "common/failure.h"
#include "marrow/example_space.h"
#include "text/nearest.h"
#include "text/printable.h"
#include "toml/toml_reader.h"

namespace marrow::cook {
namespace {

constexpr double kFarthest = 1e6, kNearest = 1e-6;  // of points of a space

class ShapeReader {
 public:
  explicit ShapeReader(const std::string& path) : read_(path) {}

  ShapeRule read(const toml::node& node) const {
    const toml::table& table = read_.table(node, "a shape", {"name", "mesh", "parameters", "examples"});
    ShapeRule rule;
    rule.origin = {read_.path(), tools::place_of(table.source()), false};
    rule.name = read_.text(read_.needed(table, "a shape", "name"), "name");
    if (const toml::node* const mesh = table.get("mesh")) rule.mesh = read_.text(*mesh, "mesh");
    for (const toml::node& parameter : read_.list(read_.needed(table, "a shape", "parameters"), "parameters"))
      add_parameter(parameter, rule.parameters);
    if (rule.parameters.empty()) read_.fail(node, "a shape without parameters", "parameters = [\"joy\"]");
    const toml::array& examples = read_.list(read_.needed(table, "a shape", "examples"), "examples");
    for (const toml::node& example : examples) add_example(example, rule);
    if (rule.examples.size() < 2)
      read_.fail(examples, "less than two examples", "give each shape its place, { target = \"smile\", at = [1] }");
    if (std::ranges::all_of(rule.examples, [](const ShapeExample& e) { return e.target.empty(); }))
      read_.fail(examples, "no example has a target", "{ target = \"smile\", at = [1] }");
    return rule;
  }

 private:
  float number(const toml::node& node, const char* key) const { return read_.number(node, key, -kFarthest, kFarthest); }

  // "joy", or { name = "joy", default = 0.5 }.
  void add_parameter(const toml::node& node, std::vector<ShapeParameter>& to) const {
    ShapeParameter made;
    if (node.is_string()) {
      made.name = read_.text(node, "name");
    } else {
      const toml::table& table = read_.table(node, "a parameter", {"name", "default"});
      made.name = read_.text(read_.needed(table, "a parameter", "name"), "name");
      if (const toml::node* const rest = table.get("default")) made.rest = number(*rest, "default");
    }
    if (std::ranges::any_of(to, [&](const ShapeParameter& p) { return p.name == made.name; }))
      read_.fail(node, fmt::format("a second parameter \"{}\"", made.name), "a name each");
    if (to.size() == kMaxExampleParameters) read_.fail(node, "more than 8 parameters", "make two spaces of it");
    to.push_back(std::move(made));
  }

  void add_example(const toml::node& node, ShapeRule& rule) const {
    const toml::table& table = read_.table(node, "an example", {"target", "at"});
    ShapeExample made;
    made.where = tools::place_of(table.source());
    if (const toml::node* const target = table.get("target")) made.target = read_.text(*target, "target");
    const toml::array& at = read_.list(read_.needed(table, "an example", "at"), "at");
    for (const toml::node& coordinate : at) made.at.push_back(number(coordinate, "at"));
    if (made.at.size() != rule.parameters.size())
      read_.fail(at, fmt::format("{} numbers for {} parameters", made.at.size(), rule.parameters.size()),
                 "a number a parameter, in their order");
    for (const ShapeExample& other : rule.examples)
      if (distance(made.at, other.at) < kNearest)
        read_.fail(node, "an example at the place of another",
                   fmt::format("the other is at {}; move one", other.where));
    if (rule.examples.size() == kMaxExamples) read_.fail(node, "more than 64 examples", "make two spaces of it");
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

  tools::TomlReader read_;
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

std::vector<Value> read_shapes(const std::string& path, const toml::node& node) {
  const ShapeReader reader(path);
  const toml::array* const array = node.as_array();
  if (array == nullptr) tools::TomlReader(path).fail(node, "\"shapes\" must be a list of tables", "write [[shapes]]");
  std::vector<Value> out;
  for (const toml::node& element : *array) {
    ShapeRule rule = reader.read(element);
    const RuleOrigin origin = rule.origin;
    out.push_back({canonical(rule), origin, std::make_shared<const ShapeRule>(std::move(rule))});
  }
  return out;
}

std::string text_of_shape(const ShapeRule& rule) {
  const auto quoted = tools::toml_quoted;
  std::string out = "[[shapes]]\nname = " + quoted(rule.name) + '\n';
  if (!rule.mesh.empty()) out += "mesh = " + quoted(rule.mesh) + '\n';
  out += "parameters = [";
  for (const ShapeParameter& p : rule.parameters)
    out += fmt::format("{{name = {}, default = {}}}, ", quoted(p.name), static_cast<double>(p.rest));
  out += "]\nexamples = [";
  for (const ShapeExample& e : rule.examples) {
    out += e.target.empty() ? "{" : "{target = " + quoted(e.target) + ", ";
    out += fmt::format("at = [{}]}}, ", fmt::join(std::vector<double>(e.at.begin(), e.at.end()), ", "));
  }
  return out + "]\n";
}

}  // namespace marrow::cook
