#include "cook/clip/compress/compress_clip.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "cook/clip/compress/choose_steps.h"
#include "cook/clip/compress/pack_tracks.h"
#include "cook/clip/measure/clip_measure.h"

namespace marrow::cook {
namespace {

// By how much each number of a track may be off. least: promised of what hangs on its joint.
double slack_of(const Track& track, const Rig& rig, const Promise& promise, double least) {
  // A quaternion's numbers are halves of an angle.
  const double lever = track.path == TrackPath::translation ? rig.scale_above[track.joint]
                       : track.path == TrackPath::rotation  ? 2 * reach_below(track.joint, rig, promise)
                                                            : reach_below(track.joint, rig, promise);
  return least / (std::sqrt(3.0) * std::max(lever, 1e-30));
}

constexpr std::size_t kMostTransforms = 1'000'000;  // a joint and moment: 80 MB; larger clips stay raw
// What moves on what moves: joints below a joint, a moment. Characters have up to 20 for each joint, and this takes
// seconds; what hangs deeper stays raw.
constexpr std::size_t kMostBelow = 128, kMostMovedBelow = 500'000;
constexpr std::size_t kStretch = 96;  // intervals that have the same steps, at most
// Lengths of segments that are tried: the fewest bytes in memory win. Each divides a stretch.
constexpr std::size_t kSegmentIntervals[] = {kStretch, 48, 32, 24, 16};
constexpr double kStillShare = 0.05;  // of the promise, below which a movement does not count
constexpr double kShare = 0.97;       // of the promise, that the search may use up
constexpr int kMostTries = 6;         // with ever less of it, until the vertices keep theirs

// The tracks that stay raw, with the times and values that they use.
BuiltClip keep_raw(const BuiltClip& clip, const std::vector<TrackId>& raw) {
  BuiltClip out;
  out.name = clip.name;
  out.skeleton = clip.skeleton;
  out.duration_s = clip.duration_s;
  out.most_keys = clip.most_keys;
  out.additive = clip.additive;
  out.reference = clip.reference;
  std::set<std::pair<std::size_t, TrackPath>> kept_raw;
  for (const TrackId& id : raw) kept_raw.emplace(id.joint, id.path);
  std::uint32_t list = UINT32_MAX, moved = 0;
  for (const Track& track : clip.tracks) {
    if (!kept_raw.contains({track.joint, track.path})) continue;
    if (track.first_time != list) {
      list = track.first_time;
      moved = static_cast<std::uint32_t>(out.times_s.size());
      const auto first = clip.times_s.begin() + track.first_time;
      out.times_s.insert(out.times_s.end(), first, first + track.key_count);
    }
    Track kept = track;
    kept.first_time = moved;
    kept.first_value = static_cast<std::uint32_t>(out.values.size());
    const auto first = clip.values.begin() + track.first_value;
    const std::size_t count = std::size_t{track.key_count} * format::floats_per_key(track.path, track.interpolation);
    out.values.insert(out.values.end(), first, first + static_cast<std::ptrdiff_t>(count));
    out.tracks.push_back(kept);
  }
  return out;
}

void set_to(TrackPath path, const format::Constant& numbers, const Transform& rest, Transform& to) {
  if (path == TrackPath::rotation) to.rotation = decode_rotation(numbers);
  if (path == TrackPath::translation) to.translation = rest.translation + decode_offset(numbers);
  if (path == TrackPath::scale) to.scale = rest.scale + decode_offset(numbers);
}

double worst_share(const ClipError& error, const Promise& promise) {
  return std::max(error.share, promise.of_vertices ? error.vertex_share : 0.0);
}

// Everything about one clip at one spacing of frames.
class Compressor {
 public:
  Compressor(const BuiltClip& clip, const BuiltSkeleton& skeleton, const Rig& rig, const Grid& grid,
             const Promise& promise, const ClipMeasure& measure, Effort effort)
      : clip_(clip),
        rig_(rig),
        measure_(measure),
        effort_(effort),
        curves_(clip, skeleton),
        grid_(grid),
        intervals_(grid.intervals) {
    for (std::size_t j = 0; j < rig.size(); ++j) {
      source_.emplace_back().reserve(intervals_ * kMoments + 1);
      for (std::size_t e = 0; e <= intervals_ * kMoments; ++e)
        source_[j].push_back(curves_.at(j, grid_.exact_time_of(e)));
    }
    std::vector<float> moments_s;  // rounded as the runtime's argument is, so that both are on the same side of a jump
    for (std::size_t e = 0; e <= intervals_ * kMoments; ++e)
      moments_s.push_back(static_cast<float>(grid_.exact_time_of(e)));
    measured_s_ = measure.moments(moments_s);
    sort_tracks(promise);
  }

