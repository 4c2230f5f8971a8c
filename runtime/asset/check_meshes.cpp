// Rules of GEOM and MESH sections.
#include "asset/checker.h"

namespace marrow {

using format::layout;

template <class Index>
bool Checker::below(const Index* first, std::uint64_t count, std::uint64_t limit, const char* rule) {
  Index largest = 0;
  for (std::uint64_t i = 0; i < count; ++i) largest = first[i] > largest ? first[i] : largest;
  return count == 0 || largest < limit || fail(first, rule);
}

bool Checker::runs(const format::GeometryHeader& h, const Run* runs, const std::uint16_t* sets) {
  std::uint64_t vertices = 0, blocks = 0, influence_blocks = 0, entries = 0;
  for (std::uint32_t r = 0; r < h.run_count; ++r) {
    const Run& run = runs[r];
    if (run.vertex_count == 0) return fail(&run, "a run has vertices");
    if (run.influences == 0 || run.influences > kMaxInfluences) return fail(&run, "1 to 8 influences");
    const std::uint64_t run_blocks = (std::uint64_t{run.vertex_count} + 3) / 4;
    vertices += run.vertex_count;
    blocks += run_blocks;
    influence_blocks += run_blocks * run.influences;
    entries += run.influences;
  }
  if (vertices != h.vertex_count || blocks != h.block_count || influence_blocks != h.influence_blocks ||
      entries != h.set_count)
    return fail(&h, "runs do not add up to the geometry's counts");
  return below(sets, h.set_count, h.joint_count, "a set refers to a joint outside the palette");
}

bool Checker::morph_blocks(const void* blocks, std::uint32_t index_bytes, const MorphTarget& t,
                           std::uint32_t block_count) {
  const auto block = [&](std::uint32_t i) -> std::uint32_t {
    return index_bytes == 2 ? static_cast<const std::uint16_t*>(blocks)[i]
                            : static_cast<const std::uint32_t*>(blocks)[i];
  };
  for (std::uint32_t i = 1; i < t.block_count; ++i)
    if (block(i - 1) >= block(i))
      return fail(at<std::byte>(blocks, std::uint64_t{i} * index_bytes), "a target's blocks ascend");
  const std::uint32_t last = t.block_count - 1;
  return t.block_count == 0 || block(last) < block_count ||
         fail(at<std::byte>(blocks, std::uint64_t{last} * index_bytes), "a target's block outside the vertices");
}

// Each moves some blocks, in ascending order, and adds to what the geometry has; lists and records stand back to back.
bool Checker::sparse_records(const format::GeometryHeader& g, const SparseRecords& r) {
  const std::uint32_t index_bytes = layout(g).index_bytes;
  std::uint64_t blocks = 0, records = 0;
  for (const MorphTarget& t : r.targets) {
    if ((t.attributes & ~r.allowed) != 0) return fail(&t.attributes, "a target moves what the geometry has");
    if ((t.attributes == 0) != (t.block_count == 0)) return fail(&t.attributes, "what moves has blocks");
    if (t.first_block != blocks || t.first_record != records) return fail(&t, "targets stand back to back");
    if (t.reserved != 0) return fail(&t.reserved, "reserved must be 0");
    if (!finite(&t.position_step, 12)) return false;
    blocks += t.block_count;
    records += std::uint64_t{t.block_count} * count_bits(t.attributes);
    if (blocks > r.block_count || records > r.record_count) return fail(&t, "a target outside the records");
    const auto* const first = at<std::byte>(&g, r.blocks + std::uint64_t{t.first_block} * index_bytes);
    if (!morph_blocks(first, index_bytes, t, g.block_count)) return false;
  }
  return (blocks == r.block_count && records == r.record_count) || fail(r.targets.data, "records that no target uses");
}

bool Checker::morphs(const format::GeometryHeader& g) {
  const auto* h = at<format::MorphHeader>(&g, format::morph_start(layout(g)));
  const format::MorphLayout l = layout(*h, layout(g));
  if (h->target_count == 0) return fail(h, "a flag without morph targets");
  if (h->reserved != 0) return fail(&h->reserved, "reserved must be 0");
  const std::uint32_t allowed = kMorphsPositions | ((g.flags & format::kHasNormals) != 0 ? kMorphsNormals : 0u) |
                                ((g.flags & format::kHasTangents) != 0 ? kMorphsTangents : 0u);
  return sparse_records(
      g, {{at<MorphTarget>(&g, l.targets), h->target_count}, l.blocks, h->block_count, h->record_count, allowed});
}

bool Checker::pose_space(const format::GeometryHeader& g) {
  const std::uint64_t start = format::pose_space_start(at<std::byte>(&g, 0));
  const auto* h = at<format::PoseSpaceHeader>(&g, start);
  const format::PoseSpaceLayout l = layout(*h, g, start);
  if (h->reserved != 0) return fail(&h->reserved, "reserved must be 0");
  if (!(h->sigma >= format::kLeastSigma && h->sigma <= format::kMostSigma))
    return fail(&h->sigma, "sigma from 0.001 to 1000");
  const auto* parents = at<std::uint16_t>(&g, l.parents);
  for (std::uint32_t j = 0; j < g.joint_count; ++j)
    if (parents[j] >= g.joint_count && parents[j] != kNoParent)
      return fail(parents + j, "a parent outside the palette");
  return sparse_records(g, {{at<MorphTarget>(&g, l.examples), h->example_count},
                            l.blocks,
                            h->block_count,
                            h->block_count,
                            kMorphsPositions});
}

// Whether a geometry's arrays fill the section; each part's header is looked at only where it is inside.
bool Checker::geometry_size(const File::Section& s, const format::GeometryHeader& h) {
  constexpr const char* kRule = "section size differs from its counts";
  const format::GeometryLayout l = layout(h);
  std::uint64_t bytes = l.bytes;
  if ((h.flags & format::kHasMorphTargets) != 0) {
    const std::uint64_t start = format::morph_start(l);
    if (start + sizeof(format::MorphHeader) > s.bytes) return fail(&h, kRule);
    bytes = layout(*at<format::MorphHeader>(&h, start), l).bytes;
  }
  if ((h.flags & format::kHasPoseSpace) != 0) {
    const std::uint64_t start = format::align4(bytes);
    if (start + sizeof(format::PoseSpaceHeader) > s.bytes) return fail(&h, kRule);
    const auto* const space = at<format::PoseSpaceHeader>(&h, start);
    if (space->example_count == 0 || space->example_count > kMaxPoseExamples)
      return fail(space, "1 to 32 example poses");
    bytes = layout(*space, h, bytes).bytes;
  }
  return has_bytes(s, bytes);
}

bool Checker::geometry(const File::Section& s) {
  const auto* h = at<format::GeometryHeader>(s, 0);
  // The layout subtracts one weight a block, so every block must have an influence before sizes mean anything.
  if (h->influence_blocks < h->block_count) return fail(&h->influence_blocks, "a block has influences");
  if (!geometry_size(s, *h)) return false;
  if ((h->flags & ~std::uint32_t{format::kAllGeometryFlags}) != 0) return fail(&h->flags, "unknown flag");
  if (h->block_count > 0x3FFFFFFF) return fail(&h->block_count, "too many vertices");
  if (h->joint_count == 0 || h->joint_count > kMaxJoints) return fail(&h->joint_count, "1 to 32767 palette entries");
  if (h->mwe_root >= ((h->flags & format::kHasMwe) != 0 ? h->joint_count : 1u))
    return fail(&h->mwe_root, "a root outside the palette, or of nothing");
  if (h->index_count % 3 != 0) return fail(&h->index_count, "three indices a triangle");
  if ((h->flags & format::kHasSourceSlots) == 0 && h->source_vertex_count != 0)
    return fail(&h->source_vertex_count, "source vertices without slots");
  const format::GeometryLayout l = layout(*h);
  const std::uint64_t slots = std::uint64_t{h->block_count} * 4;
  const bool indices_fit =
      l.index_bytes == 2
          ? below(at<std::uint16_t>(h, l.indices), h->index_count, slots, "an index outside the vertices")
          : below(at<std::uint32_t>(h, l.indices), h->index_count, slots, "an index outside the vertices");
  return indices_fit && runs(*h, at<Run>(h, l.runs), at<std::uint16_t>(h, l.sets)) &&
         source_slots(at<std::uint32_t>(h, l.source_slots), h->source_vertex_count, slots) && finite(h->box_min, 24) &&
         finite(at<float>(h, l.skin), l.colours - l.skin) &&
         ((h->flags & format::kHasMorphTargets) == 0 || morphs(*h)) &&
         ((h->flags & format::kHasPoseSpace) == 0 || pose_space(*h));
}

bool Checker::source_slots(const std::uint32_t* first, std::uint64_t count, std::uint64_t slots) {
  for (std::uint64_t i = 0; i < count; ++i)
    if (first[i] >= slots && first[i] != kNoSlot) return fail(first + i, "a slot outside the vertices");
  return true;
}

std::uint32_t Checker::target_count(std::uint32_t of_geometry) const {
  const File::Section& s = nth(format::kGeometries, of_geometry);
  const auto* const geometry = at<format::GeometryHeader>(s, 0);
  if ((geometry->flags & format::kHasMorphTargets) == 0) return 0;
  return at<format::MorphHeader>(geometry, format::morph_start(layout(*geometry)))->target_count;
}

bool Checker::lods(Span<const MeshLod> lods, const format::MeshHeader& h) {
  for (const MeshLod& lod : lods) {
    if (lod.geometry >= counts_[format::kGeometries]) return fail(&lod, "no such geometry");
    const auto* const geometry = at<format::GeometryHeader>(nth(format::kGeometries, lod.geometry), 0);
    if (std::uint64_t{h.joint_count} + h.helper_count != geometry->joint_count)
      return fail(&lod, "a level has the mesh's palette");
    const std::uint32_t targets = target_count(lod.geometry);
    if (targets != 0 && targets != h.target_count) return fail(&lod, "a level has the mesh's morph targets or none");
    if (!finite(&lod.error_m, 4)) return false;
    if (lod.error_m < 0) return fail(&lod.error_m, "an error is not below 0");
  }
  return true;
}

// Whoever puts a primitive together again from its parts leans on what they have in common.
bool Checker::next_part(const File::Section& s, const format::MeshHeader& h) {
  if ((h.flags & format::kNextPart) == 0) return true;
  const File::Section* const before = &s == sections_.data ? nullptr : &s - 1;
  if (before == nullptr || before->type != format::kTypes[format::kMeshes])
    return fail(&h.flags, "a next part follows a mesh");
  const auto* const first = at<format::MeshHeader>(*before, 0);
  const auto* const a = at<format::GeometryHeader>(nth(format::kGeometries, first->geometry), 0);
  const auto* const b = at<format::GeometryHeader>(nth(format::kGeometries, h.geometry), 0);
  constexpr std::uint32_t kSurface =
      format::kHasNormals | format::kHasTangents | format::kHasUvs | format::kHasColours | format::kHasSourceSlots;
  return (h.skeleton == first->skeleton && h.target_count == first->target_count &&
          ((a->flags ^ b->flags) & kSurface) == 0 && a->source_vertex_count == b->source_vertex_count) ||
         fail(&h.flags,
              "a next part has the skeleton, attributes, morph targets and source vertices of the part before it");
}

bool Checker::mesh(const File::Section& s) {
  const auto* h = header<format::MeshHeader>(s);
  if (h == nullptr) return false;
  if (h->material_section > counts_[format::kMaterials]) return fail(&h->material_section, "no such material");
  if ((h->flags & ~std::uint32_t{format::kAllMeshFlags}) != 0) return fail(&h->flags, "unknown flag");
  const auto* skeleton = skeleton_of(h->skeleton);
  if (skeleton == nullptr) return false;
  if (h->geometry >= counts_[format::kGeometries]) return fail(&h->geometry, "no such geometry");
  if (!next_part(s, *h)) return false;
  if (h->joint_count == 0 || std::uint64_t{h->joint_count} + h->helper_count !=
                                 at<format::GeometryHeader>(nth(format::kGeometries, h->geometry), 0)->joint_count)
    return fail(&h->joint_count, "as many palette entries as the geometry");
  if (h->target_count != target_count(h->geometry))
    return fail(&h->target_count, "as many morph targets as the geometry");
  const format::MeshLayout l = layout(*h);
  for (const MeshTarget& t : Span<const MeshTarget>{at<MeshTarget>(h, l.targets), h->target_count})
    if (!name(t.name) || !name(t.channel) || !finite(&t.weight, 4)) return false;
  if ((h->flags & format::kHelpersHaveCentres) != 0 && h->helper_count == 0)
    return fail(&h->flags, "centres without helpers");
  for (const Helper& helper : Span<const Helper>{at<Helper>(h, l.helpers), h->helper_count})
    if (helper.first >= h->joint_count || helper.second >= h->joint_count || helper.first == helper.second ||
        !(helper.share > 0 && helper.share < 1))
      return fail(&helper, "a helper blends two joints of the mesh");
  if (!bounded(at<float>(h, l.centres), l.lods - l.centres)) return false;
  if (!lods({at<MeshLod>(h, l.lods), h->lod_count}, *h)) return false;
  return name(h->name) && name(h->material) && finite(h->base_colour, 16) &&
         bounded(at<float>(h, l.inverse_bind), l.targets - l.inverse_bind) &&
         below(at<std::uint16_t>(h, l.joints), h->joint_count, skeleton->joint_count, "a joint outside the skeleton");
}

}  // namespace marrow
