#include "marrow/unpack.h"

#include <new>
#include <type_traits>

#include "core/check.h"
#include "core/off_boundary.h"
#include "core/step.h"
#include "core/zone.h"
#include "unpack/clip/bounds_record.h"
#include "unpack/clip/clip_record.h"
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
  if (h.version != packed::kVersion)
    return fail(error, Status::bad_version, 4, "packed for another version: cook it again");
  if (h.packed_bytes > packed.size) return fail(error, Status::truncated, 8, "the file ends before packed_bytes");
  if (h.packed_bytes != packed.size) return fail(error, Status::bad_data, 8, "bytes behind packed_bytes");
  if (h.memory_bytes < h.file_bytes || h.file_bytes < sizeof(format::Header) || h.memory_bytes % 16 != 0)
    return fail(error, Status::bad_data, 12, "file_bytes or memory_bytes out of range");
  if (format::checksum(packed.data + sizeof h, packed.size - sizeof h) != h.checksum)
    return fail(error, Status::bad_checksum, 24, "checksum of everything behind the header");
  return Status::ok;
}

// The checksum does not cover the header, so its sizes are checked against what the records need.
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

Status read_counts(Span<const std::byte> packed, Header& h, DataError* error) {
  const Status status = read_header(packed, h, error);
  return status == Status::ok ? check_sizes(packed, h, error) : status;
}

