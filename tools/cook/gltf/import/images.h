// The pictures that materials use: by name, or as the bytes of their files.
#pragma once

#include <vector>

#include "cook/gltf/document/json.h"
#include "cook/gltf/import/import.h"
#include "cook/gltf/import/materials.h"
#include "marrow/cook_host.h"

namespace marrow::cook::gltf {

// A hostile URI is refused even if nobody opens it.
void check_image_uris(const Json& root, Report& report);

// The document's images, by its numbering; those that no material uses stay empty. with_bytes: also reads them, which
// must be of a known format; nothing is decoded. `files` as for load_buffers(). `external_bytes` grows by what is read
// from files.
std::vector<RawImage> import_images(const Document& document, const Materials& materials, Files* files, bool with_bytes,
                                    Budget& budget, std::uint64_t& external_bytes, Report& report);

}  // namespace marrow::cook::gltf
