#include "cook/mesh/build_materials.h"

#include <algorithm>
#include <cstring>

#include "text/quantity.h"

namespace marrow::cook {
namespace {

bool same(const Texture& a, const Texture& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

bool same(const BuiltMaterial& a, const BuiltMaterial& b) {
  return a.name == b.name && a.alpha == b.alpha && a.alpha_cutoff == b.alpha_cutoff && a.unlit == b.unlit &&
         a.emissive == b.emissive &&
         std::equal(a.textures.begin(), a.textures.end(), b.textures.begin(), b.textures.end(),
                    [](const Texture& x, const Texture& y) { return same(x, y); });
}

// Embedded ones by their bytes, others by their URIs; without either by themselves.
bool same(const RawImage& a, const RawImage& b) {
  if (!a.bytes.empty() || !b.bytes.empty()) return a.bytes == b.bytes;
  return !a.uri.empty() && a.uri == b.uri;
}

class Shared {
 public:
  Shared(const RawScene& scene, Images images, BuiltLooks& out)
      : scene_(scene), images_(images), out_(out), image_of_(scene.images.size(), kNone) {}

  std::uint32_t section_of(int raw_index) {
    if (raw_index == kNone) return 0;
    const RawMaterial& raw = scene_.materials[static_cast<std::size_t>(raw_index)];
    BuiltMaterial material{raw.name, raw.alpha, raw.alpha_cutoff, raw.unlit, raw.emissive, {}};
    if (images_ != Images::none) {
      material.textures = raw.textures;
      for (Texture& texture : material.textures) texture.image = static_cast<std::uint16_t>(image_of(texture.image));
    }
    const bool is_plain = material.alpha == AlphaMode::opaque && !material.unlit && material.emissive == glm::vec3(0);
    if (is_plain && material.textures.empty()) return 0;
    std::vector<BuiltMaterial>& all = out_.materials;
    const auto twin = std::find_if(all.begin(), all.end(), [&](const auto& m) { return same(m, material); });
    const auto index = static_cast<std::uint32_t>(twin - all.begin());
    if (twin == all.end()) all.push_back(std::move(material));
    return index + 1;
  }

 private:
  int image_of(std::size_t raw_index) {
    if (image_of_[raw_index] != kNone) return image_of_[raw_index];
    RawImage image = scene_.images[raw_index];
    if (image.fallback != kNone) image.fallback = image_of(static_cast<std::size_t>(image.fallback));
    std::vector<RawImage>& all = out_.images;
    const auto twin = std::find_if(all.begin(), all.end(), [&](const auto& i) { return same(i, image); });
    image_of_[raw_index] = static_cast<int>(twin - all.begin());
    if (twin == all.end()) all.push_back(image);
    return image_of_[raw_index];
  }

  const RawScene& scene_;
  Images images_;
  BuiltLooks& out_;
  std::vector<int> image_of_;
};

// What a source holds itself is neither carried nor found by a path.
void note_left_behind(const std::vector<RawImage>& images, Notes& notes) {
  std::size_t count = 0;
  std::uint64_t bytes = 0;
  for (const RawImage& image : images) {
    if (!image.uri.empty() || !image.bytes.empty()) continue;
    ++count;
    bytes += image.inside_bytes;
  }
  if (count == 0) return;
  const std::string what = count == 1 ? "1 image stays" : std::to_string(count) + " images stay";
  notes.warnings.push_back({"/images", "images-by-name",
                            what + " in the source: " + tools::bytes_text(bytes) + "; --images embed takes " +
                                (count == 1 ? "it" : "them") + " along"});
}

}  // namespace

BuiltLooks build_materials(const RawScene& scene, const std::vector<BuiltMesh>& meshes, Images images, Notes& notes) {
  BuiltLooks out;
  Shared shared(scene, images, out);
  for (const BuiltMesh& mesh : meshes) out.sections.push_back(shared.section_of(mesh.raw_material));
  note_left_behind(out.images, notes);
  return out;
}

}  // namespace marrow::cook
