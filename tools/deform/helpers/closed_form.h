// Weights over joints and helpers that are linear blend skinning's own, and come closest to what blends rotations.
//
// Kavan, Collins, O'Sullivan, "Automatic linearization of nonlinear skinning", I3D 2009, joined to animation space.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "deform/helpers/helpers.h"

namespace marrow::deform {

// How alike two joints turn: the mean over poses of |q_i · q_j|, their rotations as quaternions, times cos 15° for each
// step from one joint to the other along the skeleton: every joint counts as turning by 30° more than poses show, since
// some will that have not, and what is far apart in the skeleton turns apart by all between. Without poses 1/2.
class Likeness {
 public:
  // Of pairs of joints that some vertex follows both of. Poses that are not finite are left out; without any other the
  // likeness of all pairs is 1/2. parents: of each joint its parent, or below 0; joints with none in common count as
  // one step apart. Empty: all do.
  Likeness(const SkinnedMesh& mesh, const std::vector<Pose>& poses, const std::vector<int>& parents);

  double of(std::uint32_t i, std::uint32_t j) const;
  // The pairs, ascending.
  const std::map<std::pair<std::uint32_t, std::uint32_t>, double>& pairs() const { return pairs_; }

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> pairs_;  // i < j
};

// Writes a vertex's weights w as shares c ≥ 0 of joints and helpers, Σ_i c_i h_i = w, with h_i what joint or helper i
// is of joints: of all that do the one with the least Σ_i c_i f_i, f_i = h_iᵀ G h_i, G_ij = E|q_i · q_j|. So vertices
// go to the helpers nearest to them, those most whose joints turn least alike. A linear program a vertex: never more
// joints and helpers than the vertex has joints.
class ClosedForm {
 public:
  // Refers to all of them.
  ClosedForm(const SkinnedMesh& mesh, const std::vector<Helper>& helpers, const Likeness& likeness);

  const glm::dvec3& position_of(std::size_t v) const { return mesh_.positions[v]; }
  // What vertex v may follow: its joints and the helpers between them, ascending.
  std::vector<std::uint32_t> entries_of(std::size_t v) const;
  // Its shares; those of no weight are left out.
  std::vector<Influence> weights_of(std::size_t v) const;
  // The same of `entries` alone, ascending; nothing where they cannot.
  std::optional<std::vector<Influence>> weights_of(std::size_t v, std::span<const std::uint32_t> entries) const;

 private:
  const SkinnedMesh& mesh_;
  const std::vector<Helper>& helpers_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> between_;  // entries, by joints
  std::vector<double> cost_;                                                               // f of each helper
};

// Animation space of such weights: q_i = c_i (v, 1).
std::vector<Coordinate> lift(const std::vector<Influence>& weights, const glm::dvec3& position);

// Helpers between the pairs of joints that vertices share: at a half for a pair at first, then at quarters, then at
// eighths, whichever misses least by the closed form, up to `most`.
//
// What a vertex of weights a and b misses of its pair is 2 a b (1 - G_ij) without a helper, and of the part between two
// helpers the same of that part; squared, summed over vertices. Without poses pairs so come in the order of Σ (a b)².
// Steps that gain less than a hundred-thousandth of the first are left out.
// places: of joints in the bind pose. about_centres: each helper turns about the mean of its vertices' centres of
// rotation, weighed by (a b)², instead of blending dual quaternions. parts: what helpers may divide a pair into, 2, 4
// or 8.
std::vector<Helper> choose_helpers(const SkinnedMesh& mesh, const Likeness& likeness,
                                   const std::vector<glm::dvec3>& places, std::size_t most, bool about_centres,
                                   int parts);

}  // namespace marrow::deform
