// Values of a TOML file, each refused at its line and column if it is not what it should be.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace marrow::tools {

// "line:column".
std::string place_of(const toml::source_region& region);

// A string as TOML has it, within quotation marks.
std::string toml_quoted(const std::string& text);

// A text of TOML. `fail` throws a Failure.
toml::table parse_toml(std::string_view text, const std::function<void(const toml::parse_error&)>& fail);

// All throw Failure (usage) with the file, the place, what is wrong and what to do.
class TomlReader {
 public:
  explicit TomlReader(std::string path) : path_(std::move(path)) {}

  const std::string& path() const { return path_; }
  [[noreturn]] void fail(const toml::source_region& at, const std::string& rule, const std::string& advice) const;
  [[noreturn]] void fail(const toml::node& at, const std::string& rule, const std::string& advice) const {
    fail(at.source(), rule, advice);
  }

  // The file's text, of at most most_bytes.
  toml::table parse(std::string_view text, std::size_t most_bytes) const;
  // A table that has none but these keys. what: "a shape".
  const toml::table& table(const toml::node& node, const char* what, const std::vector<std::string>& keys) const;
  const toml::table& table(const toml::node& node, const char* what) const;
  const toml::node& needed(const toml::table& table, const char* what, const char* key) const;
  const toml::array& list(const toml::node& node, const char* key) const;
  // Not empty.
  std::string text(const toml::node& node, const char* key) const;
  bool flag(const toml::node& node, const char* key) const;
  float number(const toml::node& node, const char* key, double least, double most) const;

 private:
  std::string path_;
};

}  // namespace marrow::tools
