// load: every rule of docs/format.md, checked once, so that no later stage has to.
#include <cstring>

#include "asset/format.h"
#include "core/check.h"

namespace marrow {
namespace {

using format::layout;

// A block under examination: the first broken rule is kept with its place.
class Checker {
 public:
  // first, counts: for each kind of section, its first one and how many there are.
  Checker(Span<const std::byte> block, Span<const File::Section> sections, const std::uint32_t* first,
          const std::uint32_t* counts)
      : block_(block), sections_(sections), first_(first), counts_(counts) {}

  bool all();
  const DataError& error() const { return error_; }

 private:
  bool fail(const void* where, const char* rule) {
    const auto offset = static_cast<const std::byte*>(where) - block_.data;
    error_ = {Status::bad_data, static_cast<std::uint32_t>(offset), rule};
    return false;
  }
  template <class Header>
  const Header* header(const File::Section& s) {
    if (s.codec != format::kCodecRaw) {
      error_ = {Status::unsupported, s.offset, "a codec that this build lacks"};
      return nullptr;
    }
    if (s.bytes < sizeof(Header)) return fail(block_.data + s.offset, "section too short for its header"), nullptr;
    const auto* h = reinterpret_cast<const Header*>(block_.data + s.offset);
    if (layout(*h).bytes != s.bytes) return fail(h, "section size differs from its counts"), nullptr;
    return h;
  }
  template <class T>
  const T* at(const File::Section& s, std::uint64_t offset) const {
    return reinterpret_cast<const T*>(block_.data + s.offset + offset);
  }

  bool name(const std::uint32_t& n) {
    return n < sections_[sections_.size - 1].bytes || fail(&n, "name outside the name section");
  }
  bool finite(const void* first, std::uint64_t bytes);
  bool names(const File::Section& s);
  bool skeleton(const File::Section& s);
  bool reference(const File::Section& s);
  bool joints(const std::uint16_t* parents, const std::uint32_t* joint_names, std::uint32_t count,
              std::uint32_t root_count);
  std::uint32_t joint_count_of(const format::ClipHeader& h) const;
  bool clip(const File::Section& s);
  bool clip_header(const File::Section& s);
  bool tracks(const File::Section& s, const format::ClipHeader& h, std::uint32_t joint_count);
  template <class Keyed>
  bool keys(const format::ClipHeader& h, const Keyed& t, std::uint32_t floats_per_key);
  bool coded(const File::Section& s, std::uint64_t start, std::uint32_t joint_count);
  bool masks(const format::CodedHeader& h, const GroupMasks* masks, std::uint32_t joint_count);
  bool constants(const GroupMasks* masks, const format::Constant* next, std::uint32_t joint_count);
  bool segments(const File::Section& s, const format::CodedHeader& h, const format::CodedLayout& l);
  bool geometry(const File::Section& s);
  const format::GeometryHeader* geometry_header(const File::Section& s);
  bool morphs(const File::Section& s, const format::GeometryHeader& h);
  template <class Index>
  bool morph_blocks(const Index* blocks, const MorphTarget& t, std::uint32_t block_count);
  bool runs(const format::GeometryHeader& h, const Run* runs, const std::uint16_t* sets);
  template <class Index>
  bool below(const Index* first, std::uint64_t count, std::uint64_t limit, const char* rule);
  bool source_slots(const std::uint32_t* first, std::uint64_t count, std::uint64_t slots);
  bool mesh(const File::Section& s);
  bool material(const File::Section& s);
  bool texture(const Texture& t, std::uint32_t& roles);
  bool image(const File::Section& s);
  bool node(const File::Section& s);
  bool property(const Property& p);

  const File::Section& nth(format::Kind kind, std::uint32_t n) const { return sections_[first_[kind] + n]; }

