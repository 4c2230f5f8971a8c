// The photographer's studio: lights, ground and backdrop round whatever is put in it → a picture.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "image/image.h"
#include "marrow/gles3_crowd.h"
#include "render/camera.h"
#include "render/gl.h"
#include "render/textures.h"

namespace marrow::tools {

// One thing to draw: vertices on the GPU, and the palette that skins them if they are not skinned yet.
struct Drawable {
  GLuint vertex_array = 0;
  GLuint index_count = 0;
  GLenum index_type = GL_UNSIGNED_SHORT;
  gles3::ProgramKey program;
  float coordinate_scale = 1;
  std::uint32_t palette_offset = 0;                        // in the palette ring
  const gles3::PaletteTexture* palette_texture = nullptr;  // of programs that read palettes from one
  std::uint32_t first_matrix = 0;                          // in it
  const gles3::Crowd* crowd = nullptr;                     // of programs that read palettes of crowds: instance 0
  const gles3::CrowdMesh* crowd_mesh = nullptr;
  glm::vec4 base_colour{1};  // linear
  // Where the vertex shader morphs; empty otherwise.
  std::vector<float> morph_weights;
  Mesh mesh;
  const gles3::GpuMesh* gpu = nullptr;
  Look look;            // its texture is drawn where the program has kUvs
  glm::vec3 centre{0};  // scene space; blended surfaces are drawn from the farthest on
};

// Of uniform buffers and texture units: what skinning takes; crowds take the unit behind the palettes too.
inline constexpr std::uint32_t kPaletteBinding = 0;
inline constexpr std::uint32_t kMorphUnit = 4;
inline constexpr std::uint32_t kPaletteUnit = 5;

struct Shot {
  Camera camera;
  Box box;           // of the character now, scene space
  float radius = 1;  // of the character, scene units: what light and shadow are scaled by
  float ground_height = 0;
  float shading = 1;         // 1: lit; 0: colours as they are
  float light_turn_rad = 0;  // how far the lights have walked round the character
  const gles3::PaletteRing* palettes = nullptr;
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

  Image shoot(const Shot& shot, std::span<const Drawable> drawables);

  // The same in two steps: the picture stays on the GPU until the next one is taken.
  void take(const Shot& shot, std::span<const Drawable> drawables);
  // Draws it, stretched, into a rectangle of a frame buffer that does not encode sRGB: a window's. x, y: its lower left
  // corner.
  void show(GLuint framebuffer, int x, int y, int width, int height);

 private:
  enum class Role : std::uint8_t { surface, depth };
  struct ShadowMap {
    int size = 0;
    GlTexture depth;
    GlFramebuffer framebuffer;
  };

  const gles3::Program& program(Role role, const gles3::ProgramKey& key);
  void make_shadow_map(ShadowMap& map, int size);
  void draw_depth(const ShadowMap& map, const LightView& view, const Shot& shot, std::span<const Drawable> drawables);
  void draw_backdrop(const Shot& shot);
  void draw_surfaces(const Shot& shot, std::span<const Drawable> drawables);
  void draw_surface(const Shot& shot, const Drawable& drawable, glm::vec2 alpha_range);
  void set_surface(GLuint id, const Drawable& drawable, glm::vec2 alpha_range);
  void draw(const Shot& shot, const Drawable& drawable, const gles3::Program& program);
  void set_studio(GLuint id, const Shot& shot);
  void make_targets();

  const Gl& gl_;
  int width_, height_;
  std::map<std::uint64_t, gles3::Program> programs_;
  gles3::Program backdrop_, show_;
  ShadowMap key_, sky_;
  LightView key_view_, sky_view_;
  GlSampler compare_sampler_, depth_sampler_;
  GlRenderbuffer samples_, samples_depth_;
  GlTexture resolved_;
  GlFramebuffer sampled_framebuffer_, resolved_framebuffer_;
  GlVertexArray no_vertices_;
};

}  // namespace marrow::tools
