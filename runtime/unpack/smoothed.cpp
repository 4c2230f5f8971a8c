#include "unpack/smoothed.h"

#include "core/step.h"
#include "unpack/arrange.h"

namespace marrow {
namespace {

constexpr std::uint32_t kWeightBits = packed::kMaxWeightBits;
constexpr std::uint32_t kColumnBits = 30;      // of a weight times a position
constexpr std::uint64_t kMostWork = 1024;      // for each vertex
constexpr std::int32_t kLeastShare = 1 << 13;  // a joint is carried from 1 / kLeastShare of the whole weight on

std::int64_t position(const Stream& s, std::uint32_t vertex, std::uint32_t axis) {
  const std::int32_t x = s.values[std::size_t{vertex} * 3 + axis], most = (1 << s.bits) - 1;
  return x < 0 ? 0 : x > most ? most : x;
}

}  // namespace

std::uint64_t Smoothed::bytes(const MeshStreams& mesh, std::uint32_t iterations) {
  const std::uint64_t v = mesh.vertex_count;
  Memory m;
  m.take<Carried>(v * kMostCarried), m.take<std::uint8_t>(v), m.take<std::uint8_t>(v);
  if (iterations > 0) {
    m.take<std::uint32_t>(v), m.take<std::uint32_t>(v), m.take<std::uint32_t>(v), m.take<Column>(v), m.take<Column>(v);
    m.take<std::uint32_t>(std::uint64_t{mesh.joint_count} + 1), m.take<std::uint32_t>(v * mesh.influences);
  }
  return m.whole();
}

std::int32_t Smoothed::own_weight(std::uint32_t leader, std::uint32_t influence) const {
  const Stream& weights = *mesh_->find(StreamKind::weights);
  const std::int32_t* const w = weights.values + std::size_t{leader} * weights.components;
  if (influence + 1u < own_[leader]) return w[influence] << weight_shift_;
  std::int32_t left = one_;
  for (std::uint32_t j = 0; j + 1u < own_[leader]; ++j) left -= w[j] << weight_shift_;
  return left;
}

bool Smoothed::begin(const MeshStreams& mesh, const MeshNeighbours& near, std::uint32_t iterations, std::uint32_t share,
                     Memory& memory) {
  const std::uint64_t count = mesh.vertex_count;
  mesh_ = &mesh;
  near_ = &near;
  iterations_ = iterations;
  joint_count_ = iterations > 0 ? mesh.joint_count : 0;
  carried_ = memory.take<Carried>(count * kMostCarried).data;
  own_ = memory.take<std::uint8_t>(count).data;
  all_ = memory.take<std::uint8_t>(count).data;
  if (iterations > 0) {
    pace_ = memory.take<std::uint32_t>(count).data;
    active_ = memory.take<std::uint32_t>(count).data;
    reached_by_ = memory.take<std::uint32_t>(count).data;
    now_ = memory.take<Column>(count).data;
    next_ = memory.take<Column>(count).data;
    first_of_ = memory.take<std::uint32_t>(std::uint64_t{mesh.joint_count} + 1).data;
    followers_ = memory.take<std::uint32_t>(count * mesh.influences).data;
  }
  if (memory.failed) return false;
  const std::uint32_t weight_bits = mesh.find(StreamKind::weights)->bits;
  weight_shift_ = kWeightBits - weight_bits;
  one_ = ((1 << weight_bits) - 1) << weight_shift_;
  const std::uint32_t bits = mesh.find(StreamKind::position)->bits + kWeightBits;
  place_shift_ = bits > kColumnBits ? bits - kColumnBits : 0;
  share_ = share;
  return true;
}

bool Smoothed::find_own(std::uint32_t& left) {
  const Stream& joints = *mesh_->find(StreamKind::joints);
  const bool smooths = iterations_ > 0;
  for (std::uint32_t j = 0; at_ == 0 && smooths && j <= joint_count_; ++j) first_of_[j] = 0;
  for (; at_ < mesh_->vertex_count && left > 0; ++at_) {
    const std::uint32_t v = at_, n = influence_count(*mesh_, v);
    use_up(4 + n, left);
    own_[v] = all_[v] = static_cast<std::uint8_t>(n);
    for (std::uint32_t j = 0; j < n; ++j)
      carried_[std::size_t{v} * kMostCarried + j] = {
          joints.values[std::size_t{v} * joints.components + j], own_weight(v, j), {0, 0, 0}};
    if (!smooths) continue;
    pace_[v] = near_->is_inside[v] != 0 ? (share_ << 15) / near_->count[v] : 0;
    reached_by_[v] = UINT32_MAX;
    for (int c = 0; c < 4; ++c) now_[v][c] = next_[v][c] = 0;
    for (std::uint32_t j = 0; near_->leader[v] == v && j < n; ++j) ++first_of_[of(v).carried[j].joint];
  }
  if (at_ < mesh_->vertex_count) return false;
  // Now first_of_ is where each joint's list ends. The lists are filled backwards, after which it is where they begin.
  for (std::uint32_t j = 0; j < joint_count_; ++j) first_of_[j + 1] += first_of_[j];
  return true;
}

bool Smoothed::find_followers(std::uint32_t& left) {
  for (; iterations_ > 0 && at_ < mesh_->vertex_count && left > 0; ++at_) {
    const std::uint32_t v = mesh_->vertex_count - 1 - at_;
    use_up(4, left);
    for (std::uint32_t j = 0; near_->leader[v] == v && j < own_[v]; ++j)
      followers_[--first_of_[of(v).carried[j].joint]] = v;
  }
  return iterations_ == 0 || at_ == mesh_->vertex_count;
}

void Smoothed::activate(std::uint32_t vertex) {
  reached_by_[vertex] = joint_;
  active_[active_count_++] = vertex;
}

void Smoothed::begin_own(std::uint32_t joint) {
  const Stream& positions = *mesh_->find(StreamKind::position);
  active_count_ = grown_ = 0;
  for (std::uint32_t i = first_of_[joint]; i < first_of_[joint + 1]; ++i) {
    const std::uint32_t v = followers_[i];
    const Joints joints = of(v);
    std::int64_t weight = 0;
    for (std::uint32_t j = 0; j < joints.own; ++j)
      if (joints.carried[j].joint == static_cast<std::int32_t>(joint)) weight = joints.carried[j].weight;
    for (std::uint32_t c = 0; c < 3; ++c)
      now_[v][c] = static_cast<std::int32_t>(weight * position(positions, v, c) >> place_shift_);
    now_[v][3] = static_cast<std::int32_t>(weight);
    if (reached_by_[v] != joint) activate(v);
  }
  grow_end_ = active_count_;
}

void Smoothed::grow(std::uint32_t v) {
  const MeshNeighbours& near = *near_;
  for (std::uint32_t i = 0; i < near.count[v]; ++i) {
    const std::uint32_t other = near.all[near.first[v] + i];
    if (pace_[other] != 0 && reached_by_[other] != joint_) activate(other);
  }
}

void Smoothed::smooth(std::uint32_t v) {
  const MeshNeighbours& near = *near_;
  const std::uint32_t n = near.count[v];
  const std::uint32_t* const row = near.all + near.first[v];
  std::int64_t sum[4] = {};
  if (pace_[v] != 0)
    for (std::uint32_t i = 0; i < n; ++i)
      for (int c = 0; c < 4; ++c) sum[c] += now_[row[i]][c];
  for (int c = 0; c < 4; ++c) {
    const std::int64_t missing = sum[c] - std::int64_t{now_[v][c]} * n;
    next_[v][c] =
        pace_[v] == 0 ? now_[v][c] : static_cast<std::int32_t>(now_[v][c] + ((missing * pace_[v] + (1 << 29)) >> 30));
  }
}

bool Smoothed::iterate(std::uint32_t& left) {
  for (; !is_grown_ && grown_ < grow_end_ && left > 0; ++grown_) {
    grow(active_[grown_]);
    use_up(1 + near_->count[active_[grown_]] / 8, left);
  }
  is_grown_ = grown_ == grow_end_;
  if (!is_grown_) return false;
  for (; at_ < active_count_ && left > 0; ++at_) {
    smooth(active_[at_]);
    use_up(1 + near_->count[active_[at_]] / 4, left);
  }
  if (at_ < active_count_) return false;
  Column* const last = now_;
  now_ = next_;
  next_ = last;
  at_ = 0;
  grow_end_ = active_count_;
  is_grown_ = false;
  return true;
}

// Hands the joint's smoothed columns to their vertices, and clears the columns.
bool Smoothed::keep(std::uint32_t& left) {
  for (; at_ < active_count_ && left > 0; ++at_) {
    keep(joint_, active_[at_]);
    use_up(4, left);
  }
  return at_ == active_count_;
}

void Smoothed::keep(std::uint32_t joint, std::uint32_t v) {
  const Stream& positions = *mesh_->find(StreamKind::position);
  Carried it{static_cast<std::int32_t>(joint), now_[v][3], {}};
  for (std::uint32_t c = 0; c < 3; ++c)
    it.offset[c] =
        static_cast<float>((std::int64_t{now_[v][c]} << place_shift_) - it.weight * position(positions, v, c));
  for (int c = 0; c < 4; ++c) now_[v][c] = next_[v][c] = 0;
  Carried* const list = carried_ + std::size_t{v} * kMostCarried;
  std::uint32_t at = 0;
  while (at < own_[v] && list[at].joint != it.joint) ++at;
  if (at < own_[v]) {
    list[at] = it;
    return;
  }
  if (it.weight < one_ / kLeastShare) return;
  if (all_[v] < kMostCarried) {
    at = all_[v]++;
  } else if (own_[v] == kMostCarried || list[kMostCarried - 1].weight >= it.weight) {
    return;
  } else {
    at = kMostCarried - 1;
  }
  for (; at > own_[v] && list[at - 1].weight < it.weight; --at) list[at] = list[at - 1];
  list[at] = it;
}

const char* Smoothed::step() {
  std::uint32_t left = kStepNumbers;
  while (place_ != Place::smoothing) {
    if (!(place_ == Place::own ? find_own(left) : find_followers(left))) return nullptr;
    at_ = 0;
    place_ = place_ == Place::own ? Place::followers : Place::smoothing;
  }
  while (joint_ < joint_count_ && left > 0) {
    if (!is_begun_) {
      const std::uint32_t followers = first_of_[joint_ + 1] - first_of_[joint_];
      use_up(1 + 2 * std::uint64_t{followers}, left);
      if (followers == 0) {
        ++joint_;
        continue;
      }
      begin_own(joint_);
      iteration_ = 0;
      is_begun_ = true;
    }
    if (iteration_ < iterations_) {
      if (!iterate(left)) return nullptr;
      ++iteration_;
      work_ += active_count_;
      if (work_ > kMostWork * mesh_->vertex_count) return "joints that spread too far to be smoothed";
    } else if (keep(left)) {
      at_ = 0;
      is_begun_ = false;
      ++joint_;
    }
  }
  return nullptr;
}

}  // namespace marrow
