#include "unpack/clip/segments.h"

#include <cstring>

#include "unpack/clip/track_fit.h"

namespace marrow {
namespace {

// What is likely at first, by how far predictions are off; from half octave 10 on two in turn. From the clips of seven
// characters.
constexpr std::uint8_t kGuess[12][SymbolModel::kCount] = {{209, 16, 18, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1},
                                                          {168, 36, 36, 3, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1},
                                                          {130, 53, 51, 6, 5, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1},
                                                          {116, 54, 50, 12, 11, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1},
                                                          {88, 52, 50, 18, 19, 6, 6, 2, 5, 3, 2, 1, 1, 1, 1, 1},
                                                          {69, 42, 43, 23, 23, 13, 12, 5, 13, 3, 4, 2, 1, 1, 1, 1},
                                                          {62, 37, 35, 24, 23, 14, 14, 9, 21, 6, 4, 2, 2, 1, 1, 1},
                                                          {51, 29, 29, 20, 18, 15, 15, 11, 28, 13, 9, 3, 11, 2, 1, 1},
                                                          {44, 21, 20, 15, 16, 14, 13, 12, 40, 21, 21, 6, 7, 4, 1, 1},
                                                          {36, 17, 16, 12, 10, 10, 9, 9, 37, 31, 27, 18, 16, 3, 4, 1},
                                                          {32, 14, 13, 9, 9, 8, 8, 7, 26, 26, 40, 18, 28, 11, 5, 2},
                                                          {35, 13, 11, 8, 8, 7, 7, 7, 22, 19, 37, 25, 36, 15, 4, 2}};
// Where the next track's bits go in frame records.
struct FrameCursor {
  std::byte* records;
  std::uint32_t frame_bytes;
  std::uint64_t bit = 0;
};

// Into bytes that are 0.
void write_numbers(const ClipTrack& track, bool moves, const TrackFit& fit, const FrameCursor& at) {
  std::byte* to = at.records + at.bit / 8;
  std::uint32_t least[3], shift[3];
  std::uint32_t bits = static_cast<std::uint32_t>(at.bit % 8);
  for (int c = 0; c < 3; ++c) {
    least[c] = static_cast<std::uint32_t>(fit.least[c]) << fit.shift;
    shift[c] = bits;
    bits += format::component_bits(fit.width_codes[c]);
  }
  for (std::uint32_t f = 0; f < track.frame_count; ++f, to += at.frame_bytes) {
    const std::int32_t(&numbers)[3] = track.numbers[moves ? f : 0];
    std::uint64_t word;
    std::memcpy(&word, to, sizeof word);
    for (int c = 0; c < 3; ++c)
      if (fit.width_codes[c] != 0) word |= std::uint64_t{static_cast<std::uint32_t>(numbers[c]) - least[c]} << shift[c];
    std::memcpy(to, &word, sizeof word);
  }
}

bool find_fit(const ClipTrack& track, bool moves, TrackFit& out) {
  std::int32_t low[3], high[3];
  for (int c = 0; c < 3; ++c) low[c] = high[c] = track.numbers[0][c];
  for (std::uint32_t f = 1; moves && f < track.frame_count; ++f)
    for (int c = 0; c < 3; ++c) {
      const std::int32_t x = track.numbers[f][c];
      low[c] = x < low[c] ? x : low[c];
      high[c] = x > high[c] ? x : high[c];
    }
  return fit_track(low, high, out);
}

format::TrackHeader header_of(const TrackFit& fit, std::int32_t step) {
  format::TrackHeader h{};
  h.codes[0] = static_cast<std::uint8_t>(fit.shift | fit.width_codes[0] << 4);
  h.codes[1] = static_cast<std::uint8_t>(fit.width_codes[1] | fit.width_codes[2] << 4);
  h.step = static_cast<std::uint8_t>(step);
  for (int c = 0; c < 3; ++c) h.least[c] = static_cast<std::int16_t>(fit.least[c]);
  return h;
}

// A track of a segment, its header and its numbers. A component that moves has a bit a frame at least, so that the
// bytes of the frames bound the work.
bool unpack_track(ClipCodec<SymbolDecoder>& codec, ClipTrack& track, bool is_first, FrameCursor& at, std::byte* header,
                  ClipTrackEnd& end) {
  if (!codec.code_head(track, end, is_first)) return false;
  std::uint32_t moving = 0;
  for (const ClipCurve& curve : track.curves) moving += curve.moves ? 1 : 0;
  const std::uint64_t room = std::uint64_t{at.frame_bytes} * 8;
  if (at.bit + moving > room || (moving > 0 && !codec.code_numbers(track, end.walks))) return false;
  TrackFit fit;
  if (!find_fit(track, moving > 0, fit) || at.bit + fit.bits > room) return false;
  for (int c = 0; c < 3; ++c)
    if (track.curves[c].moves && fit.width_codes[c] == 0) return false;
  if (fit.bits > 0) write_numbers(track, moving > 0, fit, at);
  at.bit += fit.bits;
  const format::TrackHeader h = header_of(fit, track.step);
  std::memcpy(header, &h, sizeof h);
  end.step = track.step;
  for (int c = 0; c < 3; ++c) end.numbers[c] = track.numbers[moving > 0 ? track.frame_count - 1 : 0][c];
  return true;
}

}  // namespace

void ListModels::begin() {
  for (auto& place : values)
    for (std::uint32_t size = 0; size < kSizes; ++size) begin_near(size, place[size]);
  begin_near(1, exponents);
  for (SymbolModel& model : words) begin_near(1, model);
}

void ClipModels::begin() {
  constexpr std::uint32_t kDistinct = 10;
  for (std::uint32_t scale = 0; scale < ClipScale::kCount; ++scale)
    for (auto& size : numbers[scale])
      for (SymbolModel& model : size) model.begin(kGuess[scale < kDistinct ? scale : kDistinct + scale % 2], true);
  begin_evenly(&gaps, 1);
  begin_evenly(&strays, 1);
  begin_evenly(steps, 2);
  begin_evenly(firsts, 2);
  begin_evenly(scales, 2);
  begin_evenly(&predictors, 1);
  begin_evenly(moves, 2);
  begin_evenly(masks, 2);
  begin_evenly(constants, 2);
  begin_evenly(&mask_changes, 1);
  begin_evenly(&constant_changes, 1);
  lists.begin();
  std::memset(last_masks, 0, sizeof last_masks);
  std::memset(last_constants, 0, sizeof last_constants);
}

bool read_segment_sizes(ByteReader& reader, SegmentSizes& sizes) {
  sizes.frame_bytes = reader;
  const std::uint64_t heads = 4 + std::uint64_t{sizes.header.track_count} * sizeof(format::TrackHeader);
  const std::uint32_t count = format::segment_count(sizes.header);
  for (std::uint32_t i = 0; i < count && !reader.failed(); ++i) {
    const std::uint32_t bytes = reader.take_varint(), frames = sizes.frames_of(i);
    sizes.payload_bytes += heads + std::uint64_t{frames} * bytes;
    if (bytes > 0 && frames > sizes.most_frames) sizes.most_frames = frames;
    if (sizes.payload_bytes > UINT32_MAX) return false;
  }
  return !reader.failed();
}

SegmentScratch take_segment_scratch(Memory& memory, std::uint32_t track_count, std::uint32_t most_frames) {
  SegmentScratch out;
  out.models = memory.take<ClipModels>(1).data;
  out.ends = memory.take<ClipTrackEnd>(track_count).data;
  out.numbers = memory.take<std::int32_t[3]>(std::uint64_t{most_frames} + 1).data;
  return out;
}

bool unpack_segments(ClipCodec<SymbolDecoder>& codec, const SegmentSizes& sizes, const SegmentScratch& scratch,
                     std::byte* payload, std::uint32_t* offsets) {
  ByteReader frame_bytes = sizes.frame_bytes;
  std::uint32_t offset = 0;
  for (std::uint32_t s = 0; s < format::segment_count(sizes.header); ++s) {
    ClipTrack track;
    track.numbers = scratch.numbers;
    track.frame_count = sizes.frames_of(s);
    const std::uint32_t bytes = frame_bytes.take_varint();
    const std::uint32_t heads = 4 + sizes.header.track_count * std::uint32_t{sizeof(format::TrackHeader)};
    std::byte* const segment = payload + offset;
    std::memcpy(segment, &bytes, 4);
    std::memset(segment + heads, 0, std::size_t{track.frame_count} * bytes);
    FrameCursor at{segment + heads, bytes};
    for (std::uint32_t t = 0; t < sizes.header.track_count; ++t)
      if (!unpack_track(codec, track, s == 0, at, segment + 4 + t * sizeof(format::TrackHeader), scratch.ends[t]))
        return false;
    if ((at.bit + 7) / 8 != bytes) return false;
    offsets[s] = offset;
    offset += heads + track.frame_count * bytes;
  }
  return true;
}

}  // namespace marrow
