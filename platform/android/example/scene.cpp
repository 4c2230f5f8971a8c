#include "scene.h"

#include <EGL/egl.h>
#include <GLES3/gl3.h>

namespace gles3 = marrow::gles3;
using marrow::Status;

namespace {

constexpr const char* kCharacter = "newt.mrw";
constexpr const char* kRamp = "ramp.rgb";

constexpr const char* kVertex = R"(
uniform mat4 clip_from_model;
out vec3 normal;
out vec3 colour;
void main() {
  MarrowVertex v = marrow_skin();
  normal = v.normal;
#if MARROW_COLOUR
  colour = in_colour.rgb;
#else
  colour = vec3(1.0);
#endif
  gl_Position = clip_from_model * vec4(v.position, 1.0);
}
)";
// Light from the upper left, through the ramp.
constexpr const char* kFragment = R"(
precision mediump float;
uniform vec3 base_colour;  // linear
uniform sampler2D ramp;
in vec3 normal;
in vec3 colour;
out vec4 frag_colour;
void main() {
  float facing = 0.5 + 0.5 * dot(normalize(normal), vec3(-0.48, 0.6, 0.64));
  frag_colour = vec4(pow(base_colour * colour, vec3(1.0 / 2.2)) * texture(ramp, vec2(facing, 0.5)).rgb, 1.0);
}
)";

void* load_proc(const char* name) {
  return reinterpret_cast<void*>(eglGetProcAddress(name));
}

bool check(Status status, const char* what) {
  if (status != Status::ok) LOG_ERROR("%s: %s: %s", kCharacter, what, marrow::to_string(status));
  return status == Status::ok;
}

// A camera in front and a little to the side, 2.8 m from a point 0.62 m above the ground; columns after each other.
void view(float aspect, float (&m)[16]) {
  constexpr float kCos = 0.8253356f, kSin = 0.5646425f;  // of 0.6 rad to its left
  constexpr float kTall = 3.2f, kDistance = 2.8f, kHeight = 0.62f, kNear = 0.5f, kFar = 20;
  constexpr float kDepth = (kFar + kNear) / (kFar - kNear), kShift = 2 * kFar * kNear / (kFar - kNear);
  // A window taller than wide sees as much from side to side.
  const float x = aspect < 1 ? kTall : kTall / aspect, y = aspect < 1 ? kTall * aspect : kTall;
  const float columns[16] = {x * kCos,
                             0,
                             -kDepth * kSin,
                             -kSin,  // right is (cos, 0, -sin), back (sin, 0, cos)
                             0,
                             y,
                             0,
                             0,  //
                             -x * kSin,
                             0,
                             -kDepth * kCos,
                             -kCos,  //
                             0,
                             -y * kHeight,
                             kDepth * kDistance - kShift,
                             kDistance};
  for (int i = 0; i < 16; ++i) m[i] = columns[i];
}

}  // namespace

bool Scene::load(AAssetManager* manager) {
  marrow::DataError error;
  marrow::File file;
  const marrow::Span<const std::byte> bytes = open_cooked_file(manager, kCharacter, file_, memory_);
  if (bytes.empty()) return false;
  if (marrow::load(bytes, file, &error) != Status::ok) {
    LOG_ERROR("%s: byte %u: %s; cook it again", kCharacter, static_cast<unsigned>(error.offset), error.rule);
    return false;
  }
  const marrow::CharacterOptions options{.layers = 1, .level = 0, .skin = false, .animation_space = false};
  if (!check(make_animations(file, file, memory_.take(animations_bytes(file, file)), animations_), "its clips") ||
      !check(make_character(file, options, memory_.take(character_bytes(file, options)), body_), "its skeleton"))
    return false;
  walk_ = find_animation(animations_, "walk");
  if (walk_ == nullptr) LOG_ERROR("%s: has no clip \"walk\"; `marrow info` says which it has", kCharacter);
  if (body_.meshes.size > kMostMeshes) LOG_ERROR("%s: has more than %d meshes", kCharacter, int{kMostMeshes});
  ramp_bytes_ = ramp_.open(manager, kRamp);
  if (!ramp_bytes_.empty() && ramp_bytes_.size != 3 * kRampTexels)
    LOG_ERROR("%s: has %u bytes and not %d, three a texel", kRamp, static_cast<unsigned>(ramp_bytes_.size),
              3 * kRampTexels);
  if (ramp_bytes_.size != 3 * kRampTexels) {
    LOG_WARN("%s: drawn without, so all light is even", kRamp);
    ramp_bytes_ = {};
  }
  return walk_ != nullptr && body_.meshes.size <= kMostMeshes;
}

