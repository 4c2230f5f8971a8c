#include "toml/toml_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/retold.h"
#include "text/deep_key.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::tools {

namespace {

// What toml++ says, and what to do where that is not plain.
std::string explained(std::string_view said) {
  static constexpr std::pair<std::string_view, std::string_view> kHints[] = {
      {"could not determine value type", "; text stands in straight quotes, as \"walk\""},
      {"expected key or closing '}', saw '\\n'", "; a table in { } stands in one line"},
      {"cannot redefine existing", "; it stands twice: leave one"}};
  std::string out(said.substr(0, said.find(" (TOML_")));
  for (const auto& [part, hint] : kHints)
    if (said.find(part) != std::string_view::npos) out += hint;
  if (std::ranges::any_of(said, [](char c) { return static_cast<unsigned char>(c) >= 0x80; }))
    out += "; a name with other letters than a to z is quoted";
  return out;
}

}  // namespace

std::string place_of(const toml::source_region& region) {
  return std::to_string(region.begin.line) + ':' + std::to_string(region.begin.column);
}

std::string toml_quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      out += fmt::format("\\u{:04X}", byte);
    } else {
      out += c;
    }
  }
  return out + '"';
}

void TomlReader::fail(const toml::source_region& at, const std::string& rule, const std::string& advice) const {
  throw Failure(Exit::usage, path_, place_of(at), printable(rule), printable(advice));
}

toml::table parse_toml(std::string_view text, const std::function<void(const toml::parse_error&)>& fail) {
  return retold<toml::parse_error>([&]() -> toml::table { return toml::parse(text); },
                                   [&](const toml::parse_error& e) {
                                     fail(e);
                                     return Failure(Exit::internal, "", "", "no TOML", "");
                                   });
}

toml::table TomlReader::parse(std::string_view text, std::size_t most_bytes) const {
  if (text.size() > most_bytes)
    throw Failure(Exit::usage, path_, "", "too large", fmt::format("{} KiB is the limit", most_bytes / 1024));
  if (const std::size_t line = line_of_deep_key(text))
    throw Failure(Exit::usage, path_, std::to_string(line) + ":1", "a key of too many parts", "quote names with dots");
  return parse_toml(text, [&](const toml::parse_error& e) { fail(e.source(), "no TOML", explained(e.description())); });
}

const toml::table& TomlReader::table(const toml::node& node, const char* what) const {
  const toml::table* const table = node.as_table();
  if (table == nullptr) fail(node, fmt::format("{} must be a table", what), "write { key = value }");
  return *table;
}

const toml::table& TomlReader::table(const toml::node& node, const char* what,
                                     const std::vector<std::string>& keys) const {
  const toml::table& table = this->table(node, what);
  for (const auto& [key, value] : table)
    if (std::ranges::find(keys, key.str()) == keys.end())
      fail(key.source(), fmt::format("{} has no \"{}\"", what, key.str()), suggestion(key.str(), keys));
  return table;
}

const toml::node& TomlReader::needed(const toml::table& table, const char* what, const char* key) const {
  const toml::node* const found = table.get(key);
  if (found == nullptr) fail(table, fmt::format("{} without \"{}\"", what, key), "give it");
  return *found;
}

const toml::array& TomlReader::list(const toml::node& node, const char* key) const {
  const toml::array* const array = node.as_array();
  if (array == nullptr) fail(node, fmt::format("\"{}\" must be a list", key), "write [ ]");
  return *array;
}

std::string TomlReader::text(const toml::node& node, const char* key) const {
  const auto* const text = node.as_string();
  if (text == nullptr || text->get().empty())
    fail(node, fmt::format("\"{}\" must be a string", key), "quote it, and leave it out rather than empty");
  return text->get();
}

bool TomlReader::flag(const toml::node& node, const char* key) const {
  const auto* const flag = node.as_boolean();
  if (flag == nullptr) fail(node, fmt::format("\"{}\" must be true or false", key), "without quotes");
  return flag->get();
}

float TomlReader::number(const toml::node& node, const char* key, double least, double most) const {
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value || !(least <= *value && *value <= most))
    fail(node, fmt::format("\"{}\" must be a number from {:g} to {:g}", key, least, most),
         value ? fmt::format("{:g} is none of those", *value) : "write it without quotes, as 0.5");
  return static_cast<float>(*value);
}

}  // namespace marrow::tools
