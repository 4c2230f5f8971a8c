// GEOM: triangles and vertices in slots, four to a block; behind them morph targets and pose-space deformation.
#pragma once

#include "asset/sections/fields.h"
#include "marrow/file.h"

namespace marrow::format {

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
  std::uint32_t block_count;
  std::uint32_t influence_blocks;
  std::uint32_t run_count;
  std::uint32_t set_count;
  std::uint32_t joint_count;
  std::uint32_t index_count;
  std::uint32_t source_vertex_count;
  float box_min[3];
  float box_max[3];
  std::uint32_t mwe_root;
};
static_assert(sizeof(GeometryHeader) == 64);

// Of an index, and of a block's number: 4 where there are too many slots for 2.
constexpr std::uint32_t index_bytes(const GeometryHeader& h) {
  return std::uint64_t{h.block_count} * 4 <= 65536 ? 2 : 4;
}

struct GeometryLayout {
  Array<float> skin, normals, tangents, as_residual, mwe_residual, uvs;
  Array<std::uint8_t> colours;
  Array<Run> runs;
  Array<std::uint32_t> source_slots;
  Array<std::byte> indices;  // index_bytes each
  Array<std::uint16_t> sets;
  std::uint64_t bytes;
  std::uint32_t index_bytes;
};
template <>
struct LayoutOf<GeometryHeader> {
  using Type = GeometryLayout;
};

template <class V>
constexpr void fields(V& v, const GeometryHeader& h, GeometryLayout& l) {
  const std::uint64_t blocks = h.block_count, influence_blocks = h.influence_blocks;
  const auto if_flag = [&](std::uint32_t flag, std::uint64_t count) { return (h.flags & flag) != 0 ? count : 0; };
  l.index_bytes = index_bytes(h);
  v.flags({"flags",
           "1 normals, 2 tangents, 4 UVs, 8 colours, 16 animation-space residual, 32 source slots, 64 morph targets, "
           "128 multi-weight residual, 256 pose space"},
          h.flags, kAllGeometryFlags, "unknown flag");
  v.any({"vertex_count", "Σ over runs of vertex_count"}, h.vertex_count);
  v.range({"block_count", "Σ over runs of ⌈vertex_count / 4⌉; < 2³⁰"}, h.block_count, 0u, 0x3FFFFFFFu,
          "too many vertices");
  v.any({"influence_blocks", "Σ over runs of ⌈vertex_count / 4⌉ × influences"}, h.influence_blocks);
  v.any({"run_count"}, h.run_count);
  v.any({"set_count", "Σ over runs of influences"}, h.set_count);
  v.range({"joint_count", "palette entries, 1 … 32767"}, h.joint_count, 1u, kMaxJoints, "1 to 32767 palette entries");
  v.any({"index_count", "a multiple of 3"}, h.index_count);
  v.any({"source_vertex_count", "0 without flag 32"}, h.source_vertex_count);
  v.finite({"box_min", "of the bind positions"}, h.box_min);
  v.finite({"box_max"}, h.box_max);
  v.any({"mwe_root", "a palette entry below joint_count; 0 without flag 128"}, h.mwe_root);
  // Every block has an influence; the last weight of each vertex is not stored.
  v.array({"skin", "a block: x[4] y[4] z[4], then influences − 1 times w[4]; the last weight is 1 − Σ",
           "4 × (2 block_count + influence_blocks)"},
          l.skin, (blocks * 3 + influence_blocks - blocks) * 4, Floats::finite);
  v.array({"normals", "flag 1; a block: x[4] y[4] z[4]", "12 × block_count"}, l.normals,
          if_flag(kHasNormals, blocks * 12), Floats::finite);
  v.array({"tangents", "flag 2; a block: x[4] y[4] z[4] sign[4]", "16 × block_count"}, l.tangents,
          if_flag(kHasTangents, blocks * 16), Floats::finite);
  v.array({"residual", "flag 16; a block: influences times dx[4] dy[4] dz[4] dw[4]", "16 × influence_blocks"},
          l.as_residual, if_flag(kHasAsResidual, influence_blocks * 16), Floats::finite);
  v.array({"multi-weight residual", "flag 128; a block: influences times three rows x[4] y[4] z[4] t[4]",
           "48 × influence_blocks"},
          l.mwe_residual, if_flag(kHasMwe, influence_blocks * 48), Floats::finite);
  v.array({"UVs", "flag 4; a slot: u v", "8 × block_count"}, l.uvs, if_flag(kHasUvs, blocks * 8), Floats::finite);
  v.array({"colours", "flag 8; a slot: r g b a, linear", "16 × block_count"}, l.colours,
          if_flag(kHasColours, blocks * 16));
  v.records({"runs", "u32 vertex_count ≥ 1, u32 influences 1 … 8", "run_count"}, l.runs, h.run_count,
            [&](const Run& r) {
              v.range({"vertex_count"}, r.vertex_count, 1u, UINT32_MAX, "a run has vertices");
              v.range({"influences"}, r.influences, 1u, kMaxInfluences, "1 to 8 influences");
            });
  v.array({"source slots",
           "flag 32; the slot of each vertex of the source; 4294967295: no triangle uses it, of a primitive in parts "
           "none of this part",
           "source_vertex_count"},
          l.source_slots, if_flag(kHasSourceSlots, h.source_vertex_count));
  v.array({"indices", "slots; u16 where 4 block_count ≤ 65536", "u16 or u32 × index_count"}, l.indices,
          std::uint64_t{h.index_count} * l.index_bytes);
  v.array({"sets", "each run's palette entries, run after run, below joint_count", "set_count"}, l.sets, h.set_count);
}

