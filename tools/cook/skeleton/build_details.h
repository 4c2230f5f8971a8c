// What skeletons have beside their joints: limits, springs, and nodes that the game asks for by name.
#pragma once

#include <string>
#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Of each of the built skeletons its limits, ascending by joint. Notes nodes with limits that are no joints.
std::vector<std::vector<JointLimit>> build_limits(const RawScene& scene, const BuiltScene& built, Notes& notes);

// The same, into the skeletons of `built`.
void set_limits(const RawScene& scene, BuiltScene& built, Notes& notes);

// Of each of the built skeletons its springs. Notes colliders that hang on no joint.
std::vector<BuiltSprings> build_springs(const RawScene& scene, const BuiltScene& built, Notes& notes);

// The same, into the skeletons of `built`.
void set_springs(const RawScene& scene, BuiltScene& built, Notes& notes);

struct BuiltNodes {
  std::vector<BuiltNode> nodes;  // in the source's order
  std::vector<Kept> kept;        // a GLOB
};

// Nodes that the source says to keep, and those whose names one of `keep` fits, which may have wildcards. built: its
// skeletons. Notes what fits nothing and what cannot be carried.
BuiltNodes build_nodes(const RawScene& scene, const BuiltScene& built, const std::vector<std::string>& keep,
                       Notes& notes);

}  // namespace marrow::cook