  Span<const std::byte> block_;
  Span<const File::Section> sections_;
  const std::uint32_t* first_;
  const std::uint32_t* counts_;
  DataError error_;
};

// Neither infinite nor not-a-number, in one pass without a branch a float.
bool Checker::finite(const void* first, std::uint64_t bytes) {
  const auto* words = static_cast<const std::uint32_t*>(first);
  const std::uint64_t count = bytes / 4;
  std::uint32_t bad = 0;
  for (std::uint64_t i = 0; i < count; ++i) bad |= (words[i] & 0x7F800000u) == 0x7F800000u;
  if (bad == 0) return true;
  std::uint64_t i = 0;
  while ((words[i] & 0x7F800000u) != 0x7F800000u) ++i;
  return fail(words + i, "a number that is not finite");
}

template <class Index>
bool Checker::below(const Index* first, std::uint64_t count, std::uint64_t limit, const char* rule) {
  Index largest = 0;
  for (std::uint64_t i = 0; i < count; ++i) largest = first[i] > largest ? first[i] : largest;
  return count == 0 || largest < limit || fail(first, rule);
}

bool Checker::names(const File::Section& s) {
  if (s.codec != format::kCodecRaw) return fail(block_.data + s.offset, "names have no codec");
  if (s.bytes == 0 || *at<char>(s, 0) != 0 || *at<char>(s, s.bytes - 1) != 0)
    return fail(block_.data + s.offset, "names must begin with the empty one and end with a zero");
  return true;
}

bool Checker::skeleton(const File::Section& s) {
  const auto* h = header<format::SkeletonHeader>(s);
  if (h == nullptr) return false;
  if (h->reserved != 0) return fail(&h->reserved, "reserved must be 0");
  if (h->joint_count == 0 || h->joint_count > kMaxJoints) return fail(&h->joint_count, "1 to 32767 joints");
  if (h->root_count == 0 || h->root_count > h->joint_count) return fail(&h->root_count, "1 root to as many as joints");
  const format::SkeletonLayout l = layout(*h);
  const auto* parents = at<std::uint16_t>(s, l.parents);
  const auto* joint_names = at<std::uint32_t>(s, l.names);
  return joints(parents, joint_names, h->joint_count, h->root_count) && name(h->name) &&
         finite(at<float>(s, l.roots), l.names - l.roots);
}

bool Checker::joints(const std::uint16_t* parents, const std::uint32_t* joint_names, std::uint32_t count,
                     std::uint32_t root_count) {
  for (std::uint32_t j = 0; j < count; ++j) {
    const bool root = j < root_count;
    if (root ? parents[j] != kNoParent : parents[j] >= j) return fail(parents + j, "parents come before children");
    if (j > root_count && parents[j] < parents[j - 1]) return fail(parents + j, "joints are breadth-first");
    if (!name(joint_names[j])) return false;
  }
  return true;
}

bool Checker::reference(const File::Section& s) {
  const auto* h = header<format::ReferenceHeader>(s);
  if (h == nullptr) return false;
  if (counts_[format::kSkeletons] != 0) return fail(h, "skeletons or references, not both");
  if (h->joint_count == 0 || h->joint_count > kMaxJoints) return fail(&h->joint_count, "1 to 32767 joints");
  const format::ReferenceLayout l = layout(*h);
  const auto* parents = at<std::uint16_t>(s, l.parents);
  std::uint32_t roots = 0;
  while (roots < h->joint_count && parents[roots] == kNoParent) ++roots;
  if (roots == 0) return fail(parents, "the first joint has no parent");
  return joints(parents, at<std::uint32_t>(s, l.names), h->joint_count, roots) && name(h->name);
}

// Of the skeleton or the reference that a clip is for; the number is in range.
std::uint32_t Checker::joint_count_of(const format::ClipHeader& h) const {
  if (counts_[format::kReferences] != 0)
    return at<format::ReferenceHeader>(nth(format::kReferences, h.skeleton), 0)->joint_count;
  return at<format::SkeletonHeader>(nth(format::kSkeletons, h.skeleton), 0)->joint_count;
}

// A track's or a channel's keys.
template <class Keyed>
bool Checker::keys(const format::ClipHeader& h, const Keyed& t, std::uint32_t floats_per_key) {
  if (t.interpolation > Interpolation::cubic_spline) return fail(&t, "unknown interpolation");
  if (t.key_count == 0 || std::uint64_t{t.first_time} + t.key_count > h.time_count)
    return fail(&t, "keys outside the times");
  if (t.first_value + std::uint64_t{t.key_count} * floats_per_key > h.value_count)
    return fail(&t, "keys outside the values");
  return true;
}

std::uint32_t count_bits(std::uint32_t bits) {
  std::uint32_t count = 0;
  for (; bits != 0; bits &= bits - 1) ++count;
  return count;
}

bool Checker::masks(const format::CodedHeader& h, const GroupMasks* masks, std::uint32_t joint_count) {
  std::uint32_t moving = 0, constant = 0;
  for (std::uint32_t g = 0; g < soa_count(joint_count); ++g) {
    const std::uint32_t lanes = joint_count - 4 * g < 4 ? (1u << (joint_count - 4 * g)) - 1 : 15u;
    const std::uint32_t m = masks[g].moving, c = masks[g].constant;
    if (((m | c) & ~(lanes * 0x111u)) != 0) return fail(masks + g, "a coded track outside the skeleton");
    if ((m & c) != 0) return fail(masks + g, "a track moves or is constant");
    moving += count_bits(m);
    constant += count_bits(c);
  }
  if (constant != h.constant_count) return fail(&h.constant_count, "as many constant tracks as bits in the masks");
  return moving == h.track_count || fail(&h.track_count, "as many coded tracks as bits in the masks");
}

bool Checker::constants(const GroupMasks* masks, const format::Constant* next, std::uint32_t joint_count) {
  for (std::uint32_t g = 0; g < soa_count(joint_count); ++g) {
    const std::uint32_t bits = masks[g].constant;
    for (std::uint32_t i = count_bits(bits & 15u); i > 0; --i, ++next)
      if ((next->v[0] | next->v[1] | next->v[2] | next->v[3]) == 0) return fail(next, "a rotation is not zero");
    for (std::uint32_t i = count_bits(bits >> 4); i > 0; --i, ++next)
      if (next->v[3] < 0 || next->v[3] > 255) return fail(next, "a step from 0 to 255");
  }
  return true;
}

// Segments follow one another without a gap, so one pass sees every byte once.
bool Checker::segments(const File::Section& s, const format::CodedHeader& h, const format::CodedLayout& l) {
  const auto* offsets = at<std::uint32_t>(s, l.offsets);
  const std::uint64_t limit = h.payload_bytes - format::kPayloadPadding;
  std::uint64_t end = 0;
  for (std::uint32_t i = 0; i < format::segment_count(h); ++i) {
    if (offsets[i] != end) return fail(offsets + i, "segments stand back to back");
    end += 4 + std::uint64_t{h.track_count} * sizeof(format::TrackHeader);
    if (end > limit) return fail(offsets + i, "a segment outside the payload");
    const auto* segment = at<std::byte>(s, l.payload + offsets[i]);
    std::uint32_t frame_bytes;
    std::memcpy(&frame_bytes, segment, 4);
    std::uint64_t bits = 0;
    for (std::uint32_t t = 0; t < h.track_count; ++t) {
      format::TrackHeader track;
      std::memcpy(&track, segment + 4 + t * sizeof track, sizeof track);
      const std::uint32_t x = track.codes[0] >> 4u, y = track.codes[1] & 15u, z = track.codes[1] >> 4u;
      bits += format::component_bits(x) + format::component_bits(y) + format::component_bits(z);
    }
    if ((bits + 7) / 8 != frame_bytes) return fail(segment, "a frame's bytes hold its tracks' bits");
    const std::uint64_t left = h.frame_count - 1 - std::uint64_t{i} * h.segment_intervals;
    const std::uint64_t frames = (left < h.segment_intervals ? left : h.segment_intervals) + 1;
    end += frames * frame_bytes;
    if (end > limit) return fail(offsets + i, "a segment outside the payload");
  }
  return end == limit || fail(&h.payload_bytes, "payload behind the last segment");
}

bool Checker::coded(const File::Section& s, std::uint64_t start, std::uint32_t joint_count) {
  const auto* h = at<format::CodedHeader>(s, start);
  if (s.bytes - start < sizeof *h) return fail(block_.data + s.offset, "section too short for its header");
  if (h->reserved != 0) return fail(&h->reserved, "reserved must be 0");
  if (h->frame_count < 2 || h->frame_count > format::kMaxFrames) return fail(h, "2 to 16777216 frames");
  if (h->segment_intervals == 0) return fail(&h->segment_intervals, "a segment has intervals");
  if (!finite(&h->start_s, 8)) return false;
  if (!(h->frames_per_s > 0)) return fail(&h->frames_per_s, "frames a second");
  if (h->payload_bytes < format::kPayloadPadding) return fail(&h->payload_bytes, "payload without padding");
  const format::CodedLayout l = layout(*h, start, joint_count);
  if (l.bytes != s.bytes) return fail(h, "section size differs from its counts");
  const auto* groups = at<GroupMasks>(s, l.masks);
  return masks(*h, groups, joint_count) && constants(groups, at<format::Constant>(s, l.constants), joint_count) &&
         segments(s, *h, l);
}

bool Checker::clip_header(const File::Section& s) {
  if (s.codec > format::kCodecSegments) {
    error_ = {Status::unsupported, s.offset, "a codec that this build lacks"};
    return false;
  }
  const auto* h = at<format::ClipHeader>(s, 0);
  if (s.bytes < sizeof *h) return fail(block_.data + s.offset, "section too short for its header");
  const std::uint64_t raw_bytes = layout(*h).bytes;
  if (s.codec == format::kCodecRaw ? raw_bytes != s.bytes : raw_bytes > s.bytes)
    return fail(h, "section size differs from its counts");
  // One of the two is 0.
  if (h->skeleton >= counts_[format::kSkeletons] + counts_[format::kReferences])
    return fail(&h->skeleton, "no such skeleton");
  if (h->additive > 1) return fail(&h->additive, "additive is 0 or 1");
  const bool has_reference = h->reference_groups != 0;
  if (has_reference && (h->additive == 0 || h->reference_groups != soa_count(joint_count_of(*h))))
    return fail(&h->reference_groups, "a reference is an additive clip's and has all joints");
  if (!finite(at<float>(s, sizeof *h), std::uint64_t{h->reference_groups} * sizeof(SoaTransform))) return false;
  if (!name(h->name) || !finite(&h->duration_s, 4)) return false;
  return h->duration_s >= 0 || fail(&h->duration_s, "a duration is not negative");
}

// Lists of times follow one another, each shared by neighbouring tracks and channels: so one pass sees every list once.
class Lists {
 public:
  // Whether the list may stand here; `is_new` if it has not been seen.
  bool next(std::uint32_t first, std::uint32_t count, bool& is_new) {
    is_new = empty_ || first != first_ || first + count != end_;
    if (is_new && first != end_) return false;
    empty_ = false;
    first_ = first;
    end_ = first + count;
    return true;
  }
  std::uint32_t end() const { return end_; }

