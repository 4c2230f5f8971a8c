// The payload of a coded clip: symbols → segments, as sample() reads them.
#pragma once

#include "core/byte_reader.h"
#include "core/memory.h"
#include "unpack/clip/clip_codec.h"

namespace marrow {

// What a record says of a payload.
struct SegmentSizes {
  format::CodedHeader header{};        // frame_count, segment_intervals, track_count
  ByteReader frame_bytes{nullptr, 0};  // a varint a segment
  std::uint64_t payload_bytes = 0;     // without padding
  std::uint32_t most_frames = 0;       // of a segment whose frames have bits
  std::uint32_t read = 0;              // segments

  std::uint32_t frames_of(std::uint32_t segment) const {
    const std::uint32_t left = header.frame_count - 1 - segment * header.segment_intervals;
    return (left < header.segment_intervals ? left : header.segment_intervals) + 1;
  }
};

// Reads frame_bytes of the next `most` segments. False if the reader ends before.
bool read_segment_sizes(ByteReader& reader, SegmentSizes& sizes, std::uint32_t most = UINT32_MAX);

struct SegmentScratch {
  ClipModels* models = nullptr;
  ClipTrackEnd* ends = nullptr;          // a track
  std::int32_t (*numbers)[3] = nullptr;  // a frame, at least 1
};
// Counts with a memory that has none.
SegmentScratch take_segment_scratch(Memory& memory, std::uint32_t track_count, std::uint32_t most_frames);

// How far a payload is.
struct SegmentsInWork {
  enum class Place : std::uint8_t { segment, clearing, head, numbers, writing };

  std::uint32_t segment = 0, offset = 0;     // which, and where in the payload
  std::uint32_t frame_bytes = 0, track = 0;  // of the segment
  std::uint32_t frame = 0, cleared = 0;      // frames that are decoded or written; bytes
  std::uint64_t bit = 0;                     // where in frame records the track's begin
  std::int32_t step = 0, low[3] = {}, high[3] = {};
  std::uint8_t moving = 0;  // components of the track, by bits
  Place place = Place::segment;
};

// Goes on writing payload_bytes at `payload`, and where each segment begins at `offsets`, until `left` is used up. What
// is behind payload_bytes may be written, too, by up to seven bytes, as it is. False: a segment that is none.
bool unpack_segments(ClipCodec<SymbolDecoder>& codec, SegmentSizes& sizes, const SegmentScratch& scratch,
                     std::byte* payload, std::uint32_t* offsets, SegmentsInWork& at, std::uint32_t& left);

}  // namespace marrow
