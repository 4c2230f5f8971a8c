#include "unpack/clip/clip_record.h"

#include <bit>
#include <new>

#include "core/step.h"

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

// What stands behind them, up to the segments' sizes. Returns null, or the rule that is broken.
const char* take_coded_header(ByteReader& reader, const Head& head, format::CodedHeader& h) {
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
  return nullptr;
}

constexpr const char *kWrongClipSize = "a clip that is too short or too long",
                     *kTooLarge = "a clip that is too short, or larger than a file";

// One step of a clip, over what `work` has of it.
class ClipStep {
 public:
  using Stage = ClipInWork::Stage;

  ClipStep(Span<const std::byte> record, std::uint32_t joint_count, Span<std::byte> scratch, ClipInWork& work,
           Span<std::byte> out)
      : record_(record),
        reader_(record.data, record.size),
        head_(take_head(reader_)),
        lists_(layout(head_.header)),
        joint_count_(joint_count),
        scratch_(scratch),
        w_(work),
        out_(out) {}

  const char* run(bool& has_models, std::uint32_t& bytes, std::uint32_t& codec, bool& done) {
    if (w_.stage == Stage::beginning) {
      const char* const rule = begin(bytes, codec, done);
      if (rule != nullptr || done) return rule;
    }
    if (w_.stage == Stage::sizes) {
      const std::uint32_t before = w_.sizes.read;
      if (!read_segment_sizes(w_.reader, w_.sizes, left_)) return kTooLarge;
      use_up(w_.sizes.read - before, left_);
      if (w_.sizes.read == format::segment_count(w_.sizes.header)) w_.stage = Stage::symbols;
    }
    if (w_.stage == Stage::symbols) {
      if (w_.reader.failed()) return kWrongClipSize;
      Memory memory{scratch_.data, 0, scratch_.size};
      const SegmentScratch whole = take_segment_scratch(memory, w_.sizes.header.track_count, w_.sizes.most_frames);
      if (memory.failed) return "memory_bytes too small";
      if (!has_models) whole.models->begin();
      has_models = true;
      w_.decoder = SymbolDecoder(w_.reader.take_bytes(w_.reader.left()));
      next(head_.has_lists() ? Stage::tracks : Stage::times);
    }
    Memory memory{scratch_.data, 0, scratch_.size};
    const SegmentScratch scratch = take_segment_scratch(memory, w_.sizes.header.track_count, 0);
    if (w_.stage >= Stage::tracks && w_.stage <= Stage::values && !take_lists(scratch.models->lists))
      return "a list that is none";
    if (w_.stage < Stage::times) return nullptr;
    ClipCodec<SymbolDecoder> symbols(*scratch.models, w_.decoder, w_.symbols);
    const char* const rule = take_rest(symbols, scratch, bytes, done);
    w_.symbols = symbols.state();
    return rule;
  }

 private:
  const char* begin(std::uint32_t& bytes, std::uint32_t& codec, bool& done) {
    if ((head_.flags & ~std::uint32_t{packed::kAllClipFlags}) != 0) return "unknown clip flags";
    if (joint_count_ == 0) return "no such skeleton among the first records";
    if (lists_.bytes > out_.size) return "file_bytes too small";
    std::memcpy(out_.data, &head_.header, sizeof head_.header);
    copy_to(reader_.take_bytes(static_cast<std::size_t>(lists_.tracks - lists_.reference)), out_, lists_.reference);
    bytes = static_cast<std::uint32_t>(lists_.bytes);
    codec = head_.is_coded() ? format::kCodecSegments : format::kCodecRaw;
    if (!head_.has_symbols()) {
      done = true;
      return reader_.failed() || reader_.left() != 0 ? kWrongClipSize : nullptr;
    }
    if (head_.is_coded())
      if (const char* const rule = take_coded_header(reader_, head_, w_.sizes.header)) return rule;
    w_.reader = reader_;
    next(head_.is_coded() ? Stage::sizes : Stage::symbols);
    return nullptr;
  }

  // False if there is one that no encoder writes.
  bool take_lists(ListModels& models) {
    const format::ClipHeader& h = head_.header;
    auto& at = w_.lists;
    ListCodec<SymbolDecoder> codec(models, w_.decoder, at.state);
    auto* const tracks = reinterpret_cast<Track*>(out_.data + lists_.tracks);
    auto* const channels = reinterpret_cast<Channel*>(out_.data + lists_.channels);
    if (w_.stage == Stage::tracks)
      each(h.track_count, 4, Stage::channels, [&](std::uint32_t t) { codec.code_track(tracks[t]); });
    if (w_.stage == Stage::channels)
      each(h.channel_count, 4, Stage::values, [&](std::uint32_t c) { codec.code_channel(channels[c]); });
    bool fits = true;
    while (w_.stage == Stage::values && fits && left_ > 0) {
      if (w_.at == at.list.count) {
        w_.at = 0;
        if (!next_list(h, tracks, channels, at.which, at.list)) {
          next(Stage::times);
          break;
        }
      }
      const std::uint32_t end = step_end(w_.at, at.list.count, left_);
      fits = codec.code_values(at.list, {}, reinterpret_cast<float*>(out_.data + lists_.values), w_.at, end);
      use_up(end - w_.at + 1, left_);
      w_.at = end;
    }
    if (w_.stage <= Stage::values) at.state = codec.state();
    return fits;
  }

