#include "compare/page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "compare/page_text.h"
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
    if (says_something)
      out += fmt::format("<tr><td data-value=\"{0}\">{0}</td>{1}</tr>\n", html_text(line.name), cells);
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
    const std::string clip = html_text(f.clip.empty() ? "of no clip" : f.clip),
                      joint = html_text(study.joint_names[f.joint]);
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
      name.empty() ? "" : " data-name=\"" + html_text(name) + '"', html_text(p.caption), base64(p.jpeg),
      html_text(p.caption));
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

constexpr const char* kColours[] = {"#b3b3b3", "#b3b3b3", "#b3b3b3", "#c0392b", "#d98880", "#5d6d7e", "#2980b9",
                                    "#27ae60", "#16a085", "#8e44ad", "#d35400", "#7d6608", "#b3b3b3", "#e84393"};
constexpr std::size_t kMostCharts = 8;
constexpr double kFlattening = 3;  // times the middle line's largest error
constexpr double kWidth = 580, kHeight = 210, kLeft = 58, kRight = 8, kTop = 26, kBottom = 26;
constexpr double kLow = kHeight - kBottom, kRise = kLow - kTop;

struct Series {
  std::size_t row;  // of the comparison
  double most_m = 0;
  bool hidden = false;
};

// Nobody would choose what was before SSD, and as_lift is as ssd.
std::vector<Series> series_of(const Round& round, const DeformerComparison& c) {
  std::vector<Series> out;
  std::vector<double> largest;
  for (std::size_t d = 0; d < c.rows.size(); ++d) {
    if (is_before_ssd(c.rows[d].deformer) || c.rows[d].deformer == "as_lift") continue;
    Series& s = out.emplace_back(Series{d});
    for (std::size_t i = 0; i < round.held.size(); ++i)
      if (!round.held[i].clip.empty()) s.most_m = std::max(s.most_m, c.rows[d].error_of_pose[i]);
    largest.push_back(s.most_m);
  }
  if (largest.empty()) return out;
  std::ranges::nth_element(largest, largest.begin() + static_cast<std::ptrdiff_t>(largest.size() / 2));
  const double middle = largest[largest.size() / 2];
  for (Series& s : out) s.hidden = middle > 0 && s.most_m > kFlattening * middle && c.rows[s.row].deformer != "ssd";
  return out;
}

// 1, 2 or 5 and zeros, at least `most`.
double nice(double most) {
  const double unit = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * unit >= most * 0.999999) return step * unit;
  return 10 * unit;
}

std::string axes(const std::string& clip, double top_mm, double last_s) {
  std::string out = fmt::format("<text x=\"{}\" y=\"15\" font-weight=\"bold\">{}</text>", kLeft, html_text(clip));
  for (const double share : {0.0, 0.5, 1.0}) {
    const double y = kLow - kRise * share;
    out +=
        fmt::format("<line x1=\"{0}\" x2=\"{1}\" y1=\"{2}\" y2=\"{2}\" stroke=\"#ddd\"/>", kLeft, kWidth - kRight, y);
    out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\" data-share=\"{}\">{} mm</text>", kLeft - 6, y + 4,
                       share, plain_number(top_mm * share));
    out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{} s</text>",
                       kLeft + (kWidth - kLeft - kRight) * share, kHeight - 8,
                       share == 0   ? "start"
                       : share == 1 ? "end"
                                    : "middle",
                       plain_number(last_s * share));
  }
  return out;
}

std::string line(const Series& s, const DeformerRow& row, const Round& round, const std::vector<std::size_t>& poses,
                 double top_mm, double last_s) {
  std::string points, values;
  for (const std::size_t i : poses) {
    const double mm = 1e3 * row.error_of_pose[i];
    points += fmt::format("{:.1f},{:.1f} ", kLeft + (kWidth - kLeft - kRight) * round.held[i].time_s / last_s,
                          kLow - kRise * mm / top_mm);
    values += fmt::format("{}{:.4g}", values.empty() ? "" : " ", mm);
  }
  points.pop_back();
  return fmt::format("<polyline{} data-series=\"{}\" data-mm=\"{}\" stroke=\"{}\" points=\"{}\"/>",
                     s.hidden ? " class=\"off\"" : "", html_text(row.deformer), values,
                     kColours[s.row % std::size(kColours)], points);
}

