#include "commands/compare/html.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "commands/compare/charts.h"
#include "commands/compare/motion/motion_page.h"
#include "commands/compare/page_text.h"
#include "commands/compare/verdict.h"
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

// A column of figures.
struct Column {
  const char* heading;
  const char* unit;
  int decimals;
  double (*value)(const DeformerRow& row, const DeformerRow& ssd);
  bool zero_is_none = false;
};
using Row = const DeformerRow&;
constexpr Column kColumns[] = {
    {"RMS, learnt from", "mm", 4, [](Row r, Row) { return 1e3 * r.train_rms; }},
    {"RMS, held out", "mm", 4, [](Row r, Row) { return 1e3 * r.held_rms; }},
    {"of SSD's", "", 3, [](Row r, Row ssd) { return ssd.held_rms > 0 ? r.held_rms / ssd.held_rms : 1.0; }},
    {"largest", "mm", 3, [](Row r, Row) { return 1e3 * r.held_max; }},
    {"poses worse than SSD", "%", 1, [](Row r, Row) { return 100 * r.worse_share; }},
    {"volume of the truth's", "", 3, [](Row r, Row) { return r.volume; }},
    {"sharpest crease", "degrees", 1, [](Row r, Row) { return r.crease_deg; }},
    {"normals off by", "degrees", 2, [](Row r, Row) { return r.normal_deg; }},
    {"if blended", "degrees", 2, [](Row r, Row) { return r.blended_normal_deg; }},
    {"size", "bytes a vertex", 2, [](Row r, Row) { return r.bytes_per_vertex; }, true},
    {"time", "ns a vertex", 2, [](Row r, Row) { return r.ns_per_vertex; }, true},
    {"instructions", "a vertex", 2, [](Row r, Row) { return r.instructions_per_vertex; }, true},
    {"displacements", "a vertex", 2, [](Row r, Row) { return r.displacements_per_vertex; }, true},
    {"Mali-G57", "cycles a vertex", 0, [](Row r, Row) { return r.gpu.mali_cycles; }, true},
    {"Adreno 660", "instructions a vertex", 0, [](Row r, Row) { return r.gpu.adreno_instructions; }, true},
    {"V3D 4.2", "instructions a vertex", 0, [](Row r, Row) { return r.gpu.videocore_instructions; }, true},
};

// What is known of no row makes no column.
bool has_values(const Column& column, const DeformerComparison& c) {
  return std::ranges::any_of(c.rows, [&](Row r) { return !column.zero_is_none || column.value(r, r) > 0; });
}

std::string table(const DeformerComparison& c) {
  const auto ssd = std::ranges::find(c.rows, "ssd", &DeformerRow::deformer);
  std::string out = "<div class=\"wide\"><table><thead><tr><th>deformer</th>";
  for (const Column& column : kColumns)
    if (has_values(column, c))
      out += fmt::format("<th>{}{}{}</th>", column.heading, *column.unit != '\0' ? ", " : "", column.unit);
  out += "</tr></thead>\n<tbody>\n";
  for (const DeformerRow& r : c.rows) {
    out += fmt::format("<tr><td data-value=\"{0}\">{0}</td>", escaped(r.deformer));
    for (const Column& column : kColumns) {
      if (!has_values(column, c)) continue;
      const double value = column.value(r, *ssd);
      out += column.zero_is_none && !(value > 0)
                 ? std::string("<td data-value=\"\">–</td>")
                 : fmt::format("<td data-value=\"{:.9g}\">{:.{}f}</td>", value, value, column.decimals);
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

// Named, it can be laid under the slider.
std::string figure(const Picture& p, const std::string& name) {
  return fmt::format(
      "<figure{}><img alt=\"{}\" src=\"data:image/png;base64,{}\"><figcaption>{}</figcaption></figure>\n",
      name.empty() ? "" : " data-name=\"" + escaped(name) + '"', escaped(p.caption), base64(p.png), escaped(p.caption));
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

std::string picture_row(const PictureRow& row) {
  std::string out = fmt::format(
      "<div class=\"pose\"><h3>{}</h3><div class=\"grid\" style=\"grid-template-columns:repeat({},1fr)\">\n",
      escaped(row.title), row.shapes.size());
  for (const Picture& p : row.shapes) out += figure(p, p.caption);
  for (const Picture& p : row.errors) out += figure(p, "");
  out += ramp(row);
  return out + "</div></div>\n";
}

std::string comparison_page(const PageContent& content) {
  const DeformerComparison& c = content.comparison;
  const std::string title = escaped(content.title);
  std::string out = fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>{}</title><style>{}</style>\n<h1>{}</h1>\n"
      "<p>{}: truth {}, {} poses learnt from, {} held out. {} m across.</p>\n",
      title, kPageStyle, escaped(verdict(c)), title, escaped(content.truth), c.trained, c.held,
      plain_number(c.diagonal_m));
  if (!content.worst_poses.empty())
    out +=
        "<h2>Where linear blend skinning is worst</h2>\n<p class=\"note\">First plain linear blend skinning by the "
        "joints "
        "alone, as any engine draws it; then Marrow's; then the truth. Below, how far each is from that.</p>\n";
  for (const PictureRow& row : content.worst_poses) out += picture_row(row);
  out += "<h2>Figures</h2>\n" + table(c) +
         "<p class=\"note\">Poses held out are not learnt from. Crease: how sharply some edge is folded beyond the "
         "bind pose, mean over poses. Normals: between those it shades with and those of the mesh it makes, where "
         "joints meet; animation space shades with its own tangents, the others through the blended matrix. Size: of "
         "all geometry, cooked. Time: of positions, on the machine that made this page.</p>\n" +
         charts(content.study, c);
  const std::string motion = motion_tables(content.study, c, content.motion);
  if (!motion.empty()) out += "<h2>Range of motion</h2>\n";
  for (const PictureRow& row : content.worst_joints) out += picture_row(row);
  out += motion + "<script>" + kPageScript + "</script></html>\n";
  return out;
}

}  // namespace marrow::tools
