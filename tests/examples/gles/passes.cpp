// One skinner, three roles: a shadow, the picture, motion vectors. See docs/gles/shaders.md.
#include "stage.h"

// A role's vertex text stands behind the skinning text, so it may call marrow_skin().
constexpr const char* kColourVertex = R"(
uniform mat4 clip_from_model;
out vec3 normal;
out vec4 paint;
void main() {
  MarrowVertex v = marrow_skin();
  normal = v.normal;
  paint = vec4(1.0);
#if MARROW_COLOUR
  paint = in_colour;
#endif
  gl_Position = clip_from_model * vec4(v.position, 1.0);
}
)";
constexpr const char* kColourFragment = R"(
precision highp float;
uniform vec4 base_colour;
in vec3 normal;
in vec4 paint;
out vec4 pixel;
void main() {
  float light = 0.35 + 0.65 * max(dot(normalize(normal), vec3(0.4, 0.8, 0.45)), 0.0);
  pixel = vec4(light * (base_colour * paint).rgb, 1.0);
}
)";
// A shadow needs positions alone.
constexpr const char* kShadowVertex = R"(
uniform mat4 clip_from_model;
void main() { gl_Position = clip_from_model * vec4(marrow_skin().position, 1.0); }
)";
constexpr const char* kShadowFragment = "void main() {}\n";
// How far each pixel has come since the frame before, a sixteenth of the picture from black to white; grey is nothing.
constexpr const char* kMotionVertex = R"(
uniform mat4 clip_from_model;
uniform mat4 previous_clip_from_model;
out vec4 clip;
out vec4 previous_clip;
void main() {
  MarrowVertex v = marrow_skin();
  clip = clip_from_model * vec4(v.position, 1.0);
  previous_clip = previous_clip_from_model * vec4(v.previous_position, 1.0);
  gl_Position = clip;
}
)";
constexpr const char* kMotionFragment = R"(
precision highp float;
in vec4 clip;
in vec4 previous_clip;
out vec4 motion;
void main() {
  vec2 way = 0.5 * (clip.xy / clip.w - previous_clip.xy / previous_clip.w);
  motion = vec4(0.5 + 16.0 * way, 0.0, 1.0);
}
)";

enum Role { kColour, kShadow, kMotion };

// Once a context: what each role draws with, and what of a mesh it wants to read.
void set_roles(gles3::ProgramSet& programs, marrow::Span<char> log) {
  programs.roles[kColour] = {kColourVertex, kColourFragment, {}};
  programs.roles[kShadow] = {kShadowVertex, kShadowFragment, {}};
  programs.roles[kMotion] = {kMotionVertex, kMotionFragment, {}};
  programs.role_count = 3;
  programs.role_features[kColour] = gles3::kNormals | gles3::kColours;
  programs.role_features[kShadow] = 0;
  programs.role_features[kMotion] = gles3::kMotion;
  programs.log = log;  // what the driver says of a text that does not compile
}

// Each frame and role: the program of this mesh, the game's own uniforms, all characters in as few calls as may be.
void draw_role(Stage& stage, const gles3::Skinner& skinner, const gles3::ProgramSet& programs, Role role,
               const float (&clip_from_model)[16], std::uint32_t count) {
  const gles3::Program& program = program_of(skinner, programs, role);
  const gles3::Api& gl = stage.gl;
  gl.UseProgram(program.id);
  gl.UniformMatrix4fv(gl.GetUniformLocation(program.id, "clip_from_model"), 1, 0, clip_from_model);
  if (role == kColour) {
    const float(&c)[4] = skinner.mesh.base_colour;
    gl.Uniform4f(gl.GetUniformLocation(program.id, "base_colour"), c[0], c[1], c[2], c[3]);
  }
  if (role == kMotion)  // the camera stands still here; a game keeps its matrix of the frame before
    gl.UniformMatrix4fv(gl.GetUniformLocation(program.id, "previous_clip_from_model"), 1, 0, clip_from_model);
  must(gles3::draw(gl, skinner, programs, program, 0, count), "drawing");
}

