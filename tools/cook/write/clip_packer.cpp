#include "cook/write/clip_packer.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "cook/geometry/record.h"
#include "cook/geometry/symbol_encoder.h"
#include "unpack/clip/clip.h"
#include "unpack/clip/segments.h"

namespace marrow::cook {
namespace {

template <class T>
T value_at(std::span<const std::byte> bytes, std::uint64_t at) {
  T out;
  std::memcpy(&out, bytes.data() + at, sizeof out);
  return out;
}

// Frames and header of a track that a segment begins with or goes on with.
struct Numbers {
  std::vector<std::array<std::int32_t, 3>> frames;
  std::int32_t step = 0;
};

// A segment that the cooker has written: all tracks' numbers.
std::vector<Numbers> read_segment(std::span<const std::byte> segment, std::uint32_t track_count,
                                  std::uint32_t frame_count) {
  const auto frame_bytes = value_at<std::uint32_t>(segment, 0);
  const std::byte* const records = segment.data() + 4 + track_count * sizeof(format::TrackHeader);
  std::vector<Numbers> out(track_count);
  std::uint64_t bit = 0;
  for (std::uint32_t t = 0; t < track_count; ++t) {
    const auto h = value_at<format::TrackHeader>(segment, 4 + t * sizeof(format::TrackHeader));
    const std::uint32_t packed = static_cast<std::uint32_t>(h.codes[0] | h.codes[1] << 8);
    const std::uint32_t shift = packed & 15, codes[3] = {packed >> 4 & 15, packed >> 8 & 15, packed >> 12};
    out[t].step = h.step;
    out[t].frames.resize(frame_count);
    for (std::uint32_t f = 0; f < frame_count; ++f) {
      std::uint64_t word = 0;
      std::memcpy(&word, records + std::size_t{f} * frame_bytes + bit / 8, sizeof word);
      word >>= bit % 8;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t bits = format::component_bits(codes[c]);
        out[t].frames[f][c] = static_cast<std::int32_t>(word & ((1u << bits) - 1)) + h.least[c] * (1 << shift);
        word >>= bits;
      }
    }
    for (const std::uint32_t code : codes) bit += format::component_bits(code);
  }
  return out;
}

// A product of numbers from 1 to 2^64, which orders as the sum of their logarithms does: rest · 2^(512 · scales).
struct LongProduct {
  std::size_t scales = 0;
  double rest = 1;

  void times(double x) {
    rest *= x;
    if (rest < 0x1p512) return;
    rest *= 0x1p-512;
    ++scales;
  }
  auto operator<=>(const LongProduct&) const = default;
};

// Of two predictors about the same, the first.
ClipCurve choose_curve(const Numbers& numbers, std::size_t component) {
  constexpr std::size_t kFirstFrames = 11;  // that say how far predictions are off at first
  ClipCurve best;
  const auto& frames = numbers.frames;
  const auto at = [&](std::size_t f) { return frames[f][component]; };
  for (std::size_t f = 1; f < frames.size(); ++f) best.moves = best.moves || at(f) != at(0);
  std::optional<LongProduct> least;
  for (std::uint32_t p = 0; best.moves && p < kClipPredictors; ++p) {
    LongProduct bits;  // 2 to their power
    std::int64_t first = 0, d1 = 0, d2 = 0;
    for (std::size_t f = 1; f < frames.size(); ++f) {
      const std::int64_t step = at(f) - at(f - 1);
      const std::int64_t off = std::abs(16 * step - kClipPredictor[p].a * d1 - kClipPredictor[p].b * d2);
      bits.times(static_cast<double>(8 + off));
      if (f <= kFirstFrames) first += off;
      d2 = d1;
      d1 = step;
    }
    if (least && bits >= *least) continue;
    least = bits;
    best.predictor = p;
    const auto count = static_cast<std::int64_t>(std::min(kFirstFrames, frames.size() - 1));
    best.scale = ClipScale::nearest(static_cast<std::int32_t>(first / count));
  }
  return best;
}

}  // namespace

