#include "cook/clip/build_tracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "cook/clip/compress/compress_clip.h"
#include "cook/scene/without_tiny.h"

namespace marrow::cook {
namespace {

// Unit length, and each key in the hemisphere of the one before it, so that blending two neighbours takes the shorter
// arc.
std::vector<glm::vec4> tidy_rotations(const RawChannel& channel) {
  std::vector<glm::vec4> keys = channel.values;
  if (channel.interpolation == RawInterpolation::cubic_spline) return keys;  // tangents belong to the length as it is
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const glm::dvec4 q(keys[i]);
    const double length = glm::length(q);
    if (length > 0) keys[i] = glm::vec4(q / length);
    if (i > 0 && channel.interpolation == RawInterpolation::linear && glm::dot(keys[i - 1], keys[i]) < 0)
      keys[i] = -keys[i];
  }
  return keys;
}

void add_values(const RawChannel& channel, std::vector<float>& out) {
  const bool rotation = channel.path == RawPath::rotation, scale = channel.path == RawPath::scale;
  for (const glm::vec4& v : rotation ? tidy_rotations(channel) : channel.values)
    for (int c = 0; c < (rotation ? 4 : 3); ++c) out.push_back(scale ? v[c] : without_tiny(static_cast<double>(v[c])));
}

struct ListedChannel {
  std::size_t list;  // which list of times, in order of first appearance
  std::uint16_t joint;
  const RawChannel* channel;
};

std::vector<ListedChannel> by_list(const RawClip& clip, const std::vector<int>& joint_of_node) {
  std::map<std::vector<float>, std::size_t> lists;
  std::vector<ListedChannel> out;
  for (const RawChannel& channel : clip.channels) {
    const int joint = joint_of_node[to_index(channel.node)];
    if (joint == kNone) continue;  // outside the scene; the reader has said so
    const std::size_t list = lists.try_emplace(channel.times_s, lists.size()).first->second;
    out.push_back({list, static_cast<std::uint16_t>(joint), &channel});
  }
  std::stable_sort(out.begin(), out.end(), [](const ListedChannel& a, const ListedChannel& b) {
    if (a.list != b.list) return a.list < b.list;
    if (a.joint != b.joint) return a.joint < b.joint;
    return a.channel->path < b.channel->path;
  });
  return out;
}

// As a share of a channel's largest value: how far a LINEAR one may move where keys are left out, and how far each key
// may be off. Together a thousandth of a millimetre of a shape that moves a vertex by 13 cm.
constexpr double kLineSlack = 0x1p-18, kKeySlack = 0x1p-18;

std::size_t parts_of(const RawScalar& scalar) {
  return scalar.interpolation == RawInterpolation::cubic_spline ? 3 : 1;
}

// A spline is constant if all values are the same and no tangent leads away.
bool is_constant(const RawScalar& scalar) {
  const std::size_t parts = parts_of(scalar);
  for (std::size_t i = 0; i < scalar.values.size(); ++i) {
    const bool tangent = parts == 3 && i % 3 != 1;
    if (scalar.values[i] != (tangent ? 0.0f : scalar.values[parts / 2])) return false;
  }
  return true;
}

// Of values, not of tangents.
double largest_of(const RawScalar& scalar) {
  const std::size_t parts = parts_of(scalar);
  double out = 0;
  for (std::size_t i = parts / 2; i < scalar.values.size(); i += parts)
    out = std::max(out, std::fabs(static_cast<double>(scalar.values[i])));
  return out;
}

// What jumps from key to key may be a number that stands for something, and stays.
RawScalar rounded(const RawScalar& scalar) {
  if (scalar.interpolation == RawInterpolation::step) return scalar;
  const std::size_t parts = parts_of(scalar);
  const double slack = largest_of(scalar) * kKeySlack, lever = tangent_lever(scalar.times_s);
  RawScalar out = scalar;
  for (std::size_t i = 0; i < scalar.values.size(); ++i) {
    const bool is_tangent = parts == 3 && i % 3 != 1;
    out.values[i] = rounded_within(is_tangent && lever > 0 ? slack / lever : slack, scalar.values[i]);
  }
  return out;
}

// Indices of the keys that a LINEAR channel needs: from each the next is as far as a straight line passes all between
// within the slack. The slopes that do so form an interval, which every key narrows.
std::vector<std::size_t> needed_on_lines(const RawScalar& scalar) {
  const double slack = largest_of(scalar) * kLineSlack;
  const auto run = [&](std::size_t a, std::size_t b) {
    return static_cast<double>(scalar.times_s[b]) - static_cast<double>(scalar.times_s[a]);
  };
  const auto rise = [&](std::size_t a, std::size_t b) {
    return static_cast<double>(scalar.values[b]) - static_cast<double>(scalar.values[a]);
  };
  std::vector<std::size_t> out = {0};
  double least = -std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = 1; i < scalar.times_s.size(); ++i) {
    const double slope = rise(out.back(), i) / run(out.back(), i);
    if (slope < least || slope > most) {
      out.push_back(i - 1);
      least = -std::numeric_limits<double>::infinity();
      most = -least;
    }
    const std::size_t from = out.back();
    least = std::max(least, (rise(from, i) - slack) / run(from, i));
    most = std::min(most, (rise(from, i) + slack) / run(from, i));
  }
  if (scalar.times_s.size() > 1) out.push_back(scalar.times_s.size() - 1);
  return out;
}