// Error over a clip, a line a deformer.
std::string chart(const std::string& clip, const Round& round, const std::vector<Series>& series,
                  const DeformerComparison& c) {
  std::vector<std::size_t> poses;
  double most_mm = 0, last_s = 0;
  for (std::size_t i = 0; i < round.held.size(); ++i) {
    if (round.held[i].clip != clip) continue;
    poses.push_back(i);
    last_s = std::max(last_s, round.held[i].time_s);
    for (const Series& s : series)
      if (!s.hidden) most_mm = std::max(most_mm, 1e3 * c.rows[s.row].error_of_pose[i]);
  }
  if (poses.size() < 2 || !(most_mm > 0) || !(last_s > 0)) return "";
  const double top_mm = nice(most_mm);
  std::string out = fmt::format(
      "<svg class=\"chart\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" data-low=\"{2}\" data-height=\"{3}\" "
      "font-family=\"sans-serif\" font-size=\"11\">{4}",
      kWidth, kHeight, kLow, kRise, axes(clip, top_mm, last_s));
  for (const Series& s : series) out += line(s, c.rows[s.row], round, poses, top_mm, last_s);
  return out + "</svg>\n";
}

std::string key(const std::vector<Series>& series, const DeformerComparison& c) {
  std::string out = "<p class=\"key\">";
  for (const Series& s : series)
    out += fmt::format("<label data-series=\"{0}\"><span style=\"color:{1}\">■</span> {0}{2}</label>\n",
                       html_text(c.rows[s.row].deformer), kColours[s.row % std::size(kColours)],
                       s.hidden ? ", up to " + length_text(s.most_m) + ": not drawn at first" : "");
  return out + "</p>\n";
}

using Line = const TableLine&;
using Value = std::optional<double>;

// Of a deformer.
template <class Member>
Value of(Line l, Member member, double factor = 1) {
  return l.row != nullptr ? Value(factor * static_cast<double>(l.row->*member)) : std::nullopt;
}
// 0 is not known.
template <class Member>
Value above_0(Line l, Member member) {
  return l.row != nullptr && l.row->*member > 0 ? Value(static_cast<double>(l.row->*member)) : std::nullopt;
}
Value gpu(Line l, double VertexCost::*cost) {
  return l.row != nullptr && l.row->gpu.*cost > 0 ? Value(l.row->gpu.*cost) : std::nullopt;
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
                  std::min(shapes, kMostAcross), beside, html_text(row.title));
  for (const Picture& p : row.shapes) out += figure(p, p.caption);
  out += "</div><div class=\"grid\">\n";
  for (const Picture& p : row.errors) out += figure(p, "");
  out += ramp(row);
  return out + "</div></div>\n";
}

std::string comparison_page(const PageContent& content) {
  const DeformerComparison& c = content.comparison;
  const std::string title = html_text(content.title);
  std::string out = fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>{}</title><style>{}</style>\n<h1>{}</h1>\n",
      title, kPageStyle, html_text(content.verdict.use));
  for (const std::string& line : content.verdict.why) out += fmt::format("<p class=\"why\">{}</p>\n", html_text(line));
  out += fmt::format("<p>{}: truth {}, {} poses learnt from, {} held out. {} m across.</p>\n", title,
                     html_text(content.truth), c.trained, c.held, plain_number(c.diagonal_m));
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

std::string charts(const Study& study, const DeformerComparison& c) {
  const Round& round = study.rounds.front();
  const std::vector<Series> series = series_of(round, c);
  std::vector<std::string> clips;
  for (const HeldPose& pose : round.held)
    if (!pose.clip.empty() && std::ranges::find(clips, pose.clip) == clips.end()) clips.push_back(pose.clip);
  std::string drawn;
  for (std::size_t i = 0; i < std::min(clips.size(), kMostCharts); ++i) drawn += chart(clips[i], round, series, c);
  if (drawn.empty()) return "";
  return "<h2>Error over each clip</h2><p>RMS distance from the truth in poses held out, mm.</p>\n" + key(series, c) +
         drawn;
}

