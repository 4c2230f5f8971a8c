#include "options/settings.h"

#include <algorithm>
#include <filesystem>

#include "common/failure.h"
#include "common/files.h"
#include "options/shape_settings.h"
#include "text/deep_key.h"
#include "text/nearest.h"
#include "text/pattern.h"
#include "text/printable.h"

namespace marrow::cook {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargest = 64 * 1024;
constexpr const char* kName = "marrow.toml";

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {}

  [[noreturn]] void fail(const std::string& where, const std::string& rule, const std::string& advice) const {
    throw tools::Failure(tools::Exit::usage, path_, where, tools::printable(rule), tools::printable(advice));
  }

  // `match` is a list in rules; `file` the rules' own name at the top.
  Given read_options(const toml::table& table, std::string_view but) const {
    Given given;
    for (const auto& [key, node] : table) {
      const std::string_view name = key.str();
      if (name == but) continue;
      if (name == kShapes) {
        given[kShapes] = read_shapes(path_, node);
        continue;
      }
      const auto option = std::ranges::find_if(option_table(), [&](const Option& o) { return name == o.name; });
      if (option == option_table().end()) unknown(key, but);
      given[option->name] = values(*option, node);
    }
    to_options(given);  // throws what is wrong
    return given;
  }

  FileRule read_rule(const toml::node& node) const {
    const toml::table* const table = node.as_table();
    if (table == nullptr) fail(place(node.source()), "a rule must be a table", "write [[file]]");
    FileRule rule;
    rule.where = place(table->source());
    const toml::node* const match = table->get("match");
    if (match == nullptr) fail(rule.where, "the rule does not say which files", "give match = \"chars/hero*.glb\"");
    for (const Value& value : strings("match", *match)) rule.match.push_back(value.text);
    if (rule.match.empty()) fail(place(match->source()), "\"match\" names no files", "give a name, * and ? allowed");
    rule.given = read_options(*table, "match");
    return rule;
  }

 private:
  [[noreturn]] void unknown(const toml::key& key, std::string_view also) const {
    std::vector<std::string> names{std::string(also), kShapes};
    for (const Option& option : option_table()) names.emplace_back(option.name);
    const std::string now = replacement_of(key.str());
    const std::string question = now.empty() ? tools::did_you_mean(key.str(), names) : now;
    fail(place(key.source()), "unknown setting \"" + std::string(key.str()) + "\"",
         question.empty() ? "`marrow cook --help` lists the options" : question);
  }

  Value value_of(const std::string& text, const toml::node& node) const {
    return {text, {path_, place(node.source()), false}};
  }

  std::vector<Value> strings(const std::string& name, const toml::node& node) const {
    if (const auto* const text = node.as_string()) return {value_of(text->get(), node)};
    const toml::array* const array = node.as_array();
    if (array == nullptr) fail(place(node.source()), "\"" + name + "\" must be a string or a list of them", "quote it");
    std::vector<Value> out;
    for (const toml::node& element : *array) {
      const auto* const text = element.as_string();
      if (text == nullptr) fail(place(element.source()), "\"" + name + "\" must list strings", "quote it");
      out.push_back(value_of(text->get(), element));
    }
    return out;
  }

  // As on the command line: NAME=TEXT each, in the order in which they are written.
  std::vector<Value> entries(const std::string& name, const toml::node& node) const {
    const toml::table* const table = node.as_table();
    if (table == nullptr) fail(place(node.source()), "\"" + name + "\" must be a table", "write [" + name + "]");
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
      if (text == nullptr) fail(place(value->source()), "\"" + left + "\" must be a string", "quote it");
      if (left.find('=') != std::string::npos) fail(place(key->source()), "a name with =", "leave it out");
      out.push_back(value_of(left + "=" + text->get(), *value));
    }
    return out;
  }

  std::vector<Value> values(const Option& option, const toml::node& node) const {
    const std::string name = option.name;
    if (option.kind == OptionKind::list) return strings(name, node);
    if (option.kind == OptionKind::table) return entries(name, node);
    if (option.kind == OptionKind::flag) {
      const auto* const flag = node.as_boolean();
      if (flag == nullptr) fail(place(node.source()), "\"" + name + "\" must be true or false", "without quotes");
      return {value_of(flag->get() ? "true" : "false", node)};
    }
    const auto* const text = node.as_string();
    if (text == nullptr) fail(place(node.source()), "\"" + name + "\" must be a string", "quote it");
    return {value_of(text->get(), node)};
  }

  std::string path_;
};

bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

Settings parse_settings(const std::string& path, std::string_view text) {
  const Reader reader(path);
  if (text.size() > kLargest) reader.fail("", "too large", "64 KiB is the limit; write patterns in place of names");
  if (const std::size_t line = tools::line_of_deep_key(text))
    reader.fail(std::to_string(line) + ":1", "a key of too many parts", "options stand at the top or in [[file]]");
  toml::table root;
  try {
    root = toml::parse(text);
  } catch (const toml::parse_error& e) {
    reader.fail(place(e.source()), "no TOML", std::string(e.description()));
  }
  Settings settings;
  settings.path = path;
  settings.folder = fs::weakly_canonical(fs::absolute(path)).parent_path().string();
  settings.defaults = reader.read_options(root, "file");
  if (const toml::node* const rules = root.get("file")) {
    const toml::array* const array = rules->as_array();
    if (array == nullptr) reader.fail(place(rules->source()), "\"file\" must be a list of tables", "write [[file]]");
    for (const toml::node& rule : *array) settings.rules.push_back(reader.read_rule(rule));
  }
  return settings;
}

Settings read_settings(const std::string& path) {
  std::error_code ignored;
  if (fs::file_size(path, ignored) > kLargest && !ignored && fs::is_regular_file(path, ignored))
    throw tools::Failure(tools::Exit::usage, path, "", "too large", "64 KiB is the limit");
  const tools::AlignedBytes bytes = tools::read_file(path);
  return parse_settings(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::optional<std::string> find_settings(const std::string& input, const std::string& root) {
  std::error_code ignored;
  const fs::path working = fs::weakly_canonical(fs::current_path(ignored), ignored);
  const fs::path start = fs::weakly_canonical(fs::absolute(input), ignored).parent_path();
  const fs::path above = fs::weakly_canonical(fs::absolute(root), ignored);
  const fs::path last = is_below(start, working) ? working : above;
  for (fs::path folder = start;; folder = folder.parent_path()) {
    const fs::path candidate = folder / kName;
    if (fs::is_regular_file(candidate, ignored)) {
      // As short as the user would write it.
      return is_below(candidate, working) ? candidate.lexically_relative(working).string() : candidate.string();
    }
    if (folder == last || folder == folder.parent_path() || !is_below(folder, last)) return std::nullopt;
  }
}

Given settings_for(const Settings& settings, const std::string& input, std::vector<bool>& used) {
  used.resize(settings.rules.size());
  std::error_code ignored;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(input), ignored);
  const std::string name = canonical.lexically_relative(settings.folder).generic_string();
  Given given = settings.defaults;
  for (std::size_t i = 0; i < settings.rules.size(); ++i) {
    const FileRule& rule = settings.rules[i];
    if (std::ranges::none_of(rule.match, [&](const std::string& m) { return tools::fits(m, name); })) continue;
    used[i] = true;
    replace(given, rule.given);
  }
  return given;
}

}  // namespace marrow::cook
