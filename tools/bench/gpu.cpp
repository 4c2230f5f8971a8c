#include "bench/gpu.h"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/vertices.h"
#include "bench/workload.h"
#include "common/failure.h"
#include "common/files.h"
#include "marrow/marrow.h"
#include "render/gl.h"

namespace marrow::tools {
namespace {

using gles3::Deformer;
using gles3::Path;

constexpr double kGpuBatch_s = 0.03;
constexpr std::size_t kGpuBatches = 9;
constexpr int kSide = 16;  // of the picture: what is measured is vertices

// The first four are the table of the thesis that animation space comes from, the rest what games draw today.
constexpr GpuCase kCases[] = {{"1000x3", 1000, 3, 1, nullptr},     {"2000x3", 2000, 3, 1, nullptr},
                              {"4000x5", 4000, 5, 1, nullptr},     {"8000x7", 8000, 7, 1, nullptr},
                              {"30000x60", 30000, 60, 1, nullptr}, {"1000_CesiumMan", 0, 0, 1000, "CesiumMan.glb"}};
constexpr Path kPaths[] = {Path::ubo, Path::texture, Path::feedback, Path::compute, Path::cpu};

// Out of sight, but the driver cannot know that before it has skinned.
constexpr const char* kVertex = R"(
out vec3 shade;
void main() {
  MarrowVertex v = marrow_skin();
  shade = v.normal;
  gl_Position = vec4(v.position.xy, v.position.z + 100.0, 1.0);
}
)";
constexpr const char* kFragment = R"(
precision mediump float;
in vec3 shade;
out vec4 colour;
void main() { colour = vec4(shade, 1.0); }
)";

std::vector<GpuRow> gpu_rows() {
  std::vector<GpuRow> out;
  for (const GpuCase& of : kCases)
    for (const Path path : kPaths)
      for (const Deformer deformer : {Deformer::ssd, Deformer::as})
        for (const bool normals : {false, true})
          out.push_back({fmt::format("gpu/{}/{}/{}/{}", gles3::to_string(path), deformer == Deformer::as ? "as" : "ssd",
                                     normals ? "pn" : "p", of.name),
                         &of,
                         path,
                         deformer,
                         normals,
                         0,
                         0,
                         {}});
  return out;
}

// EXT_disjoint_timer_query: how long the GPU was at it.
class GpuTimer {
 public:
  explicit GpuTimer(const Gl& gl) {
    const auto* const all = reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS));
    if (all == nullptr || std::string(all).find("GL_EXT_disjoint_timer_query") == std::string::npos) return;
    load(generate_, "glGenQueriesEXT");
    load(begin_, "glBeginQueryEXT");
    load(end_, "glEndQueryEXT");
    load(get_, "glGetQueryObjectui64vEXT");
    if (generate_ == nullptr || begin_ == nullptr || end_ == nullptr || get_ == nullptr) return;
    generate_(1, &query_);
  }
  bool can() const { return query_ != 0; }
  void begin() const {
    if (can()) begin_(kTimeElapsed, query_);
  }
  void end() const {
    if (can()) end_(kTimeElapsed);
  }
  double elapsed_ns() const {
    std::uint64_t out = 0;
    get_(query_, kQueryResult, &out);
    return static_cast<double>(out);
  }

 private:
  static constexpr GLenum kTimeElapsed = 0x88BF, kQueryResult = 0x8866;
  template <class Function>
  static void load(Function& function, const char* name) {
    function = reinterpret_cast<Function>(egl::load_proc(name));
  }

  void (*generate_)(GLsizei, GLuint*) = nullptr;
  void (*begin_)(GLenum, GLuint) = nullptr;
  void (*end_)(GLenum) = nullptr;
  void (*get_)(GLuint, GLenum, std::uint64_t*) = nullptr;
  GLuint query_ = 0;
};

// The largest mesh of a model, or a generated one.
class Subject {
 public:
  Subject(const GpuCase& of, Models& models) {
    if (of.model == nullptr) {
      generated_ = std::make_unique<GeneratedMesh>(of.vertices, 4, of.joints);
      mesh_ = generated_->view();
      return;
    }
    const File& file = models.get(kCesiumMan);
    for (std::uint32_t m = 0; m < file.mesh_count(); ++m)
      if (file.mesh(m).geometry.slot_count > mesh_.geometry.slot_count) mesh_ = file.mesh(m);
  }
  const Mesh& mesh() const { return mesh_; }

 private:
  std::unique_ptr<GeneratedMesh> generated_;
  Mesh mesh_;
};

