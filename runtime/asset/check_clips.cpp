// Rules of CLIP sections.
#include "asset/checker.h"

namespace marrow {

using format::layout;

namespace {

// Of a coded sub-track, by the widest frame records that there are.
float largest_of(const format::TrackHeader& track) {
  std::int32_t far = 0;
  for (std::uint32_t c = 0; c < 3; ++c) {
    const std::int32_t least = track.least[c];
    far = far > least ? far : least;
    far = far > -least ? far : -least;
  }
  return static_cast<float>((std::int64_t{far} << (track.codes[0] & 15u)) + (1 << 19)) * format::step_size(track.step);
}

}  // namespace

// Of the skeleton or the reference that a clip is for; the number is in range.
std::uint32_t Checker::joint_count_of(const format::ClipHeader& h) const {
  if (counts_[format::kReferences] != 0)
    return at<format::ReferenceHeader>(nth(format::kReferences, h.skeleton), 0)->joint_count;
  return at<format::SkeletonHeader>(nth(format::kSkeletons, h.skeleton), 0)->joint_count;
}

// Lists of times follow one another, each shared by neighbouring tracks and channels: so one pass sees every list once.
class Checker::TimeLists {
 public:
  explicit TimeLists(const float* times_s) : times_s_(times_s) {}
  const float* times_s() const { return times_s_; }
  // Whether the list may stand here; `is_new` if it has not been seen.
  bool next(std::uint32_t first, std::uint32_t count, bool& is_new) {
    is_new = empty_ || first != first_ || first + count != end_;
    if (is_new && first != end_) return false;
    empty_ = false;
    first_ = first;
    end_ = first + count;
    return true;
  }
  std::uint32_t end() const { return end_; }