int main(int argc, char** argv) {
  if (argc < 2) return 1;
  const char* const folder = argc > 2 ? argv[2] : nullptr;
  const Asset asset(argv[1]);
  Stage stage;
  stage.open();
  char log[1024] = "";
  gles3::ProgramSet programs;
  set_roles(programs, log);

  // Three characters. The GPU skins, so they need neither palettes nor vertices of their own.
  constexpr std::uint32_t kCount = 3;
  const marrow::CharacterOptions on_gpu{.layers = 1, .level = 0, .skin = false, .animation_space = false};
  const std::size_t own = character_bytes(asset.file, on_gpu);
  std::vector<std::byte> memory(kCount * own);
  marrow::Character bodies[kCount];
  for (std::uint32_t i = 0; i < kCount; ++i)
    must(make_character(asset.file, on_gpu, {memory.data() + i * own, own}, bodies[i]), "a character");

  // Once a mesh.
  gles3::SkinnerOptions options;
  options.path = gles3::SkinningPath::texture;  // all characters of a mesh in one draw call
  options.instances = kCount;
  options.motion = true;  // keeps the frame before on the GPU
  std::vector<gles3::Skinner> skinners(asset.file.mesh_count());
  std::vector<std::vector<std::byte>> rooms(skinners.size());
  for (std::uint32_t m = 0; m < skinners.size(); ++m) {
    const marrow::Mesh mesh = asset.file.mesh(m);
    rooms[m].resize(gles3::skinner_bytes(mesh, options));
    must(create_skinner(stage.gl, stage.caps, mesh, options, programs, rooms[m], skinners[m]), "a skinner", log);
  }

  // Column after column, as GL takes them: the scene from the front, three metres wide, y up.
  const float front[16] = {0.66f, 0, 0, 0, 0, 0.66f, 0, 0, 0, 0, -0.25f, 0, 0, -0.5f, 0, 1};
  const float sun[16] = {0.5f, 0, 0, 0, 0, 0.2f, -0.3f, 0, 0, 0.4f, 0.2f, 0, 0, -0.3f, 0, 1};  // from above
  const marrow::Animation* const walk = find_animation(asset.animations, "walk");
  for (int frame = 0; frame < 2; ++frame) {
    for (std::uint32_t i = 0; i < kCount; ++i) {
      must(pose_character(bodies[i], {{walk, 0.3f * float(i) + 0.1f * float(frame)}}), "the pose");
      const marrow::Span<marrow::Affine> joints = bodies[i].skeletons[0].pose.model_from_joint;
      for (marrow::Affine& joint : joints) joint.rows[0][3] += float(i) - 1;  // side by side
      for (std::uint32_t m = 0; m < skinners.size(); ++m)
        must(pose(skinners[m], i, joints, bodies[i].meshes[m].weights), "posing");
    }
    for (gles3::Skinner& skinner : skinners) must(update(stage.gl, skinner, programs, kCount), "updating");

    for (const Role role : {kShadow, kColour, kMotion}) {
      stage.begin_pass();
      const unsigned char seen = role != kShadow;
      stage.gl.ColorMask(seen, seen, seen, seen);
      for (const gles3::Skinner& skinner : skinners)
        draw_role(stage, skinner, programs, role, role == kShadow ? sun : front, kCount);
      stage.gl.ColorMask(1, 1, 1, 1);
      if (role == kColour) std::printf("frame %d: %d pixels", frame, stage.covered());
      stage.save(folder, role == kColour ? "colour" : role == kMotion ? "motion" : "shadow");
    }
    int moved = 0;  // pixels that have come farther than rounding
    const std::vector<unsigned char> motion = stage.read();
    for (std::size_t i = 0; i < motion.size(); i += 4)
      moved += motion[i + 3] != 0 && (std::abs(motion[i] - 128) > 1 || std::abs(motion[i + 1] - 128) > 1);
    std::printf(", %d of them moved\n", moved);
  }
  for (gles3::Skinner& skinner : skinners) destroy(stage.gl, skinner);
  destroy(stage.gl, programs);
  std::printf("GL errors: %u\n", stage.gl.GetError());
}
