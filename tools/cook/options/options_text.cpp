#include "cook/options/options_text.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/failure.h"
#include "cook/options/shape_settings.h"
#include "text/nearest.h"
#include "text/printable.h"
#include "toml/toml_reader.h"

namespace marrow::cook {
namespace {

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {}

  [[noreturn]] void fail(const std::string& where, const std::string& rule, const std::string& advice) const {
    throw tools::Failure(tools::Exit::usage, path_, where, tools::printable(rule), tools::printable(advice));
  }

  std::vector<Value> strings(const std::string& name, const toml::node& node) const {
    if (const auto* const text = node.as_string()) return {value_of(text->get(), node)};
    const toml::array* const array = node.as_array();
    if (array == nullptr)
      fail(tools::place_of(node.source()), "\"" + name + "\" must be a string or a list of them", "quote it");
    std::vector<Value> out;
    for (const toml::node& element : *array) {
      const auto* const text = element.as_string();
      if (text == nullptr) fail(tools::place_of(element.source()), "\"" + name + "\" must list strings", "quote it");
      out.push_back(value_of(text->get(), element));
    }
    return out;
  }

  std::vector<Value> values(const Option& option, const toml::node& node) const {
    const std::string name = option.name;
    if (option.kind == OptionKind::list) return strings(name, node);
    if (option.kind == OptionKind::table) return entries(name, node);
    if (option.kind == OptionKind::flag) {
      const auto* const flag = node.as_boolean();
      if (flag == nullptr)
        fail(tools::place_of(node.source()), "\"" + name + "\" must be true or false", "without quotes");
      return {value_of(flag->get() ? "true" : "false", node)};
    }
    const auto* const text = node.as_string();
    if (text == nullptr) fail(tools::place_of(node.source()), "\"" + name + "\" must be a string", "quote it");
    return {value_of(text->get(), node)};
  }

  [[noreturn]] void unknown(const toml::key& key, std::string_view also) const {
    std::vector<std::string> names{kShapes};
    if (!also.empty()) names.emplace_back(also);
    for (const Option& option : option_table()) names.emplace_back(option.name);
    const std::string now = replacement_of(key.str());
    const std::string question = now.empty() ? tools::did_you_mean(key.str(), names) : now;
    fail(tools::place_of(key.source()), "unknown setting \"" + std::string(key.str()) + "\"",
         question.empty() ? "`marrow cook --help` lists the options" : question);
  }

 private:
  Value value_of(const std::string& text, const toml::node& node) const {
    return {text, {path_, tools::place_of(node.source()), false}};
  }

  // As on the command line: NAME=TEXT each, in the order in which they are written.
  std::vector<Value> entries(const std::string& name, const toml::node& node) const {
    const toml::table* const table = node.as_table();
    if (table == nullptr)
      fail(tools::place_of(node.source()), "\"" + name + "\" must be a table", "write [" + name + "]");
    std::vector<std::pair<const toml::key*, const toml::node*>> written;
    for (const auto& [key, value] : *table) written.emplace_back(&key, &value);
    std::ranges::sort(written, [](const auto& a, const auto& b) {
      const toml::source_position &x = a.first->source().begin, &y = b.first->source().begin;
      return x.line != y.line ? x.line < y.line : x.column < y.column;
    });
    std::vector<Value> out;
    for (const auto& [key, value] : written) {
      const std::string left(key->str());
      const auto* const text = value->as_string();
      if (text == nullptr) fail(tools::place_of(value->source()), "\"" + left + "\" must be a string", "quote it");
      if (left.find('=') != std::string::npos) fail(tools::place_of(key->source()), "a name with =", "leave it out");
      out.push_back(value_of(left + "=" + text->get(), *value));
    }
    return out;
  }

  const std::string& path_;
};

const Option* find_option(std::string_view name) {
  const auto found = std::ranges::find_if(option_table(), [&](const Option& o) { return name == o.name; });
  return found == option_table().end() ? nullptr : &*found;
}

std::string text_of(const Option& option, const std::vector<Value>& values) {
  std::string list;
  for (const Value& value : values) {
    if (!list.empty()) list += ", ";
    if (option.kind == OptionKind::table) {
      const std::size_t divide = value.text.find('=');
      list += tools::toml_quoted(value.text.substr(0, divide)) + " = " +
              tools::toml_quoted(divide == std::string::npos ? "" : value.text.substr(divide + 1));
    } else {
      list += tools::toml_quoted(value.text);
    }
  }
  if (option.kind == OptionKind::flag) return values.back().text;
  if (option.kind == OptionKind::text) return tools::toml_quoted(values.back().text);
  return option.kind == OptionKind::table ? "{" + list + "}" : "[" + list + "]";
}

}  // namespace

Options options_of(const std::string& path, const toml::table& table, std::string_view but) {
  const Reader reader(path);
  Options given;
  for (const auto& [key, node] : table) {
    const std::string_view name = key.str();
    if (name == but) continue;
    if (name == kShapes) {
      given[kShapes] = read_shapes(path, node);
      continue;
    }
    const Option* const option = find_option(name);
    if (option == nullptr) reader.unknown(key, but);
    given[option->name] = reader.values(*option, node);
  }
  to_options(given);  // throws what is wrong
  return given;
}

std::vector<Value> strings_of(const std::string& path, const std::string& name, const toml::node& node) {
  return Reader(path).strings(name, node);
}

void set(Options& options, std::string_view name, std::string_view value) {
  const Option* const option = find_option(name);
  const std::string flag = "--" + std::string(name);
  if (option == nullptr) {
    std::vector<std::string> names;
    for (const Option& known : option_table()) names.emplace_back(known.name);
    throw tools::Failure(tools::Exit::usage, tools::printable(flag), "", "no such option",
                         tools::suggestion(std::string(name), names));
  }
  std::vector<Value>& values = options[option->name];
  if (option->kind == OptionKind::flag || option->kind == OptionKind::text) values.clear();
  values.push_back({std::string(value), {flag, ""}});
}

Options read_options(const std::string& file, std::string_view toml) {
  return options_of(file, tools::TomlReader(file).parse(toml, kLargestSettings), "");
}

std::string write_options(const Options& options) {
  std::string out, shapes;
  for (const auto& [name, values] : options) {
    if (values.empty()) continue;
    if (name == kShapes) {
      for (const Value& value : values) shapes += text_of_shape(*value.shape);
    } else if (const Option* const option = find_option(name)) {
      out += name + " = " + text_of(*option, values) + '\n';
    }
  }
  return out + shapes;
}

}  // namespace marrow::cook
