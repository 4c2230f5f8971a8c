// Collects the warnings of one reading and keeps a broken file from filling a report with them.
#include "cook/gltf/document/findings.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::size_t kListedPerRule = 1000;

}  // namespace

void Report::warn(const std::string& where, const std::string& rule, const std::string& text) {
  if (++count_of_rule_[rule] > kListedPerRule) return;
  warnings_.push_back({tools::printable(where), rule, tools::printable(text)});
}

void Report::mend(const std::string& where, const std::string& rule, const std::string& text) {
  if (!mends()) invalid(where, rule, "not mended, " + mends_nothing_because_ + ": " + text);
  warn(where, rule, text);
}

std::vector<RawWarning> Report::take_warnings() {
  for (const auto& [rule, count] : count_of_rule_) {
    if (count <= kListedPerRule) continue;
    for (auto warning = warnings_.rbegin(); warning != warnings_.rend(); ++warning) {
      if (warning->rule != rule) continue;
      warning->text += " (and " + std::to_string(count - kListedPerRule) + " more like this)";
      break;
    }
  }
  count_of_rule_.clear();
  return std::move(warnings_);
}

}  // namespace marrow::cook::gltf
