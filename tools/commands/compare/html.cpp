#include "commands/compare/html.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "commands/compare/charts.h"
#include "commands/compare/look/look_table.h"
#include "commands/compare/motion/motion_page.h"
#include "commands/compare/page_text.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

std::string base64(const std::vector<std::byte>& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<std::uint32_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kDigits[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

// Sorted by who clicks a heading. What looks worse than plain skinning is marked.
std::string table(const std::vector<TableColumn>& of, const std::vector<TableLine>& lines) {
  const std::vector<TableColumn> columns = known(of, lines);
  const TableLine& ssd = plain_of(lines);
  std::string out = "<div class=\"wide\"><table><thead><tr><th>deformer</th>";
  for (const TableColumn& column : columns)
    out += fmt::format("<th>{}{}{}</th>", column.heading, *column.unit != '\0' ? ", " : "", column.unit);
  out += "</tr></thead>\n<tbody>\n";
  for (const TableLine& line : lines) {
    std::string cells;
    bool says_something = false;
    for (const TableColumn& column : columns) {
      const std::optional<double> value = column.value(line, ssd);
      says_something = says_something || value;
      cells += value ? fmt::format("<td data-value=\"{:.6g}\"{}>{:.{}f}</td>", *value,
                                   is_uglier(column, line, ssd) ? " class=\"ugly\"" : "", *value, column.decimals)
                     : std::string("<td data-value=\"\">–</td>");
    }
    if (says_something) out += fmt::format("<tr><td data-value=\"{0}\">{0}</td>{1}</tr>\n", escaped(line.name), cells);
  }
  return out + "</tbody></table></div>\n";
}

std::string truth_folds(const Study& study, const DeformerComparison& c) {
  if (c.truth_folds.empty()) return "";
  std::string out = fmt::format(
      "<h2>Where the truth itself folds</h2>\n<p>In {} of {} poses held out it has more than a thousandth of its "
      "triangles facing inwards. To be near it is no beauty there.</p>\n<div class=\"wide\"><table><thead><tr>"
      "<th>clip, where it folds most</th><th>time, s</th><th>joint</th><th>flipped triangles</th>"
      "<th>by plain skinning</th></tr></thead>\n<tbody>\n",
      c.folding, c.held);
  for (const TruthFold& f : c.truth_folds) {
    const std::string clip = escaped(f.clip.empty() ? "of no clip" : f.clip),
                      joint = escaped(study.joint_names[f.joint]);
    out += fmt::format(
        "<tr><td data-value=\"{0}\">{0}</td><td data-value=\"{1:.6g}\">{1:.2f}</td><td data-value=\"{2}\">{2}</td>"
        "<td data-value=\"{3}\">{3}</td><td data-value=\"{4}\">{4}</td></tr>\n",
        clip, f.time_s, joint, f.flipped, f.plain_flipped);
  }
  return out + "</tbody></table></div>\n";
}

// Named, it can be laid under the slider.
std::string figure(const Picture& p, const std::string& name) {
  return fmt::format(
      "<figure{}><img alt=\"{}\" src=\"data:image/jpeg;base64,{}\"><figcaption>{}</figcaption></figure>\n",
      name.empty() ? "" : " data-name=\"" + escaped(name) + '"', escaped(p.caption), base64(p.jpeg),
      escaped(p.caption));
}

std::string ramp(const PictureRow& row) {
  std::string stops;
  for (const std::string& colour : row.ramp) stops += (stops.empty() ? "" : ",") + colour;
  return fmt::format(
      "<div class=\"scale\">Distance from the truth, on one scale:<div class=\"ramp\" "
      "style=\"background:linear-gradient(90deg,{})\"></div><div class=\"ends\"><span>0</span><span>{}</span>"
      "<span>{}</span></div></div>\n",
      stops, length_text(0.5 * row.scale_m), length_text(row.scale_m));
}

}  // namespace

// Shapes stand in a square beside the slider.
std::string picture_row(const PictureRow& row) {
  constexpr std::size_t kMostAcross = 5;
  const std::size_t shapes = row.shapes.size();
  std::size_t beside = 1;
  while (beside * beside < shapes) ++beside;
  std::string out =
      fmt::format("<div class=\"pose\" style=\"--across:{};--beside:{}\"><h3>{}</h3><div class=\"grid shapes\">\n",
                  std::min(shapes, kMostAcross), beside, escaped(row.title));
  for (const Picture& p : row.shapes) out += figure(p, p.caption);
  out += "</div><div class=\"grid\">\n";
  for (const Picture& p : row.errors) out += figure(p, "");
  out += ramp(row);
  return out + "</div></div>\n";
}

std::string comparison_page(const PageContent& content) {
  const DeformerComparison& c = content.comparison;
  const std::string title = escaped(content.title);
  std::string out = fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>{}</title><style>{}</style>\n<h1>{}</h1>\n",
      title, kPageStyle, escaped(content.verdict.use));
  for (const std::string& line : content.verdict.why) out += fmt::format("<p class=\"why\">{}</p>\n", escaped(line));
  out += fmt::format("<p>{}: truth {}, {} poses learnt from, {} held out. {} m across.</p>\n", title,
                     escaped(content.truth), c.trained, c.held, plain_number(c.diagonal_m));
  if (!content.worst_poses.empty())
    out +=
        "<h2>Where linear blend skinning is worst</h2>\n<p class=\"note\">First plain linear blend skinning by the "
        "joints "
        "alone, as any engine draws it; then Marrow's; then the truth. Below, how far each is from that.</p>\n";
  for (const PictureRow& row : content.worst_poses) out += picture_row(row);
  const std::vector<TableLine> lines = table_lines(c, content.motion);
  out += "<h2>Figures</h2>\n" + table(kLookColumns, lines) + kAboutFigures + table(kCostColumns, lines) + kAboutCosts +
         truth_folds(content.study, c) + charts(content.study, c);
  const std::string motion = motion_tables(content.study, c, content.motion);
  if (!motion.empty()) out += "<h2>Range of motion</h2>\n";
  for (const PictureRow& row : content.worst_joints) out += picture_row(row);
  out += motion + "<script>" + kPageScript + "</script></html>\n";
  return out;
}

}  // namespace marrow::tools
