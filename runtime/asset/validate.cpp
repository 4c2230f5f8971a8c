// load: every rule of docs/format.md, checked once, so that no later stage has to.
#include <cstring>

#include "asset/checker.h"
#include "core/check.h"
#include "core/mark.h"
#include "core/off_boundary.h"

namespace marrow {

using format::layout;

void Checker::note(const void* where, const char* broken_rule) {
  const auto offset = static_cast<const std::byte*>(where) - block_.data;
  error_ = {Status::bad_data, static_cast<std::uint32_t>(offset), broken_rule};
}

bool Checker::has_header(const File::Section& s, std::uint32_t header_bytes, std::uint32_t last_codec) {
  if (s.codec > last_codec) {
    error_ = {Status::unsupported, s.offset, "a codec that this build lacks"};
    return false;
  }
  return s.bytes >= header_bytes || fail(at<std::byte>(s, 0), "section too short for its header");
}

bool Checker::has_bytes(const File::Section& s, std::uint64_t bytes) {
  return s.bytes == bytes || fail(at<std::byte>(s, 0), "section size differs from its counts");
}

const format::SkeletonHeader* Checker::skeleton_of(const std::uint32_t& number) {
  if (number >= counts_[format::kSkeletons]) return fail(&number, "no such skeleton"), nullptr;
  return at<format::SkeletonHeader>(nth(format::kSkeletons, number), 0);
}

// Of a section that begins with the number of a skeleton, which has one section of this type.
const format::SkeletonHeader* Checker::only_of_skeleton(const File::Section& s, const char* rule) {
  const auto& number = *at<std::uint32_t>(s, 0);
  const auto* const skeleton = skeleton_of(number);
  if (skeleton == nullptr) return nullptr;
  const File::Section& before = *(&s - 1);  // of a skeleton, if of no other
  if (before.type == s.type && *at<std::uint32_t>(before, 0) >= number) return fail(&number, rule), nullptr;
  return skeleton;
}

// Whether all floats are, without their signs, less than the one with these bits; in one pass without a branch a float.
// What is not finite has the largest bits.
bool Checker::below_bits(const void* first, std::uint64_t bytes, std::uint32_t least, const char* rule) {
  const auto* words = static_cast<const std::uint32_t*>(first);
  const std::uint64_t count = bytes / 4;
  std::uint32_t bad = 0;
  for (std::uint64_t i = 0; i < count; ++i) bad |= (words[i] & 0x7FFFFFFFu) >= least;
  if (bad == 0) return true;
  std::uint64_t i = 0;
  while ((words[i] & 0x7FFFFFFFu) < least) ++i;
  return fail(words + i, rule);
}

bool Checker::finite(const void* first, std::uint64_t bytes) {
  return below_bits(first, bytes, 0x7F800000, "a number that is not finite");
}

bool Checker::bounded(const void* first, std::uint64_t bytes) {
  return below_bits(first, bytes, bit_cast<std::uint32_t>(format::kFarthest) + 1,
                    "a number that is not finite, or beyond 1e12");
}

bool Checker::units(const void* first, std::uint64_t bytes) {
  return below_bits(first, bytes, bit_cast<std::uint32_t>(1.01f), "a rotation that is no unit quaternion");
}

// Of a pose.
bool Checker::transforms(const SoaTransform* first, std::uint64_t count) {
  if (!bounded(first, count * sizeof *first)) return false;
  for (std::uint64_t i = 0; i < count; ++i)
    if (!units(first[i].rotation, sizeof first[i].rotation)) return false;
  return true;
}

bool Checker::text(const std::uint32_t& n) {
  return n < sections_[sections_.size - 1].bytes || fail(&n, "name outside the name section");
}

bool Checker::name(const std::uint32_t& n) {
  if (!text(n)) return false;
  const File::Section& s = sections_[sections_.size - 1];
  const std::uint64_t left = s.bytes - n;  // the last byte is a zero
  return left <= format::kLongestName + 1 || std::memchr(at<char>(s, n), 0, format::kLongestName + 1) != nullptr ||
         fail(&n, "a name of more than 2047 bytes");
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
  const auto* parents = at<std::uint16_t>(h, l.parents);
  const auto* joint_names = at<std::uint32_t>(h, l.names);
  return joints(parents, joint_names, h->joint_count, h->root_count) && name(h->name) &&
         bounded(at<float>(h, l.roots), l.rest - l.roots) &&
         transforms(at<SoaTransform>(h, l.rest), soa_count(h->joint_count));
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
  const auto* parents = at<std::uint16_t>(h, l.parents);
  std::uint32_t roots = 0;
  while (roots < h->joint_count && parents[roots] == kNoParent) ++roots;
  if (roots == 0) return fail(parents, "the first joint has no parent");
  return joints(parents, at<std::uint32_t>(h, l.names), h->joint_count, roots) && name(h->name);
}

// Kinds stand in one order, so a section may lean on those before it; names are checked first.
bool Checker::all() {
  if (!names(sections_[sections_.size - 1])) return false;
  struct Rules {
    format::Kind kind;
    std::uint32_t header_bytes, last_codec;
    bool (Checker::*check)(const File::Section& s);
  };
  static constexpr Rules kRules[] = {
      {format::kSkeletons, sizeof(format::SkeletonHeader), format::kCodecRaw, &Checker::skeleton},
      {format::kReferences, sizeof(format::ReferenceHeader), format::kCodecRaw, &Checker::reference},
      {format::kClips, sizeof(format::ClipHeader), format::kCodecSegments, &Checker::clip},
      {format::kGeometries, sizeof(format::GeometryHeader), format::kCodecRaw, &Checker::geometry},
      {format::kMeshes, sizeof(format::MeshHeader), format::kCodecRaw, &Checker::mesh},
      {format::kMaterials, sizeof(format::MaterialHeader), format::kCodecRaw, &Checker::material},
      {format::kImages, sizeof(format::ImageHeader), format::kCodecRaw, &Checker::image},
      {format::kNodes, sizeof(format::NodeHeader), format::kCodecRaw, &Checker::node},
      {format::kLimits, sizeof(format::LimitHeader), format::kCodecRaw, &Checker::limits},
      {format::kSprings, sizeof(format::SpringHeader), format::kCodecRaw, &Checker::springs},
      {format::kBounds, sizeof(format::BoundsHeader), format::kCodecRaw, &Checker::bounds},
  };
  for (const Rules& rules : kRules)
    for (std::uint32_t i = 0; i < counts_[rules.kind]; ++i) {
      const File::Section& s = nth(rules.kind, i);
      if (!has_header(s, rules.header_bytes, rules.last_codec) || !(this->*rules.check)(s)) return false;
    }
  return true;
}

namespace {

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
    File::Section s;
    std::memcpy(&s, block.data + entry, sizeof s);
    while (place < format::kKindCount && s.type != format::kTypes[format::kOrder[place]]) ++place;
    if (place == format::kKindCount)
      return bad(entry, "section types in order: SKEL SREF CLIP GEOM MESH MATL IMAG NODE LIMI SPRI SHAP BNDS NAME");
    if (s.offset != format::align16(end)) return bad(entry + 4, "sections stand back to back");
    if (s.offset > block.size || s.bytes > block.size - s.offset) return bad(entry + 8, "section outside the file");
    for (std::size_t pad = static_cast<std::size_t>(end); pad < s.offset; ++pad)
      if (block[pad] != std::byte{0}) return bad(pad, "padding must be 0");
    end = std::uint64_t{s.offset} + s.bytes;
    if (format::kOrder[place] == format::kNames && i + 1 != h.section_count)
      return bad(entry, "one section of names, the last");
  }
  if (format::kOrder[place] != format::kNames) return bad(sizeof h, "no section of names");
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
