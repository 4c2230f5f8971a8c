#include "terminal/warnings.h"

#include <map>

#include "text/printable.h"

namespace marrow::tools {

std::vector<std::string> warning_lines(const std::string& file, std::span<const Warning> warnings,
                                       const std::string& hint) {
  struct Rule {
    const Warning* first;
    std::size_t count = 0;
  };
  std::vector<Rule> rules;
  std::map<std::string, std::size_t> number;
  for (const Warning& warning : warnings) {
    const auto [at, is_new] = number.try_emplace(warning.rule.empty() ? warning.text : warning.rule, rules.size());
    if (is_new) rules.push_back({&warning});
    ++rules[at->second].count;
  }
  std::vector<std::string> lines;
  for (const Rule& rule : rules) {
    const Warning& first = *rule.first;
    std::string& line = lines.emplace_back(file + ": " + printable(first.where) + ": warning: ");
    line += (first.rule.empty() ? "" : first.rule + ": ") + printable(first.text);
    if (rule.count > 1) line += " (1 of " + std::to_string(rule.count) + hint + ")";
  }
  return lines;
}

}  // namespace marrow::tools
