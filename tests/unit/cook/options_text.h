// Options as the command line has them: "--lod 0.5 --keep a* --keep b --clips-only".
#pragma once

#include <algorithm>
#include <string>

#include "options/options.h"

namespace marrow::cook {

inline Given given_of(const std::string& text) {
  Given given;
  for (std::size_t at = text.find("--"); at < text.size();) {
    const std::size_t next = std::min(text.find(" --", at), text.size());
    const std::string one = text.substr(at + 2, next - at - 2), name = one.substr(0, one.find(' '));
    given[name].push_back({name == one ? "true" : one.substr(name.size() + 1), {"--" + name, ""}});
    at = next + 1;
  }
  return given;
}
// Throws tools::Failure (usage).
inline CookOptions options_of(const std::string& text) {
  return to_options(given_of(text));
}

}  // namespace marrow::cook
