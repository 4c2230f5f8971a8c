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
struct Head {
  std::uint32_t flags = 0, rate = 0;
  format::ClipHeader header{};
  bool is_coded() const { return (flags & packed::kClipIsCoded) != 0; }
  bool has_lists() const { return (flags & packed::kClipHasLists) != 0; }
  bool has_symbols() const { return is_coded() || has_lists(); }
};

Head take_head(ByteReader& reader) {
  Head out;
  out.flags = reader.take<std::uint8_t>();
  format::ClipHeader& h = out.header;
  h.name = reader.take_varint();
  h.skeleton = reader.take_varint();
  out.rate = reader.take_varint();
  h.duration_s = (out.flags & packed::kClipGivesDuration) != 0
                     ? reader.take<float>()
                     : time_of(static_cast<std::int32_t>(reader.take_varint()), out.rate);
  h.additive = (out.flags & packed::kClipIsAdditive) != 0 ? 1 : 0;
  if (out.has_lists()) {
    h.track_count = reader.take_varint();
    h.channel_count = reader.take_varint();
    h.time_count = reader.take_varint();
    h.value_count = reader.take_varint();
    h.reference_groups = reader.take<std::uint16_t>();
  }
  return out;
}

// What stands behind them. Returns null, or the rule that is broken.
const char* take_sizes(ByteReader& reader, const Head& head, SegmentSizes& out) {
  format::CodedHeader& h = out.header;
  h.frame_count = reader.take_varint();
  h.segment_intervals = reader.take_varint();
  if ((head.flags & packed::kClipGivesMean) != 0) h.frames_per_s = reader.take<float>();
  if ((head.flags & packed::kClipStartsLater) != 0) h.start_s = reader.take<float>();
  if ((head.flags & packed::kClipGivesMean) == 0)
    h.frames_per_s = mean_rate(h.frame_count, h.start_s, head.header.duration_s);
  h.track_count = reader.take_varint();
  if (h.frame_count < 2 || h.frame_count > format::kMaxFrames || h.segment_intervals < 1)
    return "frames or intervals out of range";
  h.time_count = (head.flags & packed::kClipIsUneven) != 0 ? h.frame_count : 0;
  return read_segment_sizes(reader, out) ? nullptr : "a clip that is too short, or larger than a file";
}

void take_times(ClipCodec<SymbolDecoder>& codec, std::uint32_t rate, std::uint32_t count, std::byte* out) {
  for (std::uint32_t i = 0; i < count; ++i) reinterpret_cast<float*>(out)[i] = codec.code_time(rate, 0);
}

// False if there is one that no encoder writes.
bool take_lists(ListModels& models, SymbolDecoder& decoder, const format::ClipHeader& h, std::byte* section) {
  const format::ClipLayout l = layout(h);
  ListCodec<SymbolDecoder> codec(models, decoder);
  auto* const tracks = reinterpret_cast<Track*>(section + l.tracks);
  auto* const channels = reinterpret_cast<Channel*>(section + l.channels);
  for (std::uint32_t t = 0; t < h.track_count; ++t) codec.code_track(tracks[t]);
  for (std::uint32_t c = 0; c < h.channel_count; ++c) codec.code_channel(channels[c]);
  bool fits = true;
  for_each_list(h, tracks, channels, [&](const ValueList& list) {
    fits = fits && codec.code_values(list, {}, reinterpret_cast<float*>(section + l.values));
  });
  return fits;
}

