#include "text/nearest.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <set>

#include "text/printable.h"

namespace marrow::tools {
namespace {

constexpr std::size_t kMostListed = 12;
// Fewer letters are part of too many names.
constexpr std::size_t kLeastPart = 3;

std::string lower_case(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, diagonal + 1, row[j] + 1});
    }
  }
  return row[b.size()];
}

std::string nearest_name(std::string_view wanted, const std::vector<std::string>& names) {
  const std::string text = lower_case(wanted);
  const std::string *nearest = nullptr, *holding = nullptr;
  std::size_t fewest = 0;
  for (const std::string& name : names) {
    const std::string other = lower_case(name);
    const std::size_t edits = edit_distance(text, other);
    // With as many edits as letters nothing is alike.
    const bool near =
        edits <= std::max<std::size_t>(2, other.size() / 3) && edits < std::max(text.size(), other.size());
    if (near && (nearest == nullptr || edits < fewest)) {
      nearest = &name;
      fewest = edits;
    }
    const bool holds = text.size() >= kLeastPart && other.find(text) != std::string::npos;
    if (holds && (holding == nullptr || name.size() < holding->size())) holding = &name;
  }
  const bool begins = holding != nullptr && lower_case(*holding).starts_with(text);
  if (nearest == nullptr || (begins && fewest > 1)) nearest = holding;
  return nearest == nullptr ? "" : *nearest;
}

std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names) {
  const std::string nearest = nearest_name(wanted, names);
  return nearest.empty() ? "" : "did you mean \"" + printable(nearest) + "\"?";
}

std::string listed(const std::vector<std::string>& names) {
  std::set<std::string_view> seen;
  std::string out;
  for (const std::string& name : names) {
    if (!seen.insert(name).second || seen.size() > kMostListed) continue;
    out.append(out.empty() ? "" : ", ").append(name);
  }
  if (seen.size() > kMostListed) out.append(" and ").append(std::to_string(seen.size() - kMostListed)).append(" more");
  return out;
}

std::string suggestion(std::string_view wanted, const std::vector<std::string>& names) {
  if (names.empty()) return "";
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back("\"" + printable(name) + "\"");
  const std::string question = did_you_mean(wanted, names);
  return question + (question.empty() ? "" : " ") + "there are " + listed(quoted);
}

}  // namespace marrow::tools