bool Scene::restore() {
  const char* missing = nullptr;
  if (load_api(gl_, load_proc, &missing) != Status::ok) {
    LOG_ERROR("OpenGL ES: the driver has no gl%s; it is older than OpenGL ES 3.0", missing == nullptr ? "" : missing);
    return false;
  }
  if (!check(query_caps(gl_, caps_), "OpenGL ES 3.0")) return false;
  LOG_INFO("OpenGL ES: %s", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  programs_.roles[0] = {kVertex, kFragment, {}};
  programs_.log = driver_log_;
  make_ramp();
  glClearColor(0.80f, 0.84f, 0.88f, 1);
  glEnable(GL_DEPTH_TEST);
  if (has_skinners_) {
    if (!check(on_context_restored(gl_, caps_, programs_), "programs")) return false;
    for (std::size_t i = 0; i < body_.meshes.size; ++i)
      if (!check(on_context_restored(gl_, caps_, skinners_[i]), body_.meshes[i].mesh.name)) return false;
    return true;
  }
  return make_skinners();
}

bool Scene::make_skinners() {
  for (std::size_t i = 0; i < body_.meshes.size; ++i) {
    const marrow::Mesh& mesh = body_.meshes[i].mesh;
    const marrow::Span<std::byte> memory = memory_.take(gles3::skinner_bytes(mesh, {}));
    if (check(create_skinner(gl_, caps_, mesh, {}, programs_, memory, skinners_[i]), mesh.name)) continue;
    LOG_ERROR("the driver says: %s", driver_log_);
    return false;
  }
  has_skinners_ = true;
  return true;
}

void Scene::make_ramp() {
  constexpr unsigned char kEven[3] = {255, 255, 255};
  const bool is_there = !ramp_bytes_.empty();
  glGenTextures(1, &ramp_texture_);
  glBindTexture(GL_TEXTURE_2D, ramp_texture_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, is_there ? kRampTexels : 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE,
               is_there ? static_cast<const void*>(ramp_bytes_.data) : kEven);
}

void Scene::lose() {
  if (!has_skinners_) return;
  on_context_lost(programs_);
  for (std::size_t i = 0; i < body_.meshes.size; ++i) on_context_lost(skinners_[i]);
}

bool Scene::advance(float dt_s) {
  return check(marrow::advance(playback_, walk_->duration_s, dt_s), "the time") &&
         check(pose_character(body_, {{walk_, clip_time(playback_)}}), "its pose");
}

void Scene::draw_mesh(std::size_t index, const float (&clip_from_model)[16]) {
  const marrow::CharacterMesh& m = body_.meshes[index];
  const gles3::Program& program = program_of(skinners_[index], programs_, 0);
  glUseProgram(program.id);
  glUniformMatrix4fv(glGetUniformLocation(program.id, "clip_from_model"), 1, GL_FALSE, clip_from_model);
  glUniform3fv(glGetUniformLocation(program.id, "base_colour"), 1, m.mesh.base_colour);
  glUniform1i(glGetUniformLocation(program.id, "ramp"), 1);
  check(gles3::draw(gl_, skinners_[index], programs_, program, 0, 1), m.mesh.name);
}

bool Scene::draw(int width, int height) {
  float clip_from_model[16];
  view(static_cast<float>(width) / static_cast<float>(height), clip_from_model);
  glViewport(0, 0, width, height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glActiveTexture(GL_TEXTURE1);  // Marrow takes unit 0
  glBindTexture(GL_TEXTURE_2D, ramp_texture_);
  for (std::size_t i = 0; i < body_.meshes.size; ++i) {
    const marrow::CharacterMesh& m = body_.meshes[i];
    if (!check(pose(skinners_[i], 0, body_.skeletons[m.mesh.skeleton].pose.model_from_joint, m.weights), m.mesh.name) ||
        !check(update(gl_, skinners_[i], programs_, 1), m.mesh.name))
      return false;
    draw_mesh(i, clip_from_model);
  }
  return !gles3::context_was_reset(gl_);
}
