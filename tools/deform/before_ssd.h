// What characters were deformed by before linear blend skinning.
#pragma once

#include <vector>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// Stitching: Woodland, "Filling the gaps: advanced animation using stitching and skinning", Game Programming Gems,
// 2000. One mesh without gaps, whose vertices follow one joint each, that of the largest weight; triangles between two
// joints stretch. Seams are shared: of an edge whose ends follow different joints, the end whose weights of these two
// are nearer to each other follows each of them by half. Of equal ends it is the one of the later joint; a vertex with
// seams to several joints takes the one that it has most weight of. Linear blend skinning of the result is stitching.
SkinnedMesh stitched(SkinnedMesh mesh);

// Joint-dependent local deformations: Magnenat-Thalmann, Laperrière, Thalmann, "Joint-dependent local deformations for
// hand animation and object grasping", Graphics Interface 1988.
//
// Of that paper: vertices follow one segment each; every joint has an operator that deforms the two segments beside it,
// by the angle of that joint; its domain is a part of the surface that no other operator has. Weights only say which
// segment a vertex is of, that of the largest. Not of it: the operators themselves, which are made for a hand's bones,
// bulges among them. Here an operator turns a vertex about the joint by a share of the joint's turn, so bends are arcs:
//   v' = M_parent (c + R^s (v - c)) on the parent's segment, M_joint (c + R^-s (v - c)) on the joint's own
//   s = ½ (1 - t(x / L)) (1 - t(r / L - 2)), t the smooth step from 0 to 1
// c: where the joint is in the bind pose. R: its turn beside its parent's. x: how far beyond the joint the vertex is on
// its segment's side, along the bone; r: how far from the bone's line. L: how thick the limb is, the mean r of the
// joint's segment, but at most half of either bone. A vertex is in the domain of the operator that has most of it.
//
// parents: of each joint another one of the mesh, or below 0. centres: where joints are in the bind pose. Refers to the
// mesh.
Deformer joint_operators(const SkinnedMesh& mesh, const std::vector<int>& parents,
                         const std::vector<glm::dvec3>& centres);

}  // namespace marrow::deform
