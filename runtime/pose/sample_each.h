// Coded tracks one number after the other: what sample_coded.cpp does four at a time, in a fifth of the code.
#pragma once

#include <cstring>

#include "asset/format.h"
#include "pose/sample_coded.h"

namespace marrow {

// Stands at a track's header and at its integers in two neighbouring frames.
struct TrackCursor {
  const std::byte* header;
  std::size_t frame_bytes;
  const std::byte* record;         // in the first frame
  std::uint64_t bit_times_16 = 0;  // from there

  TrackCursor(const std::byte* segment, std::uint32_t track_count, std::uint32_t frame) {
    std::uint32_t bytes;
    std::memcpy(&bytes, segment, 4);
    header = segment + 4;
    frame_bytes = bytes;
    record = header + std::size_t{track_count} * sizeof(format::TrackHeader) + frame_bytes * frame;
  }
};

// The next tracks, one for each lane in `lanes`, into `out`.
[[gnu::noinline, maybe_unused]] static void unpack_each(TrackCursor& cursor, std::uint32_t lanes, FramePair& out) {
  out = {};
  std::uint64_t bit = cursor.bit_times_16 / 16;
  for (std::uint32_t lane = 0; lane < 4; ++lane) {
    if ((lanes >> lane & 1u) == 0) continue;
    format::TrackHeader h;
    std::memcpy(&h, cursor.header, sizeof h);
    cursor.header += sizeof h;
    std::uint32_t codes = h.codes[0] | std::uint32_t{h.codes[1]} << 8;
    const std::uint32_t shift = codes & 15u;
    for (std::uint32_t c = 0; c < 3; ++c) {
      codes >>= 4;
      const std::uint32_t width = format::component_bits(codes & 15u);
      const std::byte* const first = cursor.record + bit / 8;
      const auto number_at = [&](const std::byte* place) {
        std::uint32_t word;
        std::memcpy(&word, place, sizeof word);
        return static_cast<float>(static_cast<std::int32_t>(word >> bit % 8 & ((1u << width) - 1)));
      };
      out.frame[0][c][lane] = number_at(first);
      out.frame[1][c][lane] = number_at(first + cursor.frame_bytes);
      out.other[c][lane] = static_cast<float>(std::int32_t{h.least[c]} << shift);
      bit += width;
    }
    out.step[lane] = format::step_size(h.step);
  }
  cursor.bit_times_16 = bit * 16;
}

// What does not move: the rest pose, over it the constants.
[[gnu::noinline, maybe_unused]] static void set_still_each(const Skeleton& skeleton, const CodedTracks& coded,
                                                           const SampleOptions& options, SoaTransform* out) {
  const std::byte* next = coded.constants;
  for (std::size_t g = 0; g < skeleton.soa_size(); ++g) {
    const std::uint32_t wanted = wanted_lanes(options, g);
    const SoaTransform& rest = skeleton.rest[g];
    copy_some_lanes(rest, wanted, out[g]);
    for (std::uint32_t i = 0, bits = coded.frame_count != 0 ? coded.masks[g].constant : 0u; bits != 0;
         ++i, bits >>= 1) {
      if ((bits & 1u) == 0) continue;
      format::Constant c;
      std::memcpy(&c, next, sizeof c);
      next += sizeof c;
      const std::uint32_t lane = i % 4;
      if ((wanted >> lane & 1u) == 0) continue;
      float v[4];
      for (int k = 0; k < 4; ++k) v[k] = static_cast<float>(c.v[k]);
      if (i < 4) {
        const float inverse = 1.0f / square_root(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
        for (int k = 0; k < 4; ++k) out[g].rotation[k][lane] = v[k] * inverse;
      } else {
        const float step = format::step_size(static_cast<std::uint32_t>(c.v[3]));
        for (int k = 0; k < 3; ++k) (i < 8 ? out[g].translation : out[g].scale)[k][lane] += v[k] * step;
      }
    }
  }
}

}  // namespace marrow
