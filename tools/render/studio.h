// The photographer's studio: lights, ground and backdrop round whatever is put in it → a picture.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

#include "image/image.h"
#include "marrow/gles3_crowd.h"
#include "marrow/gles3_skinner.h"
#include "render/camera.h"
#include "render/gl.h"
#include "render/overlay/strokes.h"
#include "render/textures.h"

namespace marrow::tools {

// One thing to draw: what a skinner has updated, a crowd's first instance, or vertices that the CPU has skinned.
struct Drawable {
  const gles3::Skinner* skinner = nullptr;  // of one character
  const gles3::Crowd* crowd = nullptr;
  const gles3::CrowdMesh* crowd_mesh = nullptr;
  gles3::Deformer crowd_deformer = gles3::Deformer::ssd;
  // Of neither: at the locations of marrow/gles3.h.
  GLuint vertex_array = 0;
  GLuint index_count = 0;
  GLenum index_type = GL_UNSIGNED_SHORT;
  std::uint8_t features = 0;  // what is read of the vertices
  glm::vec4 base_colour{1};   // linear
  Look look;                  // its textures are drawn where `features` has kUvs
  glm::vec3 centre{0};        // model space; blended surfaces are drawn from the farthest on
  bool double_sided = true;   // else its back faces are not drawn
  bool inside_out = false;    // its fronts are clockwise
};

// The texture unit of palettes; morph targets and crowds take the one behind it.
inline constexpr std::uint32_t kPaletteUnit = 4;

struct Shot {
  Camera camera;
  Box box;           // of the character now, model space
  float radius = 1;  // of the character, scene units: what light and shadow are scaled by
  float ground_height = 0;
  float shading = 1;         // 1: lit; 0: colours as they are
  float light_turn_rad = 0;  // how far the lights have walked round the character
};

// The lower left part of a frame buffer, as sRGB.
Image read_pixels(const Gl& gl, GLuint framebuffer, int width, int height);

class Studio {
 public:
  // Pictures of this size, 1 … 8192 each way. Throws Failure (unsupported) if the driver cannot hold one.
  Studio(const Gl& gl, int width, int height);
  // From now on pictures of another size. Throws as the constructor does.
  void resize(int width, int height);
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  // What skinners and crowds that it draws are created with; as long as the studio.
  gles3::ProgramSet& programs() { return programs_; }

  // strokes: drawn last, among the surfaces; null: none.
  Image shoot(const Shot& shot, std::span<const Drawable> drawables, Strokes* strokes = nullptr);

  // The same in two steps: the picture stays on the GPU until the next one is taken.
  void take(const Shot& shot, std::span<const Drawable> drawables, Strokes* strokes = nullptr);
  // Draws it, stretched, into a rectangle of a frame buffer that does not encode sRGB: a window's. x, y: its lower left
  // corner.
  void show(GLuint framebuffer, int x, int y, int width, int height);

 private:
  enum Role : std::uint32_t { kSurface, kDepth };
  struct ShadowMap {
    int size = 0;
    GlTexture depth;
    GlFramebuffer framebuffer;
  };

  const gles3::Program& program(Role role, const Drawable& drawable);
  void make_shadow_map(ShadowMap& map, int size);
  void draw_depth(const ShadowMap& map, const LightView& view, std::span<const Drawable> drawables);
  void draw_backdrop(const Shot& shot);
  void draw_surfaces(const Shot& shot, std::span<const Drawable> drawables);
  void draw_surface(const Shot& shot, const Drawable& drawable, glm::vec2 alpha_range);
  void set_surface(GLuint id, const Drawable& drawable, glm::vec2 alpha_range);
  void bind_texture(GLuint id, const char* name, GLint unit, GLuint texture, GLuint sampler);
  void cull(const Drawable& drawable);
  void cull_nothing();
  void draw(const Drawable& drawable, const gles3::Program& program);
  void set_studio(GLuint id, const Shot& shot);
  void make_white();
  void make_targets();

  const Gl& gl_;
  int width_, height_;
  std::string surface_text_;
  std::vector<char> log_ = std::vector<char>(1024);
  gles3::ProgramSet programs_;
  std::map<std::pair<Role, std::uint8_t>, gles3::Program> plain_;  // of vertices that the CPU has skinned, by features
  gles3::Program backdrop_, show_;
  ShadowMap key_, sky_;
  LightView key_view_, sky_view_;
  GlSampler compare_sampler_, depth_sampler_;
  GlTexture white_;  // where one of a surface's textures is missing
  GlRenderbuffer samples_, samples_depth_;
  GlTexture resolved_;
  GlFramebuffer sampled_framebuffer_, resolved_framebuffer_;
  GlVertexArray no_vertices_;
};

}  // namespace marrow::tools
