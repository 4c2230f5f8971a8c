#include "render/disk/images.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>

#include "common/decode.h"
#include "common/failure.h"
#include "common/formats.h"
#include "cook/gltf/document/scene_files.h"
#include "cook/gltf/read.h"
#include "disk/disk_files.h"
#include "text/printable.h"
#include "text/words.h"

namespace marrow::tools {

namespace fs = std::filesystem;

ImagePlaces places_beside(const std::string& source) {
  return {fs::path(source).parent_path().string(), source};
}

ImagePlaces places_of(const std::string& path, const std::string& from) {
  if (from.empty() && is_named_source(path)) return places_beside(path);
  std::error_code error;
  if (fs::is_regular_file(from, error)) return places_beside(from);
  ImagePlaces out{from.empty() ? fs::path(path).parent_path().string() : from, ""};
  for (const char* const extension : {".glb", ".gltf"}) {
    const fs::path source = fs::path(out.folder) / fs::path(path).stem().concat(extension);
    if (out.source.empty() && fs::is_regular_file(source, error)) out.source = source.string();
  }
  return out;
}

ImageFinder::ImageFinder(std::string path, const File& file, ImagePlaces places)
    : path_(std::move(path)), file_(file), places_(std::move(places)), read_(file.image_count()) {}

std::string ImageFinder::name_of(std::uint32_t index) const {
  return "image " + std::to_string(index) + " \"" + printable(file_.image(index).name) + '"';
}

Span<const std::byte> ImageFinder::bytes(std::uint32_t index) {
  const marrow::Image image = file_.image(index);
  if (!image.bytes.empty()) return image.bytes;
  return *image.uri != '\0' ? file_bytes(index) : source_bytes(index);
}

Span<const std::byte> ImageFinder::file_bytes(std::uint32_t index) {
  std::vector<std::byte>& out = read_[index];
  const std::string uri = file_.image(index).uri, where = name_of(index);
  cook::gltf::Report report(path_);
  DiskFiles disk;
  const std::string any_there = (fs::path(places_.folder) / "any").string();
  const std::string found = cook::gltf::name_beside(&disk, any_there, uri, "image", where, report);
  std::error_code error;
  if (!fs::exists(found, error))
    throw Failure(Exit::io, path_, where, "no " + printable(uri) + " below \"" + places_.folder + '"',
                  "say where with --images-from");
  if (out.empty()) out = cook::gltf::read_scene_file(disk, found, cook::kMostBytes + 1, where, report);
  return {out.data(), out.size()};
}

Span<const std::byte> ImageFinder::source_bytes(std::uint32_t index) {
  const std::string where = name_of(index), name = file_.image(index).name;
  // Today's cooker gives each a name of its own.
  for (std::uint32_t other = 0; other < file_.image_count(); ++other)
    if (const marrow::Image image = file_.image(other);
        other != index && image.name == name && *image.uri == '\0' && image.bytes.empty())
      throw Failure(Exit::invalid, path_, where, "several images of the file have this name", "cook it anew");
  const std::vector<cook::RawImage>& images = source_images(where);
  const auto found = std::ranges::find_if(
      images, [&](const cook::RawImage& image) { return image.name == name && !image.bytes.empty(); });
  if (found == images.end())
    throw Failure(Exit::invalid, path_, where, places_.source + " has no PNG or JPEG of this name",
                  "give the file's own source with --images-from");
  return {found->bytes.data(), found->bytes.size()};
}

const std::vector<cook::RawImage>& ImageFinder::source_images(const std::string& where) {
  if (source_images_) return *source_images_;
  if (places_.source.empty())
    throw Failure(Exit::io, path_, where, "it lies inside the source, which is not beside the file",
                  "give --images-from SOURCE.glb, or cook with --images embed");
  DiskFiles disk;
  try {
    source_images_ = cook::read_gltf(places_.source, disk, {.image_bytes = true}).images;
  } catch (const Failure& failure) {
    throw Failure(failure.code(), path_, where, "its source cannot be read", failure.what());
  }
  return *source_images_;
}

Pixels FoundImages::decoded(std::uint32_t index, int most) {
  const ImageFormat format = file_.image(index).format;
  if (format > ImageFormat::jpeg)
    throw Failure(Exit::unsupported, path_, finder_.name_of(index),
                  std::string("its format, ") + word(format) + ", is not decoded here",
                  "give its texture a PNG or JPEG as well");
  Pixels out = decode_image(finder_.bytes(index), path_, finder_.name_of(index));
  if (std::max(out.width, out.height) > most)
    throw Failure(Exit::unsupported, path_, finder_.name_of(index), "larger than this driver's textures",
                  "at most " + std::to_string(most) + " pixels each way");
  return out;
}

Pixels FoundImages::pixels(std::uint32_t index, int most) {
  try {
    return decoded(index, most);
  } catch (const Failure& why) {
    std::fprintf(stderr, "%s: %s: drawn without: %s: %s\n", path_.c_str(), finder_.name_of(index).c_str(),
                 why.rule().c_str(), why.advice().c_str());
    return {};
  }
}

}  // namespace marrow::tools
