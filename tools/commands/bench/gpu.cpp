#include "commands/bench/gpu.h"

#include <fnmatch.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/vertices.h"
#include "bench/workload.h"
#include "commands/bench/gpu_timer.h"
#include "commands/bench/gpu_work.h"
#include "common/failure.h"
#include "common/files.h"
#include "common/formats.h"
#include "terminal/progress.h"

namespace marrow::tools {
namespace {

using gles3::SkinningPath;

constexpr double kGpuBatch_s = 0.03;
constexpr std::size_t kGpuBatches = 9;

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

// The largest mesh of a model, or a generated one.
class Subject {
 public:
  Subject(const GpuCase& of, Models& models) {
    if (of.model == nullptr) {
      generated_ = std::make_unique<GeneratedMesh>(of.vertices, of.influences, of.joints);
      out_.mesh = generated_->view();
      return;
    }
    const File& file = models.get(kCesiumMan);
    for (std::uint32_t m = 0; m < file.mesh_count(); ++m)
      if (file.mesh(m).geometry.slot_count > out_.mesh.geometry.slot_count) out_.mesh = file.mesh(m);
    out_.skeleton = file.skeleton(out_.mesh.skeleton);
    out_.clip = file.clip(0);
  }
  const GpuSubject& get() const { return out_; }

 private:
  std::unique_ptr<GeneratedMesh> generated_;
  GpuSubject out_;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// Of so many frames, to the last pixel.
double seconds(const Gl& gl, GpuWork& work, std::uint64_t count) {
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t i = 0; i < count; ++i) work.frame();
  std::uint8_t pixel[4];
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void measure(const Gl& gl, const GpuTimer& timer, GpuWork& work, GpuRow& row) {
  seconds(gl, work, 2);  // drivers compile at the first draw
  std::uint64_t batch = 1;
  while (seconds(gl, work, batch) < kGpuBatch_s / 2 && batch < 1 << 16) batch *= 2;
  std::vector<double> frame_s, gpu_ns;
  for (std::size_t i = 0; i < kGpuBatches; ++i) {
    timer.begin();
    frame_s.push_back(seconds(gl, work, batch) / static_cast<double>(batch));
    timer.end();
    if (timer.can()) gpu_ns.push_back(timer.elapsed_ns() / static_cast<double>(batch));
  }
  const auto vertices = static_cast<double>(work.vertices());
  row.frames_per_s = 1 / median(frame_s);
  row.ns_per_vertex = 1e9 * median(frame_s) / vertices;
  if (timer.can()) row.gpu_ns_per_vertex = median(gpu_ns) / vertices;
  gl.check(row.name.c_str());
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

void measure_gpu(const Gl& gl, std::vector<GpuRow>& rows) {
  const GpuTimer timer(gl);
  Models models;
  const GpuTarget target(gl);
  std::unique_ptr<Subject> subject;
  const GpuCase* of = nullptr;
  Progress progress;
  std::size_t done = 0;
  for (GpuRow& row : rows) {
    progress.show(done++, rows.size(), row.name);
    if (row.of != of) subject = std::make_unique<Subject>(*row.of, models);
    of = row.of;
    const std::unique_ptr<GpuWork> work = make_gpu_work(gl, target, row, subject->get());
    target.bind();
    measure(gl, timer, *work, row);
  }
}

const char* path_name(std::optional<SkinningPath> path) {
  return path ? gles3::to_string(*path) : "crowd";
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
