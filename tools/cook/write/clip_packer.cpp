#include "cook/write/clip_packer.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "cook/clip/compress/coded_track.h"
#include "cook/geometry/record.h"
#include "cook/write/list_exponents.h"
#include "unpack/clip/clip_record.h"
#include "unpack/clip/segments.h"

namespace marrow::cook {
namespace {

template <class T>
T value_at(std::span<const std::byte> bytes, std::uint64_t at) {
  T out;
  std::memcpy(&out, bytes.data() + at, sizeof out);
  return out;
}

template <class T>
std::vector<T> all_at(std::span<const std::byte> bytes, std::uint64_t at, std::uint32_t count) {
  std::vector<T> out(count);
  if (count > 0) std::memcpy(out.data(), bytes.data() + at, count * sizeof(T));
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

void code_segments(std::span<const std::byte> coded, const SegmentSizes& sizes, std::uint32_t joint_count,
                   ClipCodec<SymbolEncoder>& codec) {
  const format::CodedHeader& c = sizes.header;
  const format::CodedLayout l = layout(c, 0, joint_count);
  std::vector<std::vector<Numbers>> segments;
  for (std::uint32_t s = 0; s < format::segment_count(c); ++s) {
    const auto offset = value_at<std::uint32_t>(coded, l.offsets + std::uint64_t{s} * 4);
    segments.push_back(read_segment(coded.subspan(l.payload + offset), c.track_count, sizes.frames_of(s)));
  }
  std::vector<Curves> curves(c.track_count);
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
}

void code_lists(std::span<const std::byte> section, const format::ClipHeader& h, ListModels& models,
                SymbolEncoder& encoder) {
  const format::ClipLayout l = layout(h);
  ListCodec<SymbolEncoder> codec(models, encoder);
  auto tracks = all_at<Track>(section, l.tracks, h.track_count);
  auto channels = all_at<Channel>(section, l.channels, h.channel_count);
  auto values = all_at<float>(section, l.values, h.value_count);
  for (Track& track : tracks) codec.code_track(track);
  for (Channel& channel : channels) codec.code_channel(channel);
  for_each_list(h, tracks.data(), channels.data(), [&](const ValueList& list) {
    codec.code_values(list, choose_exponents(list, values.data()), values.data());
  });
}

// What stands in front of a coded clip's symbols.
SegmentSizes add_sizes(std::span<const std::byte> coded, std::uint32_t flags, std::uint32_t joint_count,
                       std::vector<std::byte>& out) {
  SegmentSizes sizes;
  sizes.header = value_at<format::CodedHeader>(coded, 0);
  const format::CodedHeader& c = sizes.header;
  const format::CodedLayout l = layout(c, 0, joint_count);
  add_varint(c.frame_count, out);
  add_varint(c.segment_intervals, out);
  if ((flags & packed::kClipGivesMean) != 0) add_value(c.frames_per_s, out);
  if ((flags & packed::kClipStartsLater) != 0) add_value(c.start_s, out);
  add_varint(c.track_count, out);
  const std::size_t first = out.size();
  for (std::uint64_t at = l.offsets; at < l.masks; at += 4)
    add_varint(value_at<std::uint32_t>(coded, l.payload + value_at<std::uint32_t>(coded, at)), out);
  ByteReader reader(out.data() + first, out.size() - first);
  read_segment_sizes(reader, sizes);
  return sizes;
}

bool is_same(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

// How many bits times are coded in at a rate, about; more than `most` if it comes to that.
std::uint64_t bits_at(std::uint32_t rate, const std::vector<float>& times_s, std::uint64_t most) {
  std::uint64_t out = 0;
  std::int32_t part = 0, gap = 0;
  for (std::size_t i = 0; i < times_s.size() && out <= most; ++i) {
    const std::int32_t to = nearest_part(times_s[i], rate), now = to - part;
    const auto stray = std::bit_cast<std::int32_t>(times_s[i]) - std::bit_cast<std::int32_t>(time_of(to, rate));
    out += 2 * (bit_length(folded(now - gap)) + bit_length(folded(stray)));
    gap = now;
    part = to;
  }
  return out;
}

// Of which times are whole numbers of parts, as far as there is one.
std::uint32_t choose_rate(float duration_s, std::vector<float> times_s, const std::vector<float>& more_times_s) {
  constexpr std::uint32_t kMostTried = 1000, kFine[] = {3000, 24000, 30000, 60000, 1000000};
  times_s.insert(times_s.end(), more_times_s.begin(), more_times_s.end());
  std::uint32_t best = 0;
  std::uint64_t least = UINT64_MAX;
  const auto try_rate = [&](std::uint32_t rate) {
    const std::int32_t parts = nearest_part(duration_s, rate);
    const std::uint64_t bits = (is_same(time_of(parts, rate), duration_s) ? bit_length(folded(parts)) : 32) +
                               bit_length(rate) + bits_at(rate, times_s, least);
    if (bits >= least) return;
    least = bits;
    best = rate;
  };
  for (std::uint32_t rate = 1; rate <= kMostTried; ++rate) try_rate(rate);
  for (const std::uint32_t rate : kFine) try_rate(rate);
  return best;
}

// c: all 0 where nothing is coded.
std::uint32_t flags_of(const format::ClipHeader& h, const format::CodedHeader& c, std::uint32_t rate) {
  const bool coded = c.frame_count > 0;
  std::uint32_t flags = coded ? packed::kClipIsCoded : 0u;
  if (h.additive != 0) flags |= packed::kClipIsAdditive;
  if (layout(h).bytes > sizeof h) flags |= packed::kClipHasLists;
  if (c.start_s != 0) flags |= packed::kClipStartsLater;
  if (c.time_count != 0) flags |= packed::kClipIsUneven;
  if (!is_same(time_of(nearest_part(h.duration_s, rate), rate), h.duration_s)) flags |= packed::kClipGivesDuration;
  if (coded && !is_same(mean_rate(c.frame_count, c.start_s, h.duration_s), c.frames_per_s))
    flags |= packed::kClipGivesMean;
  return flags;
}

}  // namespace

std::vector<std::byte> ClipPacker::pack(std::span<const std::byte> section, std::uint32_t codec,
                                        std::size_t joint_count) {
  const auto h = value_at<format::ClipHeader>(section, 0);
  const format::ClipLayout lists = layout(h);
  const std::span<const std::byte> coded = section.subspan(lists.bytes);
  format::CodedHeader c{};
  if (codec == format::kCodecSegments) c = value_at<format::CodedHeader>(coded, 0);
  const std::vector<float> list_times = all_at<float>(section, lists.times, h.time_count);
  const std::vector<float> frame_times = all_at<float>(coded, sizeof c, c.time_count);
  const std::uint32_t rate = choose_rate(h.duration_s, list_times, frame_times);
  const std::uint32_t flags = flags_of(h, c, rate);

  std::vector<std::byte> out = {static_cast<std::byte>(flags)};
  for (const std::uint32_t n : {h.name, h.skeleton, rate}) add_varint(n, out);
  if ((flags & packed::kClipGivesDuration) != 0)
    add_value(h.duration_s, out);
  else
    add_varint(static_cast<std::uint32_t>(nearest_part(h.duration_s, rate)), out);
  if ((flags & packed::kClipHasLists) != 0) {
    for (const std::uint32_t count : {h.track_count, h.channel_count, h.time_count, h.value_count})
      add_varint(count, out);
    add_value(h.reference_groups, out);
  }
  out.insert(out.end(), section.begin() + static_cast<std::ptrdiff_t>(lists.reference),
             section.begin() + static_cast<std::ptrdiff_t>(lists.tracks));
  if (c.frame_count == 0 && (flags & packed::kClipHasLists) == 0) return out;
  SymbolEncoder encoder;
  ClipCodec<SymbolEncoder> symbols(models_, encoder);
  code_lists(section, h, models_.lists, encoder);
  for (const float time_s : list_times) symbols.code_time(rate, time_s);
  SegmentSizes sizes;
  if (c.frame_count > 0) {
    sizes = add_sizes(coded, flags, static_cast<std::uint32_t>(joint_count), out);
    for (const float time_s : frame_times) symbols.code_time(rate, time_s);
    code_still(coded, layout(c, 0, static_cast<std::uint32_t>(joint_count)), symbols);
    code_segments(coded, sizes, static_cast<std::uint32_t>(joint_count), symbols);
  }
  scratch_bytes_ = std::max(scratch_bytes_, clip_scratch_bytes(c.track_count, sizes.most_frames));
  const std::vector<std::byte> bytes = encoder.finish();
  out.insert(out.end(), bytes.begin(), bytes.end());
  return out;
}

}  // namespace marrow::cook
