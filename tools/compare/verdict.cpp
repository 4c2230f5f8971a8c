#include "compare/verdict.h"

#include <algorithm>

#include <fmt/format.h>

namespace marrow::tools {
namespace {

constexpr double kInvisible = 1e-4;  // of the diagonal: a fifth of a millimetre on a person
constexpr double kWorthIt = 0.75;    // of the error that a costlier deformer must beat
constexpr double kMostJump = 1.1;    // of plain skinning's

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

// In which ways one looks worse than plain skinning; empty: in none.
std::string worse_looks(const SurfaceLook& look, const SurfaceLook& plain) {
  std::string out;
  const auto add = [&](bool is_worse, const std::string& text) {
    if (is_worse) out += (out.empty() ? "" : ", ") + text;
  };
  add(reads_more(look.flipped, plain.flipped, kFlippedDecimals),
      fmt::format("{:.1f} flipped triangles a pose for {:.1f}", look.flipped, plain.flipped));
  add(reads_more(look.bend_deg, plain.bend_deg, kBendDecimals),
      fmt::format("it bends by {:.2f}° for {:.2f}°", look.bend_deg, plain.bend_deg));
  add(reads_more(100 * look.creased, 100 * plain.creased, kCreasedDecimals),
      fmt::format("it creases {:.2f} % of its edges for {:.2f} %", 100 * look.creased, 100 * plain.creased));
  if (look.jump_of_ssd)
    add(*look.jump_of_ssd > kMostJump, fmt::format("it jumps {:.2f} times as far between frames", *look.jump_of_ssd));
  return out;
}

struct Choice {
  const DeformerRow* row;
  const char* how;
};

constexpr std::pair<const char*, const char*> kChoices[] = {
    {"as_smooth", "--as smooth"},
    {"as_fit", "--as fit --helpers 0"},
    {"as_helpers", "--helpers auto"},
    {"as_helpers_fit4", "--as fit --helpers auto --influences 4"},
    {"as_helpers_fit5", "--as fit --helpers auto"}};

// From the cheapest on: the next one must take a quarter off the error, or the one before stays.
Choice choose(const DeformerComparison& c, const DeformerRow& ssd, bool only_beautiful) {
  Choice out{&ssd, ""};
  for (const auto& [name, options] : kChoices) {
    const DeformerRow* const row = find(c, name);
    if (row == nullptr || row->held_rms > kWorthIt * out.row->held_rms) continue;
    if (only_beautiful && is_uglier(row->look, ssd.look)) continue;
    out = {row, options};
  }
  return out;
}

std::string where(const Study& study, const TruthFold& fold) {
  return fmt::format(
      "at joint {} {}: {} triangles, plain skinning {}", study.joint_names[fold.joint],
      fold.clip.empty() ? "in a pose of no clip" : fmt::format("in \"{}\" at {:.2f} s", fold.clip, fold.time_s),
      fold.flipped, fold.plain_flipped);
}

bool can_fold(const std::string& truth) {
  return truth != "elastic" && truth != "examples";
}

// What hardly folds may be wrung to a thread instead, which no fold tells.
std::string of_rings(const DeformerComparison& c, const MotionStudy& motion, const DeformerRow& used) {
  constexpr double kThread = 0.5, kMuch = 0.2;
  if (motion.of.empty() || !motion.truth_ring) return "";
  const double ring = motion.of[static_cast<std::size_t>(&used - c.rows.data())].ring_over_bind.value_or(1);
  if (ring > kThread || *motion.truth_ring < ring + kMuch) return "";
  return fmt::format("But {} wrings joints: twisted to 170° they keep {:.2f} of their thickness, by the truth {:.2f}.",
                     used.deformer, ring, *motion.truth_ring);
}

std::string of_folds(const Study& study, const std::string& truth, const DeformerComparison& c,
                     const SurfaceLook& plain) {
  const std::string worse = worse_looks(c.truth, plain);
  if (c.folding == 0 && worse.empty()) return "";
  std::string out;
  if (c.folding > 0)
    out = fmt::format("The truth itself folds in {} of {} poses, most {}.", c.folding, c.held,
                      where(study, c.truth_folds.front()));
  if (!worse.empty())
    out += fmt::format("{}The truth looks worse than plain skinning: {}.", out.empty() ? "" : " ", worse);
  out += " To be near it is no beauty there";
  return out +
         (truth == "elastic" || truth == "examples" ? "." : ": look at --truth elastic, too, which hardly folds.");
}

}  // namespace

bool is_uglier(const SurfaceLook& look, const SurfaceLook& plain) {
  return !worse_looks(look, plain).empty();
}

Verdict verdict(const Study& study, const std::string& truth, const DeformerComparison& c, const MotionStudy& motion) {
  const DeformerRow* const ssd = find(c, "ssd");
  Verdict out{"ssd", "", {}};
  const Choice nearest = choose(c, *ssd, false), best = choose(c, *ssd, true);
  const bool is_near = ssd->held_rms < kInvisible * c.diagonal_m;
  if (is_near) {
    out.use = fmt::format(
        "Use linear blend skinning: it is within {:.3g} % of the character's size of the truth, which nobody sees.",
        100 * ssd->held_rms / c.diagonal_m);
  } else if (nearest.row == ssd) {
    out.use = "Use linear blend skinning: nothing here takes a quarter off its error.";
  } else if (best.row == ssd) {
    out.use = fmt::format("Use linear blend skinning{}: what is nearer to the truth {} looks worse.",
                          can_fold(truth) ? ", or learn from another truth" : "", truth);
  } else {
    out.deformer = best.row->deformer;
    out.use = fmt::format(
        "Use animation space (cook with {}): {:.0f} % of linear blend skinning's error in poses it was not shown, "
        "worse in {:.1f} % of them. It costs {:.1f} instead of {:.1f} bytes a vertex{}{}.",
        best.how, 100 * best.row->held_rms / ssd->held_rms, 100 * best.row->worse_share, best.row->bytes_per_vertex,
        ssd->bytes_per_vertex, more_of(*best.row, *ssd), gpu_cost_of(*best.row, *ssd));
  }
  const bool is_refused =
      !is_near && nearest.row->held_rms < best.row->held_rms && is_uglier(nearest.row->look, ssd->look);
  if (is_refused)
    out.why.push_back(fmt::format("{} is nearer, {:.0f} % of the error, but looks worse than plain skinning: {}.",
                                  nearest.row->deformer, 100 * nearest.row->held_rms / ssd->held_rms,
                                  worse_looks(nearest.row->look, ssd->look)));
  const std::string wrung = of_rings(c, motion, *find(c, out.deformer));
  if (!wrung.empty()) out.why.push_back(wrung);
  const std::string folds = of_folds(study, truth, c, ssd->look);
  if (!folds.empty()) out.why.push_back(folds);
  const auto flips = [&](const DeformerRow& row) {
    return motion.of.empty() ? 0 : motion.of[static_cast<std::size_t>(&row - c.rows.data())].mean_flipped;
  };
  if (const DeformerRow& row = *find(c, out.deformer); reads_more(flips(row), flips(*ssd), kFlippedDecimals))
    out.why.push_back(
        fmt::format("With single joints turned as far as they go, beyond the clips, it flips {:.1f} triangles a pose "
                    "for plain skinning's {:.1f}: see the range of motion.",
                    flips(row), flips(*ssd)));
  return out;
}

}  // namespace marrow::tools
