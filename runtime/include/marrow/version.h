// Which Marrow this is, and which files it reads. CMakeLists.txt reads the numbers from here; docs/versions.md says
// what they promise.
#pragma once

#include <cstdint>

// The release: MAJOR.MINOR.PATCH.
#define MARROW_VERSION_MAJOR 0
#define MARROW_VERSION_MINOR 1
#define MARROW_VERSION_PATCH 0

// The versions of the cooked file and of the packed one: load() and unpack() take these and no others.
#define MARROW_FILE_FORMAT 1
#define MARROW_PACKED_FORMAT 3

namespace marrow {

// One number that grows with each release: of 1.2.3 it is 10203.
inline constexpr std::uint32_t kVersion =
    10000 * MARROW_VERSION_MAJOR + 100 * MARROW_VERSION_MINOR + MARROW_VERSION_PATCH;
// The versions of files, as constants.
inline constexpr std::uint32_t kFileFormat = MARROW_FILE_FORMAT;
inline constexpr std::uint32_t kPackedFormat = MARROW_PACKED_FORMAT;

}  // namespace marrow
