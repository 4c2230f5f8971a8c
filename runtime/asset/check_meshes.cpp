// Rules of GEOM and MESH sections that are code.
#include "asset/checker.h"

namespace marrow {

using format::GeometryHeader;
using format::layout;
using format::MeshHeader;

template <class Index>
bool Checker::below(const Index* first, std::uint64_t count, std::uint64_t limit, const char* rule) {
  Index largest = 0;
  for (std::uint64_t i = 0; i < count; ++i) largest = first[i] > largest ? first[i] : largest;
  return count == 0 || largest < limit || fail(first, rule);
}

// The next part of a geometry, if it has it: its header is looked at only where it is inside.
bool Checker::part_size(std::uint32_t flag, std::size_t place, std::size_t header_bytes, Part arrays) {
  const std::uint64_t start = format::align4(places_[arrays_]), end = start + header_bytes;
  if ((header<GeometryHeader>().flags & flag) == 0) return true;
  begin_arrays(place, end);
  return end <= section_->bytes && keeps(rules_of(arrays), at<std::byte>(start));
}

// Whether a geometry's arrays fill the section.
bool Checker::geometry_size() {
  const format::GeometryLayout l = layout(header<GeometryHeader>());
  std::memcpy(places_, &l, offsetof(format::GeometryLayout, index_bytes));
  places_[kIndexBytesPlace] = l.index_bytes;
  arrays_ = kMorphPlace - 1;
  return part_size(format::kHasMorphTargets, kMorphPlace, sizeof(format::MorphHeader), kMorphArrays) &&
         part_size(format::kHasPoseSpace, kPosePlace, sizeof(format::PoseSpaceHeader), kPoseArrays) &&
         places_[arrays_] == section_->bytes;
}

bool Checker::indices() {
  const auto& h = header<GeometryHeader>();
  constexpr const char* kRule = "an index outside the vertices";
  const std::uint64_t slots = std::uint64_t{h.block_count} * 4;
  return index_bytes() == 2
             ? below(array<std::uint16_t>(MARROW_PLACE(GeometryLayout, indices)), h.index_count, slots, kRule)
             : below(array<std::uint32_t>(MARROW_PLACE(GeometryLayout, indices)), h.index_count, slots, kRule);
}

bool Checker::runs() {
  const auto& h = header<GeometryHeader>();
  std::uint64_t vertices = 0, blocks = 0, influence_blocks = 0, entries = 0;
  for (const Run& run : Span<const Run>{array<Run>(MARROW_PLACE(GeometryLayout, runs)), h.run_count}) {
    const std::uint64_t run_blocks = (std::uint64_t{run.vertex_count} + 3) / 4;
    vertices += run.vertex_count;
    blocks += run_blocks;
    influence_blocks += run_blocks * run.influences;
    entries += run.influences;
  }
  return vertices == h.vertex_count && blocks == h.block_count && influence_blocks == h.influence_blocks &&
         entries == h.set_count;
}

bool Checker::sets() {
  const auto& h = header<GeometryHeader>();
  return below(array<std::uint16_t>(MARROW_PLACE(GeometryLayout, sets)), h.set_count, h.joint_count,
               "a set refers to a joint outside the palette");
}

bool Checker::source_slots() {
  const auto& h = header<GeometryHeader>();
  for (const std::uint32_t& slot : Span<const std::uint32_t>{
           array<std::uint32_t>(MARROW_PLACE(GeometryLayout, source_slots)), h.source_vertex_count})
    if (slot >= std::uint64_t{h.block_count} * 4 && slot != kNoSlot) return fail(&slot, "a slot outside the vertices");
  return true;
}

bool Checker::morph_blocks(const void* blocks, const MorphTarget& t) {
  const std::uint32_t index_bytes = this->index_bytes();
  const auto block = [&](std::uint32_t i) -> std::uint32_t {
    return index_bytes == 2 ? static_cast<const std::uint16_t*>(blocks)[i]
                            : static_cast<const std::uint32_t*>(blocks)[i];
  };
  for (std::uint32_t i = 1; i < t.block_count; ++i)
    if (block(i - 1) >= block(i))
      return fail(at<std::byte>(blocks, std::uint64_t{i} * index_bytes), "a target's blocks ascend");
  const std::uint32_t last = t.block_count - 1;
  return t.block_count == 0 || block(last) < header<GeometryHeader>().block_count ||
         fail(at<std::byte>(blocks, std::uint64_t{last} * index_bytes), "a target's block outside the vertices");
}

// Each moves some blocks, in ascending order, and adds to what the geometry has; lists and records stand back to back.
bool Checker::sparse_records(const SparseRecords& r) {
  std::uint64_t blocks = 0, records = 0;
  for (const MorphTarget& t : r.targets) {
    if ((t.attributes & ~r.allowed) != 0) return fail(&t.attributes, "a target moves what the geometry has");
    if ((t.attributes == 0) != (t.block_count == 0)) return fail(&t.attributes, "what moves has blocks");
    if (t.first_block != blocks || t.first_record != records) return fail(&t, "targets stand back to back");
    if (t.reserved != 0) return fail(&t.reserved, "reserved must be 0");
    if (const void* const beyond = first_beyond(kFiniteBits, &t.position_step, 12)) return fail(beyond, kNotFinite);
    blocks += t.block_count;
    records += std::uint64_t{t.block_count} * count_bits(t.attributes);
    if (blocks > r.block_count || records > r.record_count) return fail(&t, "a target outside the records");
    if (!morph_blocks(at<std::byte>(r.blocks + std::uint64_t{t.first_block} * index_bytes()), t)) return false;
  }
  return (blocks == r.block_count && records == r.record_count) || fail(r.targets.data, "records that no target uses");
}

bool Checker::targets() {
  const auto& h = record<format::MorphHeader>();
  const std::uint32_t flags = header<GeometryHeader>().flags;
  const std::uint32_t allowed = kMorphsPositions | ((flags & format::kHasNormals) != 0 ? kMorphsNormals : 0u) |
                                ((flags & format::kHasTangents) != 0 ? kMorphsTangents : 0u);
  return sparse_records({{array<MorphTarget>(kMorphPlace), h.target_count},
                         places_[kMorphPlace + 1],
                         h.block_count,
                         h.record_count,
                         allowed});
}

bool Checker::examples() {
  const auto& h = record<format::PoseSpaceHeader>();
  return sparse_records({{array<MorphTarget>(kPosePlace), h.example_count},
                         places_[kPosePlace + 2],
                         h.block_count,
                         h.block_count,
                         kMorphsPositions});
}

const GeometryHeader& Checker::geometry(std::uint32_t number) const {
  return *at<GeometryHeader>(start_of(nth(format::kGeometries, number)), 0);
}

std::uint32_t Checker::target_count(std::uint32_t of_geometry) const {
  const GeometryHeader& g = geometry(of_geometry);
  if ((g.flags & format::kHasMorphTargets) == 0) return 0;
  return at<format::MorphHeader>(&g, format::morph_start(layout(g)))->target_count;
}

// Whoever puts a primitive together again from its parts leans on what they have in common.
bool Checker::next_part() {
  const auto& h = header<MeshHeader>();
  if ((h.flags & format::kNextPart) == 0) return true;
  if (section_ == sections_.data || section_[-1].type != section_->type)
    return fail(&h.flags, "a next part follows a mesh");
  const auto& first = *at<MeshHeader>(start_of(section_[-1]), 0);
  const GeometryHeader &a = geometry(first.geometry), &b = geometry(h.geometry);
  constexpr std::uint32_t kSurface =
      format::kHasNormals | format::kHasTangents | format::kHasUvs | format::kHasColours | format::kHasSourceSlots;
  return h.skeleton == first.skeleton && h.target_count == first.target_count &&
         ((a.flags ^ b.flags) & kSurface) == 0 && a.source_vertex_count == b.source_vertex_count;
}

bool Checker::mesh_joints() {
  return below(array<std::uint16_t>(MARROW_PLACE(MeshLayout, joints)), header<MeshHeader>().joint_count, joint_count(),
               "a joint outside the skeleton");
}

bool Checker::keeps_of_mesh(Check check, std::uint32_t limit) {
  using namespace format;
  switch (check) {
    case Check::geometry_size:
      return geometry_size();
    case Check::triangles:
      return header<GeometryHeader>().index_count % 3 == 0;
    case Check::indices:
      return indices();
    case Check::runs:
      return runs();
    case Check::sets:
      return sets();
    case Check::source_slots:
      return source_slots();
    case Check::morphs:
      return keeps(rules_of(kMorphPart), at<MorphHeader>(places_[kMorphPlace]) - 1);
    case Check::pose_space:
      return keeps(rules_of(kPosePart), at<PoseSpaceHeader>(places_[kPosePlace]) - 1);
    case Check::targets:
      return targets();
    case Check::examples:
      return examples();
    case Check::next_part:
      return next_part();
    case Check::palette:
      return std::uint64_t{header<MeshHeader>().joint_count} + header<MeshHeader>().helper_count ==
             geometry(limit).joint_count;
    case Check::target_count:
      return target_count(limit) == header<MeshHeader>().target_count;
    case Check::level_targets:
      return target_count(limit) == 0 || target_count(limit) == header<MeshHeader>().target_count;
    case Check::helper_count:
      return header<MeshHeader>().helper_count != 0;
    default:
      return mesh_joints();
  }
}

}  // namespace marrow