BadCall check_memory(const Header& h, Span<std::byte> memory, DataError* error) {
  const char* const off = off_boundary(memory.data);
  if (off != nullptr || memory.size < h.memory_bytes)
    (void)fail(error, Status::bad_argument, 0, off != nullptr ? off : "memory of memory_bytes");
  MARROW_CHECK(holds(memory, h.memory_bytes));
  return check_boundary(memory.data);
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

// The next stage of a mesh record.
enum class MeshStage : std::uint8_t { decoding, finishing, ordering, writing };

// The state that a step leaves for the next one: of its record, or of the file's checksum.
union Work {
  std::uint32_t copied;
  GeometryInWork mesh;
  NameReader names;
  BoundsInWork bounds;
  ClipInWork clip;
  format::Checksum sum;

  Work() : copied(0) {}
};

// Writes sections one behind the other into the front part of memory, a step at a time. Lies in Unpacking::state.
class Unpacker {
 public:
  Unpacker(const Header& header, Span<const std::byte> packed, Span<const MeshDecoder> decoders, Span<std::byte> memory)
      : file_bytes_(header.file_bytes),
        memory_bytes_(header.memory_bytes),
        record_count_(header.record_count),
        decoders_(decoders),
        memory_(memory),
        packed_bytes_(packed.size),
        records_(packed.data + sizeof header, packed.size - sizeof header),
        names_(find_names(records_, header.record_count)),
        end_(sizeof(format::Header) + std::uint64_t{header.record_count} * sizeof(File::Section)) {}

  bool is_begun() const { return memory_.data != nullptr; }
  bool at_end() const { return index_ == record_count_; }
  std::uint32_t done_bytes() const { return static_cast<std::uint32_t>(end_); }
  Span<const std::byte> file() const { return {memory_.data, file_bytes_}; }

  // Not to be called at_end().
  Status step(DataError* error) {
    if (end_ > file_bytes_) return fail(error, Status::bad_data, 12, "file_bytes too small");
    if (!is_going_on_) {
      offset_ = static_cast<std::uint32_t>(packed_bytes_ - records_.left());
      record_ = take_record(records_);
      begin_work();
    }
    is_going_on_ = true;
    const char* rule = nullptr;
    const Status status = add(rule);
    return status == Status::ok ? status : fail(error, status, offset_, rule);
  }

  // To be called at_end(), and again until `done`.
  Status finish(DataError* error, bool& done) {
    if (end_ != file_bytes_) return fail(error, Status::bad_data, 12, "file_bytes is not what the records come to");
    if (!is_going_on_) ::new (&work_.sum) format::Checksum;
    is_going_on_ = true;
    constexpr std::size_t kBehind = sizeof(format::Header);
    const std::byte* const data = memory_.data + kBehind;
    const std::size_t bytes = file_bytes_ - kBehind;
    done = bytes - work_.sum.at <= kStepBytes;
    if (!done) {
      work_.sum.add(data, work_.sum.at + kStepBytes);
      return Status::ok;
    }
    const format::Header h{
        format::kMagic, format::kVersion, file_bytes_, record_count_, work_.sum.finish(data, bytes), 0};
    std::memcpy(memory_.data, &h, sizeof h);
    return Status::ok;
  }

 private:
  static Status bad(const char*& rule, const char* text) {
    rule = text;
    return Status::bad_data;
  }

  void begin_work() {
    section_ = {};
    if (record_.kind < format::kKindCount) section_.type = format::kTypes[record_.kind];
    const bool compact = record_.codec == packed::kCompact;
    if (record_.codec < packed::kFirstCodec) {
      work_.copied = 0;
    } else if (compact && record_.kind == format::kNames) {
      ::new (&work_.names) NameReader(record_.bytes);
    } else if (compact && record_.kind == format::kBounds) {
      ::new (&work_.bounds) BoundsInWork(record_.bytes);
    } else if (compact && record_.kind == format::kClips) {
      ::new (&work_.clip) ClipInWork;
    } else if (record_.kind == format::kGeometries) {
      ::new (&work_.mesh) GeometryInWork{};
    }
  }

  // Does one step of the record's section. The section is complete when is_going_on_ is false afterwards.
  Status add(const char*& rule) {
    if (record_.kind >= format::kKindCount) return bad(rule, "an unknown kind of record");
    const std::uint64_t offset = format::align16(end_);
    if (offset > file_bytes_) return bad(rule, "file_bytes too small");
    std::memset(memory_.data + end_, 0, static_cast<std::size_t>(offset - end_));
    const Span<std::byte> out(memory_.data + offset, file_bytes_ - static_cast<std::size_t>(offset));
    section_.offset = static_cast<std::uint32_t>(offset);
    bool done = true;  // unless whatever takes several steps says that it is not
    const Status status = record_.codec < packed::kFirstCodec ? copy(out, rule, done) : expand(out, rule, done);
    if (status != Status::ok || !done) return status;
    is_going_on_ = false;
    if (record_.kind == format::kSkeletons && record_.codec == packed::kCompact && skeletons_ == index_) ++skeletons_;
    if (record_.kind == format::kReferences && record_.codec == format::kCodecRaw && references_ == index_)
      ++references_;
    has_models_ = has_models_ && record_.kind == format::kClips && record_.codec == packed::kCompact;
    if (record_.kind != format::kMeshes) modelled_ = kNoneModelled;  // others use the scratch, too
    std::memcpy(memory_.data + sizeof(format::Header) + index_ * sizeof section_, &section_, sizeof section_);
    end_ = offset + section_.bytes;
    ++index_;
    return Status::ok;
  }

  // A section as it stands.
  Status copy(Span<std::byte> out, const char*& rule, bool& done) {
    const auto bytes = static_cast<std::uint32_t>(record_.bytes.size);
    if (bytes > out.size) return bad(rule, "file_bytes too small");
    const std::uint32_t end = step_end(work_.copied, bytes, kStepBytes);
    if (end > work_.copied) std::memcpy(out.data + work_.copied, record_.bytes.data + work_.copied, end - work_.copied);
    work_.copied = end;
    done = end == bytes;
    section_.bytes = bytes;
    section_.codec = record_.codec;
    return Status::ok;
  }

  Span<std::byte> scratch() const {
    const std::size_t first = static_cast<std::size_t>(format::align16(file_bytes_));
    return {memory_.data + first, memory_bytes_ - first};
  }

  // A record that is not a section as it stands.
  Status expand(Span<std::byte> out, const char*& rule, bool& done) {
    if (record_.kind == format::kGeometries && record_.codec != packed::kCompact) return expand_mesh(out, rule, done);
    const UnpackedSkeletons skeletons{memory_.data, skeletons_, references_};
    std::uint32_t& bytes = section_.bytes;
    if (record_.codec != packed::kCompact) {
      rule = "a codec that is none of this kind of record";
    } else if (record_.kind == format::kSkeletons) {
      rule = unpack_skeleton(record_.bytes, names_, out, bytes);
    } else if (record_.kind == format::kClips) {
      rule =
          unpack_clip(record_.bytes, skeletons, has_models_, scratch(), work_.clip, out, bytes, section_.codec, done);
    } else if (record_.kind == format::kMeshes) {
      rule = unpack_mesh(record_.bytes, skeletons, modelled_, scratch(), out, bytes);
    } else if (record_.kind == format::kNames) {
      rule = unpack_names(work_.names, out, bytes, done);
    } else if (record_.kind == format::kBounds) {
      rule = unpack_bounds(record_.bytes, work_.bounds, out, bytes, done);
    } else {
      rule = "a codec that is none of this kind of record";
    }
    return rule == nullptr ? Status::ok : Status::bad_data;
  }

  Status expand_mesh(Span<std::byte> out, const char*& rule, bool& done) {
    GeometryInWork& mesh = work_.mesh;
    bool stage_done = true;
    if (stage_ == MeshStage::decoding) {
      const MeshDecoder* decoder = nullptr;
      for (const MeshDecoder& d : decoders_)
        if (d.codec == record_.codec) decoder = &d;
      if (decoder == nullptr) {
        rule = codec_name(record_.codec);
        return Status::unsupported;
      }
      Status decoded = Status::ok;
      rule = decode_geometry(record_.bytes, *decoder, scratch(), mesh, decoded, &stage_done);
      if (decoded == Status::out_of_memory) return decoded;
    } else if (stage_ == MeshStage::finishing) {
      rule = finish_streams(mesh, stage_done);
    } else if (stage_ == MeshStage::ordering) {
      rule = arrange_geometry(mesh, stage_done);
    } else {
      rule = write_geometry(mesh, out, section_.bytes, stage_done);
    }
    done = stage_done && stage_ == MeshStage::writing;
    if (done) {
      stage_ = MeshStage::decoding;
    } else if (stage_done) {
      const bool plain = stage_ == MeshStage::decoding && mesh.streams.apart.influences == 0;
      stage_ = static_cast<MeshStage>(static_cast<std::uint8_t>(stage_) + (plain ? 2 : 1));
    }
    return rule == nullptr ? Status::ok : Status::bad_data;
  }

  std::uint32_t file_bytes_, memory_bytes_, record_count_;
  Span<const MeshDecoder> decoders_;
  Span<std::byte> memory_;
  std::size_t packed_bytes_;
  ByteReader records_;
  NameReader names_;  // stands at the next skeleton's
  std::uint64_t end_;
  Record record_;
  File::Section section_{};  // of the record in work
  Work work_;
  std::uint32_t offset_ = 0, index_ = 0;          // of the record in work
  std::uint32_t skeletons_ = 0, references_ = 0;  // numbers of compact skeletons, or references, that begin the table
  std::uint32_t modelled_ = kNoneModelled;        // the skeleton whose rest pose is at the front of the scratch memory
  bool has_models_ = false;                       // a clip's models are at the front of the scratch memory
  bool is_going_on_ = false;                      // with a record, or with the file's checksum
  MeshStage stage_ = MeshStage::decoding;
};
static_assert(sizeof(Unpacker) <= kUnpackStateBytes && alignof(Unpacker) <= 8);
static_assert(std::is_trivially_copyable_v<Unpacker> && std::is_trivially_destructible_v<Unpacker>);

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
  const Status status = read_counts(packed, h, error);
  if (status == Status::ok) out = {h.file_bytes, h.memory_bytes};
  return status;
}

