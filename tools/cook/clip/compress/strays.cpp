#include "cook/clip/compress/strays.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

// Twelve numbers of four moments each.
struct Lanes {
  alignas(16) float of[4][3][4];  // the columns of a map and its origin

  void set(std::size_t lane, const World& map) {
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 3; ++r) of[c][r][lane] = static_cast<float>(c < 3 ? map.linear[c][r] : map.origin[r]);
  }
};

}  // namespace

Strays::Strays(const Rig& rig, const Promise& promise, const std::vector<std::span<const Transform>>& source)
    : rig_(rig), subtrees_(rig.size()), source_(rig.size()), points_(rig.size()) {
  const std::size_t moments = source.empty() ? 0 : source[0].size();
  frame_count_ = (moments + kMoments - 1) / kMoments;
  per_axis_.resize(frame_count_ * rig.size());
  unit_ = promise.error.empty() ? 1 : *std::min_element(promise.error.begin(), promise.error.end());
  for (std::size_t j = 0; j < rig.size(); ++j) {
    const int up = rig.parents[j];
    source_[j].reserve(moments);
    for (std::size_t e = 0; e < moments; ++e)
      source_[j].push_back(rig.place(j, up == kNone ? nullptr : &source_[to_index(up)][e], source[j][e]));
    for (std::size_t frame = 0; frame < frame_count_; ++frame) {
      alignas(16) float shares[3][4];
      for (std::size_t lane = 0; lane < kMoments; ++lane)
        for (int axis = 0; axis < 3; ++axis) {
          const double length = glm::length(source_[j][moment_of(frame, lane)].linear[axis]);
          shares[axis][lane] = length > 0 ? static_cast<float>(promise.shell / length) : 0;
        }
      per_axis_[at(frame, j)] = load_vectors(shares);
    }
    for (const glm::dvec4& point : promise.points[j]) points_[j].emplace_back(point);
    const double share = unit_ / promise.error[j];
    inverse_limit_.push_back(static_cast<float>(share * share));
  }
  for (Poses* poses : {&now_, &trial_}) {
    poses->local.resize(per_axis_.size());
    poses->own.resize(per_axis_.size());
    poses->placed.resize(per_axis_.size(), {{}, splat(0.0f)});
  }
}

// After the last moment come copies of it.
std::size_t Strays::moment_of(std::size_t frame, std::size_t lane) const {
  return frame + 1 == frame_count_ ? frame * kMoments : frame * kMoments + lane;
}

World Strays::decoded(std::size_t joint, std::size_t moment) const {
  const FourMaps& four = now_.placed[at(moment / kMoments, joint)].stray;
  const Vector<f32x4> columns[] = {four.linear.x, four.linear.y, four.linear.z, four.origin};
  World out = source_[joint][moment];
  for (int c = 0; c < 4; ++c) {
    alignas(16) float lanes[3][4];
    store_vectors(lanes, columns[c]);
    for (int r = 0; r < 3; ++r) {
      const double stray = unit_ * static_cast<double>(lanes[r][moment % kMoments]);
      (c < 3 ? out.linear[c][r] : out.origin[r]) += stray;
    }
  }
  return out;
}

void Strays::take_local(std::size_t joint, std::size_t frame, const Transform* decoded, Poses& out) const {
  const int up = rig_.parents[joint];
  const double inverse = 1 / unit_;
  Lanes local, own;
  for (std::size_t lane = 0; lane < kMoments; ++lane) {
    const std::size_t e = moment_of(frame, lane);
    const World map = to_world(decoded[e - frame * kMoments]);
    const World& above = up == kNone ? rig_.above[joint] : source_[to_index(up)][e];
    const World &there = source_[joint][e], here = above * map;
    local.set(lane, map);
    own.set(lane, {(here.linear - there.linear) * inverse, (here.origin - there.origin) * inverse});
  }
  const auto four = [](const Lanes& lanes) {
    return FourMaps{{load_vectors(lanes.of[0]), load_vectors(lanes.of[1]), load_vectors(lanes.of[2])},
                    load_vectors(lanes.of[3])};
  };
  out.local[at(frame, joint)] = four(local);
  out.own[at(frame, joint)] = four(own);
}

