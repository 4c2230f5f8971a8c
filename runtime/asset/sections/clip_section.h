// CLIP: an animation of one skeleton, as keys; behind those, where its codec says so, coded segments.
#pragma once

#include "asset/sections/fields.h"
#include "core/builtins.h"
#include "marrow/file.h"

namespace marrow::format {

struct ClipHeader {
  std::uint32_t name;
  std::uint32_t skeleton;
  float duration_s;
  std::uint32_t track_count;
  std::uint32_t time_count;
  std::uint32_t value_count;
  std::uint32_t channel_count;
  std::uint16_t additive;
  std::uint16_t reference_groups;
};
static_assert(sizeof(ClipHeader) == 32);

struct ClipLayout {
  Array<SoaTransform> reference;
  Array<Track> tracks;
  Array<Channel> channels;
  Array<float> times, values;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<ClipHeader> {
  using Type = ClipLayout;
};

inline constexpr const char* kNoInterpolation = "unknown interpolation";

template <class V>
constexpr void fields(V& v, const Track& t) {
  v.joint({"joint", "below the skeleton's joint_count"}, t.joint, "track's joint outside the skeleton");
  v.range({"path", "0 translation, 1 rotation, 2 scale"}, t.path, TrackPath::translation, TrackPath::scale,
          "unknown path");
  v.range({"interpolation", "0 STEP, 1 LINEAR, 2 CUBICSPLINE"}, t.interpolation, Interpolation::step,
          Interpolation::cubic_spline, kNoInterpolation);
  v.any({"key_count", "≥ 1"}, t.key_count);
  v.any({"first_time", "into times"}, t.first_time);
  v.any({"first_value", "into values"}, t.first_value);
}

template <class V>
constexpr void fields(V& v, const Channel& c) {
  v.name({"name", "offset into NAME"}, c.name);
  v.finite({"rest", "the number where no clip drives it"}, c.rest);
  v.any({"key_count", "≥ 1"}, c.key_count);
  v.any({"first_time", "into times"}, c.first_time);
  v.any({"first_value", "into values"}, c.first_value);
  v.range({"interpolation", "as a track's"}, c.interpolation, Interpolation::step, Interpolation::cubic_spline,
          kNoInterpolation);
  v.reserved(c.reserved);
}

template <class V>
constexpr void fields(V& v, const ClipHeader& h, ClipLayout& l) {
  v.name({"name", "offset into NAME"}, h.name);
  v.skeleton_or_reference({"skeleton", "which SKEL section; in a clip pack, which SREF section"}, h.skeleton);
  v.bounded({"duration_s", "≥ 0"}, h.duration_s);
  v.not_negative({}, h.duration_s, "a duration is not negative");
  v.any({"track_count"}, h.track_count);
  v.any({"time_count"}, h.time_count);
  v.any({"value_count"}, h.value_count);
  v.any({"channel_count"}, h.channel_count);
  v.range({"additive", "0; 1: changes from the reference"}, h.additive, 0u, 1u, "additive is 0 or 1");
  v.any({"reference_groups", "0: the rest pose is the reference; else ⌈joint_count / 4⌉, and additive is 1"},
        h.reference_groups);
  v.array({"reference", "as SKEL's rest", "reference_groups"}, l.reference, h.reference_groups);
  v.records({"tracks", "see below", "track_count"}, l.tracks, h.track_count, [&](const Track& t) { fields(v, t); });
  v.records({"channels", "see below", "channel_count"}, l.channels, h.channel_count,
            [&](const Channel& c) { fields(v, c); });
  v.array({"times", "seconds", "time_count"}, l.times, h.time_count, Floats::finite);
  v.array({"values", "", "value_count"}, l.values, h.value_count, Floats::finite);
}

// What a clip of codec 1 has behind all that.
struct CodedHeader {
  std::uint32_t frame_count;
  std::uint32_t segment_intervals;
  float start_s;
  float frames_per_s;
  std::uint32_t track_count;
  std::uint32_t constant_count;
  std::uint32_t payload_bytes;
  std::uint32_t time_count;
};
static_assert(sizeof(CodedHeader) == 32);

// Four numbers a constant sub-track. A rotation's quaternion up to a factor; or x, y, z and the step of those.
struct Constant {
  std::int16_t v[4];
};
static_assert(sizeof(Constant) == 8);

// A segment: u32 bytes of a frame record, a TrackHeader each moving sub-track, then frame records.
#pragma pack(push, 1)
struct TrackHeader {
  std::uint8_t codes[2];  // four bits each, lowest first: shift of the minima, widths of x, y, z (component_bits())
  std::uint8_t step;      // see step_size()
  std::int16_t least[3];  // smallest value of each component, shifted right
};
#pragma pack(pop)
static_assert(sizeof(TrackHeader) == 9);

// So that a frame's number is exact as a float.
inline constexpr std::uint32_t kMaxFrames = 1u << 24;

// A load of 64 bits may reach behind the last record or minimum.
inline constexpr std::uint32_t kPayloadPadding = 8;

// Four steps an octave: the code is the exponent and the first two bits of the mantissa of a float, from 2^-40 on.
inline constexpr std::uint32_t kFirstStep = 87u << 23;
inline constexpr std::uint32_t kStepShift = 21;
inline float step_size(std::uint32_t code) {
  return bit_cast<float>(kFirstStep + (code << kStepShift));
}

// Three components fill at most 57 bits, so one load of 64 at a byte holds a record.
constexpr std::uint32_t component_bits(std::uint32_t code) {
  return code == 15 ? 19 : code;
}

// How many segments a clip of some frames has; 0 where a header breaks its rules.
constexpr std::uint32_t segment_count(const CodedHeader& h) {
  return h.frame_count < 2 || h.segment_intervals == 0 ? 0 : (h.frame_count - 2) / h.segment_intervals + 1;
}

struct CodedLayout {
  std::uint64_t header;
  Array<float> times;
  Array<std::uint32_t> offsets;
  Array<GroupMasks> masks;
  Array<Constant> constants;
  Array<std::byte> payload;
  std::uint64_t bytes;
};

template <class V>
constexpr void fields(V& v, const CodedHeader& h, CodedLayout& l, std::uint32_t joint_count) {
  constexpr const char* kFrames = "2 to 16777216 frames";
  v.range({"frame_count", "2 … 16777216"}, h.frame_count, 2u, kMaxFrames, kFrames);
  v.range({"segment_intervals", "≥ 1; steps of time a segment, the last may have fewer"}, h.segment_intervals, 1u,
          UINT32_MAX, "a segment has intervals");
  v.finite({"start_s", "of frame 0; earlier times get frame 0"}, h.start_s);
  v.finite({"frames_per_s", "> 0; with times of their own the mean"}, h.frames_per_s);
  v.any({"track_count", "number of bits set in the masks of what moves"}, h.track_count);
  v.any({"constant_count", "number of bits set in the masks of what is constant"}, h.constant_count);
  v.range({"payload_bytes"}, h.payload_bytes, kPayloadPadding, UINT32_MAX, "payload without padding");
  v.any({"time_count", "0: frames at even steps; else frame_count"}, h.time_count);
  v.array({"times", "of the frames, ascending; the first is start_s", "time_count"}, l.times, h.time_count,
          Floats::finite);
  v.array(
      {"offsets", "of each segment in payload; segments stand back to back", "⌈(frame_count − 1) / segment_intervals⌉"},
      l.offsets, segment_count(h));
  v.array({"masks",
           "of four joints u16 what moves, u16 what is constant: bits 0–3 rotation, 4–7 translation, 8–11 scale, "
           "lowest bit first joint; no bit in both",
           "⌈joint_count / 4⌉"},
          l.masks, soa_count(joint_count));
  v.array({"constants", "i16 x y z w each, see below", "constant_count"}, l.constants, h.constant_count);
  v.array({"payload", "the segments, then 8 bytes that are not read as values", "payload_bytes"}, l.payload,
          h.payload_bytes);
}

// start: where the header stands. joint_count: of the skeleton.
constexpr CodedLayout layout(const CodedHeader& h, std::uint64_t start, std::uint32_t joint_count) {
  CodedLayout l{};
  l.header = start;
  LayOut v(start + sizeof h);
  fields(v, h, l, joint_count);
  l.bytes = v.end();
  return l;
}

// How many values a track's key has in Clip::values.
constexpr std::uint32_t floats_per_key(TrackPath path, Interpolation interpolation) {
  return (path == TrackPath::rotation ? 4u : 3u) * (interpolation == Interpolation::cubic_spline ? 3u : 1u);
}

constexpr std::uint32_t floats_per_key(Interpolation of_channel) {
  return of_channel == Interpolation::cubic_spline ? 3u : 1u;
}

}  // namespace marrow::format