 private:
  const float* times_s_;
  bool empty_ = true;
  std::uint32_t first_ = 0, end_ = 0;
};

// A track's or a channel's keys.
struct Checker::KeyList {
  const void* of;
  Interpolation interpolation;
  std::uint32_t first_time, key_count, first_value, floats_per_key;
  std::uint64_t value_count() const { return std::uint64_t{key_count} * floats_per_key; }
};

bool Checker::keys(const format::ClipHeader& h, const KeyList& k, TimeLists& lists) {
  if (k.interpolation > Interpolation::cubic_spline) return fail(k.of, "unknown interpolation");
  if (k.key_count == 0 || std::uint64_t{k.first_time} + k.key_count > h.time_count)
    return fail(k.of, "keys outside the times");
  if (k.first_value + k.value_count() > h.value_count) return fail(k.of, "keys outside the values");
  bool is_new = false;
  if (!lists.next(k.first_time, k.key_count, is_new))
    return fail(k.of, "a list of times is the last track's or follows it");
  const float* const time = lists.times_s() + k.first_time;
  for (std::uint32_t i = 1; is_new && i < k.key_count; ++i)
    if (!(time[i - 1] < time[i])) return fail(time + i, "times must increase");
  if (!(time[0] >= 0) || time[k.key_count - 1] > h.duration_s) return fail(time, "times from 0 to the duration");
  return true;
}

bool Checker::masks(const format::CodedHeader& h, const GroupMasks* masks, std::uint32_t joint_count) {
  std::uint32_t moving = 0, constant = 0;
  for (std::uint32_t g = 0; g < soa_count(joint_count); ++g) {
    const std::uint32_t lanes = joint_count - 4 * g < 4 ? (1u << (joint_count - 4 * g)) - 1 : 15u;
    const std::uint32_t m = masks[g].moving, c = masks[g].constant;
    if (((m | c) & ~(lanes * 0x111u)) != 0) return fail(masks + g, "a coded track outside the skeleton");
    if ((m & c) != 0) return fail(masks + g, "a track moves or is constant");
    moving += count_bits(m);
    constant += count_bits(c);
  }
  if (constant != h.constant_count) return fail(&h.constant_count, "as many constant tracks as bits in the masks");
  return moving == h.track_count || fail(&h.track_count, "as many coded tracks as bits in the masks");
}

bool Checker::constants(const GroupMasks* masks, const format::Constant* next, std::uint32_t joint_count) {
  for (std::uint32_t g = 0; g < soa_count(joint_count); ++g) {
    const std::uint32_t bits = masks[g].constant;
    for (std::uint32_t i = count_bits(bits & 15u); i > 0; --i, ++next)
      if ((next->v[0] | next->v[1] | next->v[2] | next->v[3]) == 0) return fail(next, "a rotation is not zero");
    for (std::uint32_t i = count_bits(bits >> 4); i > 0; --i, ++next)
      if (next->v[3] < 0 || next->v[3] > 255) return fail(next, "a step from 0 to 255");
  }
  return true;
}

// Segments follow one another without a gap, so one pass sees every byte once.
bool Checker::segments(const std::byte* section, const format::CodedHeader& h, const format::CodedLayout& l) {
  const auto* offsets = at<std::uint32_t>(section, l.offsets);
  const std::uint64_t limit = h.payload_bytes - format::kPayloadPadding;
  std::uint64_t end = 0;
  for (std::uint32_t i = 0; i < format::segment_count(h); ++i) {
    if (offsets[i] != end) return fail(offsets + i, "segments stand back to back");
    end += 4 + std::uint64_t{h.track_count} * sizeof(format::TrackHeader);
    if (end > limit) return fail(offsets + i, "a segment outside the payload");
    const auto* segment = at<std::byte>(section, l.payload + offsets[i]);
    std::uint32_t frame_bytes;
    std::memcpy(&frame_bytes, segment, 4);
    std::uint64_t bits = 0;
    for (std::uint32_t t = 0; t < h.track_count; ++t) {
      format::TrackHeader track;
      std::memcpy(&track, segment + 4 + t * sizeof track, sizeof track);
      const std::uint32_t x = track.codes[0] >> 4u, y = track.codes[1] & 15u, z = track.codes[1] >> 4u;
      bits += format::component_bits(x) + format::component_bits(y) + format::component_bits(z);
      if (largest_of(track) > format::kFarthest) return fail(segment, "a coded number beyond 1e12");
    }
    if ((bits + 7) / 8 != frame_bytes) return fail(segment, "a frame's bytes hold its tracks' bits");
    const std::uint64_t left = h.frame_count - 1 - std::uint64_t{i} * h.segment_intervals;
    const std::uint64_t frames = (left < h.segment_intervals ? left : h.segment_intervals) + 1;
    end += frames * frame_bytes;
    if (end > limit) return fail(offsets + i, "a segment outside the payload");
  }
  return end == limit || fail(&h.payload_bytes, "payload behind the last segment");
}

bool Checker::coded(const File::Section& s, std::uint64_t start, std::uint32_t joint_count) {
  const auto* const section = at<std::byte>(s, 0);
  const auto* h = at<format::CodedHeader>(section, start);
  if (s.bytes - start < sizeof *h) return fail(section, "section too short for its header");
  if (h->time_count != 0 && h->time_count != h->frame_count) return fail(&h->time_count, "a time a frame or none");
  if (h->frame_count < 2 || h->frame_count > format::kMaxFrames) return fail(h, "2 to 16777216 frames");
  if (h->segment_intervals == 0) return fail(&h->segment_intervals, "a segment has intervals");
  if (!finite(&h->start_s, 8)) return false;
  if (!(h->frames_per_s > 0)) return fail(&h->frames_per_s, "frames a second");
  if (h->payload_bytes < format::kPayloadPadding) return fail(&h->payload_bytes, "payload without padding");
  const format::CodedLayout l = layout(*h, start, joint_count);
  if (l.bytes != s.bytes) return fail(h, "section size differs from its counts");
  const auto* times = at<float>(section, l.times);
  if (!finite(times, l.offsets - l.times)) return false;
  if (h->time_count > 0 && times[0] != h->start_s) return fail(times, "frame 0 at start_s");
  for (std::uint32_t i = 1; i < h->time_count; ++i)
    if (!(times[i - 1] < times[i])) return fail(times + i, "times must increase");
  const auto* groups = at<GroupMasks>(section, l.masks);
  return masks(*h, groups, joint_count) && constants(groups, at<format::Constant>(section, l.constants), joint_count) &&
         segments(section, *h, l);
}

bool Checker::clip_header(const File::Section& s) {
  const auto* h = at<format::ClipHeader>(s, 0);
  const std::uint64_t raw_bytes = layout(*h).bytes;
  if (!has_bytes(s, s.codec == format::kCodecRaw || raw_bytes > s.bytes ? raw_bytes : s.bytes)) return false;
  // One of the two is 0.
  if (h->skeleton >= counts_[format::kSkeletons] + counts_[format::kReferences])
    return fail(&h->skeleton, "no such skeleton");
  if (h->additive > 1) return fail(&h->additive, "additive is 0 or 1");
  const bool has_reference = h->reference_groups != 0;
  if (has_reference && (h->additive == 0 || h->reference_groups != soa_count(joint_count_of(*h))))
    return fail(&h->reference_groups, "a reference is an additive clip's and has all joints");
  if (!transforms(at<SoaTransform>(h, sizeof *h), h->reference_groups)) return false;
  if (!name(h->name) || !bounded(&h->duration_s, 4)) return false;
  return h->duration_s >= 0 || fail(&h->duration_s, "a duration is not negative");
}

bool Checker::tracks(const format::ClipHeader& h, std::uint32_t joint_count) {
  const format::ClipLayout l = layout(h);
  TimeLists lists(at<float>(&h, l.times));
  std::uint64_t first_value = h.value_count, values_end = 0;  // of what tracks use, and what is between
  std::uint64_t turning = 0;                                  // values of rotations, each time that a track uses them
  for (const Track& t : Span<const Track>{at<Track>(&h, l.tracks), h.track_count}) {
    if (t.joint >= joint_count) return fail(&t, "track's joint outside the skeleton");
    if (t.path > TrackPath::scale) return fail(&t, "unknown path");
    const KeyList list = {&t,          t.interpolation, t.first_time,
                          t.key_count, t.first_value,   format::floats_per_key(t.path, t.interpolation)};
    if (!keys(h, list, lists)) return false;
    const std::uint64_t end = t.first_value + list.value_count();
    if (t.path == TrackPath::rotation && t.interpolation != Interpolation::cubic_spline) {
      turning += end - t.first_value;
      // Any number of tracks may share values, which would be looked at for each.
      if (turning > 2 * std::uint64_t{h.value_count}) return fail(&t, "rotations share values more than twice over");
      if (!units(at<float>(&h, l.values) + t.first_value, 4 * (end - t.first_value))) return false;
    }
    first_value = t.first_value < first_value ? t.first_value : first_value;
    values_end = end > values_end ? end : values_end;
  }
  if (values_end > 0 && !bounded(at<float>(&h, l.values + 4 * first_value), 4 * (values_end - first_value)))
    return false;
  for (const Channel& c : Span<const Channel>{at<Channel>(&h, l.channels), h.channel_count}) {
    if ((c.reserved[0] | c.reserved[1] | c.reserved[2]) != 0) return fail(c.reserved, "reserved must be 0");
    if (!name(c.name) || !finite(&c.rest, 4)) return false;
    const std::uint32_t floats = format::floats_per_key(c.interpolation);
    if (!keys(h, {&c, c.interpolation, c.first_time, c.key_count, c.first_value, floats}, lists)) return false;
  }
  return lists.end() == h.time_count || fail(&h.time_count, "times that no track uses");
}

bool Checker::clip(const File::Section& s) {
  if (!clip_header(s)) return false;
  const auto* h = at<format::ClipHeader>(s, 0);
  const format::ClipLayout l = layout(*h);
  const std::uint32_t joint_count = joint_count_of(*h);
  return finite(at<float>(h, l.times), l.bytes - l.times) && tracks(*h, joint_count) &&
         (s.codec == format::kCodecRaw || coded(s, l.bytes, joint_count));
}

}  // namespace marrow
