#include "render/textures.h"

#include <algorithm>
#include <bit>

namespace marrow::tools {
namespace {

GLint gl_wrap(Wrap wrap) {
  constexpr GLint kModes[] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
  return kModes[static_cast<std::size_t>(wrap)];
}

GLint gl_filter(MagFilter filter) {
  constexpr GLint kModes[] = {GL_LINEAR, GL_NEAREST, GL_LINEAR};
  return kModes[static_cast<std::size_t>(filter)];
}

GLint gl_filter(MinFilter filter) {
  constexpr GLint kModes[] = {GL_LINEAR_MIPMAP_LINEAR,
                              GL_NEAREST,
                              GL_LINEAR,
                              GL_NEAREST_MIPMAP_NEAREST,
                              GL_LINEAR_MIPMAP_NEAREST,
                              GL_NEAREST_MIPMAP_LINEAR,
                              GL_LINEAR_MIPMAP_LINEAR};
  return kModes[static_cast<std::size_t>(filter)];
}

const Texture* texture_of(const Material& material, TextureRole role) {
  for (const Texture& texture : material.textures)
    if (texture.role == role) return &texture;
  return nullptr;
}

// What is not decoded here has another that shows the same, or is tried itself, which says why it cannot be shown.
std::uint32_t shown_image(const File& file, std::uint32_t image) {
  const std::uint32_t fallback = file.image(image).fallback;
  return fallback != kNoImage ? fallback : image;
}

}  // namespace

Textures::Textures(const Gl& gl, const File& file, Images& images) : gl_(gl), file_(file) {
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    const Mesh mesh = file.mesh(i);
    Look& look = looks_.emplace_back();
    if (mesh.material_index == kNoMaterial) continue;
    const Material material = file.material(mesh.material_index);
    look.alpha = material.alpha;
    look.alpha_cutoff = material.alpha_cutoff;
    look.unlit = material.unlit;
    add_emission(material, mesh.geometry.uvs != nullptr, images, look);
    const Texture* const base = texture_of(material, TextureRole::base_colour);
    if (base == nullptr || mesh.geometry.uvs == nullptr) continue;
    look.texture = texture(shown_image(file, base->image), images);
    if (look.texture != 0) look.sampler = sampler(*base);
  }
  gl.check("uploading textures");
}

// As glTF has it an unlit surface emits nothing. Nor does one here whose texture, which says where, cannot be shown.
void Textures::add_emission(const Material& material, bool has_uvs, Images& images, Look& look) {
  const glm::vec3 emissive(material.emissive[0], material.emissive[1], material.emissive[2]);
  if (material.unlit || emissive == glm::vec3(0)) return;
  const Texture* const where = texture_of(material, TextureRole::emissive);
  if (where != nullptr) {
    if (has_uvs) look.emissive_texture = texture(shown_image(file_, where->image), images);
    if (look.emissive_texture == 0) return;
    look.emissive_sampler = sampler(*where);
  }
  look.emissive = emissive;
}

GLuint Textures::texture(std::uint32_t index, Images& images) {
  const auto [at, is_new] = textures_.try_emplace(index);
  if (!is_new) return at->second;
  GLint largest = 0;
  gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const Pixels pixels = images.pixels(index, largest);
  if (pixels.rgba.empty()) return 0;
  GlTexture& texture = at->second = GlTexture(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, texture);
  const auto side = static_cast<unsigned>(std::max(pixels.width, pixels.height));
  const auto levels = static_cast<GLsizei>(std::bit_width(side));
  gl_.TexStorage2D(GL_TEXTURE_2D, levels, GL_SRGB8_ALPHA8, pixels.width, pixels.height);
  // GL's first row is at v = 0, and so is the top row of glTF's images: nothing is turned over.
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, pixels.width, pixels.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.rgba.data());
  gl_.GenerateMipmap(GL_TEXTURE_2D);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

GLuint Textures::sampler(const Texture& t) {
  const std::uint32_t modes = static_cast<std::uint32_t>(t.wrap_u) | static_cast<std::uint32_t>(t.wrap_v) << 8 |
                              static_cast<std::uint32_t>(t.mag) << 16 | static_cast<std::uint32_t>(t.min) << 24;
  const auto known = samplers_.find(modes);
  if (known != samplers_.end()) return known->second;
  GlSampler sampler(gl_);
  gl_.SamplerParameteri(sampler, GL_TEXTURE_WRAP_S, gl_wrap(t.wrap_u));
  gl_.SamplerParameteri(sampler, GL_TEXTURE_WRAP_T, gl_wrap(t.wrap_v));
  gl_.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, gl_filter(t.mag));
  gl_.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, gl_filter(t.min));
  return samplers_.emplace(modes, std::move(sampler)).first->second;
}

}  // namespace marrow::tools
