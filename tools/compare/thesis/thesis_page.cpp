#include <algorithm>

#include <fmt/format.h>

#include "compare/page.h"
#include "compare/page_text.h"
#include "compare/thesis/thesis.h"

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

struct Column {
  const char* heading;
  int decimals;
  double (*value)(const ThesisRow& row);
};
using Row = const ThesisRow&;
constexpr Column kColumns[] = {
    {"speed: kernel, ns a vertex", 2, [](Row r) { return r.ns_per_vertex; }},
    {"speed: in double, ns a vertex", 1, [](Row r) { return r.double_ns_per_vertex; }},
    {"labour: numbers a vertex", 2, [](Row r) { return r.labour.numbers_per_vertex; }},
    {"files", 0, [](Row r) { return static_cast<double>(r.labour.files); }},
    {"poses shaped", 0, [](Row r) { return static_cast<double>(r.labour.poses); }},
    {"cooker, s", 2, [](Row r) { return r.learn_s; }},
    {"error of SSD's, held out", 3, [](Row r) { return r.held_of_ssd; }},
    {"bends: largest jump of normals, degrees", 1, [](Row r) { return r.bends.largest_jump_deg; }},
    {"bends: RMS jump, degrees", 2, [](Row r) { return r.bends.rms_jump_deg; }},
    {"bends: curvature of the bind pose's", 2, [](Row r) { return r.bends.curvature; }},
    {"twists: largest jump, degrees", 1, [](Row r) { return r.twists.largest_jump_deg; }},
    {"twists: RMS jump, degrees", 2, [](Row r) { return r.twists.rms_jump_deg; }},
    {"twists: curvature of the bind pose's", 2, [](Row r) { return r.twists.curvature; }},
};

std::string cell(double value, int decimals) {
  return value == 0 ? "<td data-value=\"\">–</td>"
                    : fmt::format("<td data-value=\"{:.9g}\">{:.{}f}</td>", value, value, decimals);
}

bool has_values(const Column& column, const ThesisStudy& study) {
  return std::ranges::any_of(study.rows, [&](Row row) { return column.value(row) != 0; });
}

std::string first_table(const ThesisStudy& study) {
  std::string out = "<div class=\"wide\"><table><thead><tr><th>algorithm</th>";
  for (const Column& column : kColumns)
    if (has_values(column, study)) out += fmt::format("<th>{}</th>", column.heading);
  out += "</tr></thead>\n<tbody>\n";
  for (const ThesisRow& row : study.rows) {
    out += fmt::format("<tr><td data-value=\"{0}\">{0}</td>", html_text(title_of_algorithm(row.algorithm)));
    for (const Column& column : kColumns)
      if (has_values(column, study)) out += cell(column.value(row), column.decimals);
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string third_table(const Thesis& thesis) {
  std::string out = "<div class=\"wide\"><table><thead><tr><th>algorithm</th><th>path</th><th>normals</th>";
  for (const ThesisSize& size : kThesisSizes) out += fmt::format("<th>{}</th>", size.name);
  out += "</tr></thead>\n<tbody>\n";
  for (const FrameRate& rate : thesis.rates) {
    out +=
        fmt::format("<tr><td data-value=\"{0}\">{0}</td><td data-value=\"{1}\">{1}</td><td data-value=\"{2}\">{2}</td>",
                    html_text(title_of_algorithm(rate.algorithm)), html_text(rate.path), rate.normals ? "yes" : "no");
    for (const double rate_hz : rate.frames_per_s) out += cell(rate_hz, 0);
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string claim_list(const Thesis& thesis) {
  std::string out;
  for (const Claim& c : claims(thesis))
    out += fmt::format("<h3>{}</h3>\n<p><b>Here: {}.</b> {}</p>\n", html_text(c.claim), html_text(c.holds),
                       html_text(c.why));
  return out;
}

constexpr const char* kThesisStyle = "td:first-child{white-space:normal;min-width:13rem}p{max-width:46rem}";

constexpr const char* kSlips =
    "<h2>Slips of the thesis</h2>\n<ul><li>Of a coordinate p_i the fourth component is w_i, the joint's weight, and "
    "not 1: "
    "so that the components of a vertex sum to 1.</li><li>In its first equation the matrix W, which takes a joint to "
    "the "
    "world, is missing: M_i = W_i B_i⁻¹.</li></ul>\n";

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

std::string thesis_page(const Thesis& thesis) {
  std::string out = fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>Skinning algorithms</title><style>{}{}</style>\n"
      "<h1>Skinning algorithms, compared as the thesis of animation space compares them</h1>\n",
      kPageStyle, kThesisStyle);
  out += "<h2>What holds</h2>\n" + claim_list(thesis);
  out += "<h2>Table 1: speed, labour, smoothness</h2>\n";
  for (const ThesisStudy& study : thesis.studies)
    out += fmt::format("<h3>{}, {} vertices, {} joints</h3>\n", html_text(study.name), study.vertices, study.joints) +
           first_table(study);
  out +=
      "<p class=\"note\">Speed: of positions, on the machine that made this page, one core. Kernels are the runtime's, "
      "in single precision and four lanes; in double precision are the plain formulas, as far as there is no kernel or "
      "to "
      "compare those. Labour: numbers that somebody paints or sets beside the joints; what is learnt takes its shapes "
      "from another deformer. Smoothness: over the range of motion, each joint alone as far as it turns, where joints "
      "meet: how far the normals of the two triangles at an edge are turned against each other beyond the bind pose, "
      "and "
      "the root mean square of the mean curvature.</p>\n";
  out += "<h2>Table 3: frames a second</h2>\n<p>Vertices × joints, four influences, with helpers five.";
  out += thesis.driver.empty() ? " No OpenGL ES here.</p>\n"
                               : fmt::format(" Drawn by {}.</p>\n", html_text(thesis.driver));
  out += third_table(thesis);
  out +=
      "<p class=\"note\">kernel: the runtime's, one core, nothing drawn. double: the plain formulas. Others are drawn, "
      "from the first call to a pixel read back.</p>\n";
  for (const ThesisStudy& study : thesis.studies) {
    if (!study.pictures.empty()) out += fmt::format("<h2>{}, bones in motion</h2>\n", html_text(study.name));
    for (const PictureRow& row : study.pictures) out += picture_row(row);
  }
  return out + kSlips + "<script>" + kPageScript + "</script></html>\n";
}

}  // namespace marrow::tools
