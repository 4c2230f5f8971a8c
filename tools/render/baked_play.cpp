#include "render/baked_play.h"

#include "common/failure.h"
#include "render/studio.h"

namespace marrow::tools {
namespace {

constexpr float kBakedHz = 30;
constexpr std::uint64_t kMostMatrices = std::uint64_t{1} << 23;  // of a skeleton, all frames: 400 MB

[[noreturn]] void refuse(const std::string& path, std::string where, std::string rule) {
  throw Failure(Exit::unsupported, path, std::move(where), std::move(rule), "use another --path");
}

// Whether any target can have a weight other than 0. first: of the mesh's in Play::channels.
bool is_morphed(const Mesh& mesh, const Play& play, std::size_t first) {
  for (std::size_t t = 0; t < mesh.targets.size; ++t) {
    if (mesh.targets[t].weight != 0) return true;
    if (!play.empty() && play.channels[first + t] != kNoChannel) return true;
  }
  return false;
}

}  // namespace

BakedPlay::BakedPlay(const Gl& gl, const gles3::ProgramSet& programs, const std::string& path, const File& file,
                     const Play& play, std::uint32_t level, const std::vector<std::vector<float>>& tangents)
    : gl_(gl), programs_(programs), reels_(file.skeleton_count()), meshes_(file.mesh_count()) {
  std::size_t first_target = 0;
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    Mesh mesh = file.mesh(i, level);
    const std::optional<Clip> clip = play.clip(mesh.skeleton);
    const std::string where = "mesh " + std::to_string(i);
    if (is_morphed(mesh, play, first_target)) refuse(path, where, "crowds have no morph targets");
    first_target += file.mesh(i).targets.size;
    mesh.geometry.targets = {};  // none of them moves anything
    meshes_[i].skeleton = mesh.skeleton;
    Reel& reel = reels_[mesh.skeleton];
    if (reel.matrices.empty()) bake(path, file.skeleton(mesh.skeleton), clip ? &*clip : nullptr, reel);
    gles3::CrowdMeshOptions options;
    options.as_tangents = tangents[i];
    AlignedBytes& memory = meshes_[i].memory;
    memory = AlignedBytes(gles3::crowd_mesh_bytes(mesh, options));
    const Status status = gles3::create_crowd_mesh(gl, gl.caps(), mesh, options, reel.frames, 1,
                                                   {memory.data(), memory.size()}, meshes_[i].gpu);
    if (status == Status::unsupported) refuse(path, where, "more frames than a crowd's texture holds");
    check(status);
  }
}

BakedPlay::~BakedPlay() {
  for (BakedMesh& mesh : meshes_) gles3::destroy(gl_, mesh.gpu);
  for (Reel& reel : reels_) gles3::destroy(gl_, reel.crowd);
}

// Without a clip the rest pose, twice, as a crowd always looks at two frames.
void BakedPlay::bake(const std::string& path, const Skeleton& skeleton, const Clip* clip, Reel& reel) {
  if (clip == nullptr) {
    reel.clip = {0, 0, 1, false};
    reel.matrices.resize(std::size_t{2} * skeleton.joint_count);
    for (std::size_t frame = 0; frame < 2; ++frame)
      check(local_to_model(skeleton, {skeleton.rest, skeleton.soa_size()},
                           {reel.matrices.data() + frame * skeleton.joint_count, skeleton.joint_count}));
    reel.frames = {{&reel.clip, 1}, reel.matrices, skeleton.joint_count, 2};
  } else {
    const std::string where = "clip \"" + std::string(clip->name) + "\"";
    if (clip->additive) refuse(path, where, "crowds have no additive clips");
    // Not looped, so that its end is its last pose, as by any other path.
    const gles3::CrowdSource source{*clip, false};
    std::uint32_t frames = 0;
    const Status status = gles3::plan_crowd({&source, 1}, kBakedHz, {&reel.clip, 1}, frames);
    if (status == Status::unsupported || std::uint64_t{frames} * skeleton.joint_count > kMostMatrices)
      refuse(path, where, "more frames than a crowd has");
    check(status);
    reel.matrices.resize(std::size_t{frames} * skeleton.joint_count);
    std::vector<SoaTransform> scratch(skeleton.soa_size());
    check(gles3::bake_crowd(skeleton, {&source, 1}, {&reel.clip, 1}, scratch, reel.matrices, reel.frames));
  }
  check(gles3::create_crowd(gl_, gl_.caps(), 1, {reel.instance, sizeof(reel.instance)}, reel.crowd));
}

void BakedPlay::blend(float time_s) {
  for (Reel& reel : reels_) {
    if (reel.matrices.empty()) continue;
    // The moment is the phase, which is finer than the ticks of the crowd's clock.
    gles3::CrowdInstance instance;
    instance.a = {0, time_s, 0, 0};
    check(gles3::set_instances(gl_, reel.crowd, reel.frames, 0, {&instance, 1}));
  }
  const gles3::Program& program = gles3::blending_program_of(programs_);
  gl_.UseProgram(program.id);
  for (const BakedMesh& mesh : meshes_)
    check(gles3::blend_crowd(gl_, reels_[mesh.skeleton].crowd, mesh.gpu, 0, 1, 0, kPaletteUnit, program));
  gl_.UseProgram(0);
  gl_.check("blending a crowd");
}

}  // namespace marrow::tools
