// marrow.toml: options for all files below its folder, and for some of them by name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cook/options/options.h"

namespace marrow::cook {

struct FileRule {
  std::vector<std::string> match;  // names relative to the settings' folder; * stands for any characters, ? for one
  std::string where;               // "12:1"
  Options given;
};

struct Settings {
  std::string path;
  std::string folder;  // canonical
  Options defaults;
  std::vector<FileRule> rules;  // in order; a later one replaces options of an earlier one
};

// Every key, type and value is checked. Throws tools::Failure at "LINE:COLUMN": io if the file cannot be read, usage
// for everything else. The file is hostile until proven otherwise: at most 64 KiB.
Settings read_settings(const std::string& path);
Settings parse_settings(const std::string& path, std::string_view text);

// The nearest marrow.toml in the input's folder and those above it, up to the working directory if the input lies below
// it, else up to `root`.
std::optional<std::string> find_settings(const std::string& input, const std::string& root);

// What the settings say about one input. `used`: one a rule, set where it fits.
Options settings_for(const Settings& settings, const std::string& input, std::vector<bool>& used);

}  // namespace marrow::cook
