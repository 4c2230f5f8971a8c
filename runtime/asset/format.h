// The cooked file byte by byte (docs/format.md), as the loader reads it and the cooker writes it. Little-endian. What
// stands in a section, sections/*.h say.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "asset/checksum.h"
#include "asset/sections/clip_motion_section.h"
#include "asset/sections/clip_section.h"
#include "asset/sections/geometry_section.h"
#include "asset/sections/kind.h"
#include "asset/sections/look_section.h"
#include "asset/sections/mesh_section.h"
#include "asset/sections/motion_section.h"
#include "asset/sections/node_section.h"
#include "asset/sections/pose_map_section.h"
#include "asset/sections/role_section.h"
#include "asset/sections/skeleton_section.h"
#include "marrow/file.h"
#include "marrow/version.h"

namespace marrow::format {

static_assert(std::endian::native == std::endian::little, "cooked files are read in place");

inline constexpr std::uint32_t kMagic = four_characters("MRRW");
inline constexpr std::uint32_t kPackedMagic = four_characters("MRRP");  // for unpack(), see unpack/packed.h
inline constexpr std::uint32_t kVersion = kFileFormat;
// The largest number of a matrix, a place or a scale, in metres where it has a unit: the product of three such matrices
// (what is above a root, a joint, its inverse bind) is finite, with room for a scene's places.
inline constexpr float kFarthest = 1e12f;
// Bytes of a name, without its zero. The cooker cuts names at 1024, and may put something behind them.
inline constexpr std::uint32_t kLongestName = 2047;
inline constexpr std::uint32_t kCodecRaw = 0;
inline constexpr std::uint32_t kCodecSegments = 1;  // clips only

struct Header {
  std::uint32_t magic;
  std::uint32_t version;
  std::uint32_t file_bytes;
  std::uint32_t section_count;
  std::uint64_t checksum;  // of everything behind the header
  std::uint64_t reserved;  // 0
};
static_assert(sizeof(Header) == 32);
static_assert(sizeof(File::Section) == 16);

}  // namespace marrow::format