  std::optional<BuiltClip> compress(const Promise& promise, double share) const {
    BuiltClip out = keep_raw(clip_, exact_);
    if (!moving_.empty() || !constant_.empty()) {
      Promise stricter = promise;
      for (double& error : stricter.error) error *= share;
      std::optional<BuiltCoded> coded = code(stricter);
      if (!coded) return std::nullopt;  // a finer grid may help
      out.coded = std::move(*coded);
    }
    out.error = measure_.measure(out, measured_s_, promise);
    return out;
  }

  // All keys, coarser as far as that is within the promise; as they are if it is not at all.
  BuiltClip keep_keys(const Promise& promise) const {
    constexpr int kMostHalvings = 16;
    double share = 1;
    for (int i = 0; i < kMostHalvings; ++i, share /= 2) {
      BuiltClip out = with_rounded_keys(clip_, rig_, promise, share);
      out.error = measure_.measure(out, measured_s_, promise);
      if (worst_share(out.error, promise) <= 1) return out;
    }
    return clip_;
  }

 private:
  // Whether a sub-track never leaves `at` by more than that.
  bool stays(std::size_t joint, TrackPath path, const Transform& at, double most) const {
    const auto is_near = [&](const Transform& t) {
      if (path == TrackPath::translation) return glm::length(t.translation - at.translation) <= most;
      if (path == TrackPath::scale) return glm::length(t.scale - at.scale) <= most;
      const glm::dquat turned = glm::conjugate(at.rotation) * t.rotation;
      return 2 * glm::length(glm::dvec3(turned.x, turned.y, turned.z)) <= most;
    };
    if (!std::all_of(source_[joint].begin(), source_[joint].end(), is_near)) return false;
    // Between two moments a track that jumps may be anywhere.
    const Track& track = *curves_.track(joint, path);
    const float* const times = clip_.times_s.data() + track.first_time;
    return !jumps(clip_, track) || std::all_of(times, times + track.key_count, [&](float time_s) {
      return is_near(curves_.at(joint, static_cast<double>(time_s)));
    });
  }

  // Between the extremes; of rotations, which are only asked for where they hardly differ, the mean.
  Transform middle(std::size_t joint) const {
    const std::vector<Transform>& source = source_[joint];
    Transform low = source[0], high = source[0];
    glm::dquat sum(0, 0, 0, 0);
    for (const Transform& t : source) {
      low.translation = glm::min(low.translation, t.translation);
      high.translation = glm::max(high.translation, t.translation);
      low.scale = glm::min(low.scale, t.scale);
      high.scale = glm::max(high.scale, t.scale);
      sum += glm::dot(sum, t.rotation) < 0 ? -t.rotation : t.rotation;
    }
    return {0.5 * (low.translation + high.translation), glm::normalize(sum), 0.5 * (low.scale + high.scale)};
  }

  // The smallest numbers near which a sub-track stays: they take fewest bits in packed files, and what differs a little
  // from clip to clip often gets the same.
  std::optional<format::Constant> constant_of(std::size_t joint, TrackPath path, double most_off) const {
    constexpr int kFewest = 15;  // of ever twice as many
    const Transform &rest = rig_.rest[joint], wanted = middle(joint);
    if (!stays(joint, path, wanted, most_off)) return std::nullopt;  // as of all that moves
    for (int most = kFewest; most <= kMostConstant; most = 2 * most + 1) {
      const format::Constant numbers = path == TrackPath::rotation ? code_rotation(wanted.rotation, most)
                                       : path == TrackPath::translation
                                           ? code_offset(wanted.translation - rest.translation, most)
                                           : code_offset(wanted.scale - rest.scale, most);
      Transform at = wanted;
      set_to(path, numbers, rest, at);
      if (stays(joint, path, at, most_off)) return numbers;
    }
    return std::nullopt;
  }

