#include "disk/settings.h"

#include <algorithm>
#include <filesystem>

#include "common/failure.h"
#include "cook/options/options_text.h"
#include "disk/files.h"
#include "text/pattern.h"
#include "toml/toml_reader.h"

namespace marrow::cook {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "marrow.toml";

FileRule read_rule(const std::string& path, const toml::node& node) {
  const tools::TomlReader reader(path);
  const toml::table* const table = node.as_table();
  if (table == nullptr) reader.fail(node, "a rule must be a table", "write [[file]]");
  FileRule rule;
  rule.where = tools::place_of(table->source());
  const toml::node* const match = table->get("match");
  if (match == nullptr) reader.fail(*table, "the rule does not say which files", "give match = \"chars/hero*.glb\"");
  for (const Value& value : strings_of(path, "match", *match)) rule.match.push_back(value.text);
  if (rule.match.empty()) reader.fail(*match, "\"match\" names no files", "give a name, * and ? allowed");
  rule.given = options_of(path, *table, "match");
  return rule;
}

bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

Settings parse_settings(const std::string& path, std::string_view text) {
  const toml::table root = tools::TomlReader(path).parse(text, kLargestSettings);
  Settings settings;
  settings.path = path;
  settings.folder = fs::weakly_canonical(fs::absolute(path)).parent_path().string();
  settings.defaults = options_of(path, root, "file");
  if (const toml::node* const rules = root.get("file")) {
    const toml::array* const array = rules->as_array();
    if (array == nullptr) tools::TomlReader(path).fail(*rules, "\"file\" must be a list of tables", "write [[file]]");
    for (const toml::node& rule : *array) settings.rules.push_back(read_rule(path, rule));
  }
  return settings;
}

Settings read_settings(const std::string& path) {
  std::error_code ignored;
  if (fs::file_size(path, ignored) > kLargestSettings && !ignored && fs::is_regular_file(path, ignored))
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

Options settings_for(const Settings& settings, const std::string& input, std::vector<bool>& used) {
  used.resize(settings.rules.size());
  std::error_code ignored;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(input), ignored);
  const std::string name = canonical.lexically_relative(settings.folder).generic_string();
  Options given = settings.defaults;
  for (std::size_t i = 0; i < settings.rules.size(); ++i) {
    const FileRule& rule = settings.rules[i];
    if (std::ranges::none_of(rule.match, [&](const std::string& m) { return tools::fits(m, name); })) continue;
    used[i] = true;
    replace(given, rule.given);
  }
  return given;
}

}  // namespace marrow::cook
