#include "commands/bench/gpu.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include <fmt/format.h>
#include <fnmatch.h>
#include <nlohmann/json.hpp>

#include "bench/workload.h"
#include "common/failure.h"
#include "common/formats.h"
#include "disk/files.h"
#include "text/html.h"

namespace marrow::tools {
namespace {

using gles3::SkinningPath;

// The first four are the table of the thesis that animation space comes from, the rest what games draw today.
constexpr GpuCase kCases[] = {
    {"1000x3", 1000, 3, 1, nullptr, false},     {"2000x3", 2000, 3, 1, nullptr, false},
    {"4000x5", 4000, 5, 1, nullptr, false},     {"8000x7", 8000, 7, 1, nullptr, true},
    {"30000x60", 30000, 60, 1, nullptr, false}, {"1000_CesiumMan", 0, 0, 1000, "CesiumMan.glb", true}};
constexpr std::optional<SkinningPath> kPaths[] = {SkinningPath::ubo,     SkinningPath::texture, SkinningPath::feedback,
                                                  SkinningPath::compute, SkinningPath::cpu,     {}};

// What vertices have but positions.
struct Attributes {
  const char* name;
  std::uint8_t features;
};
constexpr Attributes kAttributes[] = {{"p", 0}, {"pn", gles3::kNormals}, {"pnm", gles3::kNormals | gles3::kMotion}};

std::vector<GpuRow> gpu_rows() {
  std::vector<GpuRow> out;
  for (const GpuCase& of : kCases)
    for (const std::optional<SkinningPath> path : kPaths)
      for (const gles3::Deformer deformer : {gles3::Deformer::ssd, gles3::Deformer::as})
        for (const Attributes& attributes : kAttributes) {
          if (!path && of.model == nullptr) continue;  // nothing to play
          if ((attributes.features & gles3::kMotion) != 0 && !of.motion) continue;
          GpuRow row;
          row.name = fmt::format("gpu/{}/{}/{}/{}", path_name(path), deformer == gles3::Deformer::as ? "as" : "ssd",
                                 attributes.name, of.name);
          row.of = &of;
          row.path = path;
          row.deformer = deformer;
          row.features = attributes.features;
          out.push_back(std::move(row));
        }
  return out;
}

std::vector<GpuRow> selected(const std::string& pattern, const Gl& gl) {
  const Models models;
  std::vector<GpuRow> rows = gpu_rows();
  std::erase_if(rows, [&](const GpuRow& row) { return fnmatch(pattern.c_str(), row.name.c_str(), 0) != 0; });
  if (rows.empty())
    throw Failure(Exit::usage, "--only", "", "no row is called \"" + pattern + "\"", "there are\n" + gpu_row_names());
  const auto leave_out = [&](const char* why, auto&& which) {
    const std::size_t count = std::erase_if(rows, which);
    if (count > 0) fmt::print(stderr, "marrow: note: {}: rows left out: {}\n", why, count);
  };
  if (!gl.caps().compute)
    leave_out("no compute shaders here", [](const GpuRow& row) { return row.path == SkinningPath::compute; });
  if (!models.has(kCesiumMan))
    leave_out("no CesiumMan.glb", [](const GpuRow& row) { return row.of->model != nullptr; });
  return rows;
}

void print(const std::string& driver, const std::vector<GpuRow>& rows) {
  fmt::print("{}\n{:<36}{:>12}{:>12}{:>12}\n", driver, "name", "frames/s", "ns/vertex", "on the GPU");
  for (const GpuRow& row : rows)
    fmt::print("{:<36}{:>12.1f}{:>12.3f}{:>12}\n", row.name, row.frames_per_s, row.ns_per_vertex,
               row.gpu_ns_per_vertex ? fmt::format("{:.3f}", *row.gpu_ns_per_vertex) : "-");
}

nlohmann::ordered_json report(const std::string& driver, const std::vector<GpuRow>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const GpuRow& row : rows) {
    nlohmann::ordered_json r = {{"name", row.name},
                                {"frames_per_s", row.frames_per_s},
                                {"ns_per_vertex", row.ns_per_vertex},
                                {"gpu_ns_per_vertex", nullptr}};
    if (row.gpu_ns_per_vertex) r["gpu_ns_per_vertex"] = *row.gpu_ns_per_vertex;
    list.push_back(std::move(r));
  }
  return {{"driver", driver}, {"rows", std::move(list)}};
}

constexpr double kLeft = 190, kWidth = 760, kBar = 9, kGap = 6, kTitle = 34;
constexpr const char* kSsd = "#4477aa";
constexpr const char* kAs = "#cc6677";

std::string text(double x, double y, const char* more, const std::string& words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, more, html_text(words));
}

std::string bar(const GpuRow& row, double y, double ns_per_pixel) {
  const double width = std::max(1.0, row.ns_per_vertex / ns_per_pixel);
  const bool as = row.deformer == gles3::Deformer::as;
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n", kLeft, y, width,
                     kBar, as ? kAs : kSsd) +
         text(kLeft + width + 4, y + kBar - 1, "fill=\"#555\"", fmt::format("{:.1f}", row.ns_per_vertex));
}

}  // namespace

void run_gpu_bench(const GpuBenchArguments& arguments) {
  if (!arguments.chart.empty()) {
    expect_extension(arguments.chart, {".svg"});
    expect_writable(arguments.chart);
  }
  const Gl gl;
  std::vector<GpuRow> rows = selected(arguments.only, gl);
  measure_gpu(gl, rows);
  if (arguments.json) {
    fmt::print("{}\n", report(gl.driver(), rows).dump(2));
  } else {
    print(gl.driver(), rows);
  }
  if (arguments.chart.empty()) return;
  const std::string chart = gpu_chart(rows, gl.driver());
  write_file_atomically(arguments.chart, std::string_view(chart));
}

std::string gpu_row_names() {
  std::vector<const char*> cases, moving, paths;
  for (const GpuCase& of : kCases) cases.push_back(of.name);
  for (const GpuCase& of : kCases)
    if (of.motion) moving.push_back(of.name);
  for (const std::optional<SkinningPath> path : kPaths)
    if (path) paths.push_back(path_name(path));
  return fmt::format(
      "gpu/{0}/{{ssd,as}}/{{p,pn}}/{1}\ngpu/{0}/{{ssd,as}}/pnm/{2}\ngpu/crowd/{{ssd,as}}/{{p,pn,pnm}}/1000_CesiumMan\n",
      choice(paths), choice(cases), choice(moving));
}

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