class GpuWorkload {
 public:
  GpuWorkload(const Gl& gl, const GpuRow& row, const Mesh& mesh) : gl_(gl), characters_(row.of->characters) {
    programs_.roles[0] = {kVertex, kFragment, {}};
    programs_.log = log_;
    gles3::SkinnerOptions options;
    options.path = row.path;
    options.deformer = row.deformer;
    options.instances = characters_;
    options.features = row.normals ? gles3::kNormals : 0;
    memory_.resize(gles3::skinner_bytes(mesh, options) / sizeof(SoaTransform) + 1);
    const Status status = gles3::create_skinner(
        gl, gl.caps(), mesh, options, programs_,
        {reinterpret_cast<std::byte*>(memory_.data()), memory_.size() * sizeof(SoaTransform)}, skinner_);
    if (status != Status::ok)
      throw Failure(Exit::internal, row.name, "", std::string(to_string(status)) + " " + log_.data(),
                    "please report this with the driver: " + gl.driver());
    std::uint32_t joints = 0;
    for (std::uint32_t j = 0; j < mesh.joint_count; ++j) joints = std::max(joints, mesh.joints[j] + 1u);
    const std::vector<Affine> pose = noise_palette(joints);
    for (std::uint32_t i = 0; i < characters_; ++i)
      if (gles3::pose(skinner_, i, pose) != Status::ok)
        throw Failure(Exit::internal, row.name, "", "cannot be posed", "please report this");
  }
  ~GpuWorkload() {
    gles3::destroy(gl_, skinner_);
    gles3::destroy(gl_, programs_);
  }
  GpuWorkload(const GpuWorkload&) = delete;
  GpuWorkload& operator=(const GpuWorkload&) = delete;

  void frames(std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      Status status = gles3::update(gl_, skinner_, programs_, characters_);
      const gles3::Program& program = gles3::program_of(skinner_, programs_, 0);
      gl_.UseProgram(program.id);
      if (status == Status::ok) status = gles3::draw(gl_, skinner_, programs_, program, 0, characters_);
      if (status != Status::ok) throw Failure(Exit::internal, "gpu", "", to_string(status), "please report this");
    }
  }
  // To the last pixel.
  double seconds(std::uint64_t count) {
    const auto start = std::chrono::steady_clock::now();
    frames(count);
    std::uint8_t pixel[4];
    gl_.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  std::uint64_t vertices() const { return std::uint64_t{skinner_.mesh.geometry.slot_count} * characters_; }

 private:
  const Gl& gl_;
  std::uint32_t characters_;
  std::array<char, 1024> log_ = {};
  gles3::ProgramSet programs_;
  std::vector<SoaTransform> memory_;
  gles3::Skinner skinner_;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void measure(const Gl& gl, const GpuTimer& timer, const Mesh& mesh, GpuRow& row) {
  GpuWorkload work(gl, row, mesh);
  work.seconds(2);  // drivers compile at the first draw
  std::uint64_t batch = 1;
  while (work.seconds(batch) < kGpuBatch_s / 2 && batch < 1 << 16) batch *= 2;
  std::vector<double> frame_s, gpu_ns;
  for (std::size_t i = 0; i < kGpuBatches; ++i) {
    timer.begin();
    frame_s.push_back(work.seconds(batch) / static_cast<double>(batch));
    timer.end();
    if (timer.can()) gpu_ns.push_back(timer.elapsed_ns() / static_cast<double>(batch));
  }
  const auto vertices = static_cast<double>(work.vertices());
  row.frames_per_s = 1 / median(frame_s);
  row.ns_per_vertex = 1e9 * median(frame_s) / vertices;
  if (timer.can()) row.gpu_ns_per_vertex = median(gpu_ns) / vertices;
  gl.check(row.name.c_str());
}

std::vector<GpuRow> selected(const std::string& pattern, const Gl& gl, Models& models) {
  std::vector<GpuRow> rows = gpu_rows();
  std::erase_if(rows, [&](const GpuRow& row) { return fnmatch(pattern.c_str(), row.name.c_str(), 0) != 0; });
  if (rows.empty())
    throw Failure(Exit::usage, "--only", "", "no row is called \"" + pattern + "\"", "there are\n" + gpu_row_names());
  const auto leave_out = [&](const char* why, auto&& which) {
    const std::size_t count = std::erase_if(rows, which);
    if (count > 0) fmt::print(stderr, "marrow: note: {}: rows left out: {}\n", why, count);
  };
  if (!gl.caps().compute)
    leave_out("no compute shaders here", [](const GpuRow& row) { return row.path == Path::compute; });
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
  const Gl gl;
  const GpuTimer timer(gl);
  Models models;
  std::vector<GpuRow> rows = selected(arguments.only, gl, models);
  const GlRenderbuffer colour(gl);
  const GlFramebuffer target(gl);
  gl.BindRenderbuffer(GL_RENDERBUFFER, colour);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_RGBA8, kSide, kSide);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour);
  gl.Viewport(0, 0, kSide, kSide);
  std::unique_ptr<Subject> subject;
  const GpuCase* of = nullptr;
  for (GpuRow& row : rows) {
    if (row.of != of) subject = std::make_unique<Subject>(*row.of, models);
    of = row.of;
    measure(gl, timer, subject->mesh(), row);
  }
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
  std::vector<const char*> cases, paths;
  for (const GpuCase& of : kCases) cases.push_back(of.name);
  for (const Path path : kPaths) paths.push_back(gles3::to_string(path));
  return fmt::format("gpu/{}/{{ssd,as}}/{{p,pn}}/{}\n", choice(paths), choice(cases));
}

}  // namespace marrow::tools
