// Files that an untrusted scene names, read from wherever the cooker's caller has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cook/gltf/document/findings.h"
#include "marrow/cook_host.h"

namespace marrow::cook::gltf {

// The first `at_most` bytes of a file, which the report then notes. `where` locates the reference in a failure's text:
// "@0" for the scene itself.
std::vector<std::byte> read_scene_file(Files& files, const std::string& name, std::uint64_t at_most,
                                       const std::string& where, Report& report);

// The name of the file that `uri` of the scene refers to, see decode_relative_uri(). files: null for a scene in memory,
// which cannot refer to `what`.
std::string name_beside(Files* files, const std::string& scene, const std::string& uri, const char* what,
                        const std::string& where, const Report& report);

}  // namespace marrow::cook::gltf