  // What rests, what is constant and what moves; in the order in which tracks are stored. What leaves a place by less
  // than a small share of the promise stays there: exporters write every track, and most of them are rounding.
  void sort_tracks(const Promise& promise) {
    still_ = rig_.rest;
    const std::vector<double> least = rig_.least_below(promise.error);
    for (std::size_t group = 0; group < rig_.size(); group += 4)
      for (const TrackPath path : {TrackPath::rotation, TrackPath::translation, TrackPath::scale})
        for (std::size_t j = group; j < std::min(group + 4, rig_.size()); ++j) {
          const Track* const track = curves_.track(j, path);
          if (track == nullptr) continue;
          const double most_off =
              kStillShare * least[j] /
              (path == TrackPath::translation ? rig_.scale_above[j] : reach_below(j, rig_, promise));
          if (stays(j, path, rig_.rest[j], most_off)) continue;
          if (const std::optional<format::Constant> numbers = constant_of(j, path, most_off))
            constant_.push_back({{j, path}, *numbers});
          else
            (jumps(clip_, *track) ? exact_ : moving_).push_back({j, path});
        }
    for (const ConstantTrack& c : constant_) set_to(c.id.path, c.numbers, rig_.rest[c.id.joint], still_[c.id.joint]);
  }

  // Stretch by stretch; then in the segments that take least.
  std::optional<BuiltCoded> code(const Promise& promise) const {
    std::vector<std::vector<CodedTrack>> stretches;
    for (std::size_t first = 0; first < intervals_; first += kStretch) {
      const std::size_t count = std::min(kStretch, intervals_ - first);
      std::vector<std::span<const Transform>> source;
      for (const std::vector<Transform>& joint : source_)
        source.push_back(std::span(joint).subspan(first * kMoments, count * kMoments + 1));
      std::optional<std::vector<CodedTrack>> tracks =
          choose_steps(rig_, promise, moving_, exact_, still_, std::move(source), effort_);
      if (!tracks) return std::nullopt;
      stretches.push_back(std::move(*tracks));
    }
    std::optional<BuiltCoded> best;
    for (const std::size_t length : kSegmentIntervals) {
      if (best && length >= intervals_) continue;  // one segment, as before
      BuiltCoded coded = in_segments(stretches, length);
      if (!best || coded.payload.size() < best->payload.size()) best = std::move(coded);
    }
    return best;
  }

  // In segments of at most `length` intervals; of a clip of one stretch all about as long.
  BuiltCoded in_segments(const std::vector<std::vector<CodedTrack>>& stretches, std::size_t length) const {
    const std::size_t count = (intervals_ + length - 1) / length;
    const std::size_t each = stretches.size() > 1 ? length : (intervals_ + count - 1) / count;
    Packer packer(moving_, constant_, rig_.size());
    for (std::size_t first = 0; first < intervals_; first += each) {
      const std::vector<CodedTrack>& tracks = stretches[first / kStretch];
      std::vector<CodedTrack> parts;
      for (const CodedTrack& track : tracks)
        parts.push_back(part_of(track, first % kStretch, std::min(each, intervals_ - first) + 1));
      packer.add(parts);
    }
    return packer.finish(grid_, each);
  }

