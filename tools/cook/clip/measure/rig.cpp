#include "cook/clip/measure/rig.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/elementary.h"

namespace marrow::cook {
namespace {

glm::dvec4 slerp(glm::dvec4 a, glm::dvec4 b, double u) {
  if (glm::dot(a, b) < 0) b = -b;
  const double angle = 2 * tools::angle_of(glm::length(b - a), glm::length(b + a));
  if (angle < 1e-9) return glm::normalize(a + u * (b - a));
  return (tools::sine((1 - u) * angle) * a + tools::sine(u * angle) * b) / tools::sine(angle);
}

glm::dvec4 unit(glm::dvec4 q) {
  const double length = glm::length(q);
  return length > 0 ? q / length : glm::dvec4(0, 0, 0, 1);
}

}  // namespace

double rounding_at(float time_s) {
  return std::max(1e-6, static_cast<double>(time_s) * 0x1p-22);
}

bool jumps(const BuiltClip& clip, const Track& track) {
  constexpr float kRounding = 1e-6f;
  const bool is_step = track.interpolation == Interpolation::step;
  const std::size_t width = format::floats_per_key(track.path, track.interpolation), part = width / 3;
  const bool is_cubic = track.interpolation == Interpolation::cubic_spline;
  const std::size_t from = is_cubic ? part : 0, to = is_cubic ? 2 * part : width;  // the key's value
  const float* const times = clip.times_s.data() + track.first_time;
  const float* const values = clip.values.data() + track.first_value;
  float largest = track.path == TrackPath::translation ? 0.0f : 1.0f;
  for (std::size_t i = from; i < to; ++i) largest = std::max(largest, std::fabs(values[i]));
  for (std::size_t k = 1; k < track.key_count; ++k) {
    if (!is_step && static_cast<double>(times[k]) - static_cast<double>(times[k - 1]) > rounding_at(times[k])) continue;
    const float *key = values + k * width, *other = is_step ? values : key - width;
    for (std::size_t i = from; i < to; ++i)
      if (!(std::fabs(key[i] - other[i]) <= kRounding * largest)) return true;
  }
  return false;
}

SourceCurves::SourceCurves(const BuiltClip& clip, const BuiltSkeleton& skeleton)
    : clip_(&clip), rest_(rest_transforms(skeleton)), tracks_(skeleton.parents.size()) {
  for (const Track& track : clip.tracks) tracks_[track.joint][static_cast<std::size_t>(track.path)] = &track;
}

glm::dvec4 SourceCurves::evaluate(const Track& track, double time_s) const {
  const bool rotation = track.path == TrackPath::rotation;
  const int components = rotation ? 4 : 3;
  const bool cubic = track.interpolation == Interpolation::cubic_spline;
  const float* const times = clip_->times_s.data() + track.first_time;
  // part: 0 in-tangent, 1 value, 2 out-tangent of a cubic key
  const auto key = [&](std::size_t k, std::size_t part) {
    const std::size_t first = track.first_value + (cubic ? 3 * k + part : k) * to_index(components);
    glm::dvec4 v(0);
    for (int c = 0; c < components; ++c) v[c] = static_cast<double>(clip_->values[first + to_index(c)]);
    return v;
  };
  const auto fix = [&](glm::dvec4 v) { return rotation ? unit(v) : v; };
  const auto after = static_cast<std::size_t>(std::upper_bound(times, times + track.key_count, time_s) - times);
  if (after == 0) return fix(key(0, 1));
  if (after == track.key_count) return fix(key(after - 1, 1));
  const double from = static_cast<double>(times[after - 1]), span = static_cast<double>(times[after]) - from;
  const double u = (time_s - from) / span;
  const glm::dvec4 a = key(after - 1, 1), b = key(after, 1);
  if (track.interpolation == Interpolation::step) return fix(a);
  if (!cubic) return rotation ? slerp(unit(a), unit(b), u) : a + u * (b - a);
  const double u2 = u * u, u3 = u2 * u;
  return fix((2 * u3 - 3 * u2 + 1) * a + span * (u3 - 2 * u2 + u) * key(after - 1, 2) + (3 * u2 - 2 * u3) * b +
             span * (u3 - u2) * key(after, 0));
}

Transform SourceCurves::at(std::size_t joint, double time_s) const {
  Transform out = rest_[joint];
  if (const Track* t = track(joint, TrackPath::translation)) out.translation = glm::dvec3(evaluate(*t, time_s));
  if (const Track* t = track(joint, TrackPath::scale)) out.scale = glm::dvec3(evaluate(*t, time_s));
  if (const Track* t = track(joint, TrackPath::rotation)) {
    const glm::dvec4 q = evaluate(*t, time_s);
    out.rotation = glm::dquat(q.w, q.x, q.y, q.z);
  }
  return out;
}

World operator*(const World& a, const World& b) {
  return {a.linear * b.linear, a.linear * b.origin + a.origin};
}

World to_world(const Transform& t) {
  glm::dmat3 linear = glm::mat3_cast(t.rotation);
  for (int axis = 0; axis < 3; ++axis) linear[axis] *= t.scale[axis];
  return {linear, t.translation};
}

Rig::Rig(const BuiltSkeleton& skeleton) : rest(rest_transforms(skeleton)) {
  const std::size_t count = skeleton.parents.size();
  above.resize(count);
  children.resize(count);
  world.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    const bool root = skeleton.parents[j] == kNoJoint;
    parents.push_back(root ? kNone : skeleton.parents[j]);
    if (root) {
      const Affine& a = skeleton.model_from_root[j];
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) above[j].linear[c][r] = static_cast<double>(a.rows[r][c]);
        above[j].origin[r] = static_cast<double>(a.rows[r][3]);
      }
    }
    const glm::dmat3& linear = root ? above[j].linear : world[skeleton.parents[j]].linear;
    scale_above.push_back(std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])}));
    world[j] = place(j, root ? nullptr : &world[skeleton.parents[j]], rest[j]);
  }
  for (std::size_t j = 0; j < count; ++j)
    if (parents[j] != kNone) children[to_index(parents[j])].push_back(j);
  subtree_sizes.assign(count, 1);
  for (std::size_t j = count; j-- > 0;)
    if (parents[j] != kNone) subtree_sizes[to_index(parents[j])] += subtree_sizes[j];
}

