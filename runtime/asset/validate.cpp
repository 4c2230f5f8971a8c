// load: every rule of docs/format.md, checked once, so that no later stage has to.
#include <cstring>

#include "asset/checker.h"
#include "core/check.h"
#include "core/off_boundary.h"
#include "core/zone.h"

namespace marrow {
namespace format {
namespace {

constexpr SectionKind kAll[] = {
#define MARROW_KIND(number, name, type, header, last_codec) \
  section_kind<header>(number, four_characters(type), last_codec),
    MARROW_SECTION_KINDS(MARROW_KIND)
#undef MARROW_KIND
};

}  // namespace
}  // namespace format

namespace {

bool check_names(Checker& c, const File::Section& s) {
  if (s.codec != format::kCodecRaw) return c.fail(c.header(), "names have no codec");
  const Span<const char> letters(&c.at<char>(0), s.bytes);
  return (s.bytes != 0 && letters[0] == 0 && letters[s.bytes - 1u] == 0) ||
         c.fail(letters.data, "names must begin with the empty one and end with a zero");
}

// Header and section table: sizes exact, sections back to back on 16-byte boundaries, kinds in order, one set of names.
DataError check_container(Span<const std::byte> block, Span<const SectionKind> kinds, std::uint32_t* first,
                          std::uint32_t* counts) {
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
  const SectionKind* kind = kinds.begin();
  for (std::uint32_t i = 0; i < h.section_count; ++i) {
    const std::size_t entry = sizeof h + i * sizeof(File::Section);
    const auto& s = *reinterpret_cast<const File::Section*>(block.data + entry);
    while (kind != kinds.end() && s.type != kind->type) ++kind;
    if (kind == kinds.end())
      return bad(entry,
                 "section types in order: SKEL SREF CLIP GEOM MESH MATL IMAG NODE LIMI SPRI ROLE MOTN PMAP SHAP GRPH "
                 "BNDS NAME");
    if (s.offset != format::align16(end)) return bad(entry + 4, "sections stand back to back");
    if (s.offset > block.size || s.bytes > block.size - s.offset) return bad(entry + 8, "section outside the file");
    for (; end < s.offset; ++end)
      if (block[static_cast<std::size_t>(end)] != std::byte{0})
        return bad(static_cast<std::size_t>(end), "padding must be 0");
    end += s.bytes;
    if (kind + 1 == kinds.end() && i + 1 != h.section_count) return bad(entry, "one section of names, the last");
    if (counts[kind->kind]++ == 0) first[kind->kind] = i;
  }
  if (counts[format::kNames] == 0) return bad(sizeof h, "no section of names");
  if (end != block.size) return bad(8, "the last section ends the file");
  return {};
}

}  // namespace

const Span<const SectionKind> kSectionKinds = format::kAll;

DataError check_file(Span<const std::byte> block, Span<const SectionKind> kinds, std::uint32_t* first,
                     std::uint32_t* counts) {
  const DataError found = check_container(block, kinds, first, counts);
  if (found.status != Status::ok) return found;
  const auto* header = reinterpret_cast<const format::Header*>(block.data);
  const Span<const File::Section> sections(reinterpret_cast<const File::Section*>(header + 1), header->section_count);
  Checker c(block, sections, first, counts);
  const File::Section& names = sections[sections.size - 1];
  if (!c.begin(names, 0, UINT32_MAX) || !check_names(c, names)) return c.error();
  // Kinds stand in one order, so a section may lean on those before it.
  for (const SectionKind& kind : kinds)
    for (std::uint32_t i = 0; i < counts[kind.kind] && kind.check != nullptr; ++i) {
      const File::Section& s = sections[first[kind.kind] + i];
      if (!c.begin(s, kind.header_bytes, kind.last_codec)) return c.error();
      kind.check(c, c.header());
      if (!c.good()) return c.error();
    }
  return c.error();
}

Status load(Span<const std::byte> block, File& out, DataError* error) {
  MARROW_ZONE;
  if (error != nullptr) {
    const char* const off = off_boundary(block.data);
    *error = {Status::bad_argument, 0, off != nullptr ? off : "a block that is not null"};
  }
  MARROW_REQUIRE(block.data != nullptr);
  MARROW_REQUIRE_GOOD(check_boundary(block.data));
  File file;
  static_assert(sizeof file.first_ == format::kKindCount * sizeof(std::uint32_t) &&
                sizeof file.counts_ == sizeof file.first_);
  const DataError found = check_file(block, kSectionKinds, file.first_, file.counts_);
  if (found.status == Status::ok) {
    const auto* header = reinterpret_cast<const format::Header*>(block.data);
    file.block_ = block.data;
    file.sections_ = {reinterpret_cast<const File::Section*>(header + 1), header->section_count};
    out = file;
  }
  if (error != nullptr) *error = found;
  return found.status;
}

}  // namespace marrow
