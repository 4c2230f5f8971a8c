// What a game in a browser begins with: it plays the walk of a character and draws it by WebGL 2, over marrow::gles3.
// play.mjs fetches the file, has the canvas, and calls what is exported here. See docs/platforms/web.md.
#include <marrow/block.h>
#include <marrow/gles3_skinner.h>
#include <marrow/marrow.h>

#include <GLES3/gl3.h>
#include <emscripten.h>

#include <cstdlib>
#include <cstring>
#include <vector>

namespace {

namespace gles3 = marrow::gles3;
using marrow::Status;

constexpr const char* kVertex = R"(
uniform mat4 clip_from_model;
out vec3 position_scene, normal_scene;
out vec4 colour;
void main() {
  MarrowVertex v = marrow_skin();
  position_scene = v.position;
  normal_scene = v.normal;
#if MARROW_COLOUR
  colour = in_colour;
#else
  colour = vec4(1.0);
#endif
  gl_Position = clip_from_model * vec4(v.position, 1.0);
}
)";
// A little light from the camera. The canvas does not encode sRGB, so this does.
constexpr const char* kFragment = R"(
precision highp float;
uniform vec3 camera_position;
uniform vec4 base_colour;  // linear
in vec3 position_scene, normal_scene;
in vec4 colour;
out vec4 frag_colour;
void main() {
  float facing = max(dot(normalize(normal_scene), normalize(camera_position - position_scene)), 0.0);
  vec3 c = base_colour.rgb * colour.rgb * (0.80 + 0.20 * facing);
  c = mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
  frag_colour = vec4(c, 1.0);
}
)";

// Memory on a boundary of 16 bytes, until the page goes: malloc of wasm32 promises 8 alone.
marrow::Span<std::byte> block_of(std::size_t bytes) {
  const std::size_t wanted = marrow::block_bytes(bytes);
  return marrow::block_in({static_cast<std::byte*>(std::malloc(wanted)), wanted});
}

