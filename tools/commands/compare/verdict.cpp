#include "commands/compare/verdict.h"

#include <algorithm>

#include <fmt/format.h>

namespace marrow::tools {
namespace {

constexpr double kInvisible = 1e-4;  // of the diagonal: a fifth of a millimetre on a person
constexpr double kWorthIt = 0.75;    // of the error that a costlier deformer must beat

const DeformerRow* find(const DeformerComparison& c, const std::string& name) {
  const auto at = std::ranges::find(c.rows, name, &DeformerRow::deformer);
  return at == c.rows.end() ? nullptr : &*at;
}

}  // namespace

// From the cheapest on: the next one must take a quarter off the error, or the one before stays.
std::string verdict(const DeformerComparison& c) {
  const DeformerRow* const ssd = find(c, "ssd");
  if (ssd->held_rms < kInvisible * c.diagonal_m)
    return fmt::format(
        "Use linear blend skinning: it is within {:.3g} % of the character's size of the truth, which nobody sees.",
        100 * ssd->held_rms / c.diagonal_m);
  const DeformerRow* best = ssd;
  const char* how = "";
  const std::pair<const char*, const char*> choices[] = {{"as_smooth", "--as smooth"},
                                                         {"as_fit", "--as fit"},
                                                         {"as_fit_half1", "--as fit --half-joints 1"},
                                                         {"as_fit_half2", "--as fit --half-joints 2"}};
  for (const auto& [name, options] : choices) {
    const DeformerRow* const row = find(c, name);
    if (row == nullptr || row->held_rms > kWorthIt * best->held_rms) continue;
    best = row;
    how = options;
  }
  if (best == ssd) return "Use linear blend skinning: nothing here takes a quarter off its error.";
  return fmt::format(
      "Use animation space (cook with {}): {:.0f} % of linear blend skinning's error in poses it was not shown, worse "
      "in {:.1f} % "
      "of them, {:.1f} instead of {:.1f} bytes a vertex.",
      how, 100 * best->held_rms / ssd->held_rms, 100 * best->worse_share, best->bytes_per_vertex,
      ssd->bytes_per_vertex);
}

}  // namespace marrow::tools
