// What is asked of GEOM and MESH sections beyond their descriptions.
#include "asset/checker.h"

namespace marrow {

using format::GeometryHeader;
using format::GeometryLayout;
using format::MeshHeader;
using format::MeshLayout;
using format::MorphHeader;
using format::MorphLayout;
using format::PoseSpaceHeader;
using format::PoseSpaceLayout;

namespace {

template <class Index>
bool all_below(Checker& c, Span<const Index> numbers, std::uint64_t limit, const char* rule) {
  Index largest = 0;
  for (const Index n : numbers) largest = n > largest ? n : largest;
  return numbers.empty() || largest < limit || c.fail(numbers.data, rule);
}

// Indices, or numbers of blocks, of 2 or 4 bytes each.
struct BlockNumbers {
  const std::byte* first;
  std::uint32_t bytes_each;

  const std::byte* at(std::uint64_t i) const { return first + i * bytes_each; }
  std::uint32_t operator[](std::uint64_t i) const {
    return bytes_each == 2 ? *reinterpret_cast<const std::uint16_t*>(at(i))
                           : *reinterpret_cast<const std::uint32_t*>(at(i));
  }
};

bool check_indices(Checker& c, const GeometryHeader& h, const GeometryLayout& l) {
  constexpr const char* kRule = "an index outside the vertices";
  const std::uint64_t slots = std::uint64_t{h.block_count} * 4;
  return l.index_bytes == 2
             ? all_below<std::uint16_t>(c, {&c.at<std::uint16_t>(l.indices), h.index_count}, slots, kRule)
             : all_below<std::uint32_t>(c, {&c.at<std::uint32_t>(l.indices), h.index_count}, slots, kRule);
}

bool check_runs(Checker& c, const GeometryHeader& h, Span<const Run> runs) {
  std::uint64_t vertices = 0, blocks = 0, influence_blocks = 0, entries = 0;
  for (const Run& run : runs) {
    const std::uint64_t run_blocks = (std::uint64_t{run.vertex_count} + 3) / 4;
    vertices += run.vertex_count;
    blocks += run_blocks;
    influence_blocks += run_blocks * run.influences;
    entries += run.influences;
  }
  return (vertices == h.vertex_count && blocks == h.block_count && influence_blocks == h.influence_blocks &&
          entries == h.set_count) ||
         c.fail(&h, "runs do not add up to the geometry's counts");
}

bool check_source_slots(Checker& c, const GeometryHeader& h, Span<const std::uint32_t> slots) {
  for (const std::uint32_t& slot : slots)
    if (slot >= std::uint64_t{h.block_count} * 4 && slot != kNoSlot)
      return c.fail(&slot, "a slot outside the vertices");
  return true;
}

bool check_blocks(Checker& c, const MorphTarget& t, const BlockNumbers& blocks, std::uint32_t block_count) {
  for (std::uint32_t i = 1; i < t.block_count; ++i)
    if (blocks[i - 1] >= blocks[i]) return c.fail(blocks.at(i), "a target's blocks ascend");
  const std::uint32_t last = t.block_count - 1;
  return t.block_count == 0 || blocks[last] < block_count ||
         c.fail(blocks.at(last), "a target's block outside the vertices");
}

// How many there are of what targets, or examples, share out.
struct Shared {
  std::uint64_t block_count, record_count;
  std::uint32_t attributes;  // that there are
};

// Each moves some blocks, in ascending order, and adds to what the geometry has; lists and records stand back to back.
bool check_targets(Checker& c, Span<const MorphTarget> targets, const Shared& shared, const BlockNumbers& all,
                   const GeometryHeader& h) {
  std::uint64_t blocks = 0, records = 0;
  for (const MorphTarget& t : targets) {
    if ((t.attributes & ~shared.attributes) != 0) return c.fail(&t.attributes, "a target moves what the geometry has");
    if ((t.attributes == 0) != (t.block_count == 0)) return c.fail(&t.attributes, "what moves has blocks");
    if (t.first_block != blocks || t.first_record != records) return c.fail(&t, "targets stand back to back");
    format::fields(c, t);
    blocks += t.block_count;
    records += std::uint64_t{t.block_count} * count_bits(t.attributes);
    if (blocks > shared.block_count || records > shared.record_count) c.fail(&t, "a target outside the records");
    if (!c.good() || !check_blocks(c, t, {all.at(t.first_block), all.bytes_each}, h.block_count)) return false;
  }
  return (blocks == shared.block_count && records == shared.record_count) ||
         c.fail(targets.data, "records that no target uses");
}

// The parts behind a geometry's arrays, null where it has none.
struct GeometryParts {
  const MorphHeader* morphs = nullptr;
  MorphLayout morphs_at{};
  const PoseSpaceHeader* space = nullptr;
  PoseSpaceLayout space_at{};
};

// Whether arrays and parts fill the section. A header is looked at only where it is inside.
bool find_parts(Checker& c, const GeometryHeader& h, const GeometryLayout& l, GeometryParts& out) {
  const std::uint64_t bytes = c.section().bytes;
  std::uint64_t end = l.bytes;
  if ((h.flags & format::kHasMorphTargets) != 0) {
    const std::uint64_t start = format::align4(end);
    if (start + sizeof(MorphHeader) > bytes) return c.fail(&h, kWrongSize);
    out.morphs = &c.at<MorphHeader>(start);
    out.morphs_at = layout(*out.morphs, l);
    end = out.morphs_at.bytes;
  }
  if ((h.flags & format::kHasPoseSpace) != 0) {
    const std::uint64_t start = format::align4(end);
    if (start + sizeof(PoseSpaceHeader) > bytes) return c.fail(&h, kWrongSize);
    out.space = &c.at<PoseSpaceHeader>(start);
    // Of any number of examples the sizes would be none.
    c.leave_arrays(true);
    fields(c, *out.space, out.space_at, h);
    c.leave_arrays(false);
    if (!c.good()) return false;
    out.space_at = layout(*out.space, h, end);
    end = out.space_at.bytes;
  }
  return end == bytes || c.fail(&h, kWrongSize);
}

bool check_counts(Checker& c, const GeometryHeader& h) {
  const bool has_root = (h.flags & format::kHasMwe) != 0;
  if (has_root ? h.mwe_root >= h.joint_count : h.mwe_root != 0)
    return c.fail(&h.mwe_root, "a root outside the palette, or of nothing");
  if (h.index_count % 3 != 0) return c.fail(&h.index_count, "three indices a triangle");
  return (h.flags & format::kHasSourceSlots) != 0 || h.source_vertex_count == 0 ||
         c.fail(&h.source_vertex_count, "source vertices without slots");
}

bool check_parts(Checker& c, const GeometryHeader& h, const GeometryLayout& l, GeometryParts& p) {
  if (p.morphs != nullptr) {
    fields(c, *p.morphs, p.morphs_at, l);
    const std::uint32_t attributes = kMorphsPositions | ((h.flags & format::kHasNormals) != 0 ? kMorphsNormals : 0u) |
                                     ((h.flags & format::kHasTangents) != 0 ? kMorphsTangents : 0u);
    if (!c.good() ||
        !check_targets(c, c.in(p.morphs_at.targets), {p.morphs->block_count, p.morphs->record_count, attributes},
                       {c.in(p.morphs_at.blocks).data, l.index_bytes}, h))
      return false;
  }
  if (p.space == nullptr) return true;
  fields(c, *p.space, p.space_at, h);
  return c.good() &&
         check_targets(c, c.in(p.space_at.examples), {p.space->block_count, p.space->block_count, kMorphsPositions},
                       {c.in(p.space_at.blocks).data, l.index_bytes}, h);
}

const GeometryHeader& geometry(const Checker& c, std::uint32_t number) {
  return c.nth<GeometryHeader>(format::kGeometries, number);
}

std::uint32_t target_count(const GeometryHeader& g) {
  if ((g.flags & format::kHasMorphTargets) == 0) return 0;
  const auto* const section = reinterpret_cast<const std::byte*>(&g);
  return reinterpret_cast<const MorphHeader*>(section + format::morph_start(layout(g)))->target_count;
}

// Whoever puts a primitive together again from its parts leans on what they have in common.
bool check_next_part(Checker& c, const MeshHeader& h) {
  if ((h.flags & format::kNextPart) == 0) return true;
  if (!c.follows_its_like()) return c.fail(&h.flags, "a next part follows a mesh");
  const auto& first = c.header_before<MeshHeader>();
  const GeometryHeader &a = geometry(c, first.geometry), &b = geometry(c, h.geometry);
  constexpr std::uint32_t kSurface =
      format::kHasNormals | format::kHasTangents | format::kHasUvs | format::kHasColours | format::kHasSourceSlots;
  return (h.skeleton == first.skeleton && h.target_count == first.target_count &&
          ((a.flags ^ b.flags) & kSurface) == 0 && a.source_vertex_count == b.source_vertex_count) ||
         c.fail(&h.flags,
                "a next part has the skeleton, attributes, morph targets and source vertices of the part before it");
}

bool has_palette(const MeshHeader& h, const GeometryHeader& g) {
  return std::uint64_t{h.joint_count} + h.helper_count == g.joint_count;
}

bool check_geometry_of(Checker& c, const MeshHeader& h) {
  const GeometryHeader& g = geometry(c, h.geometry);
  if (!has_palette(h, g)) return c.fail(&h.joint_count, "as many palette entries as the geometry");
  return target_count(g) == h.target_count || c.fail(&h.target_count, "as many morph targets as the geometry");
}

bool check_levels(Checker& c, const MeshHeader& h, Span<const MeshLod> lods) {
  for (const MeshLod& lod : lods) {
    const GeometryHeader& g = geometry(c, lod.geometry);
    if (!has_palette(h, g)) return c.fail(&lod, "a level has the mesh's palette");
    const std::uint32_t targets = target_count(g);
    if (targets != 0 && targets != h.target_count) return c.fail(&lod, "a level has the mesh's morph targets or none");
  }
  return true;
}

bool check_helpers(Checker& c, const MeshHeader& h, Span<const Helper> helpers) {
  if ((h.flags & format::kHelpersHaveCentres) != 0 && helpers.empty())
    return c.fail(&h.flags, "centres without helpers");
  for (const Helper& helper : helpers)
    if (helper.first == helper.second) return c.fail(&helper, "a helper blends two joints of the mesh");
  return true;
}

}  // namespace

void check(Checker& c, const GeometryHeader& h) {
  // The layout subtracts one weight a block, so every block must have an influence before sizes mean anything.
  if (h.influence_blocks < h.block_count) c.fail(&h.influence_blocks, "a block has influences");
  GeometryLayout l = layout(h);
  GeometryParts parts;
  if (!c.good() || !find_parts(c, h, l, parts)) return;
  fields(c, h, l);
  c.good() && check_counts(c, h) && check_indices(c, h, l) && check_runs(c, h, c.in(l.runs)) &&
      all_below(c, c.in(l.sets), h.joint_count, "a set refers to a joint outside the palette") &&
      check_source_slots(c, h, c.in(l.source_slots)) && check_parts(c, h, l, parts);
}

void check(Checker& c, const MeshHeader& h) {
  MeshLayout l;
  check_fields(c, h, l) && check_next_part(c, h) && check_geometry_of(c, h) && check_helpers(c, h, c.in(l.helpers)) &&
      check_levels(c, h, c.in(l.lods)) && all_below(c, c.in(l.joints), c.joint_count(), "a joint outside the skeleton");
}

}  // namespace marrow
