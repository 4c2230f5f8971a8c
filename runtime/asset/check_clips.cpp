// Rules of CLIP sections that are code.
#include "asset/checker.h"

namespace marrow {

bool Checker::clip_size() {
  so_far_.first_value = header<format::ClipHeader>().value_count;
  const std::uint64_t raw = places_[MARROW_PLACE(ClipLayout, bytes)];
  return section_->codec == format::kCodecRaw ? raw == section_->bytes : raw <= section_->bytes;
}

// Lists of times follow one another, each shared by neighbouring tracks and channels: so one pass sees every list once.
// k: key_count, first_time and first_value of a track or a channel.
bool Checker::keys(const std::uint32_t* k, std::uint32_t floats_per_key) {
  const auto& h = header<format::ClipHeader>();
  const std::uint32_t count = k[0], first = k[1];
  if (count == 0 || std::uint64_t{first} + count > h.time_count)
    return fail(base(From::record), "keys outside the times");
  if (k[2] + std::uint64_t{count} * floats_per_key > h.value_count)
    return fail(base(From::record), "keys outside the values");
  const bool is_new = !so_far_.has_times || first != so_far_.first_time || first + count != so_far_.times_end;
  if (is_new && first != so_far_.times_end)
    return fail(base(From::record), "a list of times is the last track's or follows it");
  so_far_.has_times = true;
  so_far_.first_time = first;
  so_far_.times_end = first + count;
  const float* const time = array<float>(MARROW_PLACE(ClipLayout, times)) + first;
  for (std::uint32_t i = 1; is_new && i < count; ++i)
    if (!(time[i - 1] < time[i])) return fail(time + i, "times must increase");
  return (time[0] >= 0 && !(time[count - 1] > h.duration_s)) || fail(time, "times from 0 to the duration");
}

// What is between keys, and what is blended, has a length if they have.
bool Checker::turning_keys(const Track& t) {
  const float* const first = array<float>(MARROW_PLACE(ClipLayout, values)) + t.first_value;
  if (const void* const beyond = first_beyond(kUnitBits, first, std::uint64_t{16} * t.key_count))
    return fail(beyond, kNoUnit);
  for (std::uint32_t i = 0; i < t.key_count; ++i) {
    const float* const key = first + std::size_t{4} * i;
    if (!(dot_of_rotations(key, key) >= kShortestSquare)) return fail(key, kNoUnit);
    if (i > 0 && t.interpolation == Interpolation::linear && !(dot_of_rotations(key - 4, key) >= kLeastProduct))
      return fail(key, kFarKey);
  }
  return true;
}

bool Checker::track() {
  const auto& t = record<Track>();
  const std::uint32_t floats = format::floats_per_key(t.path, t.interpolation);
  if (!keys(&t.key_count, floats)) return false;
  const std::uint64_t count = std::uint64_t{t.key_count} * floats, end = t.first_value + count;
  if (t.path == TrackPath::rotation && t.interpolation != Interpolation::cubic_spline) {
    so_far_.turning += count;
    // Any number of tracks may share values, which would be looked at for each.
    if (so_far_.turning > 2 * std::uint64_t{header<format::ClipHeader>().value_count})
      return fail(&t, "rotations share values more than twice over");
    if (!turning_keys(t)) return false;
  }
  if (t.first_value < so_far_.first_value) so_far_.first_value = t.first_value;
  if (end > so_far_.values_end) so_far_.values_end = end;
  return true;
}

bool Checker::coded() {
  const std::uint64_t start = places_[MARROW_PLACE(ClipLayout, bytes)];
  if (section_->bytes - start < sizeof(format::CodedHeader))
    return fail(base(From::header), "section too short for its header");
  begin_arrays(MARROW_PLACE(CodedLayout, times), start + sizeof(format::CodedHeader));
  return keeps(rules_of(kCodedPart), at<std::byte>(start));
}

bool Checker::frame_times() {
  const auto& h = record<format::CodedHeader>();
  const auto* const times = array<float>(MARROW_PLACE(CodedLayout, times));
  if (h.time_count > 0 && times[0] != h.start_s) return fail(times, "frame 0 at start_s");
  for (std::uint32_t i = 1; i < h.time_count; ++i)
    if (!(times[i - 1] < times[i])) return fail(times + i, "times must increase");
  return true;
}

bool Checker::masks() {
  const auto& h = record<format::CodedHeader>();
  const auto* const groups = array<GroupMasks>(MARROW_PLACE(CodedLayout, masks));
  std::uint32_t moving = 0, constant = 0;
  for (std::uint32_t g = 0; g < soa_count(joint_count()); ++g) {
    const std::uint32_t left = joint_count() - 4 * g, lanes = left < 4 ? (1u << left) - 1 : 15u;
    const std::uint32_t m = groups[g].moving, c = groups[g].constant;
    if (((m | c) & ~(lanes * 0x111u)) != 0) return fail(groups + g, "a coded track outside the skeleton");
    if ((m & c) != 0) return fail(groups + g, "a track moves or is constant");
    moving += count_bits(m);
    constant += count_bits(c);
  }
  if (constant != h.constant_count) return fail(&h.constant_count, "as many constant tracks as bits in the masks");
  return moving == h.track_count || fail(&h.track_count, "as many coded tracks as bits in the masks");
}

bool Checker::constants() {
  const auto* next = array<format::Constant>(MARROW_PLACE(CodedLayout, constants));
  for (const GroupMasks* g = array<GroupMasks>(MARROW_PLACE(CodedLayout, masks));
       g != array<GroupMasks>(MARROW_PLACE(CodedLayout, constants)); ++g) {
    std::uint32_t rotations = count_bits(g->constant & 15u);
    for (std::uint32_t left = count_bits(g->constant); left > 0; --left, ++next) {
      const std::int16_t(&v)[4] = next->v;
      if (rotations > 0) {
        --rotations;
        if ((v[0] | v[1] | v[2] | v[3]) == 0) return fail(next, "a rotation is not zero");
      } else if (v[3] < 0 || v[3] > 255) {
        return fail(next, "a step from 0 to 255");
      }
    }
  }
  return true;
}

// Segments follow one another without a gap, so one pass sees every byte once.
bool Checker::segments() {
  const auto& h = record<format::CodedHeader>();
  const auto* offsets = array<std::uint32_t>(MARROW_PLACE(CodedLayout, offsets));
  const std::uint64_t limit = h.payload_bytes - format::kPayloadPadding;
  std::uint64_t end = 0;
  for (std::uint32_t i = 0; i < format::segment_count(h); ++i) {
    if (offsets[i] != end) return fail(offsets + i, "segments stand back to back");
    end += 4 + std::uint64_t{h.track_count} * sizeof(format::TrackHeader);
    if (end > limit) return fail(offsets + i, "a segment outside the payload");
    const auto* segment = at<std::byte>(places_[MARROW_PLACE(CodedLayout, payload)] + offsets[i]);
    std::uint32_t frame_bytes;
    std::memcpy(&frame_bytes, segment, 4);
    std::uint64_t bits = 0;
    for (std::uint32_t t = 0; t < h.track_count; ++t) {
      format::TrackHeader track;
      std::memcpy(&track, segment + 4 + t * sizeof track, sizeof track);
      const std::uint32_t codes = track.codes[0] | std::uint32_t{track.codes[1]} << 8;
      std::int32_t far = 0;
      for (std::uint32_t c = 0; c < 3; ++c) {
        bits += format::component_bits(codes >> (4 * c + 4) & 15u);
        const std::int32_t least = track.least[c], size = least < 0 ? -least : least;
        far = far > size ? far : size;
      }
      // With the widest frame records that there are.
      if (static_cast<float>((far << (codes & 15u)) + (1 << 19)) * format::step_size(track.step) > format::kFarthest)
        return fail(segment, "a coded number beyond 1e12");
    }
    if ((bits + 7) / 8 != frame_bytes) return fail(segment, "a frame's bytes hold its tracks' bits");
    const std::uint64_t left = h.frame_count - 1 - std::uint64_t{i} * h.segment_intervals;
    const std::uint64_t frames = (left < h.segment_intervals ? left : h.segment_intervals) + 1;
    end += frames * frame_bytes;
    if (end > limit) return fail(offsets + i, "a segment outside the payload");
  }
  return end == limit || fail(&h.payload_bytes, "payload behind the last segment");
}

bool Checker::keeps_of_clip(Check check) {
  using namespace format;
  switch (check) {
    case Check::clip_size:
      return clip_size();
    case Check::clip_reference: {
      const auto& h = header<ClipHeader>();
      return h.reference_groups == 0 || (h.additive != 0 && h.reference_groups == soa_count(joint_count()));
    }
    case Check::track:
      return track();
    case Check::track_values: {
      const std::uint64_t first = places_[MARROW_PLACE(ClipLayout, values)] + 4 * so_far_.first_value,
                          last = places_[MARROW_PLACE(ClipLayout, values)] + 4 * so_far_.values_end;
      const void* const beyond = first < last ? first_beyond(kBoundedBits, at<float>(first), last - first) : nullptr;
      return beyond == nullptr || fail(beyond, kNotBounded);
    }
    case Check::channel:
      return keys(&record<Channel>().key_count, floats_per_key(record<Channel>().interpolation));
    case Check::used_times:
      return so_far_.times_end == header<ClipHeader>().time_count;
    case Check::coded:
      return section_->codec == kCodecRaw || coded();
    case Check::segment_offsets:
      add_array(std::uint64_t{segment_count(record<CodedHeader>())} * sizeof(std::uint32_t));
      return true;
    case Check::frame_times:
      return frame_times();
    case Check::masks:
      return masks();
    case Check::constants:
      return constants();
    default:
      return segments();
  }
}

}  // namespace marrow
