// The packed file (docs/format.md), as unpack() reads it and the cooker writes it. Little-endian.
#pragma once

#include <cstdint>

#include "asset/format.h"

namespace marrow::packed {

inline constexpr std::uint32_t kMagic = format::kPackedMagic;
inline constexpr std::uint32_t kVersion = kPackedFormat;

struct Header {
  std::uint32_t magic;
  std::uint32_t version;
  std::uint32_t packed_bytes;
  std::uint32_t file_bytes;
  std::uint32_t memory_bytes;
  std::uint32_t record_count;
  std::uint64_t checksum;  // of everything behind the header
};
static_assert(sizeof(Header) == 32);

// A record's kind is the section's: numbers that no later version may change.
static_assert(format::kSkeletons == 0 && format::kNodes == 7 && format::kNames == 8 && format::kLimits == 9 &&
              format::kBounds == 10 && format::kSprings == 11 && format::kExamples == 12 && format::kRoles == 13 &&
              format::kMotions == 14 && format::kPoseMaps == 15 && format::kGraphs == 16);

// How a record stands for its section. Below kFirstCodec: the section's own bytes and codec.
enum Codec : std::uint8_t { kFirstCodec = 16, kDraco = 16, kMeshopt = 17, kCompact = 18 };

// A joint of a compact SKEL: what follows its flags, and in the highest bits its number of children.
enum JointFlags : std::uint32_t {
  kJointTranslates = 1,  // 1, 2, 4: along x, y, z
  kJointRotates = 8,
  kJointScales = 16,
  kJointNameIsOld = 32,
};
inline constexpr std::uint32_t kJointChildrenShift = 6, kJointManyChildren = 3;

// Of a compact MESH.
enum PackedMeshFlags : std::uint32_t {
  kMeshIsDoubleSided = 1,
  kMeshHasColour = 2,
  kMeshHasPlace = 4,    // model_from_mesh is not the identity
  kMeshGivesBinds = 8,  // not all inverse binds follow from the rest pose
  kMeshHasHelpers = 16,
  kMeshHasLods = 32,
  kMeshIsNextPart = 64,
  kMeshSharesAreBytes = 128,  // those of helpers, in 256ths; else f32
  kMeshHasCentres = 256,      // of helpers
  kAllPackedMeshFlags = 511,
};

// Of a compact CLIP.
enum PackedClipFlags : std::uint32_t {
  kClipIsCoded = 1,
  kClipIsAdditive = 2,
  kClipHasLists = 4,     // of tracks, channels, times, values, or a reference
  kClipStartsLater = 8,  // start_s is not 0
  kClipIsUneven = 16,
  kClipGivesDuration = 32,  // duration_s is given: it is not n / rate for a whole number n
  kClipGivesMean = 64,      // frames_per_s does not follow from the duration
  kAllClipFlags = 127,
};

// A flag of a compressed GEOM, beside GEOM's own flags: the residual is not among the codec's streams.
inline constexpr std::uint32_t kResidualIsApart = 4096;

inline constexpr std::uint32_t kMaxDirectionBits = 16;
inline constexpr std::uint32_t kMaxWeightBits = 16;
inline constexpr std::uint32_t kMaxTargetBits = 16;
inline constexpr std::uint32_t kMaxValueBits = 24;  // exact as floats

}  // namespace marrow::packed
