#include "cook/clip/compress/pack_tracks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

constexpr int kFactors = 4096;  // that are tried

// Halves away from 0. In lround's place, which no compiler inlines: it is asked for millions.
std::int16_t rounded(double x) {
  return static_cast<std::int16_t>(x + std::copysign(0.5, x));
}

constexpr double kGridSlack = 1e-3;      // of a frame
constexpr double kMostRounding = 0.125;  // of a frame
constexpr std::size_t kMostIntervals = 20000;
constexpr double kMostRefined = 8;      // frames between two keys of the shortest distance
constexpr std::size_t kMostEmpty = 2;   // even steps for a key
constexpr float kLeastFrame_s = 1e-4f;  // seconds between uneven frames

// Without those that are others but for rounding.
std::vector<float> distinct(const std::set<float>& times) {
  std::vector<float> out = {*times.begin()};
  for (const float t : times) {
    if (t - out.back() >= kLeastFrame_s) out.push_back(t);
  }
  if (out.size() > 1) out.back() = *times.rbegin();
  return out;
}

// The coarsest steps that every key falls on but for rounding, no two keys on one; nullopt if there are none.
std::optional<Grid> find_grid(const std::set<float>& times) {
  const double start = static_cast<double>(*times.begin()), length = static_cast<double>(*times.rbegin()) - start;
  const double rounding = rounding_at(*times.rbegin());
  double least = length;
  for (auto a = times.begin(), b = std::next(a); b != times.end(); ++a, ++b)
    if (const double gap = static_cast<double>(*b) - static_cast<double>(*a); gap > rounding)
      least = std::min(least, gap);
  const double fewest = std::max(1.0, std::ceil(length / (least + rounding)));
  const auto on_grid = [&](double intervals) {
    const double slack = std::max(kGridSlack, std::min(kMostRounding, rounding / length * intervals));
    double last_s = -1, last = -1;
    return std::all_of(times.begin(), times.end(), [&](float t) {
      const double time_s = static_cast<double>(t), at = (time_s - start) / length * intervals, near = std::round(at);
      const bool is_next = near > last || time_s - last_s <= rounding;
      last_s = time_s, last = near;
      return is_next && std::fabs(at - near) <= slack;
    });
  };
  const double most = std::min(kMostRefined * std::round(length / least), static_cast<double>(kMostIntervals));
  for (double n = fewest; n <= most; ++n)
    if (on_grid(n)) return Grid{*times.begin(), *times.rbegin(), static_cast<std::size_t>(n), {}};
  return std::nullopt;
}

bool has_cubic(const BuiltClip& clip) {
  return std::any_of(clip.tracks.begin(), clip.tracks.end(),
                     [](const Track& t) { return t.interpolation == Interpolation::cubic_spline; });
}

// Least significant bit first.
class BitWriter {
 public:
  explicit BitWriter(std::vector<std::byte>& to) : to_(to) {}
  void put(std::uint32_t value, std::uint32_t bits) {
    for (std::uint32_t i = 0; i < bits; ++i, ++used_) {
      if (used_ % 8 == 0) to_.push_back(std::byte{0});
      if ((value >> i & 1u) != 0) to_.back() |= std::byte{1} << (used_ % 8);
    }
  }

 private:
  std::vector<std::byte>& to_;
  std::size_t used_ = 0;
};

template <class T>
void append(std::vector<std::byte>& to, const T& value) {
  const auto* first = reinterpret_cast<const std::byte*>(&value);
  to.insert(to.end(), first, first + sizeof value);
}

format::TrackHeader header_of(const CodedTrack& track) {
  format::TrackHeader h{};
  h.codes[0] = static_cast<std::uint8_t>(track.shift | track.width_codes[0] << 4);
  h.codes[1] = static_cast<std::uint8_t>(track.width_codes[1] | track.width_codes[2] << 4);
  h.step = static_cast<std::uint8_t>(track.step_code);
  for (std::size_t c = 0; c < 3; ++c) h.least[c] = static_cast<std::int16_t>(track.least[c]);
  return h;
}

std::uint16_t mask_of(const TrackId& id) {
  const int first = id.path == TrackPath::rotation ? 0 : id.path == TrackPath::translation ? 4 : 8;
  return static_cast<std::uint16_t>(1 << (first + static_cast<int>(id.joint % 4)));
}

// The times of the keys that are to be coded.
std::set<float> key_times(const BuiltClip& clip) {
  std::set<float> times;
  for (const Track& track : clip.tracks) {
    const auto first = clip.times_s.begin() + track.first_time;
    if (!jumps(clip, track)) times.insert(first, first + track.key_count);
  }
  return times;
}

}  // namespace

format::Constant code_rotation(const glm::dquat& q, int most) {
  const double largest = std::max({std::fabs(q.x), std::fabs(q.y), std::fabs(q.z), std::fabs(q.w)});
  format::Constant best{};
  double least = INFINITY;
  const int factors = std::min(kFactors, most);  // fewer numbers, fewer that differ
  for (int i = 0; i < factors; ++i) {
    const double factor = most / largest * (1 - 0.5 * i / factors);
    const format::Constant c = {
        {rounded(q.x * factor), rounded(q.y * factor), rounded(q.z * factor), rounded(q.w * factor)}};
    // Of the distance from the line through q, so that small angles count; as a share of the length.
    const glm::dquat d(c.v[3], c.v[0], c.v[1], c.v[2]), off = d - q * glm::dot(q, d);
    const double distance = glm::dot(off, off) / glm::dot(d, d);
    if (distance >= least) continue;
    least = distance;
    best = c;
  }
  return best;
}

