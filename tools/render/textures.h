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
#include "render/images.h"

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

class Textures {
 public:
  // Decodes and uploads what the meshes of `file`, loaded from `path`, are coloured by and emit. Of WebP, KTX2 and DDS
  // the fallback is shown. An image that cannot be shown is named on stderr, with why, and its meshes are drawn
  // without. `gl` outlives it.
  Textures(const Gl& gl, const std::string& path, const File& file, const ImagePlaces& places);

  const Look& look(std::uint32_t mesh) const { return looks_[mesh]; }

 private:
  void add_emission(const Material& material, bool has_uvs, ImageFinder& finder, Look& look);
  GLuint texture(std::uint32_t image, ImageFinder& finder);
  GLuint sampler(const Texture& texture);
  Pixels pixels(std::uint32_t image, ImageFinder& finder) const;

  const Gl& gl_;
  std::string path_;
  File file_;
  std::map<std::uint32_t, GlTexture> textures_;  // by image; name 0 where there is none
  std::map<std::uint32_t, GlSampler> samplers_;  // by their modes
  std::vector<Look> looks_;                      // by mesh
};

}  // namespace marrow::tools
