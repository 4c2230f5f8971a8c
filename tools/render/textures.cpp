#include "render/textures.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "common/decode.h"
#include "common/failure.h"
#include "cook/gltf/document/regular_file.h"
#include "cook/gltf/document/uri.h"

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

const Texture* base_colour(const Material& material) {
  for (const Texture& texture : material.textures)
    if (texture.role == TextureRole::base_colour) return &texture;
  return nullptr;
}

// The bytes of an image by reference; nothing if it is not there.
std::optional<std::vector<std::byte>> read_referenced(const std::string& uri, const std::string& folder,
                                                      const std::string& path, const std::string& where) {
  cook::gltf::Report report(path);
  if (uri.empty()) return std::nullopt;
  const std::string relative = cook::gltf::decode_relative_uri(uri, where, report);
  const std::string found = cook::gltf::resolve_in_folder(folder, relative, where, report);
  std::error_code error;
  if (!std::filesystem::exists(found, error)) return std::nullopt;
  return cook::gltf::read_regular_file(found, cook::gltf::kLargestFile + 1, where, report);
}

}  // namespace

Textures::Textures(const Gl& gl, const std::string& path, const File& file, const std::string& folder)
    : gl_(gl), path_(path), file_(file), folder_(folder) {
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    const Mesh mesh = file.mesh(i);
    Look& look = looks_.emplace_back();
    if (mesh.material_index == kNoMaterial) continue;
    const Material material = file.material(mesh.material_index);
    look.alpha = material.alpha;
    look.alpha_cutoff = material.alpha_cutoff;
    const Texture* const base = base_colour(material);
    if (base == nullptr || mesh.geometry.uvs == nullptr) continue;
    look.texture = texture(base->image);
    if (look.texture != 0) look.sampler = sampler(*base);
  }
  gl.check("uploading textures");
}

GLuint Textures::texture(std::uint32_t index) {
  const auto known = textures_.find(index);
  if (known != textures_.end()) return known->second;
  const marrow::Image image = file_.image(index);
  const std::string where = "image " + std::to_string(index);
  if (!image.bytes.empty()) return upload(image.bytes, index, where);
  const auto bytes = read_referenced(image.uri, folder_, path_, where);
  if (bytes) return upload(*bytes, index, where);
  const std::string uri = printable(image.uri);
  const std::string advice = uri.empty()
                                 ? "it lies inside the source; cook with --images embed"
                                 : "there is no " + uri + " below \"" + folder_ + "\"; say where with --images-from";
  std::fprintf(stderr, "%s: %s: drawn without: %s\n", path_.c_str(), where.c_str(), advice.c_str());
  return textures_.emplace(index, GlTexture()).first->second;
}

GLuint Textures::upload(Span<const std::byte> bytes, std::uint32_t index, const std::string& where) {
  const Pixels pixels = decode_image(bytes, path_, where);
  const int side = std::max(pixels.width, pixels.height);
  GLint largest = 0;
  gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (side > largest)
    throw Failure(Exit::unsupported, path_, where, "larger than this driver's textures",
                  "at most " + std::to_string(largest) + " pixels each way");
  GlTexture texture(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, texture);
  const auto levels = static_cast<GLsizei>(std::bit_width(static_cast<unsigned>(side)));
  gl_.TexStorage2D(GL_TEXTURE_2D, levels, GL_SRGB8_ALPHA8, pixels.width, pixels.height);
  // GL's first row is at v = 0, and so is the top row of glTF's images: nothing is turned over.
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, pixels.width, pixels.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.rgba.data());
  gl_.GenerateMipmap(GL_TEXTURE_2D);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  return textures_.emplace(index, std::move(texture)).first->second;
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
