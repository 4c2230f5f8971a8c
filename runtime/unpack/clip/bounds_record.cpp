#include "unpack/clip/bounds_record.h"

#include "asset/format.h"
#include "unpack/clip/bounds_codec.h"

namespace marrow {
namespace {

format::BoundsHeader take_bounds_header(ByteReader& reader) {
  format::BoundsHeader h{};
  h.skeleton = reader.take_varint();
  h.clip_count = reader.take_varint();
  h.mesh_count = reader.take_varint();
  return h;
}

}  // namespace

std::uint64_t measure_bounds_record(Span<const std::byte> record) {
  ByteReader reader(record.data, record.size);
  const format::BoundsHeader h = take_bounds_header(reader);
  const std::uint64_t count = std::uint64_t{h.clip_count} * h.mesh_count;
  // Without a mesh, clips would take time and no room.
  return count == 0 || count > UINT32_MAX / sizeof(format::BoundsCodes) ? 0 : format::layout(h).bytes;
}

const char* unpack_bounds(Span<const std::byte> record, Span<std::byte> out, std::uint32_t& bytes) {
  const std::uint64_t size = measure_bounds_record(record);
  if (size == 0 || size > out.size) return "file_bytes too small";
  ByteReader reader(record.data, record.size);
  const format::BoundsHeader h = take_bounds_header(reader);
  std::memcpy(out.data, &h, sizeof h);
  SymbolDecoder decoder(reader.take_bytes(reader.left()));
  BoundsCodec<SymbolDecoder> codec(decoder);
  std::byte* to = out.data + sizeof h;
  for (std::uint32_t clip = 0; clip < h.clip_count; ++clip) {
    const std::uint32_t between = clip > 0 ? codec.code_between(0) : 0;
    if (clip > 0 && between >= clip) return "bounds like those of no clip";
    const std::size_t back = (between + std::size_t{1}) * h.mesh_count;
    for (std::uint32_t mesh = 0; mesh < h.mesh_count; ++mesh, to += codec.kBytes)
      codec.code(clip > 0 ? to - back * codec.kBytes : mesh > 0 ? to - codec.kBytes : codec.kNothing, to);
  }
  bytes = static_cast<std::uint32_t>(size);
  return decoder.at_end() ? nullptr : "bounds that are too short or too long";
}

}  // namespace marrow
