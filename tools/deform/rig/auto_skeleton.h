// A skeleton for a mesh that has none, out of a template.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

inline constexpr int kNoJoint = -1;

struct TemplateJoint {
  std::string name;
  int parent = kNoJoint;  // a joint before this one
  // +Y up, +Z to the front, so +X to the left; in any unit, as only proportions count. The plane x = 0 is the mirror.
  glm::dvec3 place{0};
  int mirror = kNoJoint;  // the same joint on the other side
  bool is_end = false;    // no joint, but where the one above ends
};

// The first is the only one without a parent; ends have no children.
using SkeletonTemplate = std::vector<TemplateJoint>;

inline constexpr std::size_t kMostTemplateJoints = 128;  // ends and mirrored ones among them
inline constexpr std::size_t kMostTemplateKnots = 24;    // that branch or end

// What the search places: the first joint, where ways part to several joints below one, and ends of chains.
struct Knot {
  std::size_t joint;
  glm::dvec3 place{0};             // of the first joint and of ends their own; else the mean of those of joints below
  int parent = kNoJoint;           // a knot before this one
  int mirror = kNoJoint;           // a knot
  std::vector<std::size_t> chain;  // joints on the way from the parent, this one's the last
  std::vector<double> lengths;     // one a joint of the chain: how far along the way it is
  double length = 0;               // of the way
  bool is_leaf = true;
};

std::vector<Knot> knots_of(const SkeletonTemplate& skeleton);

enum class RigFailure {
  none,
  no_room,        // flat, empty, or so open that no inside is found
  several_parts,  // far from one another
  no_fit,         // no place for some part of the template
};

struct AutoSkeleton {
  RigFailure failure = RigFailure::none;
  std::vector<glm::dvec3> places;  // a joint of the template, ends too; in the mesh's units
  glm::ivec3 voxels{0};
  std::size_t spheres = 0;
};

// The mesh stands upright, +Y up, and faces +Z. Coordinates are finite and within ±1e30. The same bits everywhere.
AutoSkeleton auto_skeleton(const Positions& positions, std::span<const std::uint32_t> indices,
                           const SkeletonTemplate& skeleton);

}  // namespace marrow::deform
