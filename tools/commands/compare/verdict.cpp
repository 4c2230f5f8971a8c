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

// Influences and palette entries, where it has more of them than SSD.
std::string more_of(const DeformerRow& row, const DeformerRow& ssd) {
  std::string out;
  const auto add = [&](const char* what, std::uint32_t has, std::uint32_t had) {
    if (has > had) out += fmt::format(", {} instead of {} {}", has, had, what);
  };
  add("influences", row.influences, ssd.influences);
  add("palette entries", row.palette_entries, ssd.palette_entries);
  return out;
}

// What it costs on phones' GPUs beside SSD, or nothing where that is not known.
std::string gpu_cost_of(const DeformerRow& row, const DeformerRow& ssd) {
  if (row.gpu.mali_cycles == 0 || ssd.gpu.mali_cycles == 0) return "";
  return fmt::format(
      ", {:.1f} times the cycles on a Mali-G57, {:.1f} and {:.1f} times the instructions on an Adreno 660 and a V3D "
      "4.2{}",
      row.gpu.mali_cycles / ssd.gpu.mali_cycles, row.gpu.adreno_instructions / ssd.gpu.adreno_instructions,
      row.gpu.videocore_instructions / ssd.gpu.videocore_instructions,
      row.gpu.spills ? ", with registers spilled" : "");
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
                                                         {"as_fit", "--as fit --helpers 0"},
                                                         {"as_helpers", "--helpers auto"},
                                                         {"as_helpers_fit4", "--as fit --helpers auto --influences 4"},
                                                         {"as_helpers_fit5", "--as fit --helpers auto"}};
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
      "of them. It costs {:.1f} instead of {:.1f} bytes a vertex{}{}.",
      how, 100 * best->held_rms / ssd->held_rms, 100 * best->worse_share, best->bytes_per_vertex, ssd->bytes_per_vertex,
      more_of(*best, *ssd), gpu_cost_of(*best, *ssd));
}

}  // namespace marrow::tools