std::vector<std::size_t> Rig::subtree(std::size_t joint) const {
  std::vector<std::size_t> out = {joint};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::vector<std::size_t>& below = children[out[i]];
    out.insert(out.end(), below.begin(), below.end());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<double> Rig::least_below(const std::vector<double>& values) const {
  std::vector<double> out = values;
  for (std::size_t j = out.size(); j-- > 0;)
    if (parents[j] != kNone) {
      double& up = out[to_index(parents[j])];
      up = std::min(up, out[j]);
    }
  return out;
}

double shell_error(const World& source, const World& other, double shell) {
  const glm::dvec3 offset = other.origin - source.origin;
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(source.linear[axis]);
    const glm::dvec3 turned =
        length > 0 ? (other.linear[axis] - source.linear[axis]) * (shell / length) : glm::dvec3(0);
    squared =
        std::max({squared, glm::dot(offset + turned, offset + turned), glm::dot(offset - turned, offset - turned)});
  }
  return std::sqrt(squared);
}

void Promise::watch(std::size_t joint, const glm::dvec4& point, const Rig& rig) {
  const double distance = glm::length(rig.world[joint].linear * glm::dvec3(point));
  if (distance <= shell) return;
  points[joint].push_back(point);
  reach[joint] = std::max(reach[joint], distance);
}

double reach_below(std::size_t joint, const Rig& rig, const Promise& promise) {
  double out = 0;
  for (const std::size_t below : rig.subtree(joint))
    out = std::max(out, glm::length(rig.world[below].origin - rig.world[joint].origin) + promise.reach[below]);
  return out;
}
}  // namespace marrow::cook
