#include "unpack/clip/segments.h"

#include <cstring>

#include "core/step.h"
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
// Of the segment in work.
struct StoredSegment {
  std::byte* start;
  std::byte* records;
  std::uint32_t frames;
};

// Frames from at.frame on and before `end`, into bytes that are 0.
void write_numbers(const std::int32_t (*numbers)[3], const TrackFit& fit, const StoredSegment& segment,
                   const SegmentsInWork& at, std::uint32_t end) {
  std::byte* to = segment.records + std::size_t{at.frame} * at.frame_bytes + at.bit / 8;
  std::uint32_t least[3], shift[3];
  std::uint32_t bits = static_cast<std::uint32_t>(at.bit % 8);
  for (int c = 0; c < 3; ++c) {
    least[c] = static_cast<std::uint32_t>(fit.least[c]) << fit.shift;
    shift[c] = bits;
    bits += format::component_bits(fit.width_codes[c]);
  }
  for (std::uint32_t f = at.frame; f < end; ++f, to += at.frame_bytes) {
    const std::int32_t(&three)[3] = numbers[at.moving != 0 ? f : 0];
    std::uint64_t word;
    std::memcpy(&word, to, sizeof word);
    for (int c = 0; c < 3; ++c)
      if (fit.width_codes[c] != 0) word |= std::uint64_t{static_cast<std::uint32_t>(three[c]) - least[c]} << shift[c];
    std::memcpy(to, &word, sizeof word);
  }
}

// Of numbers from `from` on and before `end`.
void widen_range(const std::int32_t (*numbers)[3], std::uint32_t from, std::uint32_t end, SegmentsInWork& at) {
  for (std::uint32_t f = from; f < end; ++f)
    for (int c = 0; c < 3; ++c) {
      const std::int32_t x = numbers[f][c];
      at.low[c] = x < at.low[c] ? x : at.low[c];
      at.high[c] = x > at.high[c] ? x : at.high[c];
    }
}

format::TrackHeader header_of(const TrackFit& fit, std::int32_t step) {
  format::TrackHeader h{};
  h.codes[0] = static_cast<std::uint8_t>(fit.shift | fit.width_codes[0] << 4);
  h.codes[1] = static_cast<std::uint8_t>(fit.width_codes[1] | fit.width_codes[2] << 4);
  h.step = static_cast<std::uint8_t>(step);
  for (int c = 0; c < 3; ++c) h.least[c] = static_cast<std::int16_t>(fit.least[c]);
  return h;
}

// What stands in front of a track's numbers. A component that moves has a bit a frame at least, so that the bytes of
// the frames bound the work.
bool begin_track(ClipCodec<SymbolDecoder>& codec, const SegmentScratch& scratch, SegmentsInWork& at) {
  ClipTrack track;
  track.numbers = scratch.numbers;
  if (!codec.code_head(track, scratch.ends[at.track], at.segment == 0)) return false;
  at.step = track.step;
  at.moving = 0;
  std::uint32_t moving = 0;
  for (std::uint32_t c = 0; c < 3; ++c) {
    at.moving = static_cast<std::uint8_t>(at.moving | (track.curves[c].moves ? 1u << c : 0u));
    moving += track.curves[c].moves ? 1 : 0;
    at.low[c] = at.high[c] = scratch.numbers[0][c];
  }
  at.frame = moving > 0 ? 1 : 0;
  at.place = moving > 0 ? SegmentsInWork::Place::numbers : SegmentsInWork::Place::writing;
  return at.bit + moving <= std::uint64_t{at.frame_bytes} * 8;
}

bool decode_numbers(ClipCodec<SymbolDecoder>& codec, const SegmentScratch& scratch, const StoredSegment& segment,
                    SegmentsInWork& at, std::uint32_t end) {
  ClipTrack track;
  track.numbers = scratch.numbers;
  for (std::uint32_t c = 0; c < 3; ++c) track.curves[c].moves = (at.moving >> c & 1) != 0;
  if (!codec.code_numbers(track, scratch.ends[at.track].walks, at.frame, end)) return false;
  widen_range(scratch.numbers, at.frame, end, at);
  at.frame = end;
  if (end < segment.frames) return true;
  at.frame = 0;
  at.place = SegmentsInWork::Place::writing;
  return true;
}

