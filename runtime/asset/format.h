// The cooked file byte by byte (docs/format.md), as the loader reads it and the cooker writes it. Little-endian.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "asset/checksum.h"
#include "core/builtins.h"
#include "marrow/file.h"
#include "marrow/version.h"

namespace marrow::format {

static_assert(std::endian::native == std::endian::little, "cooked files are read in place");

inline constexpr std::uint32_t four_characters(const char (&s)[5]) {
  std::uint32_t type = 0;
  for (int i = 3; i >= 0; --i) type = type << 8 | static_cast<std::uint8_t>(s[i]);
  return type;
}

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

// Kinds of sections, by the numbers that packed records have. Every kind but names may occur any number of times.
enum Kind : std::uint32_t {
  kSkeletons,
  kReferences,
  kClips,
  kGeometries,
  kMeshes,
  kMaterials,
  kImages,
  kNodes,
  kNames,
  kLimits,
  kBounds,
  kSprings,
  kExamples,  // laid out in example_format.h
  kKindCount
};
// The order in which they stand in a file.
inline constexpr Kind kOrder[kKindCount] = {kSkeletons, kReferences, kClips, kGeometries, kMeshes,
                                            kMaterials, kImages,     kNodes, kLimits,     kSprings,
                                            kExamples,  kBounds,     kNames};
inline constexpr std::uint32_t kTypes[kKindCount] = {
    four_characters("SKEL"), four_characters("SREF"), four_characters("CLIP"), four_characters("GEOM"),
    four_characters("MESH"), four_characters("MATL"), four_characters("IMAG"), four_characters("NODE"),
    four_characters("NAME"), four_characters("LIMI"), four_characters("BNDS"), four_characters("SPRI"),
    four_characters("SHAP")};

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

struct ReferenceHeader {
  std::uint32_t name;
  std::uint32_t joint_count;
  std::uint64_t hash;  // of joints, see docs/format.md
};
static_assert(sizeof(ReferenceHeader) == 16);

struct ClipHeader {
  std::uint32_t name;
  std::uint32_t skeleton;
  float duration_s;
  std::uint32_t track_count;
  std::uint32_t time_count;
  std::uint32_t value_count;
  std::uint32_t channel_count;
  std::uint16_t additive;          // 1: additive, else 0
  std::uint16_t reference_groups;  // of four joints; 0: the rest pose is the reference
};
static_assert(sizeof(ClipHeader) == 32);

// What a coded clip has behind its ClipHeader.
struct CodedHeader {
  std::uint32_t frame_count;        // 2 … kMaxFrames
  std::uint32_t segment_intervals;  // ≥ 1
  float start_s;                    // of frame 0
  float frames_per_s;               // of uneven ones the mean
  std::uint32_t track_count;        // Σ bits of the masks of moving sub-tracks
  std::uint32_t constant_count;     // Σ bits of the masks of constant ones
  std::uint32_t payload_bytes;      // kPayloadPadding included
  std::uint32_t time_count;         // 0: frames at even steps; else frame_count
};
static_assert(sizeof(CodedHeader) == 32);

// Four numbers a constant sub-track. A rotation's quaternion up to a factor; or x, y, z and the step of those.
struct Constant {
  std::int16_t v[4];
};
static_assert(sizeof(Constant) == 8);

// A segment: u32 bytes of a frame record, a TrackHeader each moving sub-track, then frame records.
#pragma pack(push, 1)
struct TrackHeader {
  std::uint8_t codes[2];  // four bits each, lowest first: shift of the minima, widths of x, y, z (component_bits())
  std::uint8_t step;      // see step_size()
  std::int16_t least[3];  // smallest value of each component, shifted right
};
#pragma pack(pop)
static_assert(sizeof(TrackHeader) == 9);

// So that a frame's number is exact as a float.
inline constexpr std::uint32_t kMaxFrames = 1u << 24;

// A load of 64 bits may reach behind the last record or minimum.
inline constexpr std::uint32_t kPayloadPadding = 8;

// Four steps an octave: the code is the exponent and the first two bits of the mantissa of a float, from 2^-40 on.
inline constexpr std::uint32_t kFirstStep = 87u << 23;
inline constexpr std::uint32_t kStepShift = 21;
inline float step_size(std::uint32_t code) {
  return bit_cast<float>(kFirstStep + (code << kStepShift));
}

// Three components fill at most 57 bits, so one load of 64 at a byte holds a record.
constexpr std::uint32_t component_bits(std::uint32_t code) {
  return code == 15 ? 19 : code;
}

enum GeometryFlags : std::uint32_t {
  kHasNormals = 1,
  kHasTangents = 2,
  kHasUvs = 4,
  kHasColours = 8,
  kHasAsResidual = 16,
  kHasSourceSlots = 32,
  kHasMorphTargets = 64,
  kHasMwe = 128,
  kHasPoseSpace = 256,
  kAllGeometryFlags = 511,
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
  std::uint32_t mwe_root;  // palette entry; 0 without kHasMwe
};
static_assert(sizeof(GeometryHeader) == 64);

// What a geometry with kHasMorphTargets has behind its arrays, on a boundary of four bytes.
struct MorphHeader {
  std::uint32_t target_count;  // ≥ 1
  std::uint32_t block_count;   // Σ over targets
  std::uint32_t record_count;  // Σ over targets of blocks · attributes
  std::uint32_t reserved;      // 0
};
static_assert(sizeof(MorphHeader) == 16);
inline constexpr std::uint64_t kMorphRecordBytes = 24;

// What a geometry with kHasPoseSpace has behind all that, on a boundary of four bytes.
struct PoseSpaceHeader {
  std::uint32_t example_count;  // 1 … kMaxPoseExamples
  std::uint32_t block_count;    // Σ over examples; as many records
  float sigma;                  // kLeastSigma … kMostSigma
  std::uint32_t reserved;       // 0
};
static_assert(sizeof(PoseSpaceHeader) == 16);
inline constexpr float kLeastSigma = 1e-3f, kMostSigma = 1e3f;

enum MeshFlags : std::uint32_t { kDoubleSided = 1, kNextPart = 2, kHelpersHaveCentres = 4, kAllMeshFlags = 7 };

struct MeshHeader {
  std::uint32_t name;
  std::uint32_t material;
  std::uint32_t skeleton;
  std::uint32_t geometry;
  std::uint32_t joint_count;
  std::uint8_t flags;
  std::uint8_t lod_count;
  std::uint16_t helper_count;
  float base_colour[4];
  std::uint32_t target_count;      // the geometry's
  std::uint32_t material_section;  // 0: the material has no section; else 1 + which
};
static_assert(sizeof(MeshHeader) == 48);

// kEmits: behind the textures stand three f32, linear RGB.
enum MaterialFlags : std::uint16_t { kUnlit = 1, kEmits = 2, kAllMaterialFlags = 3 };

struct MaterialHeader {
  std::uint32_t name;
  float alpha_cutoff;
  AlphaMode alpha;
  std::uint8_t texture_count;
  std::uint16_t flags;
};
static_assert(sizeof(MaterialHeader) == 12);

struct ImageHeader {
  std::uint32_t name;
  std::uint32_t uri;
  std::uint32_t byte_count;  // 0: by reference
  ImageFormat format;
  std::uint8_t reserved;   // 0
  std::uint16_t fallback;  // 0: none; else 1 + which IMAG section
};
static_assert(sizeof(ImageHeader) == 16);

struct NodeHeader {
  std::uint32_t name;
  std::uint32_t skeleton;
  std::uint32_t property_count;
  std::uint16_t joint;     // kNoJoint: none
  std::uint16_t reserved;  // 0
  Affine joint_from_node;
};
static_assert(sizeof(NodeHeader) == 64);

struct LimitHeader {
  std::uint32_t skeleton;
  std::uint32_t limit_count;  // ≥ 1
};
static_assert(sizeof(LimitHeader) == 8);

// Of one skeleton; behind it SpringRecords, SpringJoints and SpringColliders.
struct SpringHeader {
  std::uint32_t skeleton;
  std::uint32_t chain_count;  // ≥ 1
  std::uint32_t joint_count;  // of all chains
  std::uint32_t collider_count;
};
static_assert(sizeof(SpringHeader) == 16);

struct SpringRecord {
  std::uint64_t colliders;    // as in SpringChain
  std::uint32_t first_joint;  // joints of the chains before it
  std::uint32_t joint_count;  // ≥ 1
  float tip[3];
  std::uint32_t reserved;  // 0
};
static_assert(sizeof(SpringRecord) == 32);

// How many joints a bone may pass over, so that the way up to the joint before it has a bound.
inline constexpr std::uint32_t kLongestSpringBone = 255;

// Of one skeleton; behind it BoundsCodes, clip by clip, in each mesh by mesh, of those of the skeleton.
struct BoundsHeader {
  std::uint32_t skeleton;
  std::uint32_t clip_count;  // ≥ 1
  std::uint32_t mesh_count;  // ≥ 1
};
static_assert(sizeof(BoundsHeader) == 12);

// What a mesh reaches in a clip: integers times 2^exponent. The sphere is about the box's centre.
struct BoundsCodes {
  std::int8_t exponent;  // kLeastBoundsExponent … kMostBoundsExponent
  std::int8_t box_min[3];
  std::int8_t box_max[3];
  std::uint8_t radius;
};
static_assert(sizeof(BoundsCodes) == 8);
inline constexpr int kLeastBoundsExponent = -100, kMostBoundsExponent = 100;

inline constexpr std::uint64_t align4(std::uint64_t n) {
  return (n + 3) & ~std::uint64_t{3};
}
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

struct ReferenceLayout {
  std::uint64_t names, rest_hashes, parents, bytes;
};
constexpr ReferenceLayout layout(const ReferenceHeader& h) {
  ReferenceLayout l{};
  l.names = sizeof(ReferenceHeader);
  l.rest_hashes = l.names + std::uint64_t{h.joint_count} * 4;
  l.parents = l.rest_hashes + std::uint64_t{h.joint_count} * 4;
  l.bytes = l.parents + std::uint64_t{h.joint_count} * 2;
  return l;
}

struct ClipLayout {
  std::uint64_t reference, tracks, channels, times, values, bytes;
};
constexpr std::uint32_t segment_count(const CodedHeader& h) {
  return (h.frame_count - 2) / h.segment_intervals + 1;
}

// Behind the raw tracks of a coded clip, on a boundary of four bytes.
struct CodedLayout {
  std::uint64_t header, times, offsets, masks, constants, payload, bytes;
};
constexpr CodedLayout layout(const CodedHeader& h, std::uint64_t start, std::uint32_t joint_count) {
  CodedLayout l{};
  l.header = start;
  l.times = l.header + sizeof(CodedHeader);
  l.offsets = l.times + std::uint64_t{h.time_count} * 4;
  l.masks = l.offsets + std::uint64_t{segment_count(h)} * 4;
  l.constants = l.masks + (std::uint64_t{joint_count} + 3) / 4 * sizeof(GroupMasks);
  l.payload = l.constants + std::uint64_t{h.constant_count} * sizeof(Constant);
  l.bytes = l.payload + h.payload_bytes;
  return l;
}

constexpr ClipLayout layout(const ClipHeader& h) {
  ClipLayout l{};
  l.reference = sizeof(ClipHeader);
  l.tracks = l.reference + std::uint64_t{h.reference_groups} * sizeof(SoaTransform);
  l.channels = l.tracks + std::uint64_t{h.track_count} * sizeof(Track);
  l.times = l.channels + std::uint64_t{h.channel_count} * sizeof(Channel);
  l.values = l.times + std::uint64_t{h.time_count} * 4;
  l.bytes = l.values + std::uint64_t{h.value_count} * 4;
  return l;
}

struct GeometryLayout {
  std::uint64_t skin, normals, tangents, as_residual, mwe_residual, uvs, colours, runs, source_slots, sets, indices,
      bytes;
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
  l.mwe_residual = l.as_residual + if_flag(kHasAsResidual, std::uint64_t{h.influence_blocks} * 64);
  l.uvs = l.mwe_residual + if_flag(kHasMwe, std::uint64_t{h.influence_blocks} * 192);
  l.colours = l.uvs + if_flag(kHasUvs, blocks * 32);
  l.runs = l.colours + if_flag(kHasColours, blocks * 16);
  l.source_slots = l.runs + std::uint64_t{h.run_count} * sizeof(Run);
  l.indices = l.source_slots + if_flag(kHasSourceSlots, std::uint64_t{h.source_vertex_count} * 4);
  l.sets = l.indices + std::uint64_t{h.index_count} * l.index_bytes;
  l.bytes = l.sets + std::uint64_t{h.set_count} * 2;
  return l;
}

struct MorphLayout {
  std::uint64_t header, targets, blocks, records, bytes;
};
// Where the header stands, which what lies behind depends on.
constexpr std::uint64_t morph_start(const GeometryLayout& l) {
  return align4(l.bytes);
}
constexpr MorphLayout layout(const MorphHeader& h, const GeometryLayout& geometry) {
  MorphLayout l{};
  l.header = morph_start(geometry);
  l.targets = l.header + sizeof(MorphHeader);
  l.blocks = l.targets + std::uint64_t{h.target_count} * sizeof(MorphTarget);
  l.records = l.blocks + std::uint64_t{h.block_count} * geometry.index_bytes;
  l.bytes = l.records + h.record_count * kMorphRecordBytes;
  return l;
}

// Where the header stands in a whole section, whose own counts are right.
inline std::uint64_t pose_space_start(const std::byte* section) {
  const auto& h = *reinterpret_cast<const GeometryHeader*>(section);
  const GeometryLayout l = layout(h);
  if ((h.flags & kHasMorphTargets) == 0) return align4(l.bytes);
  return align4(layout(*reinterpret_cast<const MorphHeader*>(section + morph_start(l)), l).bytes);
}

struct PoseSpaceLayout {
  std::uint64_t header, examples, rotations, blocks, records, parents, bytes;
};
// before: the end of what stands before it, morph targets or, without those, the arrays.
constexpr PoseSpaceLayout layout(const PoseSpaceHeader& h, const GeometryHeader& g, std::uint64_t before) {
  PoseSpaceLayout l{};
  l.header = align4(before);
  l.examples = l.header + sizeof(PoseSpaceHeader);
  l.rotations = l.examples + std::uint64_t{h.example_count} * sizeof(MorphTarget);
  l.blocks = l.rotations + std::uint64_t{h.example_count} * g.joint_count * 8;
  l.records = l.blocks + std::uint64_t{h.block_count} * layout(g).index_bytes;
  l.parents = l.records + h.block_count * kMorphRecordBytes;
  l.bytes = l.parents + std::uint64_t{g.joint_count} * 2;
  return l;
}

inline constexpr std::uint64_t kCentreBytes = 3 * sizeof(float);
struct MeshLayout {
  std::uint64_t inverse_bind, targets, joints, helpers, centres, lods, bytes;
};
constexpr MeshLayout layout(const MeshHeader& h) {
  MeshLayout l{};
  l.inverse_bind = sizeof(MeshHeader);
  l.targets = l.inverse_bind + std::uint64_t{h.joint_count} * sizeof(Affine);
  l.joints = l.targets + std::uint64_t{h.target_count} * sizeof(MeshTarget);
  l.bytes = l.helpers = l.centres = l.lods = l.joints + std::uint64_t{h.joint_count} * 2;
  if (h.helper_count == 0 && h.lod_count == 0) return l;
  l.helpers = align4(l.helpers);
  l.centres = l.helpers + std::uint64_t{h.helper_count} * sizeof(Helper);
  l.lods = l.centres + ((h.flags & kHelpersHaveCentres) != 0 ? h.helper_count * kCentreBytes : 0);
  l.bytes = l.lods + std::uint64_t{h.lod_count} * sizeof(MeshLod);
  return l;
}

struct MaterialLayout {
  std::uint64_t textures, emissive, bytes;
};
constexpr MaterialLayout layout(const MaterialHeader& h) {
  const std::uint64_t emissive = sizeof h + std::uint64_t{h.texture_count} * sizeof(Texture);
  return {sizeof h, emissive, emissive + ((h.flags & kEmits) != 0 ? 3 * sizeof(float) : 0)};
}

struct BoundsLayout {
  std::uint64_t codes, bytes;
};
constexpr BoundsLayout layout(const BoundsHeader& h) {
  return {sizeof h, sizeof h + std::uint64_t{h.clip_count} * h.mesh_count * sizeof(BoundsCodes)};
}

struct ImageLayout {
  std::uint64_t data, bytes;
};
constexpr ImageLayout layout(const ImageHeader& h) {
  return {sizeof h, sizeof h + std::uint64_t{h.byte_count}};
}

struct NodeLayout {
  std::uint64_t properties, bytes;
};
constexpr NodeLayout layout(const NodeHeader& h) {
  return {sizeof h, sizeof h + std::uint64_t{h.property_count} * sizeof(Property)};
}

struct LimitLayout {
  std::uint64_t limits, bytes;
};
constexpr LimitLayout layout(const LimitHeader& h) {
  return {sizeof h, sizeof h + std::uint64_t{h.limit_count} * sizeof(JointLimit)};
}

struct SpringLayout {
  std::uint64_t chains, joints, colliders, bytes;
};
constexpr SpringLayout layout(const SpringHeader& h) {
  SpringLayout l{};
  l.chains = sizeof h;
  l.joints = l.chains + std::uint64_t{h.chain_count} * sizeof(SpringRecord);
  l.colliders = l.joints + std::uint64_t{h.joint_count} * sizeof(SpringJoint);
  l.bytes = l.colliders + std::uint64_t{h.collider_count} * sizeof(SpringCollider);
  return l;
}

// How many values a track's key has in Clip::values.
constexpr std::uint32_t floats_per_key(TrackPath path, Interpolation interpolation) {
  return (path == TrackPath::rotation ? 4u : 3u) * (interpolation == Interpolation::cubic_spline ? 3u : 1u);
}

constexpr std::uint32_t floats_per_key(Interpolation of_channel) {
  return of_channel == Interpolation::cubic_spline ? 3u : 1u;
}

}  // namespace marrow::format
