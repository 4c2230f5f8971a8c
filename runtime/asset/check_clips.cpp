// What is asked of CLIP sections beyond their description.
#include <cstring>

#include "asset/checker.h"

namespace marrow {

using format::ClipHeader;
using format::ClipLayout;
using format::CodedHeader;
using format::CodedLayout;

namespace {

// The keys of tracks and channels. Lists of times follow one another, each shared by neighbouring tracks and channels:
// so one pass sees every list once.
class Keys {
 public:
  Keys(Checker& c, const ClipHeader& h, const ClipLayout& l)
      : c_(c), h_(h), times_(c.in(l.times).data), values_(c.in(l.values).data), first_value_(h.value_count) {}

  bool track(const Track& t) {
    const std::uint32_t floats = format::floats_per_key(t.path, t.interpolation);
    if (!list(&t, {t.key_count, t.first_time, t.first_value}, floats)) return false;
    const std::uint64_t count = std::uint64_t{t.key_count} * floats, end = t.first_value + count;
    if (t.path == TrackPath::rotation && t.interpolation != Interpolation::cubic_spline) {
      turning_ += count;
      // Any number of tracks may share values, which would be looked at for each.
      if (turning_ > 2 * std::uint64_t{h_.value_count})
        return c_.fail(&t, "rotations share values more than twice over");
      if (!rotations(t)) return false;
    }
    if (t.first_value < first_value_) first_value_ = t.first_value;
    if (end > values_end_) values_end_ = end;
    return true;
  }
  bool channel(const Channel& c) {
    return list(&c, {c.key_count, c.first_time, c.first_value}, format::floats_per_key(c.interpolation));
  }
  // Of what tracks use, and what is between.
  bool values_are_bounded() {
    return first_value_ >= values_end_ ||
           c_.floats_below(kBeyondFarthest, values_ + first_value_, values_end_ - first_value_, kNotBounded);
  }
  bool uses_all_times() const { return times_end_ == h_.time_count; }

 private:
  struct List {
    std::uint32_t key_count, first_time, first_value;
  };
  bool list(const void* record, const List& k, std::uint32_t floats_per_key) {
    if (k.key_count == 0 || std::uint64_t{k.first_time} + k.key_count > h_.time_count)
      return c_.fail(record, "keys outside the times");
    if (k.first_value + std::uint64_t{k.key_count} * floats_per_key > h_.value_count)
      return c_.fail(record, "keys outside the values");
    const bool is_new = !has_times_ || k.first_time != first_time_ || k.first_time + k.key_count != times_end_;
    if (is_new && k.first_time != times_end_)
      return c_.fail(record, "a list of times is the last track's or follows it");
    has_times_ = true;
    first_time_ = k.first_time;
    times_end_ = k.first_time + k.key_count;
    const float* const time = times_ + k.first_time;
    for (std::uint32_t i = 1; is_new && i < k.key_count; ++i)
      if (!(time[i - 1] < time[i])) return c_.fail(time + i, "times must increase");
    return (time[0] >= 0 && !(time[k.key_count - 1] > h_.duration_s)) || c_.fail(time, "times from 0 to the duration");
  }
  // What is between keys, and what is blended, has a length if they have.
  bool rotations(const Track& t) {
    const float* const first = values_ + t.first_value;
    if (!c_.floats_below(kMostOfUnit, first, std::uint64_t{4} * t.key_count, kNoUnit)) return false;
    for (std::uint32_t i = 0; i < t.key_count; ++i) {
      const float* const key = first + std::size_t{4} * i;
      if (!(dot_of_rotations(key, key) >= kShortestSquare)) return c_.fail(key, kNoUnit);
      if (i > 0 && t.interpolation == Interpolation::linear && !(dot_of_rotations(key - 4, key) >= kLeastProduct))
        return c_.fail(key, "a LINEAR rotation in the hemisphere of the one before it");
    }
    return true;
  }