// Of the farthest of the six points of the shell, and of the joint's points, in units of the strictest promise.
f32x4 Strays::squared_error(std::size_t joint, std::size_t frame, const FourMaps& stray) const {
  const Vector<f32x4>& share = per_axis_[at(frame, joint)];
  const f32x4 moved = dot(stray.origin, stray.origin);
  const auto of_axis = [&](const Vector<f32x4>& column, f32x4 by) {
    const Vector<f32x4> turned = column * by;
    const f32x4 along = absolute(dot(stray.origin, turned));
    return moved + dot(turned, turned) + (along + along);
  };
  f32x4 out = greater(greater(of_axis(stray.linear.x, share.x), of_axis(stray.linear.y, share.y)),
                      of_axis(stray.linear.z, share.z));
  for (const glm::vec4& point : points_[joint]) {
    const Vector<f32x4> off = stray.linear * splat(point.x, point.y, point.z) + stray.origin * splat(point.w);
    out = greater(out, dot(off, off));
  }
  return out;
}

// Places a joint for trial. Gives (error / promise)². own: where its tracks are; above: where its parent is placed.
f32x4 Strays::move(std::size_t joint, std::size_t frame, const Poses& own, const Poses& above) {
  const std::size_t i = at(frame, joint);
  FourMaps stray = own.own[i];
  if (rig_.parents[joint] != kNone) {
    const FourMaps& up = above.placed[at(frame, to_index(rig_.parents[joint]))].stray;
    const FourMaps& local = own.local[i];
    const Linear<f32x4> turned = up.linear * local.linear;
    stray.linear = {stray.linear.x + turned.x, stray.linear.y + turned.y, stray.linear.z + turned.z};
    stray.origin = stray.origin + up.origin + up.linear * local.origin;
  }
  trial_.placed[i].stray = stray;
  return squared_error(joint, frame, stray) * splat(inverse_limit_[joint]);
}

// share: as move() gives it.
f32x4 Strays::energy_change(std::size_t joint, std::size_t frame, f32x4 share) {
  const f32x4 fourth_power = share * share, energy = fourth_power * fourth_power;
  trial_.placed[at(frame, joint)].energy = energy;
  return energy - now_.placed[at(frame, joint)].energy;
}

const std::vector<std::size_t>& Strays::subtree(std::size_t joint) {
  if (subtrees_[joint].empty()) subtrees_[joint] = rig_.subtree(joint);
  return subtrees_[joint];
}

bool Strays::attempt(std::size_t joint, std::size_t frame, const Transform* decoded, double& energy) {
  take_local(joint, frame, decoded, trial_);
  f32x4 change = splat(0.0f);
  for (const std::size_t j : subtree(joint)) {
    const bool first = j == joint;
    const f32x4 share = move(j, frame, first ? trial_ : now_, first ? now_ : trial_);
    if (!all(share < splat(1.0f))) return false;
    change = change + energy_change(j, frame, share);
  }
  float lanes[4];
  store(lanes, change);
  const std::size_t count = frame + 1 == frame_count_ ? 1 : kMoments;
  for (std::size_t lane = 0; lane < count; ++lane) energy += static_cast<double>(lanes[lane]);
  return true;
}

float Strays::worst(std::size_t joint, std::size_t frame, const Transform* decoded, bool only_first, float most) {
  take_local(joint, frame, decoded, trial_);
  float out = 0;
  for (const std::size_t j : subtree(joint)) {
    const bool first = j == joint;
    float lanes[4];
    store(lanes, move(j, frame, first ? trial_ : now_, first ? now_ : trial_));
    for (std::size_t lane = 0; lane < (only_first ? 1 : kMoments); ++lane) out = std::max(out, lanes[lane]);
    if (!(out <= most)) return out;
  }
  return out;
}

void Strays::commit(std::size_t joint) {
  const std::vector<std::size_t>& below = subtree(joint);
  for (std::size_t frame = 0; frame < frame_count_; ++frame) {
    now_.local[at(frame, joint)] = trial_.local[at(frame, joint)];
    now_.own[at(frame, joint)] = trial_.own[at(frame, joint)];
    for (const std::size_t j : below) now_.placed[at(frame, j)] = trial_.placed[at(frame, j)];
  }
}

bool Strays::place(const std::vector<std::vector<Transform>>& decoded) {
  for (std::size_t frame = 0; frame < frame_count_; ++frame)
    for (std::size_t j = 0; j < rig_.size(); ++j) {
      take_local(j, frame, &decoded[j][frame * kMoments], trial_);
      const f32x4 share = move(j, frame, trial_, trial_);
      if (!all(share < splat(1.0f))) return false;
      energy_change(j, frame, share);
    }
  std::swap(now_, trial_);
  return true;
}

}  // namespace marrow::cook
