#include "gpu_bench/gpu_work.h"

#include <algorithm>
#include <array>
#include <vector>

#include "bench/workload.h"
#include "common/aligned_bytes.h"
#include "common/failure.h"
#include "marrow/gles3_crowd.h"
#include "marrow/marrow.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

// Out of sight, but the driver cannot know that before it has skinned.
constexpr const char* kVertex = R"(
out vec3 shade;
void main() {
  MarrowVertex v = marrow_skin();
  shade = v.normal + v.position - v.previous_position;
  gl_Position = vec4(v.position.xy, v.position.z + 100.0, 1.0);
}
)";
constexpr const char* kFragment = R"(
precision mediump float;
in vec3 shade;
out vec4 colour;
void main() { colour = vec4(shade, 1.0); }
)";

[[noreturn]] void refuse(const Gl& gl, const GpuRow& row, const std::string& why) {
  throw Failure(Exit::internal, row.name, "", why, "please report this with the driver: " + gl.driver());
}

class SkinnerWork : public GpuWork {
 public:
  SkinnerWork(const Gl& gl, const GpuRow& row, const Mesh& mesh)
      : GpuWork(std::uint64_t{mesh.geometry.slot_count} * row.of->characters),
        gl_(gl),
        characters_(row.of->characters) {
    programs_.roles[0] = {kVertex, kFragment, {}};
    programs_.log = log_;
    gles3::SkinnerOptions options;
    options.path = *row.path;
    options.deformer = row.deformer;
    options.instances = characters_;
    options.features = row.features;
    options.motion = (row.features & gles3::kMotion) != 0;
    memory_.resize(gles3::skinner_bytes(mesh, options) / sizeof(SoaTransform) + 1);
    const Status status = gles3::create_skinner(
        gl, gl.caps(), mesh, options, programs_,
        {reinterpret_cast<std::byte*>(memory_.data()), memory_.size() * sizeof(SoaTransform)}, skinner_);
    if (status != Status::ok) refuse(gl, row, std::string(to_string(status)) + " " + log_.data());
    std::uint32_t joints = 0;
    for (std::uint32_t j = 0; j < mesh.joint_count; ++j) joints = std::max(joints, mesh.joints[j] + 1u);
    const std::vector<Affine> pose = noise_palette(joints);
    for (std::uint32_t i = 0; i < characters_; ++i) check(gles3::pose(skinner_, i, pose));
  }
  ~SkinnerWork() override {
    gles3::destroy(gl_, skinner_);
    gles3::destroy(gl_, programs_);
  }
  SkinnerWork(const SkinnerWork&) = delete;
  SkinnerWork& operator=(const SkinnerWork&) = delete;

  void frame() override {
    check(gles3::update(gl_, skinner_, programs_, characters_));
    const gles3::Program& program = gles3::program_of(skinner_, programs_, 0);
    gl_.UseProgram(program.id);
    check(gles3::draw(gl_, skinner_, programs_, program, 0, characters_));
  }

 private:
  const Gl& gl_;
  std::uint32_t characters_;
  std::array<char, 1024> log_ = {};
  gles3::ProgramSet programs_;
  std::vector<SoaTransform> memory_;
  gles3::Skinner skinner_;
};

