// Imports the pictures that materials use, without looking into them.
#include "cook/gltf/import/images.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>

#include "cook/gltf/document/scene_files.h"
#include "cook/gltf/document/uri.h"
#include "text/nearest.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::uint64_t kMostImageBytes = kMostBytes;  // of all that are read from files

struct FormatName {
  ImageFormat format;
  std::string_view mime_type, extension;
};
constexpr FormatName kFormats[] = {
    {ImageFormat::png, "image/png", ".png"},    {ImageFormat::jpeg, "image/jpeg", ".jpg"},
    {ImageFormat::jpeg, "image/jpeg", ".jpeg"}, {ImageFormat::webp, "image/webp", ".webp"},
    {ImageFormat::ktx2, "image/ktx2", ".ktx2"}, {ImageFormat::dds, "image/vnd-ms.dds", ".dds"}};

ImageFormat format_of_bytes(std::span<const std::byte> bytes) {
  const auto has = [&](std::initializer_list<int> signature, std::size_t at = 0) {
    return bytes.size() >= at + signature.size() &&
           std::equal(signature.begin(), signature.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      [](int s, std::byte b) { return s == std::to_integer<int>(b); });
  };
  if (has({0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'})) return ImageFormat::png;
  if (has({0xFF, 0xD8, 0xFF})) return ImageFormat::jpeg;
  if (has({'R', 'I', 'F', 'F'}) && has({'W', 'E', 'B', 'P'}, 8)) return ImageFormat::webp;
  if (has({0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'})) return ImageFormat::ktx2;
  if (has({'D', 'D', 'S', ' '})) return ImageFormat::dds;
  return ImageFormat::unknown;
}

ImageFormat format_of_mime_type(std::string_view mime) {
  for (const FormatName& known : kFormats)
    if (mime == known.mime_type) return known.format;
  return ImageFormat::unknown;
}

ImageFormat format_of_uri(std::string_view uri) {
  std::string extension;
  if (const std::size_t dot = uri.rfind('.'); dot != std::string_view::npos)
    for (const char c : uri.substr(dot)) extension += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const FormatName& known : kFormats)
    if (extension == known.extension) return known.format;
  return ImageFormat::unknown;
}

class ImageImporter {
 public:
  ImageImporter(const Document& document, Files* files, Budget& budget, std::uint64_t& external_bytes, Report& report)
      : document_(document), files_(files), budget_(budget), external_bytes_(external_bytes), report_(report) {}

  RawImage import(std::size_t index, bool with_bytes) {
    const Json& image = document_.looks.at("images")[index];
    const std::string where = pointer("images", index);
    RawImage raw;
    raw.name = clean_name(image.value("name", std::string()), where, report_);
    if (raw.name.empty()) raw.name = "images[" + std::to_string(index) + ']';
    const auto uri = image.find("uri");
    const bool is_file = uri != image.end() && !is_data_uri(uri->get_ref<const std::string&>());
    if (is_file) raw.uri = uri->get<std::string>();
    raw.format = format_of_mime_type(image.value("mimeType", std::string()));
    if (raw.format == ImageFormat::unknown) raw.format = format_of_uri(raw.uri);
    if (!is_file) raw.inside_bytes = inside_bytes(image);
    if (!with_bytes) return raw;
    if (is_file) {
      raw.bytes = file_bytes(raw.uri, under(where, "uri"));
    } else if (uri != image.end()) {
      raw.bytes = decode_data_uri(uri->get_ref<const std::string&>(), under(where, "uri"), report_).bytes;
    } else if (image.contains("bufferView")) {
      raw.bytes = view_bytes(image.at("bufferView").get<std::size_t>(), under(where, "bufferView"));
    } else {
      report_.mend(where, "image-without-data", "it has neither uri nor bufferView");
    }
    check_bytes(image, where, raw);
    return raw;
  }

 private:
  // Without decoding: base64 has four characters for three bytes.
  std::uint64_t inside_bytes(const Json& image) const {
    if (image.contains("bufferView")) return document_.buffers.views[image.at("bufferView").get<std::size_t>()].length;
    const std::string uri = image.value("uri", std::string());
    const std::size_t characters = uri.size() - std::min(uri.size(), uri.find(',') + 1);
    const std::size_t bytes = characters / 4 * 3, padding = uri.ends_with("==") ? 2 : uri.ends_with('=') ? 1 : 0;
    return bytes - std::min(bytes, padding);
  }

  std::vector<std::byte> view_bytes(std::size_t index, const std::string& where) {
    const View& view = document_.buffers.views[index];
    if (!view.present) {
      report_.warn(where, "image-without-data", "the buffer has no bytes");
      return {};
    }
    budget_.take(view.bytes.size(), where, report_);  // many images may share a view
    return {view.bytes.begin(), view.bytes.end()};
  }

  // A file named twice is read and counted twice: it is the sum of what is held.
  std::vector<std::byte> file_bytes(const std::string& uri, const std::string& where) {
    const std::string path = name_beside(files_, report_.file(), uri, "image", where, report_);
    std::vector<std::byte> bytes = read_scene_file(*files_, path, kMostBytes + 1, where, report_);
    image_bytes_ += bytes.size();
    if (image_bytes_ > kMostImageBytes) report_.unsupported(where, "images too large", "2 GiB is the limit");
    external_bytes_ += bytes.size();
    return bytes;
  }

  void check_bytes(const Json& image, const std::string& where, RawImage& raw) {
    if (raw.bytes.empty()) return;
    const ImageFormat format = format_of_bytes(raw.bytes);
    if (format == ImageFormat::unknown) {
      report_.mend(where, "image-format",
                   "no PNG, JPEG, WebP, KTX2 or DDS, so it cannot be embedded; referred to by name");
      raw.bytes.clear();
      return;
    }
    if (image.contains("mimeType") && format != format_of_mime_type(image.at("mimeType").get<std::string>()))
      report_.mend(under(where, "mimeType"), "image-mime-type", "the bytes say otherwise, and are believed");
    raw.format = format;
  }

  const Document& document_;
  Files* files_;
  Budget& budget_;
  std::uint64_t& external_bytes_;
  Report& report_;
  std::uint64_t image_bytes_ = 0;
};

// By its name alone an image inside the source is found again, so no two have the same. Files are found by their URIs.
void number_equal_names(std::vector<RawImage>& images, Report& report) {
  std::set<std::string> all;
  std::map<std::string, std::size_t> last;  // the number of each name's last bearer
  for (const RawImage& image : images) all.insert(image.name);
  std::vector<std::string> renamed;
  for (RawImage& image : images) {
    if (image.name.empty() || !image.uri.empty()) continue;
    const auto [at, is_first] = last.try_emplace(image.name, 1);
    if (is_first) continue;
    while (!all.insert(image.name).second) image.name = at->first + '.' + std::to_string(++at->second);
    renamed.push_back('"' + image.name + '"');
  }
  if (!renamed.empty())
    report.warn("/images", "images-numbered",
                std::to_string(renamed.size()) + " images are called as others are; now " + tools::listed(renamed));
}

}  // namespace

void check_image_uris(const Json& root, Report& report) {
  const auto images = root.find("images");
  if (images == root.end()) return;
  for (std::size_t i = 0; i < images->size(); ++i) {
    const auto uri = (*images)[i].find("uri");
    if (uri == (*images)[i].end()) continue;
    const auto& text = uri->get_ref<const std::string&>();
    if (!is_data_uri(text)) decode_relative_uri(text, pointer("images", i, "uri"), report);
  }
}

std::vector<RawImage> import_images(const Document& document, const Materials& materials, Files* files, bool with_bytes,
                                    Budget& budget, std::uint64_t& external_bytes, Report& report) {
  const auto list = document.looks.find("images");
  std::vector<RawImage> images(list == document.looks.end() ? 0 : list->size());
  std::vector<bool> known(images.size(), false);
  ImageImporter importer(document, files, budget, external_bytes, report);
  const auto import = [&](std::size_t index) {
    if (!known[index]) images[index] = importer.import(index, with_bytes);
    known[index] = true;
  };
  for (const RawMaterial& material : materials.raw)
    for (const Texture& texture : material.textures) import(texture.image);
  for (const auto& [index, alternative] : materials.alternatives) {
    RawImage& image = images[index];
    if (image.format == ImageFormat::unknown) image.format = image.bytes.empty() ? alternative.format : image.format;
    if (alternative.fallback == kNone || image.format <= ImageFormat::jpeg) continue;
    const auto fallback = static_cast<std::size_t>(alternative.fallback);
    import(fallback);
    // Every decoder must know it; so a fallback has none itself.
    if (images[fallback].format <= ImageFormat::jpeg)
      image.fallback = alternative.fallback;
    else
      report.warn(pointer("images", index), "image-fallback",
                  "what should stand in for it is no PNG or JPEG; left out");
  }
  number_equal_names(images, report);
  return images;
}

}  // namespace marrow::cook::gltf
