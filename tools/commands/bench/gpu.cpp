#include "commands/bench/gpu.h"

#include <fnmatch.h>

#include <cstdio>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/workload.h"
#include "common/failure.h"
#include "common/formats.h"
#include "disk/files.h"

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

}  // namespace marrow::tools
