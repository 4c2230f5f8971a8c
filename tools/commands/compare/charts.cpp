#include "commands/compare/charts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "text/quantity.h"

namespace marrow::tools {
namespace {

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
  std::string out = fmt::format("<text x=\"{}\" y=\"15\" font-weight=\"bold\">{}</text>", kLeft, escaped(clip));
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
                     s.hidden ? " class=\"off\"" : "", escaped(row.deformer), values,
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
                       escaped(c.rows[s.row].deformer), kColours[s.row % std::size(kColours)],
                       s.hidden ? ", up to " + length_text(s.most_m) + ": not drawn at first" : "");
  return out + "</p>\n";
}

}  // namespace

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

}  // namespace marrow::tools
