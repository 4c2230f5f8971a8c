#include "text/deep_key.h"

#include <algorithm>
#include <string>

namespace marrow::tools {

std::size_t line_of_deep_key(std::string_view text) {
  constexpr std::size_t kMostDots = 16;
  std::size_t line = 1, dots = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '\n') {
      ++line;
      dots = 0;
    } else if (c == '#') {
      at = std::min(text.find('\n', at), text.size()) - 1;
    } else if (c == '.' && ++dots > kMostDots) {
      return line;
    } else if (c == '"' || c == '\'') {
      // A string, to its closing quote; one of a single quote ends with its line even if it is not closed.
      const bool multiline = text.substr(at, 3) == std::string(3, c);
      const std::string_view close = text.substr(at, multiline ? 3 : 1);
      for (at += close.size(); at < text.size() && text.substr(at, close.size()) != close; ++at) {
        if (text[at] == '\n' && !multiline) break;
        if (text[at] == '\n') ++line;
        if (text[at] == '\\' && c == '"' && text.substr(at + 1, 1) != "\n") ++at;
      }
      if (at >= text.size()) return 0;
      at = text[at] == '\n' ? at - 1 : at + close.size() - 1;
      for (int more = 0; multiline && more < 2 && text.substr(at + 1, 1) == close.substr(0, 1); ++more) ++at;
    }
  }
  return 0;
}

}  // namespace marrow::tools
