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

  std::uint32_t frames_of(std::uint32_t segment) const {
    const std::uint32_t left = header.frame_count - 1 - segment * header.segment_intervals;
    return (left < header.segment_intervals ? left : header.segment_intervals) + 1;
  }
};

// Reads frame_bytes. False if the reader ends before.
bool read_segment_sizes(ByteReader& reader, SegmentSizes& sizes);

struct SegmentScratch {
  ClipModels* models = nullptr;
  ClipTrackEnd* ends = nullptr;          // a track
  std::int32_t (*numbers)[3] = nullptr;  // a frame, at least 1
};
// Counts with a memory that has none.
SegmentScratch take_segment_scratch(Memory& memory, std::uint32_t track_count, std::uint32_t most_frames);

// Writes payload_bytes at `payload`, and where each segment begins at `offsets`. What is behind payload_bytes may be
// written, too, by up to seven bytes, as it is. False: a segment that is none.
bool unpack_segments(ClipCodec<SymbolDecoder>& codec, const SegmentSizes& sizes, const SegmentScratch& scratch,
                     std::byte* payload, std::uint32_t* offsets);

}  // namespace marrow