// Each function of OpenGL ES 3.0 that Marrow calls, by name. emscripten_GetProcAddress() would link every one there is.
void* load_proc(const char* name) {
#define MARROW_FIND(Result, Name, Parameters) \
  if (std::strcmp(name, "gl" #Name) == 0) return reinterpret_cast<void*>(&gl##Name);
  MARROW_GLES3_FUNCTIONS(MARROW_FIND)
#undef MARROW_FIND
  return nullptr;
}

// A camera that looks at a point from in front, a little from the side and above.
// 0.56 rad to its left and 0.21 rad up, its view 0.47 rad high.
constexpr float kCosYaw = 0.847255111f, kSinYaw = 0.531186198f, kCosPitch = 0.978030915f, kSinPitch = 0.2084599f;
constexpr float kTall = 4.17669589f;  // 1 / tan(0.47 / 2)
constexpr float kNear = 0.1f, kFar = 100;
void look_at(const float (&target)[3], float distance, float aspect, float (&position)[3], float (&clip)[16]) {
  constexpr float back[3] = {kSinYaw * kCosPitch, kSinPitch, kCosYaw * kCosPitch};
  constexpr float right[3] = {kCosYaw, 0, -kSinYaw};
  constexpr float up[3] = {-kSinPitch * kSinYaw, kCosPitch, -kSinPitch * kCosYaw};
  constexpr float depth = (kFar + kNear) / (kFar - kNear);
  float at[3] = {0, 0, 0};  // the camera, in its own axes
  for (int c = 0; c < 3; ++c) {
    position[c] = target[c] + distance * back[c];
    at[0] += right[c] * position[c];
    at[1] += up[c] * position[c];
    at[2] += back[c] * position[c];
    clip[4 * c] = kTall / aspect * right[c];
    clip[4 * c + 1] = kTall * up[c];
    clip[4 * c + 2] = -depth * back[c];
    clip[4 * c + 3] = -back[c];
  }
  clip[12] = -kTall / aspect * at[0];
  clip[13] = -kTall * at[1];
  clip[14] = depth * at[2] - 2 * kFar * kNear / (kFar - kNear);
  clip[15] = at[2];
}

struct Game {
  marrow::Character body;
  marrow::Animations animations;
  const marrow::Animation* walk = nullptr;
  marrow::Playback playback;
  gles3::Api gl;
  gles3::Caps caps;
  gles3::ProgramSet programs;
  std::vector<gles3::Skinner> skinners;  // one a mesh
};
Game game;

Status open(marrow::Span<const std::byte> bytes, const gles3::SkinnerOptions& how) {
  marrow::File file;
  Status status = load(bytes, file);
  if (status != Status::ok) return status;
  if (status = make_animations(file, file, block_of(animations_bytes(file, file)), game.animations);
      status != Status::ok)
    return status;
  game.walk = find_animation(game.animations, "walk");
  if (game.walk == nullptr) return Status::mismatch;
  const marrow::CharacterOptions options{.layers = 1, .level = 0, .skin = false, .animation_space = false};
  if (status = make_character(file, options, block_of(character_bytes(file, options)), game.body); status != Status::ok)
    return status;
  if (status = load_api(game.gl, load_proc); status != Status::ok) return status;
  if (status = query_caps(game.gl, game.caps); status != Status::ok) return status;
  game.programs.roles[0] = {kVertex, kFragment, {}};
  for (const marrow::CharacterMesh& m : game.body.meshes) {
    const marrow::Span<std::byte> memory = block_of(gles3::skinner_bytes(m.mesh, how));
    status = create_skinner(game.gl, game.caps, m.mesh, how, game.programs, memory, game.skinners.emplace_back());
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

Status draw_mesh(const marrow::CharacterMesh& m, gles3::Skinner& skinner, const float (&position)[3],
                 const float (&clip)[16]) {
  const gles3::Api& gl = game.gl;
  Status status = pose(skinner, 0, game.body.skeletons[m.mesh.skeleton].pose.model_from_joint, m.weights);
  if (status == Status::ok) status = update(gl, skinner, game.programs, 1);
  const gles3::Program& program = program_of(skinner, game.programs, 0);
  gl.UseProgram(program.id);
  gl.UniformMatrix4fv(gl.GetUniformLocation(program.id, "clip_from_model"), 1, GL_FALSE, clip);
  gl.Uniform3fv(gl.GetUniformLocation(program.id, "camera_position"), 1, position);
  gl.Uniform4fv(gl.GetUniformLocation(program.id, "base_colour"), 1, m.mesh.base_colour);
  (m.mesh.double_sided ? gl.Disable : gl.Enable)(GL_CULL_FACE);
  if (status == Status::ok) status = draw(gl, skinner, game.programs, program, 0, 1);
  return status;
}

Status draw_body(int width, int height, float distance) {
  glViewport(0, 0, width, height);
  glEnable(GL_DEPTH_TEST);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const marrow::Affine& pelvis = game.body.skeletons[0].pose.model_from_joint[0];
  float position[3], clip[16];
  look_at({pelvis.rows[0][3], pelvis.rows[1][3], pelvis.rows[2][3]}, distance,
          static_cast<float>(width) / static_cast<float>(height), position, clip);
  Status status = Status::ok;
  for (std::size_t i = 0; i < game.skinners.size() && status == Status::ok; ++i)
    status = draw_mesh(game.body.meshes[i], game.skinners[i], position, clip);
  return status;
}

}  // namespace

// What play.mjs calls. Results are marrow::Status: 0 is ok.
extern "C" {

// Where the page puts the file.
EMSCRIPTEN_KEEPALIVE std::byte* block(int bytes) {
  return block_of(static_cast<std::size_t>(bytes)).data;
}

// With a current context. deformer: see gles3::Deformer, path: gles3::SkinningPath.
EMSCRIPTEN_KEEPALIVE int start(const std::byte* file, int bytes, int deformer, int path) {
  gles3::SkinnerOptions how;
  how.deformer = static_cast<gles3::Deformer>(deformer);
  how.path = static_cast<gles3::SkinningPath>(path);
  return static_cast<int>(open({file, static_cast<std::size_t>(bytes)}, how));
}

// Moves time on by dt_s, or by 0 to draw the same again, and draws.
EMSCRIPTEN_KEEPALIVE int frame(float dt_s, int width, int height, float distance) {
  Status status = advance(game.playback, game.walk->duration_s, dt_s);
  if (status == Status::ok) status = pose_character(game.body, {{game.walk, clip_time(game.playback)}});
  if (status == Status::ok) status = draw_body(width, height, distance);
  return static_cast<int>(status);
}

EMSCRIPTEN_KEEPALIVE void lost() {
  on_context_lost(game.programs);
  for (gles3::Skinner& skinner : game.skinners) on_context_lost(skinner);
}

EMSCRIPTEN_KEEPALIVE int restored() {
  Status status = query_caps(game.gl, game.caps);
  if (status == Status::ok) status = on_context_restored(game.gl, game.caps, game.programs);
  for (gles3::Skinner& skinner : game.skinners)
    if (status == Status::ok) status = on_context_restored(game.gl, game.caps, skinner);
  return static_cast<int>(status);
}
}
