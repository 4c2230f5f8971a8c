// How the palette entries that a vertex follows stand for others, which its neighbours follow.
#pragma once

#include "skin/as_surface.h"

namespace marrow {

// An entry is h of joints: a joint itself, a helper the shares of two. One that the vertex lacks counts as the sum
// Σ x_i h_i of the vertex's own entries that is h, or closest to it: a helper at 3/4 as twice that at 1/2 less that at
// 1/4. Of h what joints have that none of the vertex's entries blends counts as that joint of the vertex's which the
// neighbour follows most, or else as the vertex's own heaviest.
class StandIns {
 public:
  // Refers to both.
  StandIns(const AsSurface& surface, std::uint32_t slot, const AsVertex& vertex)
      : surface_(surface), slot_(slot), vertex_(vertex) {}

  // Adds a neighbour's coordinates to those of the vertex's entries.
  void add(std::uint32_t neighbour, float (&q)[kMaxInfluences][4]);

 private:
  static constexpr std::uint32_t kMostJoints = 2 * kMaxInfluences;
  // Perpendicular to those before it, unit; and what it is of the vertex's entries.
  struct Direction {
    float along[kMostJoints], of_entries[kMaxInfluences];
  };

  void prepare();
  std::uint32_t heir_of(std::uint32_t neighbour, const AsVertex& n) const;
  void find_shares(std::uint32_t neighbour, std::uint32_t entry, std::uint32_t heir, float (&x)[kMaxInfluences]) const;
  // Of an entry of that slot's mesh, a joint: its number among the vertex's joints, joint_count_ if it is none.
  std::uint32_t place_of(std::uint32_t other_slot, std::uint32_t joint) const;

  const AsSurface& surface_;
  std::uint32_t slot_;
  const AsVertex& vertex_;
  bool prepared_ = false;
  std::uint32_t joint_count_ = 0, direction_count_ = 0, heaviest_entry_ = 0;
  std::uint16_t joints_[kMostJoints];  // that its entries blend
  float weights_[kMostJoints];         // theirs
  Direction directions_[kMaxInfluences];
};

}  // namespace marrow
