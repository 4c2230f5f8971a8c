// Options as the command line has them: "--lod 0.5 --keep a* --keep b --clips-only".
#pragma once

#include <algorithm>
#include <string>

#include "cook/options/options.h"

namespace marrow::cook {

inline Options given_of(const std::string& text) {
  Options given;
  for (std::size_t at = text.find("--"); at < text.size();) {
    const std::size_t next = std::min(text.find(" --", at), text.size());
    const std::string one = text.substr(at + 2, next - at - 2), name = one.substr(0, one.find(' '));
    std::string value = name == one ? "true" : one.substr(name.size() + 1);
    value.erase(value.find_last_not_of(' ') + 1);
    given[name].push_back({value, {"--" + name, ""}});
    at = next + 1;
  }
  return given;
}
// Throws tools::Failure (usage).
inline CookOptions options_of(const std::string& text) {
  return to_options(given_of(text));
}

}  // namespace marrow::cook
