// Clips in packed files (docs/format.md) → their sections.
#pragma once

#include "marrow/file.h"
#include "unpack/clip/segments.h"
#include "unpack/packed.h"
#include "unpack/structure.h"

namespace marrow {

// What a compact record will need, by the counts that it states.
struct ClipNeeds {
  std::uint64_t scratch_bytes = 0;       // as clip_scratch_bytes()
  std::uint64_t most_section_bytes = 0;  // but for what stands in the record as it is
};
// Returns null, or the rule that is broken.
const char* measure_clip_record(Span<const std::byte> record, ClipNeeds& out);

// What a clip with symbols takes beside its section: models, which stay for the next clip, ends of tracks, and the
// frames of one track of the longest segment of which a frame has bits; 0 if none has.
std::uint64_t clip_scratch_bytes(std::uint32_t track_count, std::uint32_t most_frames);

// Tracks and channels on their way; list: the one that is gone through, whose next is that of `which`.
struct ListsInWork {
  ListCodecState state;
  ValueList list;
  std::uint32_t which = 0;
};

// A clip on its way: what decodes it, and how far it is.
struct ClipInWork {
  enum class Stage : std::uint8_t { beginning, sizes, symbols, tracks, channels, values, times, masks, frames };

  Stage stage = Stage::beginning;
  std::uint32_t at = 0;  // of what the stage goes through
  ByteReader reader{nullptr, 0};
  SymbolDecoder decoder{{}};
  ClipCodecState symbols;
  SegmentSizes sizes;
  union {  // lists come before segments
    ListsInWork lists;
    SegmentsInWork segments;
  };

  ClipInWork() : lists() {}
};

// Goes on writing a section at `out`, 16-byte aligned, and says how long it is and its codec. Returns null, or the rule
// that is broken. has_models: the front of the scratch memory is as the last clip with symbols left it; set if this is
// one.
const char* unpack_clip(Span<const std::byte> record, UnpackedSkeletons skeletons, bool& has_models,
                        Span<std::byte> scratch, ClipInWork& work, Span<std::byte> out, std::uint32_t& bytes,
                        std::uint32_t& codec, bool& done);
inline const char* unpack_clip(Span<const std::byte> record, UnpackedSkeletons skeletons, bool& has_models,
                               Span<std::byte> scratch, Span<std::byte> out, std::uint32_t& bytes,
                               std::uint32_t& codec) {
  ClipInWork work;
  const char* rule = nullptr;
  for (bool done = false; !done && rule == nullptr;)
    rule = unpack_clip(record, skeletons, has_models, scratch, work, out, bytes, codec, done);
  return rule;
}

}  // namespace marrow