 private:
  bool empty_ = true;
  std::uint32_t first_ = 0, end_ = 0;
};

bool Checker::tracks(const File::Section& s, const format::ClipHeader& h, std::uint32_t joint_count) {
  const format::ClipLayout l = layout(h);
  const auto* times = at<float>(s, l.times);
  Lists lists;
  const auto in_order = [&](const auto& t) {
    bool is_new = false;
    if (!lists.next(t.first_time, t.key_count, is_new))
      return fail(&t, "a list of times is the last track's or follows it");
    const float* const key = times + t.first_time;
    for (std::uint32_t i = 1; is_new && i < t.key_count; ++i)
      if (!(key[i - 1] < key[i])) return fail(key + i, "times must increase");
    if (!(key[0] >= 0) || key[t.key_count - 1] > h.duration_s) return fail(key, "times from 0 to the duration");
    return true;
  };
  for (const Track& t : Span<const Track>{at<Track>(s, l.tracks), h.track_count}) {
    if (t.joint >= joint_count) return fail(&t, "track's joint outside the skeleton");
    if (t.path > Path::scale) return fail(&t, "unknown path");
    if (!keys(h, t, format::floats_per_key(t.path, t.interpolation)) || !in_order(t)) return false;
  }
  for (const Channel& c : Span<const Channel>{at<Channel>(s, l.channels), h.channel_count}) {
    if ((c.reserved[0] | c.reserved[1] | c.reserved[2]) != 0) return fail(c.reserved, "reserved must be 0");
    if (!name(c.name) || !finite(&c.rest, 4)) return false;
    if (!keys(h, c, format::floats_per_key(c.interpolation)) || !in_order(c)) return false;
  }
  return lists.end() == h.time_count || fail(&h.time_count, "times that no track uses");
}

bool Checker::clip(const File::Section& s) {
  if (!clip_header(s)) return false;
  const auto* h = at<format::ClipHeader>(s, 0);
  const format::ClipLayout l = layout(*h);
  const std::uint32_t joint_count = joint_count_of(*h);
  return finite(at<float>(s, l.times), l.bytes - l.times) && tracks(s, *h, joint_count) &&
         (s.codec == format::kCodecRaw || coded(s, l.bytes, joint_count));
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

// Each moves some blocks, in ascending order, and adds to what the geometry has; lists and records stand back to back.
bool Checker::morphs(const File::Section& s, const format::GeometryHeader& g) {
  const auto* h = at<format::MorphHeader>(s, format::morph_start(layout(g)));
  const format::MorphLayout l = layout(*h, layout(g));
  if (h->target_count == 0) return fail(h, "a flag without morph targets");
  if (h->reserved != 0) return fail(&h->reserved, "reserved must be 0");
  const std::uint32_t allowed = kMorphsPositions | ((g.flags & format::kHasNormals) != 0 ? kMorphsNormals : 0u) |
                                ((g.flags & format::kHasTangents) != 0 ? kMorphsTangents : 0u);
  std::uint64_t blocks = 0, records = 0;
  for (const MorphTarget& t : Span<const MorphTarget>{at<MorphTarget>(s, l.targets), h->target_count}) {
    if ((t.attributes & ~allowed) != 0) return fail(&t.attributes, "a target moves what the geometry has");
    if ((t.attributes == 0) != (t.block_count == 0)) return fail(&t.attributes, "what moves has blocks");
    if (t.first_block != blocks || t.first_record != records) return fail(&t, "targets stand back to back");
    if (t.reserved != 0) return fail(&t.reserved, "reserved must be 0");
    if (!finite(&t.position_step, 12)) return false;
    blocks += t.block_count;
    records += std::uint64_t{t.block_count} * count_bits(t.attributes);
    if (blocks > h->block_count || records > h->record_count) return fail(&t, "a target outside the records");
    const std::uint64_t first = l.blocks + std::uint64_t{t.first_block} * layout(g).index_bytes;
    const bool good = layout(g).index_bytes == 2 ? morph_blocks(at<std::uint16_t>(s, first), t, g.block_count)
                                                 : morph_blocks(at<std::uint32_t>(s, first), t, g.block_count);
    if (!good) return false;
  }
  return (blocks == h->block_count && records == h->record_count) || fail(h, "records that no target uses");
}

template <class Index>
bool Checker::morph_blocks(const Index* blocks, const MorphTarget& t, std::uint32_t block_count) {
  for (std::uint32_t i = 1; i < t.block_count; ++i)
    if (blocks[i - 1] >= blocks[i]) return fail(blocks + i, "a target's blocks ascend");
  return t.block_count == 0 || blocks[t.block_count - 1] < block_count ||
         fail(blocks + t.block_count - 1, "a target's block outside the vertices");
}

// The header, if the section is as long as its counts say; else null.
const format::GeometryHeader* Checker::geometry_header(const File::Section& s) {
  if (s.codec != format::kCodecRaw) {
    error_ = {Status::unsupported, s.offset, "a codec that this build lacks"};
    return nullptr;
  }
  const auto* h = at<format::GeometryHeader>(s, 0);
  if (s.bytes < sizeof *h) return fail(block_.data + s.offset, "section too short for its header"), nullptr;
  // The layout subtracts one weight a block, so every block must have an influence before sizes mean anything.
  if (h->influence_blocks < h->block_count) return fail(&h->influence_blocks, "a block has influences"), nullptr;
  const format::GeometryLayout l = layout(*h);
  std::uint64_t bytes = l.bytes;
  if ((h->flags & format::kHasMorphTargets) != 0) {
    const std::uint64_t start = format::morph_start(l);
    bytes = start + sizeof(format::MorphHeader);
    if (bytes <= s.bytes) bytes = layout(*at<format::MorphHeader>(s, start), l).bytes;
  }
  return bytes == s.bytes ? h : (fail(h, "section size differs from its counts"), nullptr);
}

bool Checker::geometry(const File::Section& s) {
  const auto* h = geometry_header(s);
  if (h == nullptr) return false;
  if (h->reserved != 0) return fail(&h->reserved, "reserved must be 0");
  if ((h->flags & ~std::uint32_t{format::kAllGeometryFlags}) != 0) return fail(&h->flags, "unknown flag");
  if (h->block_count > 0x3FFFFFFF) return fail(&h->block_count, "too many vertices");
  if (h->joint_count == 0 || h->joint_count > kMaxJoints) return fail(&h->joint_count, "1 to 32767 palette entries");
  if (h->index_count % 3 != 0) return fail(&h->index_count, "three indices a triangle");
  if ((h->flags & format::kHasSourceSlots) == 0 && h->source_vertex_count != 0)
    return fail(&h->source_vertex_count, "source vertices without slots");
  const format::GeometryLayout l = layout(*h);
  const std::uint64_t slots = std::uint64_t{h->block_count} * 4;
  const bool indices_fit =
      l.index_bytes == 2
          ? below(at<std::uint16_t>(s, l.indices), h->index_count, slots, "an index outside the vertices")
          : below(at<std::uint32_t>(s, l.indices), h->index_count, slots, "an index outside the vertices");
  return indices_fit && runs(*h, at<Run>(s, l.runs), at<std::uint16_t>(s, l.sets)) &&
         source_slots(at<std::uint32_t>(s, l.source_slots), h->source_vertex_count, slots) && finite(h->box_min, 24) &&
         finite(at<float>(s, l.skin), l.colours - l.skin) &&
         ((h->flags & format::kHasMorphTargets) == 0 || morphs(s, *h));
}

bool Checker::source_slots(const std::uint32_t* first, std::uint64_t count, std::uint64_t slots) {
  for (std::uint64_t i = 0; i < count; ++i)
    if (first[i] >= slots && first[i] != kNoSlot) return fail(first + i, "a slot outside the vertices");
  return true;
}

bool Checker::mesh(const File::Section& s) {
  const auto* h = header<format::MeshHeader>(s);
  if (h == nullptr) return false;
  if (h->material_section > counts_[format::kMaterials]) return fail(&h->material_section, "no such material");
  if ((h->flags & ~std::uint32_t{format::kAllMeshFlags}) != 0) return fail(&h->flags, "unknown flag");
  if (h->skeleton >= counts_[format::kSkeletons]) return fail(&h->skeleton, "no such skeleton");
  if (h->geometry >= counts_[format::kGeometries]) return fail(&h->geometry, "no such geometry");
  const auto* skeleton = at<format::SkeletonHeader>(nth(format::kSkeletons, h->skeleton), 0);
  const File::Section& of_geometry = nth(format::kGeometries, h->geometry);
  const auto* geometry = at<format::GeometryHeader>(of_geometry, 0);
  if (h->joint_count != geometry->joint_count) return fail(&h->joint_count, "as many joints as the geometry");
  const std::uint64_t morphs = format::morph_start(layout(*geometry));
  const bool has_targets = (geometry->flags & format::kHasMorphTargets) != 0;
  if (h->target_count != (has_targets ? at<format::MorphHeader>(of_geometry, morphs)->target_count : 0u))
    return fail(&h->target_count, "as many morph targets as the geometry");
  const format::MeshLayout l = layout(*h);
  for (const MeshTarget& t : Span<const MeshTarget>{at<MeshTarget>(s, l.targets), h->target_count})
    if (!name(t.name) || !name(t.channel) || !finite(&t.weight, 4)) return false;
  return name(h->name) && name(h->material) && finite(h->base_colour, 16) &&
         finite(at<float>(s, l.inverse_bind), l.targets - l.inverse_bind) &&
         below(at<std::uint16_t>(s, l.joints), h->joint_count, skeleton->joint_count, "a joint outside the skeleton");
}

bool Checker::texture(const Texture& t, std::uint32_t& roles) {
  if (t.image >= counts_[format::kImages]) return fail(&t, "no such image");
  if (t.role > TextureRole::emissive) return fail(&t.role, "unknown role of a texture");
  if (t.wrap_u > Wrap::mirrored_repeat || t.wrap_v > Wrap::mirrored_repeat) return fail(&t.wrap_u, "unknown wrap mode");
  if (t.mag > MagFilter::linear || t.min > MinFilter::linear_mipmap_linear) return fail(&t.mag, "unknown filter");
  if (t.reserved != 0) return fail(&t.reserved, "reserved must be 0");
  const std::uint32_t role = 1u << static_cast<std::uint32_t>(t.role);
  if ((roles & role) != 0) return fail(&t.role, "a role twice in one material");
  roles |= role;
  return true;
}

bool Checker::material(const File::Section& s) {
  const auto* h = header<format::MaterialHeader>(s);
  if (h == nullptr) return false;
  if (h->reserved != 0) return fail(&h->reserved, "reserved must be 0");
  if (h->alpha > AlphaMode::blend) return fail(&h->alpha, "unknown alpha mode");
  if (!name(h->name) || !finite(&h->alpha_cutoff, 4)) return false;
  if (!(h->alpha_cutoff >= 0)) return fail(&h->alpha_cutoff, "a cutoff is not negative");
  std::uint32_t roles = 0;
  for (const Texture& t : Span<const Texture>{at<Texture>(s, layout(*h).textures), h->texture_count})
    if (!texture(t, roles)) return false;
  return true;
}

bool Checker::image(const File::Section& s) {
  const auto* h = header<format::ImageHeader>(s);
  if (h == nullptr) return false;
  if ((h->reserved[0] | h->reserved[1] | h->reserved[2]) != 0) return fail(h->reserved, "reserved must be 0");
  if (h->format > ImageFormat::jpeg) return fail(&h->format, "unknown format of an image");
  if (h->byte_count > 0 && h->format == ImageFormat::unknown) return fail(&h->format, "bytes of an unknown format");
  return name(h->name) && name(h->uri);
}

bool Checker::property(const Property& p) {
  if ((p.reserved[0] | p.reserved[1] | p.reserved[2]) != 0) return fail(p.reserved, "reserved must be 0");
  if (p.type > PropertyType::text) return fail(&p.type, "unknown type of a property");
  if (!name(p.name)) return false;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &p.number, sizeof bits);
  if (p.type == PropertyType::text) return bits >> 32 != 0 ? fail(&p.number, "reserved must be 0") : name(p.text);
  if ((bits >> 52 & 0x7FF) == 0x7FF) return fail(&p.number, "a number that is not finite");
  const bool truth = p.type == PropertyType::boolean;
  return !truth || bits == 0 || p.number == 1 || fail(&p.number, "a boolean is 0 or 1");
}

bool Checker::node(const File::Section& s) {
  const auto* h = header<format::NodeHeader>(s);
  if (h == nullptr) return false;
  if (h->reserved != 0) return fail(&h->reserved, "reserved must be 0");
  if (h->skeleton >= counts_[format::kSkeletons]) return fail(&h->skeleton, "no such skeleton");
  const auto* skeleton = at<format::SkeletonHeader>(nth(format::kSkeletons, h->skeleton), 0);
  if (h->joint != kNoJoint && h->joint >= skeleton->joint_count) return fail(&h->joint, "a joint outside the skeleton");
  if (!name(h->name) || !finite(&h->joint_from_node, sizeof h->joint_from_node)) return false;
  for (const Property& p : Span<const Property>{at<Property>(s, layout(*h).properties), h->property_count})
    if (!property(p)) return false;
  return true;
}

// Kinds stand in ascending order, so a section may lean on those before it; names are checked first.
bool Checker::all() {
  if (!names(sections_[sections_.size - 1])) return false;
  for (const File::Section& s : sections_) {
    const bool good = s.type == format::kTypes[format::kSkeletons]    ? skeleton(s)
                      : s.type == format::kTypes[format::kReferences] ? reference(s)
                      : s.type == format::kTypes[format::kClips]      ? clip(s)
                      : s.type == format::kTypes[format::kGeometries] ? geometry(s)
                      : s.type == format::kTypes[format::kMeshes]     ? mesh(s)
                      : s.type == format::kTypes[format::kMaterials]  ? material(s)
                      : s.type == format::kTypes[format::kImages]     ? image(s)
                      : s.type == format::kTypes[format::kNodes]      ? node(s)
                                                                      : true;
    if (!good) return false;
  }
  return true;
}

// Header and section table: sizes exact, sections back to back on 16-byte boundaries, kinds in order, one set of names.
DataError check_container(Span<const std::byte> block) {
  const auto bad = [](std::size_t offset, const char* rule) {
    return DataError{Status::bad_data, static_cast<std::uint32_t>(offset), rule};
  };
  if (block.size < sizeof(format::Header)) return {Status::truncated, 0, "32 bytes of header"};
  format::Header h;
  std::memcpy(&h, block.data, sizeof h);
  if (h.magic == format::kPackedMagic)
    return {Status::unsupported, 0, "a packed file: unpack() it first (marrow/unpack.h)"};
  if (h.magic != format::kMagic) return {Status::bad_magic, 0, "begins with MRRW"};
  if (h.version != format::kVersion) return {Status::bad_version, 4, "format version 1; cook the source again"};
  if (h.file_bytes > block.size) return {Status::truncated, 8, "the file ends before its stated size"};
  if (h.file_bytes < block.size) return bad(8, "bytes behind the end");
  if (h.reserved != 0) return bad(24, "reserved must be 0");
  std::uint64_t end = sizeof(format::Header) + std::uint64_t{h.section_count} * sizeof(File::Section);
  if (h.section_count == 0 || end > block.size) return bad(12, "section table outside the file");
  if (format::checksum(block.data + sizeof h, block.size - sizeof h) != h.checksum)
    return {Status::bad_checksum, 16, "checksum of everything behind the header"};
  std::uint32_t kind = 0;
  for (std::uint32_t i = 0; i < h.section_count; ++i) {
    const std::size_t entry = sizeof h + i * sizeof(File::Section);
    File::Section s;
    std::memcpy(&s, block.data + entry, sizeof s);
    while (kind < format::kKindCount && s.type != format::kTypes[kind]) ++kind;
    if (kind == format::kKindCount)
      return bad(entry, "section types in order: SKEL SREF CLIP GEOM MESH MATL IMAG NODE NAME");
    if (s.offset != format::align16(end)) return bad(entry + 4, "sections stand back to back");
    if (s.offset > block.size || s.bytes > block.size - s.offset) return bad(entry + 8, "section outside the file");
    for (std::uint64_t pad = end; pad < s.offset; ++pad)
      if (block[pad] != std::byte{0}) return bad(pad, "padding must be 0");
    end = std::uint64_t{s.offset} + s.bytes;
    if (kind == format::kNames && i + 1 != h.section_count) return bad(entry, "one section of names, the last");
  }
  if (kind != format::kNames) return bad(sizeof h, "no section of names");
  if (end != block.size) return bad(8, "the last section ends the file");
  return {};
}

}  // namespace

Status load(Span<const std::byte> block, File& out, DataError* error) {
  MARROW_REQUIRE(block.data != nullptr);
  MARROW_REQUIRE(reinterpret_cast<std::uintptr_t>(block.data) % 16 == 0);
  DataError found = check_container(block);
  if (found.status == Status::ok) {
    const auto* header = reinterpret_cast<const format::Header*>(block.data);
    File file;
    file.block_ = block.data;
    file.sections_ = {reinterpret_cast<const File::Section*>(header + 1), header->section_count};
    for (std::uint32_t i = 0; i < header->section_count; ++i)
      for (std::uint32_t kind = 0; kind < format::kKindCount; ++kind)
        if (file.sections_[i].type == format::kTypes[kind] && file.counts_[kind]++ == 0) file.first_[kind] = i;
    Checker checker(block, file.sections_, file.first_, file.counts_);
    if (checker.all()) {
      out = file;
    } else {
      found = checker.error();
    }
  }
  if (error != nullptr) *error = found;
  return found.status;
}

}  // namespace marrow
