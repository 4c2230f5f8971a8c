#include "cook/write/clip_packer.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "cook/clip/compress/packed_cost.h"
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
  ClipFrames frames;
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

using Curves = std::array<ClipCurve, 3>;

// Of a track, from one segment on as far as its steps stay.
Curves choose_curves(const std::vector<std::vector<Numbers>>& segments, std::size_t first, std::size_t track) {
  const std::int32_t step = segments[first][track].step;
  ClipFrames frames;
  for (std::size_t s = first; s < segments.size() && segments[s][track].step == step; ++s) {
    const ClipFrames& more = segments[s][track].frames;
    frames.insert(frames.end(), more.begin() + (s > first ? 1 : 0), more.end());
  }
  return {choose_curve(frames, 0), choose_curve(frames, 1), choose_curve(frames, 2)};
}

// Which sub-tracks move, which are constant, and those.
void code_still(std::span<const std::byte> coded, const format::CodedLayout& l, ClipCodec<SymbolEncoder>& codec) {
  const auto mask_count = static_cast<std::uint32_t>((l.constants - l.masks) / 2);
  const auto mask_at = [&](std::uint32_t i) { return value_at<std::uint16_t>(coded, l.masks + std::uint64_t{2} * i); };
  for (std::uint32_t i = 0; i < mask_count; ++i) codec.code_mask(i, mask_at(i));
  std::uint64_t at = l.constants;
  for (std::uint32_t i = 1; i < mask_count; i += 2)  // of constant sub-tracks
    for (std::uint32_t left = mask_at(i); left != 0; left &= left - 1, at += sizeof(format::Constant))
      codec.code_constant(16 * (i / 2) + static_cast<std::uint32_t>(std::countr_zero(left)),
                          value_at<format::Constant>(coded, at));
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
  std::vector<std::vector<Numbers>> segments;
  for (std::uint32_t s = 0; s < format::segment_count(c); ++s) {
    const auto offset = value_at<std::uint32_t>(coded, l.offsets + std::uint64_t{s} * 4);
    segments.push_back(read_segment(coded.subspan(l.payload + offset), c.track_count, sizes.frames_of(s)));
  }
  std::vector<Curves> curves(c.track_count);
  SymbolEncoder encoder;
  ClipCodec<SymbolEncoder> codec(models_, encoder);
  code_still(coded, l, codec);
  std::vector<ClipTrackEnd> ends(c.track_count);
  for (std::size_t s = 0; s < segments.size(); ++s)
    for (std::uint32_t t = 0; t < c.track_count; ++t) {
      Numbers& numbers = segments[s][t];
      ClipTrack track;
      track.numbers = reinterpret_cast<std::int32_t(*)[3]>(numbers.frames.data());
      track.frame_count = static_cast<std::uint32_t>(numbers.frames.size());
      track.step = numbers.step;
      if (s == 0 || numbers.step != ends[t].step) curves[t] = choose_curves(segments, s, t);
      for (std::size_t i = 0; i < 3; ++i) {
        track.curves[i] = curves[t][i];
        track.curves[i].moves = moves(numbers.frames, i);
      }
      codec.code_head(track, ends[t], s == 0);
      codec.code_numbers(track, ends[t].walks);
      ends[t].step = track.step;
      for (std::size_t i = 0; i < 3; ++i) ends[t].numbers[i] = numbers.frames.back()[i];
    }
  const std::vector<std::byte> symbols = encoder.finish();
  out.insert(out.end(), symbols.begin(), symbols.end());
}

}  // namespace marrow::cook
