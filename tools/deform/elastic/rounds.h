// The shape that an elastic body takes in a pose: rotations of cells and places of corners, turn by turn.
#pragma once

#include <array>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "deform/elastic/body.h"

namespace marrow::deform {

// Where joints alone would have the body, in sides of a cell.
struct Carried {
  std::vector<glm::dvec3> places;     // of nodes
  std::vector<glm::dquat> turns;      // of nodes
  std::vector<glm::dmat3> stretches;  // of nodes, symmetric; empty: all are the identity
};

struct BodyShape {
  std::vector<Four> places;                    // of nodes
  std::vector<std::array<Four, 3>> gradients;  // of nodes: how the body is turned and stretched there, by columns
};

// 16 rounds from where the joints have it: first each cell takes the rotation nearest to its own gradient and twice
// its neighbours' rotations, then the corners go to where their energy is least for those rotations. Most rounds go
// beyond that, which is worth four rounds more. After Sorkine and Alexa, "As-rigid-as-possible surface modeling", SGP
// 2007; McAdams, Zhu, Selle, Empey, Tamstorf, Teran, Sifakis, "Efficient elasticity for character skinning with contact
// and collisions", ACM TOG 30(4), 2011, for cells of a lattice; Levi and Gotsman, "Smooth rotation enhanced
// as-rigid-as-possible mesh animation", IEEE TVCG 21(2), 2015. A cell of volume 1 nearest to its gradient pulls as
// well, that one of its share of volume.
// Thread-safe. The same bits everywhere.
BodyShape find_shape(const Body& body, const Carried& carried);

}  // namespace marrow::deform
