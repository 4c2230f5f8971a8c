// Opens files that an untrusted scene names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cook/gltf/document/findings.h"

namespace marrow::cook::gltf {

// No single input may be larger; far above any scene for a phone, and below what 32-bit offsets can name.
inline constexpr std::uint64_t kLargestFile = 2'147'483'647;

// Reads the first `at_most` bytes of a regular file, and notes in the report that it did. `where` locates the reference
// in a failure's text: "@0" for the scene itself. Directories, devices, pipes and sockets are never opened.
std::vector<std::byte> read_regular_file(const std::string& path, std::uint64_t at_most, const std::string& where,
                                         Report& report);

}  // namespace marrow::cook::gltf
