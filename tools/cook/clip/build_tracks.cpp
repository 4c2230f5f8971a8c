#include "cook/clip/build_tracks.h"

#include <algorithm>
#include <cmath>
#include <map>

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
    const int joint = joint_of_node[static_cast<std::size_t>(channel.node)];
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

}  // namespace marrow::cook