const std::vector<TableColumn> kLookColumns = {
    {"RMS, learnt from", "mm", "learnt", 9, 3, [](Line l, Line) { return of(l, &DeformerRow::train_rms, 1e3); }},
    {"RMS, held out", "mm", "held out", 9, 3, [](Line l, Line) { return of(l, &DeformerRow::held_rms, 1e3); }},
    {"of SSD's", "", "of ssd's", 9, 3,
     [](Line l, Line ssd) {
       if (l.row == nullptr) return Value();
       return Value(ssd.row->held_rms > 0 ? l.row->held_rms / ssd.row->held_rms : 1.0);
     }},
    {"largest", "mm", "largest", 9, 2, [](Line l, Line) { return of(l, &DeformerRow::held_max, 1e3); }},
    {"poses worse than SSD", "%", "worse %", 8, 1, [](Line l, Line) { return of(l, &DeformerRow::worse_share, 100); }},
    {"flipped triangles", "a pose", "flips", 8, kFlippedDecimals, [](Line l, Line) { return Value(l.look.flipped); },
     true},
    {"bend", "degrees", "bend °", 8, kBendDecimals, [](Line l, Line) { return Value(l.look.bend_deg); }, true},
    {"creases", "%", "crease %", 9, kCreasedDecimals, [](Line l, Line) { return Value(100 * l.look.creased); }, true},
    {"narrowest ring", "", "ring", 6, 2, [](Line l, Line) { return l.ring; }},
    {"jumps of SSD's", "", "jumps", 7, 2, [](Line l, Line) { return l.look.jump_of_ssd; }},
    {"volume of the truth's", "", "volume", 8, 3, [](Line l, Line) { return of(l, &DeformerRow::volume); }},
    {"sharpest edge", "degrees", "sharpest", 9, 1, [](Line l, Line) { return of(l, &DeformerRow::crease_deg); }},
    {"normals off by", "degrees", "normals", 8, 2, [](Line l, Line) { return of(l, &DeformerRow::normal_deg); }},
    {"if blended", "degrees", "blended", 8, 2, [](Line l, Line) { return of(l, &DeformerRow::blended_normal_deg); }},
};

const std::vector<TableColumn> kCostColumns = {
    {"influences", "", "influences", 11, 0, [](Line l, Line) { return above_0(l, &DeformerRow::influences); }},
    {"palette entries", "", "palette", 8, 0, [](Line l, Line) { return above_0(l, &DeformerRow::palette_entries); }},
    {"size", "bytes a vertex", "B/vertex", 9, 2,
     [](Line l, Line) { return above_0(l, &DeformerRow::bytes_per_vertex); }},
    {"displacements", "a vertex", "displaced", 10, 2,
     [](Line l, Line) { return above_0(l, &DeformerRow::displacements_per_vertex); }},
    {"time", "ns a vertex", "ns", 8, 2, [](Line l, Line) { return above_0(l, &DeformerRow::ns_per_vertex); }},
    {"instructions", "a vertex", "instr", 8, 2,
     [](Line l, Line) { return above_0(l, &DeformerRow::instructions_per_vertex); }},
    {"Mali-G57", "cycles a vertex", "Mali", 7, 0, [](Line l, Line) { return gpu(l, &VertexCost::mali_cycles); }},
    {"Adreno 660", "instructions a vertex", "Adreno", 8, 0,
     [](Line l, Line) { return gpu(l, &VertexCost::adreno_instructions); }},
    {"V3D 4.2", "instructions a vertex", "V3D", 6, 0,
     [](Line l, Line) { return gpu(l, &VertexCost::videocore_instructions); }},
};

std::vector<TableLine> table_lines(const DeformerComparison& c, const MotionStudy& motion) {
  std::vector<TableLine> out;
  for (std::size_t d = 0; d < c.rows.size(); ++d)
    out.push_back({c.rows[d].deformer, &c.rows[d], c.rows[d].look,
                   motion.of.empty() ? std::nullopt : motion.of[d].ring_over_bind});
  out.push_back({"truth", nullptr, c.truth, motion.truth_ring});
  return out;
}

const TableLine& plain_of(const std::vector<TableLine>& lines) {
  return *std::ranges::find(lines, "ssd", &TableLine::name);
}

std::vector<TableColumn> known(const std::vector<TableColumn>& columns, const std::vector<TableLine>& lines) {
  std::vector<TableColumn> out;
  for (const TableColumn& column : columns)
    if (std::ranges::any_of(lines, [&](Line l) { return column.value(l, plain_of(lines)).has_value(); }))
      out.push_back(column);
  return out;
}

bool is_uglier(const TableColumn& column, const TableLine& line, const TableLine& ssd) {
  return column.more_is_uglier && reads_more(*column.value(line, ssd), *column.value(ssd, ssd), column.decimals);
}

}  // namespace marrow::tools
