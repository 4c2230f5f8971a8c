#include "marrow/unpack.h"

#include "core/off_boundary.h"
#include "core/check.h"
#include "unpack/geometry.h"
#include "unpack/records.h"
#include "unpack/structure.h"

namespace marrow {
namespace {

using packed::Header;

Status fail(DataError* error, Status status, std::size_t offset, const char* rule) {
  if (error != nullptr) *error = {status, static_cast<std::uint32_t>(offset), rule};
  return status;
}

Status read_header(Span<const std::byte> packed, Header& h, DataError* error) {
  if (packed.size < sizeof h) return fail(error, Status::truncated, 0, "shorter than a header");
  std::memcpy(&h, packed.data, sizeof h);
  if (h.magic != packed::kMagic) return fail(error, Status::bad_magic, 0, "not a packed file");
  if (h.version != packed::kVersion) return fail(error, Status::bad_version, 4, "packed for another version");
  if (h.packed_bytes > packed.size) return fail(error, Status::truncated, 8, "the file ends before packed_bytes");
  if (h.packed_bytes != packed.size) return fail(error, Status::bad_data, 8, "bytes behind packed_bytes");
  if (h.memory_bytes < h.file_bytes || h.file_bytes < sizeof(format::Header) || h.memory_bytes % 16 != 0)
    return fail(error, Status::bad_data, 12, "file_bytes or memory_bytes out of range");
  if (format::checksum(packed.data + sizeof h, packed.size - sizeof h) != h.checksum)
    return fail(error, Status::bad_checksum, 24, "damaged");
  return Status::ok;
}

// The header lies outside the checksum: what it says of memory must be what the records need.
Status check_sizes(Span<const std::byte> packed, const Header& h, DataError* error) {
  ByteReader reader(packed.data + sizeof h, packed.size - sizeof h);
  RecordNeeds needs;
  needs.most_file_bytes = sizeof(format::Header) + std::uint64_t{h.record_count} * sizeof(File::Section);
  for (std::uint32_t i = 0; i < h.record_count; ++i) {
    const std::size_t offset = packed.size - reader.left();
    const Record record = take_record(reader);
    if (reader.failed()) return fail(error, Status::truncated, offset, "the file ends within a record");
    if (const char* const rule = add_needs(record, needs)) return fail(error, Status::bad_data, offset, rule);
  }
  if (reader.left() != 0) return fail(error, Status::bad_data, packed.size - reader.left(), "bytes behind the records");
  if (h.file_bytes > needs.most_file_bytes)
    return fail(error, Status::bad_data, 12, "file_bytes is more than the records come to");
  if (h.memory_bytes != format::align16(h.file_bytes) + format::align16(needs.scratch_bytes))
    return fail(error, Status::bad_data, 16, "memory_bytes is not what the records need");
  return Status::ok;
}

// The last record's bytes if they are compact names, else none.
Span<const std::byte> find_names(ByteReader reader, std::uint32_t record_count) {
  Record last;
  for (std::uint32_t i = 0; i < record_count && !reader.failed(); ++i) last = take_record(reader);
  return last.kind == format::kNames && last.codec == packed::kCompact ? last.bytes : Span<const std::byte>();
}

const char* codec_name(std::uint32_t codec) {
  if (codec == packed::kDraco) return "meshes are compressed with Draco: pass marrow::draco_decoder()";
  if (codec == packed::kMeshopt) return "meshes are compressed with meshoptimizer: pass marrow::meshopt_decoder()";
  return "an unknown codec";
}

// Writes sections one behind the other into the front part of memory.
class Unpacker {
 public:
  Unpacker(const Header& header, Span<const MeshDecoder> decoders, NameReader names, Span<std::byte> memory)
      : header_(header),
        decoders_(decoders),
        names_(names),
        memory_(memory),
        scratch_at_(static_cast<std::size_t>(format::align16(header.file_bytes))) {}

  // The end of a header and of a table with this many entries.
  bool begin() {
    end_ = sizeof(format::Header) + std::uint64_t{header_.record_count} * sizeof(File::Section);
    return end_ <= header_.file_bytes;
  }

  Status add(std::uint32_t index, const Record& record, const char*& rule) {
    if (record.kind >= format::kKindCount) return bad(rule, "an unknown kind of record");
    const std::uint64_t offset = format::align16(end_);
    if (offset > header_.file_bytes) return bad(rule, "file_bytes too small");
    std::memset(memory_.data + end_, 0, static_cast<std::size_t>(offset - end_));
    const Span<std::byte> out(memory_.data + offset, header_.file_bytes - static_cast<std::size_t>(offset));
    File::Section section{format::kTypes[record.kind], static_cast<std::uint32_t>(offset), 0, 0};
    if (record.codec < packed::kFirstCodec) {
      if (record.bytes.size > out.size) return bad(rule, "file_bytes too small");
      std::memcpy(out.data, record.bytes.data, record.bytes.size);
      section.bytes = static_cast<std::uint32_t>(record.bytes.size);
      section.codec = record.codec;
    } else {
      const Status status = expand(record, out, section, rule);
      if (status != Status::ok) return status;
    }
    if (record.kind == format::kSkeletons && record.codec == packed::kCompact && compact_skeletons_ == index)
      ++compact_skeletons_;
    std::memcpy(memory_.data + sizeof(format::Header) + index * sizeof section, &section, sizeof section);
    end_ = offset + section.bytes;
    return Status::ok;
  }

