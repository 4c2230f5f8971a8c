// Two hundred characters whose clips are baked into a texture: the CPU does nothing for them. See docs/gles/crowds.md.
#include <marrow/gles3_crowd.h>

#include <cmath>

#include "stage.h"

constexpr const char* kVertex = R"(
uniform mat4 clip_from_model;
out vec3 colour;
void main() {
  MarrowVertex v = marrow_skin();
  colour = (0.6 + 0.4 * v.normal.y) * marrow_instance_colour().rgb;
  gl_Position = clip_from_model * vec4(v.position, 1.0);
}
)";
constexpr const char* kFragment = R"(
precision highp float;
in vec3 colour;
out vec4 pixel;
void main() { pixel = vec4(colour, 1.0); }
)";
constexpr std::uint32_t kCount = 200;

// Once a character: its clips become frames. What comes out is for all its meshes and for sockets.
struct Baked {
  gles3::CrowdClip clips[2];
  std::vector<marrow::Affine> matrices;
  gles3::CrowdFrames frames;

  void bake(const marrow::File& file) {
    const gles3::CrowdSource sources[] = {{file.clip(file.find_clip("idle")), true},
                                          {file.clip(file.find_clip("walk")), true}};
    std::uint32_t count = 0;
    must(gles3::plan_crowd(sources, 30, clips, count), "planning");
    const marrow::Skeleton skeleton = file.skeleton(0);
    std::vector<marrow::SoaTransform> scratch(skeleton.soa_size());
    matrices.resize(count * skeleton.joint_count);
    must(gles3::bake_crowd(skeleton, sources, clips, scratch, matrices, frames), "baking");
  }
};

int main(int argc, char** argv) {
  if (argc < 2) return 1;
  const Asset asset(argv[1]);
  Stage stage;
  stage.open();
  char log[1024] = "";
  gles3::ProgramSet programs;
  programs.roles[0] = {kVertex, kFragment, {}};
  programs.role_features[0] = gles3::kNormals;
  programs.log = log;
  Baked baked;
  baked.bake(asset.file);

  // Once a mesh: it goes up, and its palette of every frame.
  std::vector<gles3::CrowdMesh> meshes(asset.file.mesh_count());
  std::vector<std::vector<std::byte>> rooms(meshes.size());
  for (std::uint32_t m = 0; m < meshes.size(); ++m) {
    const marrow::Mesh mesh = asset.file.mesh(m);
    rooms[m].resize(gles3::crowd_mesh_bytes(mesh));
    must(create_crowd_mesh(stage.gl, stage.caps, mesh, {}, baked.frames, kCount, rooms[m], meshes[m]), "a mesh");
    must(create_crowd_programs(stage.gl, stage.caps, meshes[m], gles3::Deformer::ssd, 255, programs), "programs", log);
  }

  // Once a crowd, and when somebody does something else: who stands where, and plays what since when.
  std::vector<std::byte> records(kCount * gles3::kCrowdInstanceBytes);
  gles3::Crowd crowd;
  must(create_crowd(stage.gl, stage.caps, kCount, records, crowd), "the crowd");
  std::vector<gles3::CrowdInstance> newts(kCount);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const float x = float(i % 20) - 9.5f, z = -float(i / 20);
    newts[i].world_from_model = {{{1, 0, 0, x}, {0, 1, 0, 0}, {0, 0, 1, z}}};
    newts[i].a.clip = 0;  // idle
    newts[i].a.phase_s = 0.1f * float(i % 30);
    newts[i].colour[0] = 0.3f + 0.1f * float(i % 7);
  }
  must(set_instances(stage.gl, crowd, baked.frames, 0, newts), "placing");
  newts[3].b.clip = 1;  // number 3 begins to walk at 2 s, and is done with idling a quarter of a second later
  newts[3].b.start_s = newts[3].blend_start_s = 2;
  newts[3].blend_s = 0.25f;
  must(set_instances(stage.gl, crowd, baked.frames, 3, {&newts[3], 1}), "number 3");

  const float front[16] = {0.1f, 0, 0, 0, 0, 0.1f, 0.02f, 0, 0, -0.08f, -0.05f, 0, 0, -0.4f, 0, 1};
  for (const double time_s : {0.0, 2.1, 3.0}) {
    // Blending draws into a texture, so the state of a picture comes after it.
    const gles3::Program& blending = blending_program_of(programs);
    stage.gl.UseProgram(blending.id);
    stage.gl.Disable(GL_CULL_FACE);
    for (const gles3::CrowdMesh& mesh : meshes)
      must(blend_crowd(stage.gl, crowd, mesh, 0, kCount, time_s, 0, blending), "blending");

    stage.begin_pass();
    for (const gles3::CrowdMesh& mesh : meshes) {
      const gles3::Program& program = crowd_program_of(mesh, gles3::Deformer::ssd, 255, programs, 0);
      stage.gl.UseProgram(program.id);
      stage.gl.UniformMatrix4fv(stage.gl.GetUniformLocation(program.id, "clip_from_model"), 1, 0, front);
      must(bind_crowd(stage.gl, crowd, mesh, 0, kCount, 0, program), "binding");
      must(gles3::draw(stage.gl, mesh, gles3::Deformer::ssd, program, kCount), "drawing");
    }
    // Where a lantern goes that number 3 holds: by the arithmetic of the GPU, without asking it.
    const std::uint32_t hand = asset.file.find_joint(asset.file.skeleton(0), "hand.L");
    marrow::Affine socket;
    must(crowd_joint(baked.frames, newts[3], time_s, hand, socket), "a socket");
    stage.save(argc > 2 ? argv[2] : nullptr, "crowd");
    std::printf("%.1f s: %d pixels, the hand of number 3 at %.3f %.3f %.3f\n", time_s, stage.covered(),
                double(socket.rows[0][3]), double(socket.rows[1][3]), double(socket.rows[2][3]));
  }
  for (gles3::CrowdMesh& mesh : meshes) destroy(stage.gl, mesh);
  destroy(stage.gl, crowd);
  destroy(stage.gl, programs);
  std::printf("GL errors: %u\n", stage.gl.GetError());
}