  Checker& c_;
  const ClipHeader& h_;
  const float *times_, *values_;
  bool has_times_ = false;
  std::uint32_t first_time_ = 0, times_end_ = 0;  // of the last list
  std::uint64_t first_value_, values_end_ = 0;    // of what tracks use
  std::uint64_t turning_ = 0;                     // values of rotations, each time that a track uses them
};

bool check_keys(Checker& c, const ClipHeader& h, const ClipLayout& l) {
  Keys keys(c, h, l);
  for (const Track& t : c.in(l.tracks))
    if (!keys.track(t)) return false;
  if (!keys.values_are_bounded()) return false;
  for (const Channel& channel : c.in(l.channels))
    if (!keys.channel(channel)) return false;
  return keys.uses_all_times() || c.fail(&h.time_count, "times that no track uses");
}

bool check_frame_times(Checker& c, const CodedHeader& h, const float* times) {
  if (h.time_count > 0 && times[0] != h.start_s) return c.fail(times, "frame 0 at start_s");
  for (std::uint32_t i = 1; i < h.time_count; ++i)
    if (!(times[i - 1] < times[i])) return c.fail(times + i, "times must increase");
  return true;
}

bool check_masks(Checker& c, const CodedHeader& h, Span<const GroupMasks> groups) {
  std::uint32_t moving = 0, constant = 0, joints = c.joint_count();
  for (const GroupMasks& group : groups) {
    const std::uint32_t lanes = joints < 4 ? (1u << joints) - 1 : 15u;
    const std::uint32_t m = group.moving, k = group.constant;
    if (((m | k) & ~(lanes * 0x111u)) != 0) return c.fail(&group, "a coded track outside the skeleton");
    if ((m & k) != 0) return c.fail(&group, "a track moves or is constant");
    moving += count_bits(m);
    constant += count_bits(k);
    joints -= 4;
  }
  if (constant != h.constant_count) return c.fail(&h.constant_count, "as many constant tracks as bits in the masks");
  return moving == h.track_count || c.fail(&h.track_count, "as many coded tracks as bits in the masks");
}

bool check_constants(Checker& c, Span<const GroupMasks> groups, const format::Constant* next) {
  for (const GroupMasks& group : groups) {
    std::uint32_t rotations = count_bits(group.constant & 15u);
    for (std::uint32_t left = count_bits(group.constant); left > 0; --left, ++next) {
      const std::int16_t(&v)[4] = next->v;
      if (rotations > 0) {
        --rotations;
        if ((v[0] | v[1] | v[2] | v[3]) == 0) return c.fail(next, "a rotation is not zero");
      } else if (v[3] < 0 || v[3] > 255) {
        return c.fail(next, "a step from 0 to 255");
      }
    }
  }
  return true;
}

// Segments follow one another without a gap, so one pass sees every byte once.
bool check_segments(Checker& c, const CodedHeader& h, Span<const std::uint32_t> offsets, const std::byte* payload) {
  const std::uint64_t limit = h.payload_bytes - format::kPayloadPadding;
  std::uint64_t end = 0;
  for (std::uint32_t i = 0; i < offsets.size; ++i) {
    if (offsets[i] != end) return c.fail(&offsets[i], "segments stand back to back");
    end += 4 + std::uint64_t{h.track_count} * sizeof(format::TrackHeader);
    if (end > limit) return c.fail(&offsets[i], "a segment outside the payload");
    const std::byte* const segment = payload + offsets[i];
    std::uint32_t frame_bytes;
    std::memcpy(&frame_bytes, segment, 4);
    std::uint64_t bits = 0;
    for (std::uint32_t t = 0; t < h.track_count; ++t) {
      format::TrackHeader track;
      std::memcpy(&track, segment + 4 + t * sizeof track, sizeof track);
      const std::uint32_t codes = track.codes[0] | std::uint32_t{track.codes[1]} << 8;
      std::int32_t far = 0;
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        bits += format::component_bits(codes >> (4 * axis + 4) & 15u);
        const std::int32_t least = track.least[axis], size = least < 0 ? -least : least;
        far = far > size ? far : size;
      }
      // With the widest frame records that there are.
      if (static_cast<float>((far << (codes & 15u)) + (1 << 19)) * format::step_size(track.step) > format::kFarthest)
        return c.fail(segment, "a coded number beyond 1e12");
    }
    if ((bits + 7) / 8 != frame_bytes) return c.fail(segment, "a frame's bytes hold its tracks' bits");
    const std::uint64_t left = h.frame_count - 1 - std::uint64_t{i} * h.segment_intervals;
    const std::uint64_t frames = (left < h.segment_intervals ? left : h.segment_intervals) + 1;
    end += frames * frame_bytes;
    if (end > limit) return c.fail(&offsets[i], "a segment outside the payload");
  }
  return end == limit || c.fail(&h.payload_bytes, "payload behind the last segment");
}

bool check_coded(Checker& c, std::uint64_t start) {
  if (c.section().bytes - start < sizeof(CodedHeader)) return c.fail(c.header(), "section too short for its header");
  const auto& h = c.at<CodedHeader>(start);
  CodedLayout l = layout(h, start, c.joint_count());
  if (h.time_count != 0 && h.time_count != h.frame_count) return c.fail(&h.time_count, "a time a frame or none");
  c.leave_arrays(true);
  fields(c, h, l, c.joint_count());
  c.leave_arrays(false);
  if (!(h.frames_per_s > 0)) c.fail(&h.frames_per_s, "frames a second");
  if (!c.good()) return false;
  if (l.bytes != c.section().bytes) return c.fail(&h, kWrongSize);
  fields(c, h, l, c.joint_count());
  return c.good() && check_frame_times(c, h, c.in(l.times).data) && check_masks(c, h, c.in(l.masks)) &&
         check_constants(c, c.in(l.masks), c.in(l.constants).data) &&
         check_segments(c, h, c.in(l.offsets), c.in(l.payload).data);
}

}  // namespace

void check(Checker& c, const ClipHeader& h) {
  ClipLayout l = layout(h);
  const bool raw = c.section().codec == format::kCodecRaw;
  if (raw ? l.bytes != c.section().bytes : l.bytes > c.section().bytes) {
    c.fail(&h, kWrongSize);
    return;
  }
  fields(c, h, l);
  if (h.reference_groups != 0 && (h.additive == 0 || h.reference_groups != soa_count(c.joint_count())))
    c.fail(&h.reference_groups, "a reference is an additive clip's and has all joints");
  if (c.good() && check_keys(c, h, l) && !raw) check_coded(c, l.bytes);
}

}  // namespace marrow
