// The base colour textures of a cooked file on the GPU.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "marrow/file.h"
#include "render/gl.h"

namespace marrow::tools {

// How a mesh's surface is drawn.
struct Look {
  GLuint texture = 0;  // 0: none
  GLuint sampler = 0;
  AlphaMode alpha = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
};

class Textures {
 public:
  // Decodes and uploads what the meshes of `file`, loaded from `path`, are coloured by. Images by reference are looked
  // for in `folder` and below; one that is not there is named on stderr, and its meshes are drawn without. Throws
  // Failure (invalid: an image is damaged, or its URI leads out of the folder; unsupported: larger than the driver
  // takes). `gl` outlives it.
  Textures(const Gl& gl, const std::string& path, const File& file, const std::string& folder);

  const Look& look(std::uint32_t mesh) const { return looks_[mesh]; }

 private:
  GLuint texture(std::uint32_t image);
  GLuint sampler(const Texture& texture);
  GLuint upload(Span<const std::byte> bytes, std::uint32_t index, const std::string& where);

  const Gl& gl_;
  std::string path_;
  File file_;
  std::string folder_;
  std::map<std::uint32_t, GlTexture> textures_;  // by image; name 0 where there is none
  std::map<std::uint32_t, GlSampler> samplers_;  // by their modes
  std::vector<Look> looks_;                      // by mesh
};

}  // namespace marrow::tools