// What a geometry with kHasMorphTargets has behind its arrays, on a boundary of four bytes.
struct MorphHeader {
  std::uint32_t target_count;
  std::uint32_t block_count;
  std::uint32_t record_count;
  std::uint32_t reserved;
};
static_assert(sizeof(MorphHeader) == 16);

// dx[4] dy[4] dz[4] of a block.
struct MorphRecord {
  std::int16_t deltas[12];
};
inline constexpr std::uint64_t kMorphRecordBytes = sizeof(MorphRecord);

struct MorphLayout {
  std::uint64_t header;
  Array<MorphTarget> targets;
  Array<std::byte> blocks;  // as wide as indices
  Array<MorphRecord> records;
  std::uint64_t bytes;
};

template <class V>
constexpr void fields(V& v, const MorphHeader& h, MorphLayout& l, const GeometryLayout& geometry) {
  v.range({"target_count", "≥ 1"}, h.target_count, 1u, UINT32_MAX, "a flag without morph targets");
  v.any({"block_count", "Σ over targets"}, h.block_count);
  v.any({"record_count", "Σ over targets of blocks × attributes"}, h.record_count);
  v.reserved(h.reserved);
  v.array({"targets", "see below", "target_count"}, l.targets, h.target_count);
  v.array({"target blocks", "as wide as the indices; a target's ascend strictly, below the geometry's block_count",
           "u16 or u32 × block_count"},
          l.blocks, std::uint64_t{h.block_count} * geometry.index_bytes);
  v.array({"records", "i16: dx[4] dy[4] dz[4]", "record_count"}, l.records, h.record_count);
}

// Where the header stands, which what lies behind depends on.
constexpr std::uint64_t morph_start(const GeometryLayout& l) {
  return align4(l.bytes);
}
constexpr MorphLayout layout(const MorphHeader& h, const GeometryLayout& geometry) {
  MorphLayout l{};
  l.header = morph_start(geometry);
  LayOut v(l.header + sizeof h);
  fields(v, h, l, geometry);
  l.bytes = v.end();
  return l;
}

// Of morph targets and of examples of a pose space.
template <class V>
constexpr void fields(V& v, const MorphTarget& t) {
  v.any({"first_block", "blocks of the targets before it"}, t.first_block);
  v.any({"block_count"}, t.block_count);
  v.any({"first_record", "records of the targets before it"}, t.first_record);
  v.any({"attributes",
         "1 positions, 2 normals (with flag 1), 4 tangents (with flag 2); 0 if block_count is, and only then"},
        t.attributes);
  v.finite({"position_step", "of positions"}, t.position_step);
  v.finite({"normal_step", "of normals"}, t.normal_step);
  v.finite({"tangent_step", "of tangents"}, t.tangent_step);
  v.reserved(t.reserved);
}

// What a geometry with kHasPoseSpace has behind all that, on a boundary of four bytes.
struct PoseSpaceHeader {
  std::uint32_t example_count;
  std::uint32_t block_count;
  float sigma;
  std::uint32_t reserved;
};
static_assert(sizeof(PoseSpaceHeader) == 16);
inline constexpr float kLeastSigma = 1e-3f, kMostSigma = 1e3f;

// x y z w, up to a positive factor.
struct PackedRotation {
  std::int16_t v[4];
};

struct PoseSpaceLayout {
  std::uint64_t header;
  Array<MorphTarget> examples;
  Array<PackedRotation> rotations;
  Array<std::byte> blocks;  // as wide as indices
  Array<MorphRecord> records;
  Array<std::uint16_t> parents;
  std::uint64_t bytes;
};

template <class V>
constexpr void fields(V& v, const PoseSpaceHeader& h, PoseSpaceLayout& l, const GeometryHeader& g) {
  v.range({"example_count", "1 … 32"}, h.example_count, 1u, kMaxPoseExamples, "1 to 32 example poses");
  v.any({"block_count", "Σ over examples"}, h.block_count);
  v.within({"sigma", "0.001 … 1000"}, h.sigma, kLeastSigma, kMostSigma, "sigma from 0.001 to 1000");
  v.reserved(h.reserved);
  v.array({"examples", "as morph targets; attributes 1 or 0", "example_count"}, l.examples, h.example_count);
  v.array({"rotations", "example by example, of each palette entry i16 x y z w up to a positive factor",
           "joint_count × example_count"},
          l.rotations, std::uint64_t{h.example_count} * g.joint_count);
  v.array({"example blocks", "as target blocks", "u16 or u32 × block_count"}, l.blocks,
          std::uint64_t{h.block_count} * index_bytes(g));
  v.array({"records", "i16: dx[4] dy[4] dz[4]", "block_count"}, l.records, h.block_count);
  v.records({"parents",
             "the palette entry that an entry's rotation is relative to, below joint_count; 65535: none, its rotation "
             "does not count",
             "joint_count"},
            l.parents, g.joint_count, [&](const std::uint16_t& parent) {
              if (parent != kNoJoint) v.below({}, parent, g.joint_count, "a parent outside the palette");
            });
}

// before: the end of what stands before it, morph targets or, without those, the arrays.
constexpr PoseSpaceLayout layout(const PoseSpaceHeader& h, const GeometryHeader& g, std::uint64_t before) {
  PoseSpaceLayout l{};
  l.header = align4(before);
  LayOut v(l.header + sizeof h);
  fields(v, h, l, g);
  l.bytes = v.end();
  return l;
}

// Where the header stands in a whole section, whose own counts are right.
inline std::uint64_t pose_space_start(const std::byte* section) {
  const auto& h = *reinterpret_cast<const GeometryHeader*>(section);
  const GeometryLayout l = layout(h);
  if ((h.flags & kHasMorphTargets) == 0) return align4(l.bytes);
  return align4(layout(*reinterpret_cast<const MorphHeader*>(section + morph_start(l)), l).bytes);
}

}  // namespace marrow::format
