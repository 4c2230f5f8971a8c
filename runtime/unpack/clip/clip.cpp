#include "unpack/clip/clip.h"

#include <bit>

#include "unpack/clip/segments.h"

namespace marrow {
namespace {

std::uint32_t bit_count(std::uint32_t bits) {
  return static_cast<std::uint32_t>(std::popcount(bits));
}

void copy_to(Span<const std::byte> from, Span<std::byte> out, std::uint64_t offset) {
  if (from.size > 0) std::memcpy(out.data + offset, from.data, from.size);
}

// False if they are not those of the tracks.
bool take_masks(ClipCodec<SymbolDecoder>& codec, std::uint32_t groups, GroupMasks* masks, format::CodedHeader& h) {
  std::uint32_t track_count = 0;
  for (std::uint32_t g = 0; g < groups; ++g) {
    masks[g].moving = codec.code_mask(2 * g, 0);
    masks[g].constant = codec.code_mask(2 * g + 1, 0);
    track_count += bit_count(masks[g].moving);
    h.constant_count += bit_count(masks[g].constant);
  }
  return track_count == h.track_count;
}

void take_constants(ClipCodec<SymbolDecoder>& codec, std::uint32_t groups, const GroupMasks* masks,
                    format::Constant* out) {
  for (std::uint32_t g = 0; g < groups; ++g)
    for (std::uint32_t left = masks[g].constant; left != 0; left &= left - 1)
      *out++ = codec.code_constant(16 * g + static_cast<std::uint32_t>(std::countr_zero(left)), {});
}

// What stands in front of a clip's lists.
format::ClipHeader take_header(ByteReader& reader, std::uint32_t& flags) {
  flags = reader.take<std::uint8_t>();
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
  return h;
}

// What stands behind them. Returns null, or the rule that is broken.
const char* take_sizes(ByteReader& reader, std::uint32_t flags, SegmentSizes& out) {
  format::CodedHeader& h = out.header;
  h.frame_count = reader.take_varint();
  h.segment_intervals = reader.take_varint();
  h.frames_per_s = reader.take<float>();
  h.start_s = (flags & packed::kClipStartsLater) != 0 ? reader.take<float>() : 0.0f;
  h.track_count = reader.take_varint();
  if (h.frame_count < 2 || h.frame_count > format::kMaxFrames || h.segment_intervals < 1)
    return "frames or intervals out of range";
  h.time_count = (flags & packed::kClipIsUneven) != 0 ? h.frame_count : 0;
  return read_segment_sizes(reader, out) ? nullptr : "a clip that is too short, or larger than a file";
}

// From `start` on; what the reader has left.
const char* unpack_coded(ByteReader& reader, std::uint32_t flags, std::uint32_t joint_count, bool has_models,
                         Span<std::byte> scratch, std::uint64_t start, Span<std::byte> out, std::uint32_t& bytes) {
  SegmentSizes sizes;
  if (const char* const rule = take_sizes(reader, flags, sizes)) return rule;
  format::CodedHeader& h = sizes.header;
  const format::CodedLayout fixed = layout(h, start, joint_count);  // up to the constants
  if (fixed.constants > out.size) return "file_bytes too small";
  copy_to(reader.take_bytes(std::size_t{h.time_count} * 4), out, fixed.times);
  const std::uint64_t payload_bytes = sizes.payload_bytes + format::kPayloadPadding;
  if (reader.failed() || payload_bytes > UINT32_MAX) return "a clip that is too short, or larger than a file";
  Memory memory{scratch.data, 0, scratch.size};
  const SegmentScratch work = take_segment_scratch(memory, h.track_count, sizes.most_frames);
  if (memory.failed) return "memory_bytes too small";
  if (!has_models) work.models->begin();
  SymbolDecoder decoder(reader.take_bytes(reader.left()));
  ClipCodec<SymbolDecoder> codec(*work.models, decoder);

  auto* const masks = reinterpret_cast<GroupMasks*>(out.data + fixed.masks);
  const auto groups = static_cast<std::uint32_t>(soa_count(joint_count));
  if (!take_masks(codec, groups, masks, h)) return "masks that are not the tracks'";
  h.payload_bytes = static_cast<std::uint32_t>(payload_bytes);
  const format::CodedLayout l = layout(h, start, joint_count);
  if (l.bytes > out.size) return "file_bytes too small";
  std::memcpy(out.data + l.header, &h, sizeof h);
  take_constants(codec, groups, masks, reinterpret_cast<format::Constant*>(out.data + l.constants));
  std::memset(out.data + l.bytes - format::kPayloadPadding, 0, format::kPayloadPadding);
  bytes = static_cast<std::uint32_t>(l.bytes);
  if (!unpack_segments(codec, sizes, work, out.data + l.payload,
                       reinterpret_cast<std::uint32_t*>(out.data + l.offsets)))
    return "a segment that is none";
  return decoder.at_end() ? nullptr : "a clip that is too short or too long";
}

}  // namespace

std::uint64_t clip_scratch_bytes(std::uint32_t track_count, std::uint32_t most_frames) {
  Memory count;
  take_segment_scratch(count, track_count, most_frames);
  return count.whole();
}

const char* measure_clip_record(Span<const std::byte> record, ClipNeeds& out) {
  ByteReader reader(record.data, record.size);
  std::uint32_t flags = 0;
  const format::ClipHeader h = take_header(reader, flags);
  if ((flags & packed::kClipIsCoded) == 0) return nullptr;
  const std::uint64_t lists = layout(h).bytes - sizeof h;
  if (lists > reader.left()) return "a clip that is too short or too long";
  reader.take_bytes(static_cast<std::size_t>(lists));
  SegmentSizes sizes;
  if (const char* const rule = take_sizes(reader, flags, sizes)) return rule;
  out.scratch_bytes = clip_scratch_bytes(sizes.header.track_count, sizes.most_frames);
  out.most_section_bytes = sizes.payload_bytes;
  return nullptr;
}

const char* unpack_clip(Span<const std::byte> record, UnpackedSkeletons skeletons, bool has_models,
                        Span<std::byte> scratch, Span<std::byte> out, std::uint32_t& bytes, std::uint32_t& codec) {
  ByteReader reader(record.data, record.size);
  std::uint32_t flags = 0;
  const format::ClipHeader h = take_header(reader, flags);
  if ((flags & ~std::uint32_t{packed::kAllClipFlags}) != 0) return "unknown clip flags";
  const std::uint32_t joint_count = joint_count_at(skeletons, h.skeleton);
  if (joint_count == 0) return "no such skeleton among the first records";
  const format::ClipLayout l = layout(h);
  if (l.bytes > out.size) return "file_bytes too small";
  std::memcpy(out.data, &h, sizeof h);
  copy_to(reader.take_bytes(static_cast<std::size_t>(l.bytes - sizeof h)), out, sizeof h);
  bytes = static_cast<std::uint32_t>(l.bytes);
  codec = (flags & packed::kClipIsCoded) != 0 ? format::kCodecSegments : format::kCodecRaw;
  if (codec == format::kCodecSegments)
    return unpack_coded(reader, flags, joint_count, has_models, scratch, l.bytes, out, bytes);
  return reader.failed() || reader.left() != 0 ? "a clip that is too short or too long" : nullptr;
}

}  // namespace marrow
