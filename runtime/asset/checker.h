// Keeps files to the rules of docs/format.md: a table of them (file_rules.h), and those that are code (check_*.cpp).
#pragma once

#include <cstring>

#include "asset/file_rules.h"
#include "asset/format.h"
#include "core/builtins.h"

namespace marrow {

// A block under examination: the first broken rule is kept with its place.
class Checker {
 public:
  // first, counts: for each kind of section, its first one and how many there are.
  Checker(Span<const std::byte> block, Span<const File::Section> sections, const std::uint32_t* first,
          const std::uint32_t* counts)
      : block_(block), sections_(sections), first_(first), counts_(counts) {
    base(From::counts) = counts;
    base(From::arrays) = places_;
    base(From::constants) = constants_of_rules();
  }

  bool all();
  // Of a whole file: all() leaves it out, so that a game without links none of it.
  bool example_space(std::uint32_t index);
  const DataError& error() const { return error_; }

 private:
  // Keeps the first; false.
  [[gnu::cold]] bool fail(const void* where, const char* rule);
  // Whether the section is long enough for a header, and its codec one of those up to `last_codec`.
  bool has_header(const File::Section& s, std::uint32_t header_bytes, std::uint32_t last_codec);
  bool names(const File::Section& s);
  // Names are compared with others, so how long they are has a limit; text() is only handed out.
  bool name(const std::uint32_t& n);
  bool text(const std::uint32_t& n);
  // The first float that is not, without its sign, less than the one with the limit's bits; null if all are. What is
  // not finite has the largest bits.
  static const void* first_beyond(std::uint32_t limit, const void* first, std::uint64_t bytes);

  // Rules from `rule` to the end of the list, about `record`.
  bool keeps(const Rule* rule, const void* record);
  static bool agree(How how, std::uint32_t a, std::uint32_t b);
  bool keeps_other(const Rule& rule, const void*& where, std::uint32_t a, std::uint32_t b);
  bool keeps_each(const Rule* rule);
  bool keeps(Check check, std::uint32_t limit);
  bool keeps_of_clip(Check check);
  bool keeps_of_mesh(Check check, std::uint32_t limit);
  bool keeps_of_others(Check check);
  const void* place(RuleNumber n) const { return at<std::byte>(bases_[n.from], n.at); }
  std::uint32_t value(RuleNumber n) const;
  // Arrays begin behind a header.
  void begin_arrays(std::size_t place, std::uint64_t at) {
    arrays_ = static_cast<std::uint32_t>(place);
    places_[arrays_] = at;
  }
  void add_array(std::uint64_t bytes) {
    places_[arrays_ + 1] = places_[arrays_] + bytes;
    ++arrays_;
  }
  bool find_owner(std::uint32_t number, bool or_reference);

  const void*& base(From from) { return bases_[static_cast<std::size_t>(from)]; }
  const void* base(From from) const { return bases_[static_cast<std::size_t>(from)]; }
  // The section, its header, and what is looked at.
  template <class T>
  const T* at(std::uint64_t offset) const {
    return at<T>(base(From::header), offset);
  }
  template <class T>
  static const T* at(const void* start, std::uint64_t offset) {
    return reinterpret_cast<const T*>(static_cast<const std::byte*>(start) + offset);
  }
  template <class T>
  const T* array(std::size_t n) const {
    return at<T>(places_[n]);
  }
  template <class T>
  const T& record() const {
    return *static_cast<const T*>(base(From::record));
  }
  template <class Header>
  const Header& header() const {
    return *static_cast<const Header*>(base(From::header));
  }
  const void* start_of(const File::Section& s) const { return block_.data + s.offset; }
  const File::Section& nth(format::Kind kind, std::uint32_t n) const { return sections_[first_[kind] + n]; }
  // Of the skeleton or reference that the section is for.
  std::uint32_t joint_count() const {
    return static_cast<const format::SkeletonHeader*>(base(From::owner))->joint_count;
  }

  bool joints(const std::uint16_t* parents, const std::uint32_t* joint_names, std::uint32_t root_count);
  bool reference_joints();
  bool clip_size();
  bool keys(const std::uint32_t* k, std::uint32_t floats_per_key);
  bool track();
  bool turning_keys(const Track& t);
  bool coded();
  bool frame_times();
  bool masks();
  bool constants();
  bool segments();
  bool geometry_size();
  bool part_size(std::uint32_t flag, std::size_t place, std::size_t header_bytes, Part arrays);
  std::uint32_t index_bytes() const { return static_cast<std::uint32_t>(places_[kIndexBytesPlace]); }
  template <class Index>
  bool below(const Index* first, std::uint64_t count, std::uint64_t limit, const char* rule);
  bool indices();
  bool runs();
  bool sets();
  bool source_slots();
  struct SparseRecords {
    Span<const MorphTarget> targets;
    std::uint64_t blocks;  // where they stand
    std::uint64_t block_count, record_count;
    std::uint32_t allowed;  // attributes
  };
  bool sparse_records(const SparseRecords& r);
  bool morph_blocks(const void* blocks, const MorphTarget& t);
  bool targets();
  bool examples();
  const format::GeometryHeader& geometry(std::uint32_t number) const;
  std::uint32_t target_count(std::uint32_t of_geometry) const;
  bool next_part();
  bool mesh_joints();
  bool fallback();
  bool only_of_owner();
  bool box() const;
  bool chain_joints();

  Span<const std::byte> block_;
  Span<const File::Section> sections_;
  const std::uint32_t* first_;
  const std::uint32_t* counts_;
  // What follows is of the section.
  const File::Section* section_;
  const void* bases_[static_cast<std::size_t>(From::count)];  // by From
  std::uint64_t places_[kPlaceCount];  // of arrays behind the header; the next one will stand at places_[arrays_]
  std::uint32_t arrays_;
  // What is gone through in order, and began at the header.
  struct {
    std::uint32_t first_time, times_end, next_joint, roles;
    bool has_times;
    std::uint64_t first_value, values_end;  // of what tracks use, and what is between
    std::uint64_t turning;                  // values of rotations, each time that a track uses them
  } so_far_;
  DataError error_;
};

// Of two quaternions of which each number stands `stride` behind the one before it.
inline float dot_of_rotations(const float* a, const float* b, std::size_t stride = 1) {
  return a[0] * b[0] + a[stride] * b[stride] + a[2 * stride] * b[2 * stride] + a[3 * stride] * b[3 * stride];
}

inline std::uint32_t count_bits(std::uint32_t bits) {
  std::uint32_t count = 0;
  for (; bits != 0; bits &= bits - 1) ++count;
  return count;
}

}  // namespace marrow
