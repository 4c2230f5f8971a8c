// Warnings on their way to a terminal: one line a rule, however often it was broken.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace marrow::tools {

struct Warning {
  std::string where;  // what it is about, in a source or a cooked file
  std::string rule;   // empty: the text says all
  std::string text;
};

// `file: where: warning: rule: text`, the first of each rule, and of a rule that was broken more often
// ` (1 of 50HINT)` behind it. In the order in which rules first come.
std::vector<std::string> warning_lines(const std::string& file, std::span<const Warning> warnings,
                                       const std::string& hint = "");

}  // namespace marrow::tools
