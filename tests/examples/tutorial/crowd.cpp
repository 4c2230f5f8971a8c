// Step 7: two hundred newts. Their clips are baked into a texture once; the CPU does nothing for them afterwards.
#include <marrow/gles3_crowd.h>

#include "actor.h"
#include "ground.h"

constexpr std::uint32_t kNewts = 200;

struct Crowd {
  gles3::CrowdClip clips[2];
  gles3::CrowdFrames frames;
  std::vector<gles3::CrowdMesh> meshes;
  gles3::Crowd instances;

  Crowd(const marrow::File& file, const Window& window, Programs& programs) {
    const gles3::CrowdSource sources[] = {{file.clip(file.find_clip("walk"))}, {file.clip(file.find_clip("idle"))}};
    std::uint32_t count = 0;
    must(gles3::plan_crowd(sources, 30, clips, count), "planning the crowd");
    const marrow::Skeleton skeleton = file.skeleton(0);
    const marrow::Span<std::byte> baked = memory_of(sizeof(marrow::Affine) * count * skeleton.joint_count);
    std::vector<marrow::SoaTransform> scratch(skeleton.soa_size());
    must(gles3::bake_crowd(skeleton, sources, clips, scratch,
                           {reinterpret_cast<marrow::Affine*>(baked.data), count * skeleton.joint_count}, frames),
         "baking the crowd");
    for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
      const marrow::Mesh mesh = file.mesh(i, 1);  // level of detail 1: an eighth of the triangles
      must(create_crowd_mesh(window.gl, window.caps, mesh, {}, frames, kNewts, memory_of(gles3::crowd_mesh_bytes(mesh)),
                             meshes.emplace_back()),
           "the crowd on the GPU");
      must(create_crowd_programs(window.gl, window.caps, meshes.back(), gles3::Deformer::ssd, 255, programs.set),
           "programs of the crowd", programs.log);
    }
    must(create_crowd(window.gl, window.caps, kNewts, memory_of(kNewts * gles3::kCrowdInstanceBytes), instances),
         "instances");
  }

  // Rows of twenty. Each newt has a moment of its own in the clip; every third stands and idles.
  void place(const Window& window) {
    std::vector<gles3::CrowdInstance> newts(kNewts);
    for (std::uint32_t i = 0; i < kNewts; ++i) {
      const float x = 1.1f * (float(i % 20) - 9.5f) + 0.3f * float(i / 20 % 2), z = -1.2f * float(i / 20);
      const std::uint32_t clip = i % 3 == 0 ? 1 : 0;
      newts[i].world_from_model = {{{1, 0, 0, x}, {0, 1, 0, 0}, {0, 0, 1, z}}};
      newts[i].a = {.clip = clip, .phase_s = clips[clip].duration_s * std::fmod(0.618f * float(i), 1.0f)};
    }
    must(set_instances(window.gl, instances, frames, 0, newts), "placing the crowd");
  }

  void blend(const Window& window, const Programs& programs, double time_s) const {
    const gles3::Program& program = blending_program_of(programs.set);
    window.gl.UseProgram(program.id);
    window.gl.Disable(GL_CULL_FACE);
    for (const gles3::CrowdMesh& mesh : meshes)
      must(blend_crowd(window.gl, instances, mesh, 0, kNewts, time_s, 0, program), "blending the crowd");
  }

  void draw(const Window& window, const Programs& programs) const {
    for (const gles3::CrowdMesh& mesh : meshes) {
      const gles3::Program& program = crowd_program_of(mesh, gles3::Deformer::ssd, 255, programs.set, 0);
      window.use(program.id, mesh.mesh.base_colour);
      (mesh.mesh.double_sided ? window.gl.Disable : window.gl.Enable)(GL_CULL_FACE);
      must(bind_crowd(window.gl, instances, mesh, 0, kNewts, 0, program), "binding the crowd");
      must(gles3::draw(window.gl, mesh, gles3::Deformer::ssd, program, kNewts), "drawing the crowd");
    }
  }
};

int main(int argc, char** argv) {
  Window window(argc, argv);
  window.eye = {0, 4.0f, 5.0f};
  window.at = {0, 0.4f, -2};
  const marrow::File file = load_file(window.file);
  Programs programs;
  Crowd crowd(file, window, programs);
  crowd.place(window);
  Ground ground(level);
  ground.upload(window);

  double time_s = 0;
  for (float dt_s; window.begin(dt_s); window.end()) {
    time_s += double(dt_s);
    crowd.blend(window, programs, time_s);  // draws into textures, so before clear()
    window.clear();
    ground.draw(window, 0);
    crowd.draw(window, programs);
  }
}
