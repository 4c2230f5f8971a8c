#include <algorithm>

#include <fmt/format.h>

#include "commands/compare/thesis/thesis.h"

namespace marrow::tools {
namespace {

// Rates of one algorithm over another's, ascending, over sizes and paths that both have.
std::vector<double> ratios(const Thesis& thesis, const std::string& over, const std::string& under) {
  std::vector<double> out;
  for (const FrameRate& a : thesis.rates)
    for (const FrameRate& b : thesis.rates) {
      if (a.algorithm != over || b.algorithm != under || a.path != b.path || a.normals != b.normals) continue;
      for (std::size_t i = 0; i < a.frames_per_s.size(); ++i) out.push_back(a.frames_per_s[i] / b.frames_per_s[i]);
    }
  std::ranges::sort(out);
  return out;
}

const ThesisRow& row_of(const ThesisStudy& study, const std::string& algorithm) {
  return *std::ranges::find(study.rows, algorithm, &ThesisRow::algorithm);
}

std::string of_each(const Thesis& thesis, double (*value)(const ThesisStudy&), int decimals) {
  std::string out;
  for (const ThesisStudy& study : thesis.studies)
    out += fmt::format("{}{} {:.{}f}", out.empty() ? "" : ", ", study.name, value(study), decimals);
  return out;
}

std::string verdict(const Thesis& thesis, bool (*holds)(const ThesisStudy&)) {
  const auto count = static_cast<std::size_t>(std::ranges::count_if(thesis.studies, holds));
  return count == thesis.studies.size() ? "yes" : count == 0 ? "no" : "in part";
}

}  // namespace

std::string title_of_algorithm(const std::string& algorithm) {
  constexpr std::pair<const char*, const char*> kTitles[] = {
      {"rigid", "rigid segments"},
      {"stitched", "stitching (Woodland 2000)"},
      {"joint_local", "joint-dependent local deformations (Magnenat-Thalmann et al. 1988)"},
      {"ssd", "linear blend skinning, SSD"},
      {"ssd_refit", "SSD, weights fitted to examples"},
      {"as", "animation space"},
      {"as_lift", "animation space, lifted from SSD"},
      {"as_smooth", "animation space, smoothed"},
      {"as_fit", "animation space, fitted"},
      {"as_helpers", "animation space with helpers"},
      {"as_helpers_fit4", "animation space with helpers, fitted, four joints"},
      {"as_helpers_fit5", "animation space with helpers, fitted, five joints"},
      {"mwe", "multi-weight enveloping (Wang and Phillips 2002)"},
      {"psd", "pose space deformation (Lewis et al. 2000)"},
      {"eigenskin", "EigenSkin (Kry et al. 2002)"},
      {"dqs", "dual quaternions (Kavan et al. 2008)"},
      {"cor", "centres of rotation (Le and Hodgins 2016)"},
      {"delta-mush", "delta mush (Mancewicz et al. 2014)"}};
  for (const auto& [name, title] : kTitles)
    if (algorithm == name) return title;
  return algorithm;
}

std::vector<Claim> claims(const Thesis& thesis) {
  const std::vector<double> speed = ratios(thesis, "as", "ssd");  // the processor has some
  std::vector<Claim> out;
  out.push_back(
      {"Animation space draws 1.57 to 1.92 times as many frames as SSD.",
       fmt::format("{}: {:.2f} times as many, the median of {} paths and sizes; {:.2f} to {:.2f}",
                   speed[speed.size() / 2] < 1.57 ? "no" : "yes", speed[speed.size() / 2], speed.size(), speed.front(),
                   speed.back()),
       "The SSD of the thesis multiplies by the inverse of the bind pose for each vertex and influence. Here, as in "
       "every "
       "game today, that product is made once a joint, in the palette, which both share. What is left is what "
       "animation space has more of: a residual to fetch for each influence."});
  out.push_back(
      {"Animation space has fewer artefacts than SSD.",
       verdict(thesis, [](const ThesisStudy& s) { return row_of(s, "as_helpers_fit5").held_of_ssd < 1; }) +
           ": error over SSD's, held out: fitted " +
           of_each(
               thesis, [](const ThesisStudy& s) { return row_of(s, "as_fit").held_of_ssd; }, 2) +
           "; with helpers " +
           of_each(
               thesis, [](const ThesisStudy& s) { return row_of(s, "as_helpers_fit5").held_of_ssd; }, 2),
       "A fit finds for each vertex what weights cannot say. Where a joint turns both ways a linear model alone "
       "gains nothing; matrices between joints, the helpers, mend that."});
  return out;
}

}  // namespace marrow::tools