// Its numbers, and when all stand there its header.
bool write_track(const SegmentScratch& scratch, const StoredSegment& segment, SegmentsInWork& at, std::uint32_t end) {
  TrackFit fit;
  if (!fit_track(at.low, at.high, fit) || at.bit + fit.bits > std::uint64_t{at.frame_bytes} * 8) return false;
  for (std::uint32_t c = 0; c < 3; ++c)
    if ((at.moving >> c & 1) != 0 && fit.width_codes[c] == 0) return false;
  if (fit.bits > 0) write_numbers(scratch.numbers, fit, segment, at, end);
  at.frame = fit.bits > 0 ? end : segment.frames;
  if (at.frame < segment.frames) return true;
  at.bit += fit.bits;
  const format::TrackHeader h = header_of(fit, at.step);
  std::memcpy(segment.start + 4 + at.track * sizeof h, &h, sizeof h);
  ClipTrackEnd& last = scratch.ends[at.track];
  last.step = at.step;
  for (int c = 0; c < 3; ++c) last.numbers[c] = scratch.numbers[at.moving != 0 ? segment.frames - 1 : 0][c];
  ++at.track;
  at.place = SegmentsInWork::Place::head;
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

bool read_segment_sizes(ByteReader& reader, SegmentSizes& sizes, std::uint32_t most) {
  if (sizes.read == 0) sizes.frame_bytes = reader;
  const std::uint64_t heads = 4 + std::uint64_t{sizes.header.track_count} * sizeof(format::TrackHeader);
  for (const std::uint32_t end = step_end(sizes.read, format::segment_count(sizes.header), most);
       sizes.read < end && !reader.failed(); ++sizes.read) {
    const std::uint32_t bytes = reader.take_varint(), frames = sizes.frames_of(sizes.read);
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

bool unpack_segments(ClipCodec<SymbolDecoder>& codec, SegmentSizes& sizes, const SegmentScratch& scratch,
                     std::byte* payload, std::uint32_t* offsets, SegmentsInWork& at, std::uint32_t& left) {
  using Place = SegmentsInWork::Place;
  const std::uint32_t heads = 4 + sizes.header.track_count * std::uint32_t{sizeof(format::TrackHeader)};
  while (left > 0 && at.segment < format::segment_count(sizes.header)) {
    std::byte* const start = payload + at.offset;
    const StoredSegment segment{start, start + heads, sizes.frames_of(at.segment)};
    const std::uint32_t bytes = segment.frames * at.frame_bytes;
    if (at.place == Place::segment) {
      at.frame_bytes = sizes.frame_bytes.take_varint();
      std::memcpy(start, &at.frame_bytes, 4);
      at.cleared = at.track = 0;
      at.bit = 0;
      at.place = Place::clearing;
    } else if (at.place == Place::clearing) {
      const std::uint32_t end = step_end(at.cleared, bytes, kStepBytes);
      std::memset(segment.records + at.cleared, 0, end - at.cleared);
      use_up((end - at.cleared) / (kStepBytes / kStepNumbers), left);
      at.cleared = end;
      if (end == bytes) at.place = Place::head;
    } else if (at.place == Place::head) {
      use_up(8, left);
      if (at.track < sizes.header.track_count) {
        if (!begin_track(codec, scratch, at)) return false;
        continue;
      }
      if ((at.bit + 7) / 8 != at.frame_bytes) return false;
      offsets[at.segment++] = at.offset;
      at.offset += heads + bytes;
      at.place = Place::segment;
    } else {
      const std::uint32_t end = step_end(at.frame, segment.frames, left / 3 + 1);
      use_up(3 * (end - at.frame), left);
      if (!(at.place == Place::numbers ? decode_numbers(codec, scratch, segment, at, end)
                                       : write_track(scratch, segment, at, end)))
        return false;
    }
  }
  return true;
}

}  // namespace marrow
