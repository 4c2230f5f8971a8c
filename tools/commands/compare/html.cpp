#include "commands/compare/html.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "commands/compare/verdict.h"

namespace marrow::tools {
namespace {

constexpr const char* kStyle =
    R"(body{font:15px/1.5 system-ui,sans-serif;max-width:1240px;margin:2rem auto;padding:0 1rem;color:#222;background:#fafafa}
h1{font-size:1.5rem;line-height:1.3}h2{font-size:1.1rem;margin-top:2.2rem}
table{border-collapse:collapse;background:#fff}td,th{padding:.3rem .7rem;text-align:right;border-bottom:1px solid #ddd}
td:first-child,th:first-child{text-align:left}tr.best{background:#e8f4ea}
.row{display:flex;flex-wrap:wrap;gap:8px}figure{margin:0;width:232px}figure img{width:100%;border-radius:4px}
figcaption{font-size:.85rem;color:#555}svg{background:#fff;border:1px solid #ddd;margin:0 8px 8px 0}.note{color:#666;font-size:.9rem})";
constexpr const char* kColours[] = {"#b3b3b3", "#c0392b", "#d98880", "#5d6d7e", "#2980b9",
                                    "#27ae60", "#16a085", "#8e44ad", "#d35400", "#7d6608"};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

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

std::string table(const DeformerComparison& c) {
  const auto ssd = std::ranges::find(c.rows, "ssd", &DeformerRow::deformer);
  std::string out =
      "<table><tr><th>deformer</th><th>RMS, learnt from, mm</th><th>RMS, held out, mm</th><th>of "
      "SSD's</th><th>largest, mm</th>"
      "<th>poses worse than SSD</th><th>volume of the truth's</th><th>sharpest crease</th><th>normals off by</th>"
      "<th>if blended</th><th>bytes a vertex</th><th>ns a vertex</th><th>instructions a vertex</th></tr>\n";
  for (const DeformerRow& r : c.rows) {
    const auto or_none = [](double x) { return x > 0 ? fmt::format("{:.2f}", x) : std::string("–"); };
    out += fmt::format(
        "<tr><td>{}</td><td>{:.4f}</td><td>{:.4f}</td><td>{:.3f}</td><td>{:.3f}</td><td>{:.1f} "
        "%</td><td>{:.3f}</td><td>{:.1f}°</td>"
        "<td>{:.2f}°</td><td>{:.2f}°</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        r.deformer, 1e3 * r.train_rms, 1e3 * r.held_rms, ssd->held_rms > 0 ? r.held_rms / ssd->held_rms : 1.0,
        1e3 * r.held_max, 100 * r.worse_share, r.volume, r.crease_deg, r.normal_deg, r.blended_normal_deg,
        or_none(r.bytes_per_vertex), or_none(r.ns_per_vertex), or_none(r.instructions_per_vertex));
  }
  return out + "</table>\n";
}

// Error over a clip, a line a deformer.
std::string chart(const std::string& clip, const Round& round, const DeformerComparison& c) {
  constexpr double kWidth = 580, kHeight = 200, kLeft = 54, kBottom = 24, kTop = 22;
  std::vector<std::size_t> poses;
  for (std::size_t i = 0; i < round.held.size(); ++i)
    if (round.held[i].clip == clip) poses.push_back(i);
  double most = 0, last = 0;
  for (const DeformerRow& r : c.rows)
    for (const std::size_t i : poses) {
      if (r.deformer != "rigid") most = std::max(most, r.error_of_pose[i]);
      last = std::max(last, round.held[i].time_s);
    }
  if (poses.size() < 2 || !(most > 0) || !(last > 0)) return "";
  std::string out = fmt::format(
      "<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"11\">"
      "<text x=\"{2}\" y=\"14\">{3}</text><text x=\"2\" y=\"{4}\">{5:.2f} mm</text><text x=\"2\" y=\"{6}\">0</text>"
      "<text x=\"{7}\" y=\"{8}\" text-anchor=\"end\">{9:.2f} s</text>",
      kWidth, kHeight, kLeft, escaped(clip), kTop + 8, 1e3 * most, kHeight - kBottom, kWidth - 4, kHeight - 8, last);
  for (std::size_t d = 0; d < c.rows.size(); ++d) {
    if (c.rows[d].deformer == "rigid" || c.rows[d].deformer == "as_lift") continue;
    std::string points;
    for (const std::size_t i : poses)
      points += fmt::format("{:.1f},{:.1f} ", kLeft + (kWidth - kLeft - 6) * round.held[i].time_s / last,
                            kHeight - kBottom - (kHeight - kBottom - kTop) * c.rows[d].error_of_pose[i] / most);
    out += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" points=\"{}\"/>",
                       kColours[d % std::size(kColours)], points);
  }
  return out + "</svg>\n";
}

std::string charts(const Study& study, const DeformerComparison& c) {
  constexpr std::size_t kMost = 8;
  const Round& round = study.rounds.front();
  std::vector<std::string> clips;
  for (const HeldPose& pose : round.held)
    if (!pose.clip.empty() && std::ranges::find(clips, pose.clip) == clips.end()) clips.push_back(pose.clip);
  std::string drawn;
  for (std::size_t i = 0; i < std::min(clips.size(), kMost); ++i) drawn += chart(clips[i], round, c);
  if (drawn.empty()) return "";
  std::string key;
  for (std::size_t d = 0; d < c.rows.size(); ++d)
    if (c.rows[d].deformer != "rigid" && c.rows[d].deformer != "as_lift")
      key += fmt::format("<span style=\"color:{}\">■</span> {} &nbsp; ", kColours[d % std::size(kColours)],
                         c.rows[d].deformer);
  return "<h2>Error over each clip</h2><p>RMS distance from the truth in poses held out. " + key + "</p>\n" + drawn;
}

}  // namespace

std::string comparison_page(const std::string& title, const std::string& truth, const Study& study,
                            const DeformerComparison& c, const std::vector<PictureRow>& pictures) {
  std::string out = fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>{}</title><style>{}</style>\n<h1>{}</h1>\n"
      "<p>{}: truth {}, {} poses learnt from, {} held out. {:.4g} m across.</p>\n",
      escaped(title), kStyle, escaped(verdict(c)), escaped(title), escaped(truth), c.trained, c.held, c.diagonal_m);
  if (!pictures.empty()) out += "<h2>Where linear blend skinning is worst</h2>\n";
  for (const PictureRow& row : pictures) {
    out += "<p>" + escaped(row.title) + "</p><div class=\"row\">\n";
    for (const Picture& p : row.pictures)
      out += "<figure><img alt=\"" + escaped(p.caption) + "\" src=\"data:image/png;base64," + base64(p.png) +
             "\"><figcaption>" + escaped(p.caption) + "</figcaption></figure>\n";
    out += "</div>\n";
  }
  out += "<h2>Figures</h2>\n" + table(c) +
         "<p class=\"note\">Poses held out are not learnt from. Crease: how sharply some edge is folded beyond the "
         "bind pose, mean over "
         "poses. Normals: between those it shades with and those of the mesh it makes, where joints meet; animation "
         "space shades with its own tangents, the others through the blended matrix. Bytes: of "
         "all geometry, cooked. ns: positions, "
         "on the machine that made this page.</p>\n" +
         charts(study, c) + "</html>\n";
  return out;
}

}  // namespace marrow::tools