  // Times and segments of what is coded; channels' and tracks' times are coded the same way.
  const char* take_rest(ClipCodec<SymbolDecoder>& symbols, const SegmentScratch& scratch, std::uint32_t& bytes,
                        bool& done) {
    const format::ClipHeader& h = head_.header;
    format::CodedHeader& coded = w_.sizes.header;
    const std::uint64_t start = lists_.bytes;
    format::CodedLayout fixed{};  // up to the constants
    if (head_.is_coded()) fixed = layout(coded, start, joint_count_);
    if (w_.stage == Stage::times) {
      if (head_.is_coded() && fixed.constants > out_.size) return "file_bytes too small";
      const std::uint64_t payload_bytes = w_.sizes.payload_bytes + format::kPayloadPadding;
      if (payload_bytes > UINT32_MAX) return "a clip larger than a file";
      const std::uint64_t count = std::uint64_t{h.time_count} + coded.time_count;
      if (count > UINT32_MAX) return "a clip larger than a file";
      each(static_cast<std::uint32_t>(count), 2, Stage::masks, [&](std::uint32_t i) {
        const bool is_frame = i >= h.time_count;
        auto* const times = reinterpret_cast<float*>(out_.data + (is_frame ? fixed.times : lists_.times));
        times[is_frame ? i - h.time_count : i] = symbols.code_time(head_.rate, 0);
      });
    }
    if (w_.stage == Stage::masks && head_.is_coded()) {
      auto* const masks = reinterpret_cast<GroupMasks*>(out_.data + fixed.masks);
      const auto groups = static_cast<std::uint32_t>(soa_count(joint_count_));
      if (!take_masks(symbols, groups, masks, coded)) return "masks that are not the tracks'";
      coded.payload_bytes = static_cast<std::uint32_t>(w_.sizes.payload_bytes + format::kPayloadPadding);
      const format::CodedLayout l = layout(coded, start, joint_count_);
      if (l.bytes > out_.size) return "file_bytes too small";
      std::memcpy(out_.data + l.header, &coded, sizeof coded);
      take_constants(symbols, groups, masks, reinterpret_cast<format::Constant*>(out_.data + l.constants));
      std::memset(out_.data + l.bytes - format::kPayloadPadding, 0, format::kPayloadPadding);
      bytes = static_cast<std::uint32_t>(l.bytes);
      use_up(8 * groups + 4 * coded.constant_count, left_);
    }
    if (w_.stage == Stage::masks) {
      ::new (&w_.segments) SegmentsInWork;
      next(Stage::frames);
    }
    if (w_.stage == Stage::frames && head_.is_coded()) {
      const format::CodedLayout l = layout(coded, start, joint_count_);
      if (!unpack_segments(symbols, w_.sizes, scratch, out_.data + l.payload,
                           reinterpret_cast<std::uint32_t*>(out_.data + l.offsets), w_.segments, left_))
        return "a segment that is none";
    }
    done = w_.stage == Stage::frames && (!head_.is_coded() || w_.segments.segment == format::segment_count(coded));
    return !done || w_.decoder.at_end() ? nullptr : kWrongClipSize;
  }

  // Elements from where the stage is, of so much work each; then the next stage.
  template <class F>
  void each(std::uint32_t count, std::uint32_t work, Stage then, const F& f) {
    for (; w_.at < count && left_ > 0; ++w_.at) {
      f(w_.at);
      use_up(work, left_);
    }
    if (w_.at == count) next(then);
  }
  void next(Stage stage) {
    w_.stage = stage;
    w_.at = 0;
  }

  Span<const std::byte> record_;
  ByteReader reader_;
  Head head_;
  format::ClipLayout lists_;
  std::uint32_t joint_count_;
  Span<std::byte> scratch_;
  ClipInWork& w_;
  Span<std::byte> out_;
  std::uint32_t left_ = kStepNumbers;
};

}  // namespace

std::uint64_t clip_scratch_bytes(std::uint32_t track_count, std::uint32_t most_frames) {
  Memory count;
  take_segment_scratch(count, track_count, most_frames);
  return count.whole();
}

const char* measure_clip_record(Span<const std::byte> record, ClipNeeds& out) {
  // A symbol takes a 95th of a bit or more, see bounds_record.cpp, and says 19 bits of a frame at most.
  constexpr std::uint64_t kMostBytesOfByte = 4096, kMostFramesOfByte = 1024;
  ByteReader reader(record.data, record.size);
  const Head head = take_head(reader);
  if (!head.has_symbols()) return nullptr;
  const format::ClipLayout l = layout(head.header);
  if (l.tracks - l.reference > reader.left()) return kWrongClipSize;
  reader.take_bytes(static_cast<std::size_t>(l.tracks - l.reference));
  SegmentSizes sizes;
  if (head.is_coded()) {
    if (const char* const rule = take_coded_header(reader, head, sizes.header)) return rule;
    if (!read_segment_sizes(reader, sizes)) return kTooLarge;
  }
  out.scratch_bytes = clip_scratch_bytes(sizes.header.track_count, sizes.most_frames);
  out.most_section_bytes = l.bytes - l.tracks + std::uint64_t{sizes.header.time_count} * 4 + sizes.payload_bytes;
  return out.most_section_bytes > kMostBytesOfByte * record.size || sizes.most_frames > kMostFramesOfByte * record.size
             ? kTooLarge
             : nullptr;
}

const char* unpack_clip(Span<const std::byte> record, UnpackedSkeletons skeletons, bool& has_models,
                        Span<std::byte> scratch, ClipInWork& work, Span<std::byte> out, std::uint32_t& bytes,
                        std::uint32_t& codec, bool& done) {
  done = false;
  ByteReader reader(record.data, record.size);
  const std::uint32_t joint_count = joint_count_at(skeletons, take_head(reader).header.skeleton);
  return ClipStep(record, joint_count, scratch, work, out).run(has_models, bytes, codec, done);
}

}  // namespace marrow
