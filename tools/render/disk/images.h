// Where the images of a cooked file are: in it, beside it, or inside the source that it was cooked from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cook/scene/raw.h"
#include "marrow/file.h"
#include "render/textures.h"

namespace marrow::tools {

struct ImagePlaces {
  std::string folder;  // here and below lie images that are files of their own
  std::string source;  // a glTF file, whose images the cooked file may know by name alone; empty: none
};

// Those of a source that is about to be cooked, or just was.
ImagePlaces places_beside(const std::string& source);

// Those of what a command opens: of a cooked file its folder, and a glTF file of the same name in it; or of a model.
// from: a folder instead of the file's, or the source; empty: neither.
ImagePlaces places_of(const std::string& path, const std::string& from);

class ImageFinder {
 public:
  // Of `file`, loaded from `path`, a view that outlives it.
  ImageFinder(std::string path, const File& file, ImagePlaces places);

  // The PNG or JPEG file that image `index` is, valid as long as the finder. Throws Failure, whose rule and advice say
  // why there is none. The source is read once, when an image may lie inside it.
  Span<const std::byte> bytes(std::uint32_t index);

  // "image 3 "skin"", for messages.
  std::string name_of(std::uint32_t index) const;

 private:
  Span<const std::byte> file_bytes(std::uint32_t index);
  Span<const std::byte> source_bytes(std::uint32_t index);
  const std::vector<cook::RawImage>& source_images(const std::string& where);

  std::string path_;
  File file_;
  ImagePlaces places_;
  std::optional<std::vector<cook::RawImage>> source_images_;
  std::vector<std::vector<std::byte>> read_;  // by image
};

// Decodes what an ImageFinder finds. What cannot be shown is named on stderr, with why.
class FoundImages : public Images {
 public:
  // Of `file`, loaded from `path`, a view that outlives it.
  FoundImages(std::string path, const File& file, ImagePlaces places)
      : path_(path), file_(file), finder_(std::move(path), file, std::move(places)) {}
  Pixels pixels(std::uint32_t index, int most) override;

 private:
  Pixels decoded(std::uint32_t index, int most);

  std::string path_;
  File file_;
  ImageFinder finder_;
};

}  // namespace marrow::tools