Status unpack(Span<const std::byte> packed, Span<const MeshDecoder> decoders, Span<std::byte> memory,
              Span<const std::byte>& file, DataError* error) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(packed) && holds(decoders));
  Header h;
  Status status = read_counts(packed, h, error);
  if (status != Status::ok) return status;
  MARROW_REQUIRE_GOOD(check_memory(h, memory, error));
  Unpacker unpacker(h, packed, decoders, memory);
  while (status == Status::ok && !unpacker.at_end()) status = unpacker.step(error);
  for (bool done = false; status == Status::ok && !done;) status = unpacker.finish(error, done);
  if (status == Status::ok) file = unpacker.file();
  return status;
}

Status begin_unpack(Span<const std::byte> packed, Span<const MeshDecoder> decoders, Span<std::byte> memory,
                    Unpacking& out, DataError* error) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(packed) && holds(decoders));
  Header h;
  const Status status = read_counts(packed, h, error);
  if (status != Status::ok) return status;
  MARROW_REQUIRE_GOOD(check_memory(h, memory, error));
  const Unpacker unpacker(h, packed, decoders, memory);
  out = {};
  out.done_bytes = unpacker.done_bytes();
  out.total_bytes = h.file_bytes;
  std::memcpy(out.state, &unpacker, sizeof unpacker);
  return Status::ok;
}

Status unpack_step(Unpacking& unpacking, DataError* error) {
  MARROW_ZONE;
  Unpacker& unpacker = *reinterpret_cast<Unpacker*>(unpacking.state);
  MARROW_REQUIRE(unpacker.is_begun() && "begin_unpack() before, and neither failed nor finished since");
  bool last = false;
  const Status status = unpacker.at_end() ? unpacker.finish(error, last) : unpacker.step(error);
  unpacking.done_bytes = unpacker.done_bytes();
  if (last && status == Status::ok) unpacking.file = unpacker.file();
  if (last || status != Status::ok) std::memset(unpacking.state, 0, sizeof unpacking.state);
  return status;
}

}  // namespace marrow
