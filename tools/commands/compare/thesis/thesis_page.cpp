#include <algorithm>

#include <fmt/format.h>

#include "commands/compare/charts.h"
#include "commands/compare/html.h"
#include "commands/compare/page_text.h"
#include "commands/compare/thesis/thesis.h"

namespace marrow::tools {
namespace {

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
    out += fmt::format("<tr><td data-value=\"{0}\">{0}</td>", escaped(title_of_algorithm(row.algorithm)));
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
                    escaped(title_of_algorithm(rate.algorithm)), escaped(rate.path), rate.normals ? "yes" : "no");
    for (const double rate_hz : rate.frames_per_s) out += cell(rate_hz, 0);
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string claim_list(const Thesis& thesis) {
  std::string out;
  for (const Claim& c : claims(thesis))
    out += fmt::format("<h3>{}</h3>\n<p><b>Here: {}.</b> {}</p>\n", escaped(c.claim), escaped(c.holds), escaped(c.why));
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

std::string thesis_page(const Thesis& thesis) {
  std::string out = fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>Skinning algorithms</title><style>{}{}</style>\n"
      "<h1>Skinning algorithms, compared as the thesis of animation space compares them</h1>\n",
      kPageStyle, kThesisStyle);
  out += "<h2>What holds</h2>\n" + claim_list(thesis);
  out += "<h2>Table 1: speed, labour, smoothness</h2>\n";
  for (const ThesisStudy& study : thesis.studies)
    out += fmt::format("<h3>{}, {} vertices, {} joints</h3>\n", escaped(study.name), study.vertices, study.joints) +
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
  out +=
      thesis.driver.empty() ? " No OpenGL ES here.</p>\n" : fmt::format(" Drawn by {}.</p>\n", escaped(thesis.driver));
  out += third_table(thesis);
  out +=
      "<p class=\"note\">kernel: the runtime's, one core, nothing drawn. double: the plain formulas. Others are drawn, "
      "from the first call to a pixel read back.</p>\n";
  for (const ThesisStudy& study : thesis.studies) {
    if (!study.pictures.empty()) out += fmt::format("<h2>{}, bones in motion</h2>\n", escaped(study.name));
    for (const PictureRow& row : study.pictures) out += picture_row(row);
  }
  return out + kSlips + "<script>" + kPageScript + "</script></html>\n";
}

}  // namespace marrow::tools