std::vector<std::byte> ClipPacker::pack(std::span<const std::byte> section, std::uint32_t codec,
                                        std::size_t joint_count) {
  const auto h = value_at<format::ClipHeader>(section, 0);
  const format::ClipLayout lists = layout(h);
  const bool coded = codec == format::kCodecSegments;
  format::CodedHeader c{};
  if (coded) c = value_at<format::CodedHeader>(section, lists.bytes);
  std::uint32_t flags = coded ? packed::kClipIsCoded : 0u;
  if (h.additive != 0) flags |= packed::kClipIsAdditive;
  if (lists.bytes > sizeof h) flags |= packed::kClipHasLists;
  if (c.start_s != 0) flags |= packed::kClipStartsLater;
  if (c.time_count != 0) flags |= packed::kClipIsUneven;

  std::vector<std::byte> out = {static_cast<std::byte>(flags)};
  add_varint(h.name, out);
  add_varint(h.skeleton, out);
  add_value(h.duration_s, out);
  if ((flags & packed::kClipHasLists) != 0) {
    for (const std::uint32_t count : {h.track_count, h.channel_count, h.time_count, h.value_count})
      add_varint(count, out);
    add_value(h.reference_groups, out);
  }
  out.insert(out.end(), section.begin() + sizeof h, section.begin() + static_cast<std::ptrdiff_t>(lists.bytes));
  if (coded) add_coded(section.subspan(lists.bytes), joint_count, out);
  return out;
}

void ClipPacker::add_coded(std::span<const std::byte> coded, std::size_t joint_count, std::vector<std::byte>& out) {
  const auto c = value_at<format::CodedHeader>(coded, 0);
  const format::CodedLayout l = layout(c, 0, static_cast<std::uint32_t>(joint_count));
  const auto add_bytes = [&](std::uint64_t first, std::uint64_t end) {
    const auto part = coded.subspan(first, end - first);
    out.insert(out.end(), part.begin(), part.end());
  };
  SegmentSizes sizes;
  sizes.header = c;
  add_varint(c.frame_count, out);
  add_varint(c.segment_intervals, out);
  add_value(c.frames_per_s, out);
  if (c.start_s != 0) add_value(c.start_s, out);
  add_varint(c.track_count, out);
  const std::size_t first_size = out.size();
  for (std::uint64_t at = l.offsets; at < l.masks; at += 4)
    add_varint(value_at<std::uint32_t>(coded, l.payload + value_at<std::uint32_t>(coded, at)), out);
  ByteReader reader(out.data() + first_size, out.size() - first_size);
  read_segment_sizes(reader, sizes);
  scratch_bytes_ = std::max(scratch_bytes_, clip_scratch_bytes(c.track_count, sizes.most_frames));
  add_bytes(l.times, l.offsets);
  for (std::uint64_t at = l.masks; at < l.constants; at += 2) add_varint(value_at<std::uint16_t>(coded, at), out);
  add_bytes(l.constants, l.payload);

  SymbolEncoder encoder;
  ClipCodec<SymbolEncoder> codec(models_, encoder);
  std::vector<ClipTrackEnd> ends(c.track_count);
  for (std::uint32_t s = 0; s < format::segment_count(c); ++s) {
    const auto offset = value_at<std::uint32_t>(coded, l.offsets + std::uint64_t{s} * 4);
    std::vector<Numbers> tracks = read_segment(coded.subspan(l.payload + offset), c.track_count, sizes.frames_of(s));
    for (std::uint32_t t = 0; t < c.track_count; ++t) {
      ClipTrack track;
      track.numbers = reinterpret_cast<std::int32_t(*)[3]>(tracks[t].frames.data());
      track.frame_count = sizes.frames_of(s);
      track.step = tracks[t].step;
      for (std::size_t i = 0; i < 3; ++i) track.curves[i] = choose_curve(tracks[t], i);
      codec.code_head(track, s > 0 ? &ends[t] : nullptr);
      codec.code_numbers(track);
      ends[t].step = track.step;
      for (std::size_t i = 0; i < 3; ++i) ends[t].numbers[i] = tracks[t].frames.back()[i];
    }
  }
  const std::vector<std::byte> symbols = encoder.finish();
  out.insert(out.end(), symbols.begin(), symbols.end());
}

}  // namespace marrow::cook
