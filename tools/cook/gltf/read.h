// Reads artists' glTF. The only stage that knows tinygltf, JSON and Draco input.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"
#include "marrow/cook_host.h"

namespace marrow::cook {

struct ReadOptions {
  bool image_bytes = false;  // also read the images that materials use
  SceneChoice scene = {};
  bool strict = false;  // refuse what would be mended
};

// Reads a .gltf or .glb file and everything that it refers to, images if asked for.
//
// The file is hostile until proven otherwise: container, JSON and every reference are checked before use; what it
// refers to is asked of `files` by Files::beside(); sizes are capped by what the file can hold. What glTF allows but
// Marrow does not carry is listed in `RawScene::warnings`; what is wrong but has one sensible meaning is repaired and
// listed there too.
// Throws tools::Failure (io: cannot be read; invalid: breaks glTF 2.0; unsupported: needs an extension that Marrow
// lacks), located by a JSON pointer or a byte offset; and (usage) where the scene was chosen if there is none such.
RawScene read_gltf(const std::string& name, Files& files, const ReadOptions& options = {});

// The same for a file in memory, which cannot refer to others. `name` is for failures.
RawScene read_gltf(const std::string& name, std::span<const std::byte> bytes, const ReadOptions& options = {});

}  // namespace marrow::cook