std::vector<std::size_t> needed_keys(const RawScalar& scalar) {
  if (scalar.interpolation == RawInterpolation::linear) return needed_on_lines(scalar);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < scalar.times_s.size(); ++i) {
    const bool repeats =
        scalar.interpolation == RawInterpolation::step && i > 0 && scalar.values[i] == scalar.values[i - 1];
    if (!repeats) out.push_back(i);
  }
  return out;
}

RawScalar with_keys(const RawScalar& scalar, const std::vector<std::size_t>& keys) {
  RawScalar out = scalar;
  const std::size_t parts = parts_of(scalar);
  out.times_s.clear();
  out.values.clear();
  for (const std::size_t key : keys) {
    out.times_s.push_back(scalar.times_s[key]);
    for (std::size_t part = 0; part < parts; ++part) out.values.push_back(scalar.values[key * parts + part]);
  }
  return out;
}

// `sharers`: how many channels have this list of times. A list of its own must be worth its bytes.
RawScalar reduced(const RawScalar& scalar, std::size_t sharers) {
  if (is_constant(scalar)) {
    RawScalar out = scalar;
    out.interpolation = RawInterpolation::step;
    out.times_s = {0.0f};  // any time will do, and all constants share one
    out.values = {scalar.values[parts_of(scalar) / 2]};
    return out;
  }
  const std::vector<std::size_t> keys = needed_keys(scalar);
  const bool worth = sharers == 1 || keys.size() * 2 < scalar.times_s.size();
  return worth ? with_keys(scalar, keys) : scalar;
}

std::vector<RawScalar> reduce_all(const std::vector<RawScalar>& scalars) {
  std::map<std::vector<float>, std::size_t> sharers;
  for (const RawScalar& scalar : scalars) ++sharers[scalar.times_s];
  std::vector<RawScalar> out;
  for (const RawScalar& scalar : scalars) out.push_back(rounded(reduced(scalar, sharers[scalar.times_s])));
  return out;
}

}  // namespace

BuiltClip build_tracks(const RawClip& clip, const std::vector<int>& joint_of_node) {
  BuiltClip out;
  out.name = clip.name;
  const std::vector<ListedChannel> channels = by_list(clip, joint_of_node);
  std::uint32_t first_time = 0;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const RawChannel& channel = *channels[i].channel;
    if (i == 0 || channels[i].list != channels[i - 1].list) {
      first_time = static_cast<std::uint32_t>(out.times_s.size());
      out.times_s.insert(out.times_s.end(), channel.times_s.begin(), channel.times_s.end());
    }
    Track track;
    track.joint = channels[i].joint;
    track.path = static_cast<TrackPath>(channel.path);
    track.interpolation = static_cast<Interpolation>(channel.interpolation);
    track.key_count = static_cast<std::uint32_t>(channel.times_s.size());
    track.first_time = first_time;
    track.first_value = static_cast<std::uint32_t>(out.values.size());
    out.tracks.push_back(track);
    add_values(channel, out.values);
    out.duration_s = std::max(out.duration_s, channel.times_s.back());
    out.most_keys = std::max(out.most_keys, track.key_count);
  }
  for (const RawScalar& scalar : clip.scalars) out.duration_s = std::max(out.duration_s, scalar.times_s.back());
  return out;
}

void add_channels(const RawClip& raw, bool all_keys, BuiltClip& clip) {
  const std::vector<RawScalar> scalars = all_keys ? raw.scalars : reduce_all(raw.scalars);
  // The last track's list stands first, so that channels can share it.
  std::map<std::vector<float>, std::size_t> lists;
  std::uint32_t first_time = 0;
  std::size_t list = SIZE_MAX;
  if (!clip.tracks.empty() && !scalars.empty()) {
    const Track& last = clip.tracks.back();
    const auto first = clip.times_s.begin() + last.first_time;
    list = lists.try_emplace({first, first + last.key_count}, 0).first->second;
    first_time = last.first_time;
  }
  std::vector<std::pair<std::size_t, const RawScalar*>> listed;
  for (const RawScalar& scalar : scalars)
    listed.emplace_back(lists.try_emplace(scalar.times_s, lists.size()).first->second, &scalar);
  std::stable_sort(listed.begin(), listed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [number, scalar] : listed) {
    if (number != list) {
      list = number;
      first_time = static_cast<std::uint32_t>(clip.times_s.size());
      clip.times_s.insert(clip.times_s.end(), scalar->times_s.begin(), scalar->times_s.end());
    }
    Channel channel{};
    channel.rest = scalar->rest;
    channel.key_count = static_cast<std::uint32_t>(scalar->times_s.size());
    channel.first_time = first_time;
    channel.first_value = static_cast<std::uint32_t>(clip.values.size());
    channel.interpolation = static_cast<Interpolation>(scalar->interpolation);
    clip.values.insert(clip.values.end(), scalar->values.begin(), scalar->values.end());
    clip.channels.push_back(channel);
    clip.channel_names.push_back(scalar->name);
  }
}
}  // namespace marrow::cook
