// The rows of `marrow bench --gpu` as bars.
#include <algorithm>

#include <fmt/format.h>

#include "commands/bench/gpu.h"

namespace marrow::tools {
namespace {

constexpr double kLeft = 190, kWidth = 760, kBar = 9, kGap = 6, kTitle = 34;
constexpr const char* kSsd = "#4477aa";
constexpr const char* kAs = "#cc6677";

std::string text(double x, double y, const char* more, const std::string& words) {
  std::string safe;
  for (const char c : words)
    safe += c == '<' ? std::string("&lt;") : c == '&' ? std::string("&amp;") : std::string(1, c);
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, more, safe);
}

std::string bar(const GpuRow& row, double y, double ns_per_pixel) {
  const double width = std::max(1.0, row.ns_per_vertex / ns_per_pixel);
  const bool as = row.deformer == gles3::Deformer::as;
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n", kLeft, y, width,
                     kBar, as ? kAs : kSsd) +
         text(kLeft + width + 4, y + kBar - 1, "fill=\"#555\"", fmt::format("{:.1f}", row.ns_per_vertex));
}

}  // namespace

std::string gpu_chart(const std::vector<GpuRow>& rows, const std::string& driver) {
  std::string body;
  double y = 40;
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t end = first;
    double most = 0;
    for (; end < rows.size() && rows[end].of == rows[first].of; ++end) most = std::max(most, rows[end].ns_per_vertex);
    const GpuCase& of = *rows[first].of;
    body += text(10, y + 18, "font-weight=\"bold\"",
                 of.model == nullptr ? fmt::format("{} vertices, {} joints", of.vertices, of.joints)
                                     : fmt::format("{} × {}", of.characters, of.model));
    y += kTitle - kGap;
    for (; first < end; ++first) {
      const GpuRow& row = rows[first];
      const bool paired = first > 0 && rows[first - 1].of == row.of && rows[first - 1].path == row.path;
      if (!paired) y += kGap;
      body += text(kLeft - 6, y + kBar - 1, "text-anchor=\"end\"",
                   fmt::format("{} {}{}", path_name(row.path), row.deformer == gles3::Deformer::as ? "AS" : "SSD",
                               (row.features & gles3::kMotion) != 0    ? ", normals, motion"
                               : (row.features & gles3::kNormals) != 0 ? ", normals"
                                                                       : ""));
      body += bar(row, y, most / (kWidth - kLeft - 60));
      y += kBar + 1;
    }
    y += kGap;
  }
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" viewBox=\"0 0 {0} {1:.0f}\" "
             "font-family=\"sans-serif\" font-size=\"10\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
             kWidth, y + 10) +
         text(10, 18, "font-size=\"13\"", "Nanoseconds a vertex, a frame with one pass") +
         text(10, 32, "fill=\"#555\"", driver) + body + "</svg>\n";
}

}  // namespace marrow::tools
