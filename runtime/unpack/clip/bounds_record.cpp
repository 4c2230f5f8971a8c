#include "unpack/clip/bounds_record.h"

#include "asset/format.h"
#include "core/step.h"

namespace marrow {
namespace {

// A symbol leaves at least 120 of 16384 to the others, so it takes a 95th of a bit or more, and a code has eight.
constexpr std::uint64_t kMostCodesOfByte = 96;

format::BoundsHeader take_bounds_header(ByteReader& reader) {
  format::BoundsHeader h{};
  h.skeleton = reader.take_varint();
  h.clip_count = reader.take_varint();
  h.mesh_count = reader.take_varint();
  return h;
}

Span<const std::byte> symbols_of(Span<const std::byte> record) {
  ByteReader reader(record.data, record.size);
  take_bounds_header(reader);
  return reader.take_bytes(reader.left());
}

}  // namespace

std::uint64_t measure_bounds_record(Span<const std::byte> record) {
  ByteReader reader(record.data, record.size);
  const format::BoundsHeader h = take_bounds_header(reader);
  const std::uint64_t count = std::uint64_t{h.clip_count} * h.mesh_count;
  // Without a mesh, clips would take time and no room.
  return count == 0 || count > UINT32_MAX / sizeof(format::BoundsCodes) || count > kMostCodesOfByte * record.size
             ? 0
             : format::layout(h).bytes;
}

BoundsInWork::BoundsInWork(Span<const std::byte> record) : decoder(symbols_of(record)) {}

const char* unpack_bounds(Span<const std::byte> record, BoundsInWork& work, Span<std::byte> out, std::uint32_t& bytes,
                          bool& done) {
  const std::uint64_t size = measure_bounds_record(record);
  if (size == 0 || size > out.size) return "file_bytes too small";
  ByteReader reader(record.data, record.size);
  const format::BoundsHeader h = take_bounds_header(reader);
  std::memcpy(out.data, &h, sizeof h);
  std::byte* const codes = out.data + sizeof h;
  auto& codec = work.codec;
  const std::uint32_t count = h.clip_count * h.mesh_count;
  for (const std::uint32_t end = step_end(work.next, count, kStepNumbers / codec.kBytes); work.next < end;
       ++work.next) {
    if (work.next > 0 && work.next % h.mesh_count == 0) {
      const std::uint32_t between = codec.code_between(work.decoder, 0);
      if (between >= work.next / h.mesh_count) return "bounds like those of no clip";
      work.back = (between + 1) * h.mesh_count;
    }
    std::byte* const to = codes + std::size_t{work.next} * codec.kBytes;
    const std::size_t back = work.next < h.mesh_count ? 1 : work.back;
    codec.code(work.decoder, work.next > 0 ? to - back * codec.kBytes : codec.kNothing, to);
  }
  bytes = static_cast<std::uint32_t>(size);
  done = work.next == count;
  return !done || work.decoder.at_end() ? nullptr : "bounds that are too short or too long";
}

}  // namespace marrow
