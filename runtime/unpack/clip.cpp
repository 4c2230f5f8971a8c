#include <bit>

#include "marrow/file.h"
#include "unpack/structure.h"

namespace marrow {
namespace {

std::uint32_t bit_count(std::uint32_t bits) {
  return static_cast<std::uint32_t>(std::popcount(bits));
}

void copy_to(Span<const std::byte> from, Span<std::byte> out, std::uint64_t offset) {
  if (from.size > 0) std::memcpy(out.data + offset, from.data, from.size);
}

// A u16 each, as varints; counts their bits.
bool take_masks(ByteReader& reader, std::uint64_t groups, GroupMasks* masks, format::CodedHeader& h) {
  for (std::uint64_t g = 0; g < groups; ++g) {
    const std::uint32_t moving = reader.take_varint(), constant = reader.take_varint();
    if (moving > 0xFFFF || constant > 0xFFFF) return false;
    masks[g] = {static_cast<std::uint16_t>(moving), static_cast<std::uint16_t>(constant)};
    h.track_count += bit_count(moving);
    h.constant_count += bit_count(constant);
  }
  return true;
}

// From `start` on; what the reader has left.
const char* unpack_coded(ByteReader& reader, std::uint32_t flags, std::uint32_t joint_count, std::uint64_t start,
                         Span<std::byte> out, std::uint32_t& bytes) {
  format::CodedHeader h{};
  h.frame_count = reader.take_varint();
  h.segment_intervals = reader.take_varint();
  h.frames_per_s = reader.take<float>();
  h.start_s = (flags & packed::kClipStartsLater) != 0 ? reader.take<float>() : 0.0f;
  if (h.frame_count < 2 || h.frame_count > format::kMaxFrames || h.segment_intervals < 1)
    return "frames or intervals out of range";
  h.time_count = (flags & packed::kClipIsUneven) != 0 ? h.frame_count : 0;
  const format::CodedLayout fixed = layout(h, start, joint_count);  // up to the constants
  if (fixed.constants > out.size) return "file_bytes too small";
  copy_to(reader.take_bytes(std::size_t{h.time_count} * 4), out, fixed.times);
  auto* const offsets = reinterpret_cast<std::uint32_t*>(out.data + fixed.offsets);
  offsets[0] = 0;
  for (std::uint32_t i = 1; i < segment_count(h); ++i) offsets[i] = offsets[i - 1] + reader.take_varint();
  if (!take_masks(reader, soa_count(joint_count), reinterpret_cast<GroupMasks*>(out.data + fixed.masks), h))
    return "a mask of more than 16 bits";

  const std::uint64_t constants = std::uint64_t{h.constant_count} * sizeof(format::Constant);
  if (reader.failed() || constants > reader.left()) return "a clip that is too short";
  h.payload_bytes = static_cast<std::uint32_t>(reader.left() - constants) + format::kPayloadPadding;
  const format::CodedLayout l = layout(h, start, joint_count);
  if (l.bytes > out.size) return "file_bytes too small";
  std::memcpy(out.data + l.header, &h, sizeof h);
  copy_to(reader.take_bytes(reader.left()), out, l.constants);  // and the payload behind them
  std::memset(out.data + l.bytes - format::kPayloadPadding, 0, format::kPayloadPadding);
  bytes = static_cast<std::uint32_t>(l.bytes);
  return nullptr;
}

}  // namespace

const char* unpack_clip(Span<const std::byte> record, UnpackedSkeletons skeletons, Span<std::byte> out,
                        std::uint32_t& bytes, std::uint32_t& codec) {
  ByteReader reader(record.data, record.size);
  const std::uint32_t flags = reader.take<std::uint8_t>();
  if ((flags & ~std::uint32_t{packed::kAllClipFlags}) != 0) return "unknown clip flags";
  format::ClipHeader h{};
  h.name = reader.take_varint();
  h.skeleton = reader.take_varint();
  h.duration_s = reader.take<float>();
  h.additive = (flags & packed::kClipIsAdditive) != 0 ? 1 : 0;
  if ((flags & packed::kClipHasLists) != 0) {
    h.track_count = reader.take_varint();
    h.channel_count = reader.take_varint();
    h.time_count = reader.take_varint();
    h.value_count = reader.take_varint();
    h.reference_groups = reader.take<std::uint16_t>();
  }
  const std::uint32_t joint_count = skeleton_at(skeletons, h.skeleton).joint_count;
  if (joint_count == 0) return "no such skeleton among the compact ones";
  const format::ClipLayout l = layout(h);
  if (l.bytes > out.size) return "file_bytes too small";
  std::memcpy(out.data, &h, sizeof h);
  copy_to(reader.take_bytes(static_cast<std::size_t>(l.bytes - sizeof h)), out, sizeof h);
  bytes = static_cast<std::uint32_t>(l.bytes);
  codec = (flags & packed::kClipIsCoded) != 0 ? format::kCodecSegments : format::kCodecRaw;
  if (codec == format::kCodecSegments) {
    const char* const rule = unpack_coded(reader, flags, joint_count, l.bytes, out, bytes);
    if (rule != nullptr) return rule;
  }
  return reader.failed() || reader.left() != 0 ? "a clip that is too short or too long" : nullptr;
}

}  // namespace marrow