  bool finish() {
    if (end_ != header_.file_bytes) return false;
    constexpr std::size_t kBehind = sizeof(format::Header);
    const format::Header h{format::kMagic,
                           format::kVersion,
                           header_.file_bytes,
                           header_.record_count,
                           format::checksum(memory_.data + kBehind, header_.file_bytes - kBehind),
                           0};
    std::memcpy(memory_.data, &h, sizeof h);
    return true;
  }

 private:
  static Status bad(const char*& rule, const char* text) {
    rule = text;
    return Status::bad_data;
  }

  // A record that is not a section as it stands.
  Status expand(const Record& record, Span<std::byte> out, File::Section& section, const char*& rule) {
    const UnpackedSkeletons skeletons{memory_.data, compact_skeletons_};
    std::uint32_t& bytes = section.bytes;
    Status decoded = Status::ok;
    const Span<std::byte> scratch(memory_.data + scratch_at_, header_.memory_bytes - scratch_at_);
    if (record.kind == format::kGeometries && record.codec != packed::kCompact) {
      const MeshDecoder* decoder = nullptr;
      for (const MeshDecoder& d : decoders_)
        if (d.codec == record.codec) decoder = &d;
      if (decoder == nullptr) {
        rule = codec_name(record.codec);
        return Status::unsupported;
      }
      rule = unpack_geometry(record.bytes, *decoder, scratch, out, bytes, decoded);
    } else if (record.codec != packed::kCompact) {
      rule = "a codec that is none of this kind of record";
    } else if (record.kind == format::kSkeletons) {
      rule = unpack_skeleton(record.bytes, names_, out, bytes);
    } else if (record.kind == format::kClips) {
      rule = unpack_clip(record.bytes, skeletons, out, bytes, section.codec);
    } else if (record.kind == format::kMeshes) {
      rule = unpack_mesh(record.bytes, skeletons, scratch, out, bytes);
    } else if (record.kind == format::kNames) {
      rule = unpack_names(record.bytes, out, bytes);
    } else {
      rule = "a codec that is none of this kind of record";
    }
    if (decoded == Status::out_of_memory) return decoded;
    return rule == nullptr ? Status::ok : Status::bad_data;
  }

  const Header& header_;
  Span<const MeshDecoder> decoders_;
  NameReader names_;  // stands at the next skeleton's
  Span<std::byte> memory_;
  std::size_t scratch_at_;
  std::uint64_t end_ = 0;
  std::uint32_t compact_skeletons_ = 0;  // at the front of the table
};

}  // namespace

bool is_packed(Span<const std::byte> bytes) {
  std::uint32_t magic = 0;
  if (!holds(bytes, sizeof magic)) return false;
  std::memcpy(&magic, bytes.data, sizeof magic);
  return magic == packed::kMagic;
}

Status unpack_sizes(Span<const std::byte> packed, UnpackSizes& out, DataError* error) {
  MARROW_REQUIRE(holds(packed));
  Header h;
  Status status = read_header(packed, h, error);
  if (status == Status::ok) status = check_sizes(packed, h, error);
  if (status == Status::ok) out = {h.file_bytes, h.memory_bytes};
  return status;
}

Status unpack(Span<const std::byte> packed, Span<const MeshDecoder> decoders, Span<std::byte> memory,
              Span<const std::byte>& file, DataError* error) {
  MARROW_REQUIRE(holds(packed) && holds(decoders));
  Header h;
  Status status = read_header(packed, h, error);
  if (status == Status::ok) status = check_sizes(packed, h, error);
  if (status != Status::ok) return status;
  const char* const off = off_boundary(memory.data);
  if (off != nullptr || memory.size < h.memory_bytes)
    (void)fail(error, Status::bad_argument, 0, off != nullptr ? off : "memory of memory_bytes");
  MARROW_REQUIRE(holds(memory, h.memory_bytes));
  MARROW_REQUIRE_GOOD(check_boundary(memory.data));
  ByteReader reader(packed.data + sizeof h, packed.size - sizeof h);
  Unpacker unpacker(h, decoders, NameReader(find_names(reader, h.record_count)), memory);
  if (!unpacker.begin()) return fail(error, Status::bad_data, 12, "file_bytes too small");
  for (std::uint32_t i = 0; i < h.record_count; ++i) {
    const std::size_t offset = packed.size - reader.left();
    const Record record = take_record(reader);
    const char* rule = nullptr;
    const Status added = unpacker.add(i, record, rule);
    if (added != Status::ok) return fail(error, added, offset, rule);
  }
  if (!unpacker.finish()) return fail(error, Status::bad_data, 12, "file_bytes is not what the records come to");
  file = {memory.data, h.file_bytes};
  return Status::ok;
}

}  // namespace marrow