  const BuiltClip& clip_;
  const Rig& rig_;
  const ClipMeasure& measure_;
  Effort effort_;
  SourceCurves curves_;
  Grid grid_;
  std::size_t intervals_;
  std::vector<std::vector<Transform>> source_;  // a joint and moment
  std::vector<float> measured_s_;
  std::vector<TrackId> exact_, moving_;
  std::vector<ConstantTrack> constant_;
  std::vector<Transform> still_;  // a joint: the rest pose with the constants
};

std::size_t bytes_of(const BuiltClip& clip) {
  return clip.tracks.size() * sizeof(Track) + 4 * (clip.times_s.size() + clip.values.size()) +
         clip.coded.payload.size() + 4 * clip.coded.offsets.size() + sizeof(GroupMasks) * clip.coded.masks.size() +
         sizeof(format::Constant) * clip.coded.constants.size() + 4 * clip.coded.times_s.size() +
         (clip.coded.header.frame_count > 0 ? sizeof(format::CodedHeader) : 0);
}

// The smallest that came out but strayed too far.
struct Strayed {
  double share = INFINITY;  // of the promise
  std::size_t bytes = 0;
};

// nullopt if nothing that keeps the promise comes out on this grid.
std::optional<BuiltClip> compress_on(const Compressor& compressor, const BuiltClip& clip, const Promise& promise,
                                     Strayed& strayed) {
  double share = kShare, last = INFINITY;
  for (int i = 0; i < kMostTries; ++i) {
    std::optional<BuiltClip> made = compressor.compress(promise, share);
    if (!made) return std::nullopt;
    const double worst = worst_share(made->error, promise);
    if (worst <= 1) return made;
    if (bytes_of(*made) < bytes_of(clip) && worst < strayed.share) strayed = {worst, bytes_of(*made)};
    if (worst > 1.5 && worst > 0.98 * last) return std::nullopt;  // it is the grid that strays
    last = worst;
    share *= std::clamp(kShare / worst, 0.5, 0.93);
  }
  return std::nullopt;
}

bool hangs_too_deep(const BuiltClip& clip, const Rig& rig, std::size_t moments) {
  std::vector<char> moves(rig.size(), 0);
  for (const Track& track : clip.tracks) moves[track.joint] = 1;
  std::size_t joints = 0, below = 0;
  for (std::size_t j = 0; j < rig.size(); ++j) {
    if (moves[j] == 0) continue;
    ++joints;
    below += rig.subtree_sizes[j];
  }
  return below > kMostBelow * joints && below > kMostMovedBelow / moments;
}

std::string why_it_strays(const Strayed& strayed) {
  std::string out = "no steps of time and value that are tried keep --clip-error";
  if (strayed.bytes > 0)
    out += fmt::format("; {:.2g} times as large, it would be {} bytes", 1.1 * strayed.share, strayed.bytes);
  return out;
}

}  // namespace

float rounded_within(double slack, float value) {
  constexpr int kFinest = -100, kCoarsest = 80;
  int exponent = 0;
  std::frexp(2 * slack, &exponent);  // the power of two is at most that much
  if (!(slack > 0) || exponent < kFinest) return value;
  const double step = std::ldexp(0.5, std::min(exponent, kCoarsest));
  const double steps = std::round(static_cast<double>(value) / step);
  return static_cast<float>(steps * step) + 0.0f;  // no -0
}

// Twice the largest of t³ − 2 t² + t, as both ends have one.
double tangent_lever(std::span<const float> times_s) {
  double longest_s = 0;
  for (std::size_t k = 1; k < times_s.size(); ++k)
    longest_s = std::max(longest_s, static_cast<double>(times_s[k]) - static_cast<double>(times_s[k - 1]));
  return longest_s * 8 / 27;
}

BuiltClip with_rounded_keys(const BuiltClip& clip, const Rig& rig, const Promise& promise, double share) {
  BuiltClip out = clip;
  const std::vector<double> least = rig.least_below(promise.error);
  for (const Track& track : clip.tracks) {
    const bool is_spline = track.interpolation == Interpolation::cubic_spline;
    if (track.path == TrackPath::rotation && !is_spline) continue;
    const double slack = share * slack_of(track, rig, promise, least[track.joint]);
    const double lever = tangent_lever({clip.times_s.data() + track.first_time, track.key_count});
    const std::uint32_t width = track.path == TrackPath::rotation ? 4 : 3;
    const std::uint32_t count = track.key_count * format::floats_per_key(track.path, track.interpolation);
    for (std::uint32_t i = 0; i < count; ++i) {
      float& value = out.values[track.first_value + i];
      const bool is_tangent = is_spline && i / width % 3 != 1;
      value = rounded_within(is_tangent && lever > 0 ? slack / lever : slack, value);
    }
  }
  return out;
}

void compress_clip(BuiltClip& clip, const BuiltSkeleton& skeleton, const Rig& rig, const Promise& promise,
                   const Hung& hung, Effort effort, const BuiltClip& channels) {
  if (clip.tracks.empty()) return;
  std::string why = "its curves jump, or are all at one time";
  const ClipMeasure measure(clip, channels, skeleton, rig, hung);
  std::optional<Compressor> compressor;
  Strayed strayed;
  for (const Grid& grid : grids(clip)) {
    why = "it has more than a million joints times moments";
    if (rig.size() * (grid.intervals * kMoments + 1) > kMostTransforms) continue;
    why = "its joints hang too deep, one below the other";
    if (hangs_too_deep(clip, rig, grid.intervals * kMoments + 1)) continue;
    compressor.emplace(clip, skeleton, rig, grid, promise, measure, effort);
    std::optional<BuiltClip> made = compress_on(*compressor, clip, promise, strayed);
    if (made && bytes_of(*made) < bytes_of(clip)) {
      clip = std::move(*made);
      return;
    }
    why = made ? fmt::format("in segments its curves would be {} bytes and not {}", bytes_of(*made), bytes_of(clip))
               : why_it_strays(strayed);
    if (made) break;
  }
  if (compressor) clip = compressor->keep_keys(promise);
  clip.raw_because = std::move(why);
}
}  // namespace marrow::cook
