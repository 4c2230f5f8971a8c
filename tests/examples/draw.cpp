// Draws an animation with OpenGL ES, and goes on when the context is lost. Of a file that is not packed.
#include <marrow/egl.h>
#include <marrow/gles3_skinner.h>
#include <marrow/marrow.h>

#include <GLES3/gl3.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

namespace gles3 = marrow::gles3;

constexpr int kSide = 128;
constexpr const char* kVertex = R"(
out vec3 normal;
void main() {
  MarrowVertex v = marrow_skin();
  normal = v.normal;
  gl_Position = vec4(v.position.xy - vec2(0.0, 0.7), 0.5 * v.position.z, 1.0);
}
)";
constexpr const char* kFragment = R"(
precision highp float;
in vec3 normal;
out vec4 colour;
void main() { colour = vec4(0.5 + 0.5 * normalize(normal), 1.0); }
)";

// Where a game has a window, here is a texture whose pixels are counted.
struct Window {
  std::optional<marrow::egl::HeadlessContext> context;
  gles3::Api gl;
  gles3::Caps caps;

  bool open() {
    context.reset();
    if (context.emplace().create() != marrow::Status::ok ||
        load_api(gl, marrow::egl::load_proc) != marrow::Status::ok || query_caps(gl, caps) != marrow::Status::ok)
      return false;
    unsigned texture = 0, framebuffer = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    gl.Viewport(0, 0, kSide, kSide);
    return true;
  }
  void clear() { reinterpret_cast<PFNGLCLEARPROC>(marrow::egl::load_proc("glClear"))(GL_COLOR_BUFFER_BIT); }
  int covered() {
    std::vector<unsigned char> rgba(4 * kSide * kSide);
    gl.ReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    int out = 0;
    for (std::size_t i = 3; i < rgba.size(); i += 4) out += rgba[i] != 0;
    return out;
  }
};

// A character, and for each of its meshes a skinner.
struct Actor {
  marrow::Character body;
  std::vector<gles3::Skinner> skinners;
  std::vector<std::vector<std::byte>> memory;

  marrow::Status make(const marrow::File& file, const Window& window, gles3::ProgramSet& programs) {
    const marrow::CharacterOptions options{.layers = 1, .level = 0, .skin = false, .animation_space = false};
    memory.emplace_back(character_bytes(file, options));
    marrow::Status status = make_character(file, options, memory.back(), body);
    for (const marrow::CharacterMesh& m : body.meshes) {
      memory.emplace_back(gles3::skinner_bytes(m.mesh, {}));
      if (status == marrow::Status::ok)
        status = create_skinner(window.gl, window.caps, m.mesh, {}, programs, memory.back(), skinners.emplace_back());
    }
    return status;
  }
  marrow::Status draw(const gles3::Api& gl, const gles3::ProgramSet& programs) {
    marrow::Status status = marrow::Status::ok;
    for (std::size_t i = 0; i < skinners.size() && status == marrow::Status::ok; ++i) {
      const marrow::CharacterMesh& m = body.meshes[i];
      status = pose(skinners[i], 0, body.skeletons[m.mesh.skeleton].pose.model_from_joint, m.weights);
      if (status == marrow::Status::ok) status = update(gl, skinners[i], programs, 1);
      const gles3::Program& program = program_of(skinners[i], programs, 0);
      gl.UseProgram(program.id);
      if (status == marrow::Status::ok) status = gles3::draw(gl, skinners[i], programs, program, 0, 1);
    }
    return status;
  }
};

int main(int argc, char** argv) {
  const char* const path = argc > 1 ? argv[1] : "newt.mrw";
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::perror(path), 1;
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  marrow::File file;
  if (load({reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()}, file) != marrow::Status::ok) return 1;
  std::vector<std::byte> shared(animations_bytes(file, file));
  marrow::Animations animations;
  if (make_animations(file, file, shared, animations) != marrow::Status::ok) return 1;
  const marrow::Animation* const walk = find_animation(animations, "walk");

  Window window;
  gles3::ProgramSet programs;
  programs.roles[0] = {kVertex, kFragment, {}};
  Actor actor;
  if (!window.open() || actor.make(file, window, programs) != marrow::Status::ok) return 1;

  marrow::Playback playback;
  for (int frame = 0; frame < 60; ++frame) {
    if (gles3::context_was_reset(window.gl) || frame == 30) {  // 30: as if it were
      on_context_lost(programs);
      for (gles3::Skinner& skinner : actor.skinners) on_context_lost(skinner);
      if (!window.open() || on_context_restored(window.gl, window.caps, programs) != marrow::Status::ok) return 1;
      for (gles3::Skinner& skinner : actor.skinners)
        if (on_context_restored(window.gl, window.caps, skinner) != marrow::Status::ok) return 1;
    }
    if (advance(playback, walk->duration_s, 1.0f / 60) != marrow::Status::ok ||
        pose_character(actor.body, {{walk, clip_time(playback)}}) != marrow::Status::ok)
      return 1;
    window.clear();
    if (actor.draw(window.gl, programs) != marrow::Status::ok) return 1;
    if (frame % 29 == 0) std::printf("frame %d: %d pixels\n", frame, window.covered());
  }
  for (gles3::Skinner& skinner : actor.skinners) destroy(window.gl, skinner);
  destroy(window.gl, programs);
}
