#include "gpu_bench/gpu_rows.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include "bench/vertices.h"
#include "bench/workload.h"
#include "gpu_bench/gpu_timer.h"
#include "gpu_bench/gpu_work.h"
#include "terminal/progress.h"

namespace marrow::tools {
namespace {

constexpr double kGpuBatch_s = 0.03;
constexpr std::size_t kGpuBatches = 9;

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

}  // namespace

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

const char* path_name(std::optional<gles3::SkinningPath> path) {
  return path ? gles3::to_string(*path) : "crowd";
}

}  // namespace marrow::tools