// From `start` on.
const char* unpack_coded(ClipCodec<SymbolDecoder>& codec, const Head& head, SegmentSizes& sizes,
                         std::uint32_t joint_count, const SegmentScratch& work, std::uint64_t start,
                         Span<std::byte> out, std::uint32_t& bytes) {
  format::CodedHeader& h = sizes.header;
  const format::CodedLayout fixed = layout(h, start, joint_count);  // up to the constants
  if (fixed.constants > out.size) return "file_bytes too small";
  const std::uint64_t payload_bytes = sizes.payload_bytes + format::kPayloadPadding;
  if (payload_bytes > UINT32_MAX) return "a clip larger than a file";
  take_times(codec, head.rate, h.time_count, out.data + fixed.times);
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
  return unpack_segments(codec, sizes, work, out.data + l.payload,
                         reinterpret_cast<std::uint32_t*>(out.data + l.offsets))
             ? nullptr
             : "a segment that is none";
}

}  // namespace

std::uint64_t clip_scratch_bytes(std::uint32_t track_count, std::uint32_t most_frames) {
  Memory count;
  take_segment_scratch(count, track_count, most_frames);
  return count.whole();
}

const char* measure_clip_record(Span<const std::byte> record, ClipNeeds& out) {
  ByteReader reader(record.data, record.size);
  const Head head = take_head(reader);
  if (!head.has_symbols()) return nullptr;
  const format::ClipLayout l = layout(head.header);
  if (l.tracks - l.reference > reader.left()) return "a clip that is too short or too long";
  reader.take_bytes(static_cast<std::size_t>(l.tracks - l.reference));
  SegmentSizes sizes;
  if (head.is_coded())
    if (const char* const rule = take_sizes(reader, head, sizes)) return rule;
  out.scratch_bytes = clip_scratch_bytes(sizes.header.track_count, sizes.most_frames);
  out.most_section_bytes = l.bytes - l.tracks + std::uint64_t{sizes.header.time_count} * 4 + sizes.payload_bytes;
  return nullptr;
}

const char* unpack_clip(Span<const std::byte> record, UnpackedSkeletons skeletons, bool& has_models,
                        Span<std::byte> scratch, Span<std::byte> out, std::uint32_t& bytes, std::uint32_t& codec) {
  ByteReader reader(record.data, record.size);
  const Head head = take_head(reader);
  const format::ClipHeader& h = head.header;
  if ((head.flags & ~std::uint32_t{packed::kAllClipFlags}) != 0) return "unknown clip flags";
  const std::uint32_t joint_count = joint_count_at(skeletons, h.skeleton);
  if (joint_count == 0) return "no such skeleton among the first records";
  const format::ClipLayout l = layout(h);
  if (l.bytes > out.size) return "file_bytes too small";
  std::memcpy(out.data, &h, sizeof h);
  copy_to(reader.take_bytes(static_cast<std::size_t>(l.tracks - l.reference)), out, l.reference);
  bytes = static_cast<std::uint32_t>(l.bytes);
  codec = head.is_coded() ? format::kCodecSegments : format::kCodecRaw;
  const char* const wrong_size = "a clip that is too short or too long";
  if (!head.has_symbols()) return reader.failed() || reader.left() != 0 ? wrong_size : nullptr;

  SegmentSizes sizes;
  if (head.is_coded())
    if (const char* const rule = take_sizes(reader, head, sizes)) return rule;
  if (reader.failed()) return wrong_size;
  Memory memory{scratch.data, 0, scratch.size};
  const SegmentScratch work = take_segment_scratch(memory, sizes.header.track_count, sizes.most_frames);
  if (memory.failed) return "memory_bytes too small";
  if (!has_models) work.models->begin();
  has_models = true;
  SymbolDecoder decoder(reader.take_bytes(reader.left()));
  ClipCodec<SymbolDecoder> symbols(*work.models, decoder);
  if (head.has_lists() && !take_lists(work.models->lists, decoder, h, out.data)) return "a list that is none";
  take_times(symbols, head.rate, h.time_count, out.data + l.times);
  if (head.is_coded())
    if (const char* const rule = unpack_coded(symbols, head, sizes, joint_count, work, l.bytes, out, bytes))
      return rule;
  return decoder.at_end() ? nullptr : wrong_size;
}

}  // namespace marrow
