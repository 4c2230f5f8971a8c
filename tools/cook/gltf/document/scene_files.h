// What an untrusted scene names by URIs: bytes in the URI itself, or files, read from wherever the cooker's caller has
// them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cook/gltf/document/findings.h"
#include "marrow/cook_host.h"

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

// The first `at_most` bytes of a file, which the report then notes. `where` locates the reference in a failure's text:
// "@0" for the scene itself.
std::vector<std::byte> read_scene_file(Files& files, const std::string& name, std::uint64_t at_most,
                                       const std::string& where, Report& report);

// The name of the file that `uri` of the scene refers to, see decode_relative_uri(). files: null for a scene in memory,
// which cannot refer to `what`.
std::string name_beside(Files* files, const std::string& scene, const std::string& uri, const char* what,
                        const std::string& where, const Report& report);

}  // namespace marrow::cook::gltf
