#include "skin/as_stand_ins.h"

#include "core/builtins.h"

namespace marrow {
namespace {

// The squared sine of the angle between an entry and the span of the entries before it. If it is not above this, the
// entry counts as linearly dependent on them.
constexpr float kLeastNewness = 1e-3f;

// A palette entry as the joints that it blends, one or two, and the share of each.
struct JointShares {
  std::uint32_t joint[2];
  float share[2];
  std::uint32_t count;
};
JointShares joint_shares_of(const Mesh& mesh, std::uint32_t entry) {
  if (entry < mesh.joint_count) return {{entry, entry}, {1, 0}, 1};
  const Helper& h = mesh.helpers[entry - mesh.joint_count];
  return {{h.first, h.second}, {1 - h.share, h.share}, 2};
}

float inner_product(const float* a, const float* b, std::uint32_t count) {
  float sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

// The index of the greatest number; if several are equal, the first.
std::uint32_t place_of_greatest(const float* of, std::uint32_t count) {
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < count; ++i)
    if (of[i] > of[best]) best = i;
  return best;
}

}  // namespace

std::uint32_t StandIns::place_of(std::uint32_t other_slot, std::uint32_t joint) const {
  std::uint32_t place = 0;
  while (place < joint_count_ && !surface_.same_entry(slot_, joints_[place], other_slot, joint)) ++place;
  return place;
}

// Lists the joints that the vertex's entries blend. Makes an orthonormal basis of the entries, as vectors of joint
// shares, by Gram–Schmidt.
void StandIns::prepare() {
  const Mesh& mesh = *surface_.part(slot_).mesh;
  float entry_weights[kMaxInfluences];
  for (std::uint32_t e = 0; e < vertex_.influences; ++e) {
    entry_weights[e] = vertex_.q[e][3];
    const JointShares shares = joint_shares_of(mesh, vertex_.set[e]);
    Direction d = {};
    d.of_entries[e] = 1;
    for (std::uint32_t i = 0; i < shares.count; ++i) {
      const std::uint32_t place = place_of(slot_, shares.joint[i]);
      if (place == joint_count_) {
        joints_[joint_count_] = static_cast<std::uint16_t>(shares.joint[i]);
        weights_[joint_count_++] = 0;
      }
      weights_[place] += shares.share[i] * vertex_.q[e][3];
      d.along[place] += shares.share[i];
    }
    const float before = inner_product(d.along, d.along, kMostJoints);
    for (std::uint32_t k = 0; k < direction_count_; ++k) {
      const Direction& other = directions_[k];
      const float part = inner_product(d.along, other.along, kMostJoints);
      for (std::uint32_t i = 0; i < kMostJoints; ++i) d.along[i] -= part * other.along[i];
      for (std::uint32_t i = 0; i < kMaxInfluences; ++i) d.of_entries[i] -= part * other.of_entries[i];
    }
    const float square = inner_product(d.along, d.along, kMostJoints);
    if (!(square > kLeastNewness * before)) continue;
    const float length = square_root(square);
    for (float& x : d.along) x /= length;
    for (float& x : d.of_entries) x /= length;
    directions_[direction_count_++] = d;
  }
  heaviest_entry_ = place_of_greatest(entry_weights, vertex_.influences);
  prepared_ = true;
}

// The joint that takes over the shares of joints that the vertex lacks: of the vertex's joints the one that the
// neighbour follows most, or the vertex's heaviest if the neighbour follows none of them.
std::uint32_t StandIns::heir_of(std::uint32_t neighbour, const AsVertex& n) const {
  float followed[kMostJoints + 1] = {};
  for (std::uint32_t e = 0; e < n.influences; ++e) {
    const JointShares shares = joint_shares_of(*surface_.part(neighbour).mesh, n.set[e]);
    for (std::uint32_t i = 0; i < shares.count; ++i)
      followed[place_of(neighbour, shares.joint[i])] += shares.share[i] * n.q[e][3];
  }
  const std::uint32_t most = place_of_greatest(followed, joint_count_);
  return followed[most] > 0 ? most : place_of_greatest(weights_, joint_count_);
}

// Sets x to the shares of the vertex's entries that stand in for an entry of the neighbour. They add up to 1: what is
// missing goes to the heaviest entry.
void StandIns::find_shares(std::uint32_t neighbour, std::uint32_t entry, std::uint32_t heir,
                           float (&x)[kMaxInfluences]) const {
  const JointShares shares = joint_shares_of(*surface_.part(neighbour).mesh, entry);
  float h[kMostJoints] = {};
  for (std::uint32_t i = 0; i < shares.count; ++i) {
    const std::uint32_t place = place_of(neighbour, shares.joint[i]);
    h[place < joint_count_ ? place : heir] += shares.share[i];
  }
  for (float& share : x) share = 0;
  for (std::uint32_t k = 0; k < direction_count_; ++k) {
    const float part = inner_product(h, directions_[k].along, kMostJoints);
    for (std::uint32_t i = 0; i < vertex_.influences; ++i) x[i] += part * directions_[k].of_entries[i];
  }
  float left = 1;
  for (std::uint32_t i = 0; i < vertex_.influences; ++i) left -= x[i];
  x[heaviest_entry_] += left;
}

void StandIns::add(std::uint32_t neighbour, float (&q)[kMaxInfluences][4]) {
  AsVertex n;
  surface_.read(neighbour, n);
  float others[kMaxInfluences][4] = {};  // from entries that the vertex lacks
  std::uint32_t heir = kMostJoints;
  for (std::uint32_t i = 0; i < n.influences; ++i) {
    std::uint32_t j = 0;
    while (j < vertex_.influences && !surface_.same_entry(slot_, vertex_.set[j], neighbour, n.set[i])) ++j;
    if (j < vertex_.influences) {
      for (int c = 0; c < 4; ++c) q[j][c] += n.q[i][c];
      continue;
    }
    if (!prepared_) prepare();
    if (heir == kMostJoints) heir = heir_of(neighbour, n);
    float x[kMaxInfluences];
    find_shares(neighbour, n.set[i], heir, x);
    for (j = 0; j < vertex_.influences; ++j)
      for (int c = 0; c < 4; ++c) others[j][c] += x[j] * n.q[i][c];
  }
  for (std::uint32_t j = 0; j < vertex_.influences; ++j)
    for (int c = 0; c < 4; ++c) q[j][c] += others[j][c];
}

}  // namespace marrow
