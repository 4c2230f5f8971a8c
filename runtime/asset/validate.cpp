// load: every rule of docs/format.md, checked once, so that no later stage has to.
#include <cstring>

#include "asset/checker.h"
#include "core/check.h"
#include "core/mark.h"
#include "core/off_boundary.h"

namespace marrow {
namespace {

// How a section begins.
struct Beginning {
  std::uint8_t kind, header_bytes, last_codec = format::kCodecRaw;
};
// Kinds stand in one order, so a section may lean on those before it.
constexpr Beginning kBeginnings[] = {
    {format::kSkeletons, sizeof(format::SkeletonHeader)},
    {format::kReferences, sizeof(format::ReferenceHeader)},
    {format::kClips, sizeof(format::ClipHeader), format::kCodecSegments},
    {format::kGeometries, sizeof(format::GeometryHeader)},
    {format::kMeshes, sizeof(format::MeshHeader)},
    {format::kMaterials, sizeof(format::MaterialHeader)},
    {format::kImages, sizeof(format::ImageHeader)},
    {format::kNodes, sizeof(format::NodeHeader)},
    {format::kLimits, sizeof(format::LimitHeader)},
    {format::kSprings, sizeof(format::SpringHeader)},
    {format::kBounds, sizeof(format::BoundsHeader)},
};

}  // namespace

bool Checker::fail(const void* where, const char* rule) {
  if (error_.status == Status::ok) {
    const auto offset = static_cast<const std::byte*>(where) - block_.data;
    error_ = {Status::bad_data, static_cast<std::uint32_t>(offset), rule};
  }
  return false;
}

bool Checker::has_header(const File::Section& s, std::uint32_t header_bytes, std::uint32_t last_codec) {
  if (s.codec > last_codec) {
    error_ = {Status::unsupported, s.offset, "a codec that this build lacks"};
    return false;
  }
  return s.bytes >= header_bytes || fail(start_of(s), "section too short for its header");
}

// In one pass without a branch a float.
const void* Checker::first_beyond(std::uint32_t limit, const void* first, std::uint64_t bytes) {
  const auto* words = static_cast<const std::uint32_t*>(first);
  const std::uint64_t count = bytes / 4;
  std::uint32_t bad = 0;
  const auto most = static_cast<std::int32_t>(limit);  // what has a sign is compared more quickly
  for (std::uint64_t i = 0; i < count; ++i) bad |= static_cast<std::int32_t>(words[i] & 0x7FFFFFFFu) >= most;
  if (bad == 0) return nullptr;
  while ((*words & 0x7FFFFFFFu) < limit) ++words;
  return words;
}

bool Checker::text(const std::uint32_t& n) {
  return n < sections_[sections_.size - 1].bytes || fail(&n, "name outside the name section");
}

bool Checker::name(const std::uint32_t& n) {
  if (!text(n)) return false;
  const File::Section& s = sections_[sections_.size - 1];
  const std::uint64_t left = s.bytes - n;  // the last byte is a zero
  return left <= format::kLongestName + 1 ||
         std::memchr(at<char>(start_of(s), n), 0, format::kLongestName + 1) != nullptr ||
         fail(&n, "a name of more than 2047 bytes");
}

bool Checker::names(const File::Section& s) {
  const auto* const letters = at<char>(start_of(s), 0);
  if (s.codec != format::kCodecRaw) return fail(letters, "names have no codec");
  return (s.bytes != 0 && letters[0] == 0 && letters[s.bytes - 1] == 0) ||
         fail(letters, "names must begin with the empty one and end with a zero");
}

std::uint32_t Checker::value(RuleNumber n) const {
  const auto* const p = static_cast<const std::uint8_t*>(place(n));
  std::uint32_t out = p[0];
  if (n.bytes > 1) out |= std::uint32_t{p[1]} << 8;
  if (n.bytes > 2) std::memcpy(&out, p, 4);
  return out;
}

bool Checker::find_owner(std::uint32_t number, bool or_reference) {
  const format::Kind kind =
      or_reference && counts_[format::kReferences] != 0 ? format::kReferences : format::kSkeletons;
  if (number >= counts_[kind]) return false;
  base(From::owner) = start_of(nth(kind, number));
  return true;
}

bool Checker::keeps_each(const Rule* rule) {
  const auto* const last = at<std::byte>(value(rule->limit));
  for (const auto* element = at<std::byte>(value(rule->number)); element < last; element += rule->count)
    if (!keeps(rule + 1, element)) return false;
  return true;
}

// Of a number and a limit.
bool Checker::agree(How how, std::uint32_t a, std::uint32_t b) {
  switch (how) {
    case How::equal:
      return a == b;
    case How::below:
      return a < b;
    case How::at_most:
      return a <= b;
    case How::at_least:
      return a >= b;
    case How::where_differ:
    case How::differ:
      return a != b;
    case How::from_1_to:
      return a - 1 < b;
    case How::only_bits:
      return (a & ~b) == 0;
    case How::where_bits:
      return (a & b) != 0;
    case How::where_lacks:
      return (a & b) == 0;
    case How::not_negative:
      return bit_cast<float>(a) >= 0;
    default:
      return bit_cast<float>(a) > 0;
  }
}

// What is no matter of a number and a limit. where: the place that is told, which may be another one.
bool Checker::keeps_other(const Rule& rule, const void*& where, std::uint32_t a, std::uint32_t b) {
  switch (static_cast<How>(rule.how)) {
    case How::floats:
    case How::floats_until: {
      const bool until = static_cast<How>(rule.how) == How::floats_until;
      const void* const beyond = until ? first_beyond(constants_of_rules()[rule.count], at<float>(a), b - a)
                                       : first_beyond(b, where, std::uint64_t{rule.count} * 4);
      if (beyond != nullptr && rule.back == 0) where = beyond;
      return beyond == nullptr;
    }
    case How::name:
      return name(*static_cast<const std::uint32_t*>(where));
    case How::text:
      return text(*static_cast<const std::uint32_t*>(where));
    case How::owner:
      return find_owner(a, rule.count != 0);
    case How::each:
      return keeps_each(&rule);
    case How::array:
      add_array(std::uint64_t{a} * b * rule.count);
      return true;
    case How::groups:
      add_array(soa_count(a) * rule.count);
      return true;
    case How::aligned:
      places_[arrays_] = format::align4(places_[arrays_]);
      return true;
    case How::fills:
      return section_->bytes == places_[arrays_];
    default:
      return keeps(static_cast<Check>(rule.count), b);
  }
}

bool Checker::keeps(const Rule* rule, const void* record) {
  const void* const before = base(From::record);
  base(From::record) = record;
  for (; static_cast<How>(rule->how) > How::ends; ++rule) {
    const void* where = place(rule->number);
    const auto how = static_cast<How>(rule->how);
    const std::uint32_t a = value(rule->number), b = value(rule->limit);
    const bool good = how < How::floats ? agree(how, a, b) : keeps_other(*rule, where, a, b);
    if (how < How::equal) {
      rule += !good;
    } else if (!good) {
      return fail(static_cast<const std::byte*>(where) - rule->back, text_of(*rule));
    } else if (how == How::each) {
      while (static_cast<How>(rule->how) != How::ends) ++rule;
    }
  }
  base(From::record) = before;
  return true;
}

bool Checker::all() {
  if (!names(sections_[sections_.size - 1])) return false;
  for (const Beginning& b : kBeginnings)
    for (std::uint32_t i = 0; i < counts_[b.kind]; ++i) {
      section_ = &nth(static_cast<format::Kind>(b.kind), i);
      if (!has_header(*section_, b.header_bytes, b.last_codec)) return false;
      base(From::header) = start_of(*section_);
      so_far_ = {};
      begin_arrays(0, b.header_bytes);
      if (!keeps(rules_of(b.kind), base(From::header))) return false;
    }
  return true;
}

// Whether it holds; if not, it may have said where and why.
bool Checker::keeps(Check check, std::uint32_t limit) {
  if (check < Check::geometry_size) return keeps_of_clip(check);
  return check < Check::joints ? keeps_of_mesh(check, limit) : keeps_of_others(check);
}

namespace {

// Header and section table: sizes exact, sections back to back on 16-byte boundaries, kinds in order, one set of names.
// Tells for each kind the first section and how many there are.
DataError check_container(Span<const std::byte> block, std::uint32_t* first, std::uint32_t* counts) {
  const auto bad = [](std::size_t offset, const char* rule) {
    return DataError{Status::bad_data, static_cast<std::uint32_t>(offset), rule};
  };
  if (block.size < sizeof(format::Header)) return {Status::truncated, 0, "32 bytes of header"};
  const auto& h = *reinterpret_cast<const format::Header*>(block.data);
  if (h.magic == format::kPackedMagic)
    return {Status::unsupported, 0, "a packed file: unpack() it first (marrow/unpack.h)"};
  if (h.magic != format::kMagic) return {Status::bad_magic, 0, "begins with MRRW"};
  if (h.version != format::kVersion)
    return {Status::bad_version, 4, "cooked for another format version; cook the source again"};
  if (h.file_bytes > block.size) return {Status::truncated, 8, "the file ends before its stated size"};
  if (h.file_bytes < block.size) return bad(8, "bytes behind the end");
  if (h.reserved != 0) return bad(24, "reserved must be 0");
  std::uint64_t end = sizeof(format::Header) + std::uint64_t{h.section_count} * sizeof(File::Section);
  if (h.section_count == 0 || end > block.size) return bad(12, "section table outside the file");
  if (format::checksum(block.data + sizeof h, block.size - sizeof h) != h.checksum)
    return {Status::bad_checksum, 16, "checksum of everything behind the header"};
  std::uint32_t place = 0;  // in format::kOrder
  for (std::uint32_t i = 0; i < h.section_count; ++i) {
    const std::size_t entry = sizeof h + i * sizeof(File::Section);
    const auto& s = *reinterpret_cast<const File::Section*>(block.data + entry);
    while (place < format::kKindCount && s.type != format::kTypes[format::kOrder[place]]) ++place;
    if (place == format::kKindCount)
      return bad(entry, "section types in order: SKEL SREF CLIP GEOM MESH MATL IMAG NODE LIMI SPRI SHAP BNDS NAME");
    if (s.offset != format::align16(end)) return bad(entry + 4, "sections stand back to back");
    if (s.offset > block.size || s.bytes > block.size - s.offset) return bad(entry + 8, "section outside the file");
    for (; end < s.offset; ++end)
      if (block[static_cast<std::size_t>(end)] != std::byte{0})
        return bad(static_cast<std::size_t>(end), "padding must be 0");
    end += s.bytes;
    const format::Kind kind = format::kOrder[place];
    if (kind == format::kNames && i + 1 != h.section_count) return bad(entry, "one section of names, the last");
    if (counts[kind]++ == 0) first[kind] = i;
  }
  if (counts[format::kNames] == 0) return bad(sizeof h, "no section of names");
  if (end != block.size) return bad(8, "the last section ends the file");
  return {};
}

}  // namespace

Status load(Span<const std::byte> block, File& out, DataError* error) {
  MARROW_MARK;
  if (error != nullptr) {
    const char* const off = off_boundary(block.data);
    *error = {Status::bad_argument, 0, off != nullptr ? off : "a block that is not null"};
  }
  MARROW_REQUIRE(block.data != nullptr);
  MARROW_REQUIRE_GOOD(check_boundary(block.data));
  File file;
  DataError found = check_container(block, file.first_, file.counts_);
  if (found.status == Status::ok) {
    const auto* header = reinterpret_cast<const format::Header*>(block.data);
    file.block_ = block.data;
    file.sections_ = {reinterpret_cast<const File::Section*>(header + 1), header->section_count};
    Checker checker(block, file.sections_, file.first_, file.counts_);
    if (checker.all()) out = file;
    found = checker.error();
  }
  if (error != nullptr) *error = found;
  return found.status;
}

}  // namespace marrow
