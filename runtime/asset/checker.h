// The rules of docs/format.md, section by section; validate.cpp goes through a block with them.
#pragma once

#include <cstring>

#include "asset/format.h"
#include "core/builtins.h"

namespace marrow {

// A block under examination: the first broken rule is kept with its place.
class Checker {
 public:
  // first, counts: for each kind of section, its first one and how many there are.
  Checker(Span<const std::byte> block, Span<const File::Section> sections, const std::uint32_t* first,
          const std::uint32_t* counts)
      : block_(block), sections_(sections), first_(first), counts_(counts) {}

  bool all();
  // Of a whole file: all() leaves it out, so that a game without links none of it.
  bool example_space(std::uint32_t index);
  const DataError& error() const { return error_; }

 private:
  [[gnu::cold]] void note(const void* where, const char* broken_rule);
  bool fail(const void* where, const char* rule) {
    note(where, rule);
    return false;
  }
  // Whether the section is long enough for a header, and its codec one of those up to `last_codec`.
  bool has_header(const File::Section& s, std::uint32_t header_bytes, std::uint32_t last_codec);
  bool has_bytes(const File::Section& s, std::uint64_t bytes);
  // Of a section that has one: null unless its arrays fill the section.
  template <class Header>
  const Header* header(const File::Section& s) {
    const auto* h = at<Header>(s, 0);
    using format::layout;  // and those of other headers than format.h
    return has_bytes(s, layout(*h).bytes) ? h : nullptr;
  }
  template <class T>
  const T* at(const File::Section& s, std::uint64_t offset) const {
    return at<T>(block_.data + s.offset, offset);
  }
  // From the beginning of a section, or of what stands in one.
  template <class T>
  static const T* at(const void* start, std::uint64_t offset) {
    return reinterpret_cast<const T*>(static_cast<const std::byte*>(start) + offset);
  }

  // Names are compared with others, so how long they are has a limit; text() is only handed out.
  bool name(const std::uint32_t& n);
  bool text(const std::uint32_t& n);
  bool finite(const void* first, std::uint64_t bytes);
  // Finite, and at most format::kFarthest: what becomes matrices that are multiplied.
  bool bounded(const void* first, std::uint64_t bytes);
  // Quaternions of unit length but for rounding: their squares are multiplied with scales.
  bool units(const void* first, std::uint64_t bytes);
  bool transforms(const SoaTransform* first, std::uint64_t count);
  bool below_bits(const void* first, std::uint64_t bytes, std::uint32_t least, const char* rule);
  bool names(const File::Section& s);
  bool skeleton(const File::Section& s);
  bool reference(const File::Section& s);
  bool joints(const std::uint16_t* parents, const std::uint32_t* joint_names, std::uint32_t count,
              std::uint32_t root_count);
  std::uint32_t joint_count_of(const format::ClipHeader& h) const;
  bool clip(const File::Section& s);
  bool clip_header(const File::Section& s);
  bool tracks(const format::ClipHeader& h, std::uint32_t joint_count);
  struct KeyList;
  class TimeLists;
  bool keys(const format::ClipHeader& h, const KeyList& k, TimeLists& lists);
  bool coded(const File::Section& s, std::uint64_t start, std::uint32_t joint_count);
  bool masks(const format::CodedHeader& h, const GroupMasks* masks, std::uint32_t joint_count);
  bool constants(const GroupMasks* masks, const format::Constant* next, std::uint32_t joint_count);
  bool segments(const std::byte* section, const format::CodedHeader& h, const format::CodedLayout& l);
  bool geometry(const File::Section& s);
  bool morphs(const format::GeometryHeader& h);
  bool pose_space(const format::GeometryHeader& h);
  struct SparseRecords {
    Span<const MorphTarget> targets;
    std::uint64_t blocks;  // where they stand
    std::uint64_t block_count, record_count;
    std::uint32_t allowed;  // attributes
  };
  bool sparse_records(const format::GeometryHeader& h, const SparseRecords& r);
  bool geometry_size(const File::Section& s, const format::GeometryHeader& h);
  bool morph_blocks(const void* blocks, std::uint32_t index_bytes, const MorphTarget& t, std::uint32_t block_count);
  bool runs(const format::GeometryHeader& h, const Run* runs, const std::uint16_t* sets);
  template <class Index>
  bool below(const Index* first, std::uint64_t count, std::uint64_t limit, const char* rule);
  bool source_slots(const std::uint32_t* first, std::uint64_t count, std::uint64_t slots);
  std::uint32_t target_count(std::uint32_t of_geometry) const;
  bool lods(Span<const MeshLod> lods, const format::MeshHeader& h);
  bool mesh(const File::Section& s);
  bool next_part(const File::Section& s, const format::MeshHeader& h);
  bool material(const File::Section& s);
  bool texture(const Texture& t, std::uint32_t& roles);
  bool image(const File::Section& s);
  bool fallback(const format::ImageHeader& h);
  bool node(const File::Section& s);
  bool property(const Property& p);
  bool limits(const File::Section& s);
  bool bounds(const File::Section& s);
  bool springs(const File::Section& s);
  bool spring_chain(const format::SpringHeader& h, const format::SpringRecord& chain, const SpringJoint* joints);

  const format::SkeletonHeader* skeleton_of(const std::uint32_t& number);
  const format::SkeletonHeader* only_of_skeleton(const File::Section& s, const char* rule);
  const File::Section& nth(format::Kind kind, std::uint32_t n) const { return sections_[first_[kind] + n]; }

  Span<const std::byte> block_;
  Span<const File::Section> sections_;
  const std::uint32_t* first_;
  const std::uint32_t* counts_;
  DataError error_;
};

inline std::uint32_t count_bits(std::uint32_t bits) {
  std::uint32_t count = 0;
  for (; bits != 0; bits &= bits - 1) ++count;
  return count;
}

}  // namespace marrow