glm::dquat decode_rotation(const format::Constant& c) {
  return glm::normalize(glm::dquat(c.v[3], c.v[0], c.v[1], c.v[2]));
}

format::Constant code_offset(const glm::dvec3& offset, int most) {
  const double largest = std::max({std::fabs(offset.x), std::fabs(offset.y), std::fabs(offset.z)});
  int code = 0;
  while (code < 255 && largest > most * static_cast<double>(format::step_size(static_cast<std::uint32_t>(code))))
    ++code;
  const double inverse = 1 / static_cast<double>(format::step_size(static_cast<std::uint32_t>(code)));
  const auto fitted = [&](double x) { return rounded(std::clamp(x * inverse, -1.0 * most, 1.0 * most)); };
  return {{fitted(offset.x), fitted(offset.y), fitted(offset.z), static_cast<std::int16_t>(code)}};
}

glm::dvec3 decode_offset(const format::Constant& c) {
  return static_cast<double>(format::step_size(static_cast<std::uint32_t>(c.v[3]))) *
         glm::dvec3(c.v[0], c.v[1], c.v[2]);
}

double Grid::exact_time_of(std::size_t moment) const {
  if (times_s.empty()) {
    const double start = static_cast<double>(start_s), length = static_cast<double>(end_s) - start;
    return start + length * static_cast<double>(moment) / static_cast<double>(intervals * kMoments);
  }
  const std::size_t frame = std::min(moment / kMoments, intervals - 1);
  const double from = static_cast<double>(times_s[frame]), to = static_cast<double>(times_s[frame + 1]);
  return from + (to - from) * static_cast<double>(moment - frame * kMoments) / static_cast<double>(kMoments);
}

std::vector<Grid> grids(const BuiltClip& clip) {
  const std::set<float> times = key_times(clip);
  std::vector<Grid> out;
  if (times.empty()) return out;
  if (times.size() == 1) return {{*times.begin(), *times.begin() + 1, 1, {}}};  // nothing moves
  const std::optional<Grid> own = find_grid(times);
  if (!has_cubic(clip)) {
    // Steps that are even cost no times, and frames of them that have no keys few bits.
    if (own && own->intervals <= times.size() * kMostEmpty) out.push_back(*own);
    std::vector<float> uneven = distinct(times);
    if (uneven.size() > 1) out.push_back({uneven.front(), uneven.back(), uneven.size() - 1, uneven});
    if (!out.empty()) return out;
  }
  const double length = static_cast<double>(*times.rbegin()) - static_cast<double>(*times.begin());
  const double coarsest = own ? static_cast<double>(own->intervals) : std::ceil(length * 30);
  for (const double finer : {1.0, 2.0, 4.0, 8.0})
    if (coarsest * finer <= static_cast<double>(kMostIntervals))
      out.push_back({*times.begin(), *times.rbegin(), static_cast<std::size_t>(coarsest * finer), {}});
  return out;
}

Packer::Packer(const std::vector<TrackId>& moving, const std::vector<ConstantTrack>& constant,
               std::size_t joint_count) {
  out_.masks.resize(soa_count(joint_count));
  for (const TrackId& id : moving) out_.masks[id.joint / 4].moving |= mask_of(id);
  for (const ConstantTrack& track : constant) {
    out_.masks[track.id.joint / 4].constant |= mask_of(track.id);
    out_.constants.push_back(track.numbers);
  }
  out_.header.track_count = static_cast<std::uint32_t>(moving.size());
  out_.header.constant_count = static_cast<std::uint32_t>(constant.size());
}

void Packer::add(const std::vector<CodedTrack>& tracks) {
  out_.offsets.push_back(static_cast<std::uint32_t>(out_.payload.size()));
  std::uint32_t frame_bits = 0;
  for (const CodedTrack& track : tracks) frame_bits += track.frame_bits;
  append(out_.payload, (frame_bits + 7) / 8);
  for (const CodedTrack& track : tracks) append(out_.payload, header_of(track));
  for (std::size_t frame = 0; !tracks.empty() && frame < tracks[0].values.size(); ++frame) {
    BitWriter record(out_.payload);
    for (const CodedTrack& track : tracks)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::int32_t least = track.least[c] * (1 << track.shift);
        record.put(static_cast<std::uint32_t>(track.values[frame][c] - least),
                   format::component_bits(track.width_codes[c]));
      }
  }
}

BuiltCoded Packer::finish(const Grid& grid, std::size_t segment_intervals) {
  out_.payload.insert(out_.payload.end(), format::kPayloadPadding, std::byte{0});
  out_.header.frame_count = static_cast<std::uint32_t>(grid.intervals + 1);
  out_.header.segment_intervals = static_cast<std::uint32_t>(segment_intervals);
  out_.header.frames_per_s = static_cast<float>(static_cast<double>(grid.intervals) /
                                                (static_cast<double>(grid.end_s) - static_cast<double>(grid.start_s)));
  out_.header.start_s = grid.start_s;
  out_.header.time_count = static_cast<std::uint32_t>(grid.times_s.size());
  out_.times_s = grid.times_s;
  out_.header.payload_bytes = static_cast<std::uint32_t>(out_.payload.size());
  return std::move(out_);
}
}  // namespace marrow::cook
