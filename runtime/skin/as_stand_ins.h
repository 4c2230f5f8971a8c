// Expresses palette entries that a vertex's neighbours follow in terms of the entries that the vertex follows.
#pragma once

#include "skin/as_surface.h"

namespace marrow {

// An entry is a vector h of shares of joints: a joint has one share, a helper has shares of two joints. An entry that
// the vertex lacks is replaced by the combination Σ x_i h_i of the vertex's own entries that equals h or is closest to
// it. For example, a helper at 3/4 is twice the helper at 1/2 less the helper at 1/4. Before that, joints in h that
// none of the vertex's entries blends are replaced by one that the vertex has: the one that the neighbour follows most,
// or if it follows none of them, the vertex's heaviest.
class StandIns {
 public:
  // Keeps references to `surface` and `vertex`.
  StandIns(const AsSurface& surface, std::uint32_t slot, const AsVertex& vertex)
      : surface_(surface), slot_(slot), vertex_(vertex) {}

  // Adds a neighbour's coordinates to those of the vertex's entries.
  void add(std::uint32_t neighbour, float (&q)[kMaxInfluences][4]);

 private:
  static constexpr std::uint32_t kMostJoints = 2 * kMaxInfluences;
  // A unit vector perpendicular to the directions before it, and its coefficients over the vertex's entries.
  struct Direction {
    float along[kMostJoints], of_entries[kMaxInfluences];
  };

  void prepare();
  std::uint32_t heir_of(std::uint32_t neighbour, const AsVertex& n) const;
  void find_shares(std::uint32_t neighbour, std::uint32_t entry, std::uint32_t heir, float (&x)[kMaxInfluences]) const;
  // The index among the vertex's joints of a joint of the other slot's mesh; joint_count_ if it is not among them.
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
