// Turns URIs of an untrusted scene into bytes or into relative paths.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cook/gltf/document/findings.h"

namespace marrow::cook::gltf {

bool is_data_uri(std::string_view uri);

struct DataUri {
  std::string mime_type;  // lower case
  std::vector<std::byte> bytes;
};

// RFC 2397, base64 or percent-encoded, strictly: no blanks, no missing padding, no stray bits.
DataUri decode_data_uri(std::string_view uri, const std::string& where, const Report& report);

// The relative path that a URI names, percent-decoded once. Refuses schemes, absolute paths, backslashes, control
// characters and any way up.
std::string decode_relative_uri(std::string_view uri, const std::string& where, const Report& report);

}  // namespace marrow::cook::gltf
