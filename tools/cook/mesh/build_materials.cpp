#include "cook/mesh/build_materials.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <string_view>
#include <unordered_map>

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

// Values that are the same() have one.
std::size_t hash_of(const BuiltMaterial& m) {
  const std::string_view textures(reinterpret_cast<const char*>(m.textures.data()),
                                  m.textures.size() * sizeof(Texture));
  return std::hash<std::string_view>()(textures) ^ std::hash<std::string>()(m.name);
}

std::size_t hash_of(const RawImage& image) {
  if (image.bytes.empty()) return std::hash<std::string>()(image.uri);
  return std::hash<std::string_view>()({reinterpret_cast<const char*>(image.bytes.data()), image.bytes.size()});
}

// Values of which each is there once.
template <class T>
class Distinct {
 public:
  explicit Distinct(std::vector<T>& all) : all_(all) {}
  std::size_t number_of(T value) {
    const std::size_t hash = hash_of(value);
    const auto [first, end] = by_hash_.equal_range(hash);
    const auto twin = std::find_if(first, end, [&](const auto& known) { return same(all_[known.second], value); });
    if (twin != end) return twin->second;
    // What is not even the same as itself is never found.
    if (same(value, value)) by_hash_.emplace(hash, all_.size());
    all_.push_back(std::move(value));
    return all_.size() - 1;
  }

 private:
  std::vector<T>& all_;
  std::unordered_multimap<std::size_t, std::size_t> by_hash_;
};

class Shared {
 public:
  Shared(const RawScene& scene, Images images, BuiltLooks& out)
      : scene_(scene),
        images_(images),
        known_materials_(out.materials),
        known_images_(out.images),
        image_of_(scene.images.size(), kNone) {}

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
    return static_cast<std::uint32_t>(known_materials_.number_of(std::move(material)) + 1);
  }

 private:
  int image_of(std::size_t raw_index) {
    if (image_of_[raw_index] != kNone) return image_of_[raw_index];
    RawImage image = scene_.images[raw_index];
    if (image.fallback != kNone) image.fallback = image_of(static_cast<std::size_t>(image.fallback));
    image_of_[raw_index] = static_cast<int>(known_images_.number_of(std::move(image)));
    return image_of_[raw_index];
  }

  const RawScene& scene_;
  Images images_;
  Distinct<BuiltMaterial> known_materials_;
  Distinct<RawImage> known_images_;
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
