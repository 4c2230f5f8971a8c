// The cooked file byte by byte (docs/format.md), as the loader reads it and the cooker writes it. Little-endian.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "marrow/file.h"

namespace marrow::format {

static_assert(std::endian::native == std::endian::little, "cooked files are read in place");

inline constexpr std::uint32_t four_characters(const char (&s)[5]) {
  std::uint32_t type = 0;
  for (int i = 3; i >= 0; --i) type = type << 8 | static_cast<std::uint8_t>(s[i]);
  return type;
}

inline constexpr std::uint32_t kMagic = four_characters("MRRW");
inline constexpr std::uint32_t kVersion = 1;
inline constexpr std::uint32_t kCodecRaw = 0;

// Kinds of sections in the order in which they stand in a file. Every kind but names may occur any number of times.
enum Kind : std::uint32_t { kSkeletons, kClips, kGeometries, kMeshes, kNames, kKindCount };
inline constexpr std::uint32_t kTypes[kKindCount] = {four_characters("SKEL"), four_characters("CLIP"),
                                                     four_characters("GEOM"), four_characters("MESH"),
                                                     four_characters("NAME")};

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

struct SkeletonHeader {
  std::uint32_t name;
  std::uint32_t joint_count;
  std::uint32_t root_count;
  std::uint32_t reserved;  // 0
};
static_assert(sizeof(SkeletonHeader) == 16);

struct ClipHeader {
  std::uint32_t name;
  std::uint32_t skeleton;
  float duration_s;
  std::uint32_t track_count;
  std::uint32_t time_count;
  std::uint32_t value_count;
  std::uint32_t reserved[2];  // 0
};
static_assert(sizeof(ClipHeader) == 32);

enum GeometryFlags : std::uint32_t {
  kHasNormals = 1,
  kHasTangents = 2,
  kHasUvs = 4,
  kHasColours = 8,
  kHasAsResidual = 16,
  kHasSourceSlots = 32,
  kAllGeometryFlags = 63,
};

struct GeometryHeader {
  std::uint32_t flags;
  std::uint32_t vertex_count;
  std::uint32_t block_count;       // slots are four times as many
  std::uint32_t influence_blocks;  // Σ over runs of blocks · influences
  std::uint32_t run_count;
  std::uint32_t set_count;  // Σ over runs of influences
  std::uint32_t joint_count;
  std::uint32_t index_count;
  std::uint32_t source_vertex_count;  // 0 without kHasSourceSlots
  float box_min[3];
  float box_max[3];
  std::uint32_t reserved;  // 0
};
static_assert(sizeof(GeometryHeader) == 64);

enum MeshFlags : std::uint32_t { kDoubleSided = 1, kAllMeshFlags = 1 };

struct MeshHeader {
  std::uint32_t name;
  std::uint32_t material;
  std::uint32_t skeleton;
  std::uint32_t geometry;
  std::uint32_t joint_count;
  std::uint32_t flags;
  float base_colour[4];
  std::uint32_t reserved[2];  // 0
};
static_assert(sizeof(MeshHeader) == 48);

inline constexpr std::uint64_t align16(std::uint64_t n) {
  return (n + 15) & ~std::uint64_t{15};
}

// Offsets of a section's arrays from its start, and its size. Sums of products of 32-bit counts: no overflow in 64
// bits.
struct SkeletonLayout {
  std::uint64_t roots, rest, names, parents, bytes;
};
constexpr SkeletonLayout layout(const SkeletonHeader& h) {
  SkeletonLayout l{};
  l.roots = sizeof(SkeletonHeader);
  l.rest = l.roots + std::uint64_t{h.root_count} * sizeof(Affine);
  l.names = l.rest + (std::uint64_t{h.joint_count} + 3) / 4 * sizeof(SoaTransform);
  l.parents = l.names + std::uint64_t{h.joint_count} * 4;
  l.bytes = l.parents + std::uint64_t{h.joint_count} * 2;
  return l;
}

struct ClipLayout {
  std::uint64_t tracks, times, values, bytes;
};
constexpr ClipLayout layout(const ClipHeader& h) {
  ClipLayout l{};
  l.tracks = sizeof(ClipHeader);
  l.times = l.tracks + std::uint64_t{h.track_count} * sizeof(Track);
  l.values = l.times + std::uint64_t{h.time_count} * 4;
  l.bytes = l.values + std::uint64_t{h.value_count} * 4;
  return l;
}

struct GeometryLayout {
  std::uint64_t skin, normals, tangents, as_residual, uvs, colours, runs, source_slots, sets, indices, bytes;
  std::uint32_t index_bytes;
};
constexpr GeometryLayout layout(const GeometryHeader& h) {
  const std::uint64_t blocks = h.block_count;
  const auto if_flag = [&](std::uint32_t flag, std::uint64_t bytes) { return (h.flags & flag) != 0 ? bytes : 0; };
  GeometryLayout l{};
  l.index_bytes = blocks * 4 <= 65536 ? 2 : 4;
  l.skin = sizeof(GeometryHeader);
  l.normals = l.skin + (blocks * 3 + h.influence_blocks - blocks) * 16;
  l.tangents = l.normals + if_flag(kHasNormals, blocks * 48);
  l.as_residual = l.tangents + if_flag(kHasTangents, blocks * 64);
  l.uvs = l.as_residual + if_flag(kHasAsResidual, std::uint64_t{h.influence_blocks} * 64);
  l.colours = l.uvs + if_flag(kHasUvs, blocks * 32);
  l.runs = l.colours + if_flag(kHasColours, blocks * 16);
  l.source_slots = l.runs + std::uint64_t{h.run_count} * sizeof(Run);
  l.indices = l.source_slots + if_flag(kHasSourceSlots, std::uint64_t{h.source_vertex_count} * 4);
  l.sets = l.indices + std::uint64_t{h.index_count} * l.index_bytes;
  l.bytes = l.sets + std::uint64_t{h.set_count} * 2;
  return l;
}

struct MeshLayout {
  std::uint64_t inverse_bind, joints, bytes;
};
constexpr MeshLayout layout(const MeshHeader& h) {
  MeshLayout l{};
  l.inverse_bind = sizeof(MeshHeader);
  l.joints = l.inverse_bind + std::uint64_t{h.joint_count} * sizeof(Affine);
  l.bytes = l.joints + std::uint64_t{h.joint_count} * 2;
  return l;
}

// How many values a track's key has in Clip::values.
constexpr std::uint32_t floats_per_key(Path path, Interpolation interpolation) {
  return (path == Path::rotation ? 4u : 3u) * (interpolation == Interpolation::cubic_spline ? 3u : 1u);
}

// Finds damage, not malice. Four independent lanes of 64-bit multiply and rotate; `bytes` may be any number.
std::uint64_t checksum(const std::byte* data, std::size_t bytes);

}  // namespace marrow::format