class CrowdWork : public GpuWork {
 public:
  CrowdWork(const Gl& gl, const GpuTarget& target, const GpuRow& row, const GpuSubject& subject)
      : GpuWork(std::uint64_t{subject.mesh.geometry.slot_count} * row.of->characters),
        gl_(gl),
        target_(target),
        deformer_(row.deformer),
        features_(row.features),
        characters_(row.of->characters) {
    const Mesh& mesh = subject.mesh;
    gles3::CrowdMeshOptions options;
    options.ssd = deformer_ == gles3::Deformer::ssd;
    options.as = !options.ssd;
    programs_.roles[0] = {kVertex, kFragment, {}};
    programs_.log = log_;
    memory_ = AlignedBytes(gles3::crowd_mesh_bytes(mesh, options));
    records_ = AlignedBytes(gles3::kCrowdInstanceBytes * characters_);
    bake(subject.skeleton, subject.clip);
    const bool made =
        gles3::create_crowd_mesh(gl, gl.caps(), mesh, options, frames_, characters_, {memory_.data(), memory_.size()},
                                 mesh_, (features_ & gles3::kMotion) != 0) == Status::ok &&
        gles3::create_crowd(gl, gl.caps(), characters_, {records_.data(), records_.size()}, crowd_) == Status::ok &&
        gles3::create_crowd_programs(gl, gl.caps(), mesh_, deformer_, features_, programs_) == Status::ok;
    if (!made) refuse(gl, row, log_.data());
    place();
  }
  ~CrowdWork() override {
    gles3::destroy(gl_, mesh_);
    gles3::destroy(gl_, crowd_);
    gles3::destroy(gl_, programs_);
  }
  CrowdWork(const CrowdWork&) = delete;
  CrowdWork& operator=(const CrowdWork&) = delete;

  void frame() override {
    time_s_ += 1.0 / 60;
    gles3::begin_frame(mesh_);
    const gles3::Program& blending = gles3::blending_program_of(programs_);
    gl_.UseProgram(blending.id);
    check(gles3::blend_crowd(gl_, crowd_, mesh_, 0, characters_, time_s_, 0, blending));
    target_.bind();
    const gles3::Program& drawing = gles3::crowd_program_of(mesh_, deformer_, features_, programs_, 0);
    gl_.UseProgram(drawing.id);
    check(gles3::bind_crowd(gl_, crowd_, mesh_, 0, characters_, 0, drawing));
    check(gles3::draw(gl_, mesh_, deformer_, drawing, characters_));
  }

 private:
  void bake(const Skeleton& skeleton, const Clip& clip) {
    const gles3::CrowdSource source{clip, true};
    std::uint32_t frames = 0;
    check(gles3::plan_crowd({&source, 1}, 30, {&baked_, 1}, frames));
    matrices_.resize(std::size_t{frames} * skeleton.joint_count);
    std::vector<SoaTransform> scratch(skeleton.soa_size());
    check(gles3::bake_crowd(skeleton, {&source, 1}, {&baked_, 1}, scratch, matrices_, frames_));
  }
  // Each at a moment of its own.
  void place() {
    std::vector<gles3::CrowdInstance> instances(characters_);
    Noise noise;
    for (gles3::CrowdInstance& instance : instances) instance.a = {0, noise.next() * baked_.duration_s, 1, 0};
    check(gles3::set_instances(gl_, crowd_, frames_, 0, instances));
  }

  const Gl& gl_;
  const GpuTarget& target_;
  gles3::Deformer deformer_;
  std::uint8_t features_;
  std::uint32_t characters_;
  double time_s_ = 0;
  gles3::CrowdClip baked_;
  std::vector<Affine> matrices_;
  gles3::CrowdFrames frames_;
  AlignedBytes memory_, records_;
  std::array<char, 1024> log_ = {};
  gles3::ProgramSet programs_;
  gles3::CrowdMesh mesh_;
  gles3::Crowd crowd_;
};

}  // namespace

GpuTarget::GpuTarget(const Gl& gl) : gl_(gl), colour_(gl), framebuffer_(gl) {
  gl.BindRenderbuffer(GL_RENDERBUFFER, colour_);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_RGBA8, kSide, kSide);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  bind();
}

void GpuTarget::bind() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(0, 0, kSide, kSide);
}

std::unique_ptr<GpuWork> make_gpu_work(const Gl& gl, const GpuTarget& target, const GpuRow& row,
                                       const GpuSubject& subject) {
  if (!row.path) return std::make_unique<CrowdWork>(gl, target, row, subject);
  return std::make_unique<SkinnerWork>(gl, row, subject.mesh);
}

}  // namespace marrow::tools
