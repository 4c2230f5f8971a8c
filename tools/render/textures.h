// What colours the surfaces of a cooked file, and what they emit, on the GPU.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "common/decode.h"
#include "marrow/file.h"
#include "render/gl.h"

namespace marrow::tools {

// How a mesh's surface is drawn.
struct Look {
  GLuint texture = 0;  // of the base colour; 0: none
  GLuint sampler = 0;
  glm::vec3 emissive{0};        // linear; times its texture
  GLuint emissive_texture = 0;  // 0: none
  GLuint emissive_sampler = 0;
  AlphaMode alpha = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool unlit = false;

  bool textured() const { return texture != 0 || emissive_texture != 0; }
};

// Where a file's images come from.
class Images {
 public:
  virtual ~Images() = default;
  // The pixels of image `index`, at most `most` each way. Empty: it cannot be shown, and whoever wants to know why has
  // been told.
  virtual Pixels pixels(std::uint32_t index, int most) = 0;
};

class Textures {
 public:
  // Uploads what the meshes of `file` are coloured by and emit. Of WebP, KTX2 and DDS the fallback is shown. Meshes
  // whose image cannot be shown are drawn without. `gl` outlives it, `images` need not.
  Textures(const Gl& gl, const File& file, Images& images);

  const Look& look(std::uint32_t mesh) const { return looks_[mesh]; }

 private:
  void add_emission(const Material& material, bool has_uvs, Images& images, Look& look);
  GLuint texture(std::uint32_t image, Images& images);
  GLuint sampler(const Texture& texture);

  const Gl& gl_;
  File file_;
  std::map<std::uint32_t, GlTexture> textures_;  // by image; name 0 where there is none
  std::map<std::uint32_t, GlSampler> samplers_;  // by their modes
  std::vector<Look> looks_;                      // by mesh
};

}  // namespace marrow::tools
