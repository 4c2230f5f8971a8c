// The deformers that others are measured against, evaluated offline and slowly.
//
// All keep a reference to the mesh, which must outlive them. In finite poses all are finite; a joint without
// has_rotation(), of scale 0 say, counts as if it did not turn.
#pragma once

#include <vector>

#include "deform/skinned_mesh.h"
#include "deform/surface.h"

namespace marrow::deform {

// Every vertex follows its joint with the largest weight; of equal ones the first.
Deformer rigid(const SkinnedMesh& mesh);

// Linear blend skinning.
Deformer ssd(const SkinnedMesh& mesh);

// Dual quaternion skinning: Kavan, Collins, Žára, O'Sullivan, "Geometric skinning with approximate dual quaternion
// blending", ACM TOG 27(4), 2008. Quaternions take the sign that is nearest to that of the vertex's largest weight.
//
// Joints may scale: a joint's part at a vertex is its nearest rotation, and the place where it takes the vertex,
// stretch included. So without rotations it is linear blending; where all joints scale alike, that scale of what it is
// without; and it does not matter where the mesh's origin is. For the paper's joints, which are rigid, it is the same.
Deformer dual_quaternions(const SkinnedMesh& mesh);

// Le and Hodgins, "Real-time skeletal skinning with optimized centers of rotation", ACM TOG 35(4), 2016: rotations are
// blended as quaternions, about a centre a vertex, which moves by SSD. sigma: how alike weights must be, in that paper
// 0.1. What joints have beside rotation, S of M = R S, is blended linearly and applied first, from the centre.
Deformer centres_of_rotation(const SkinnedMesh& mesh, double sigma = 0.1);
// The centres; for a vertex that follows one joint alone, or like no triangle, itself.
Positions rotation_centres(const SkinnedMesh& mesh, double sigma = 0.1);

// Delta mush: Mancewicz, Derksen, Rijpkema, Wilson, DigiPro 2014. SSD, smoothed, with the detail that smoothing takes
// from the bind pose put back in each vertex's own frame. Borders are not smoothed.
struct DeltaMushOptions {
  int iterations = 10;
  double step = 0.5;  // 0 … 1
  EdgeWeights weights = EdgeWeights::uniform;
};
Deformer delta_mush(const SkinnedMesh& mesh, const DeltaMushOptions& options = {});
// The same over another deformer than SSD.
Deformer delta_mush(const SkinnedMesh& mesh, const DeltaMushOptions& options, const Deformer& over);
// The share of the bind pose's area that smoothing leaves; 1 for a mesh without area. Parts that smoothing shrinks to
// threads lose their frames, so what is put back turns anywhere.
double area_kept(const SkinnedMesh& mesh, const DeltaMushOptions& options);
// With steps that leave kLeastArea, shorter by eighths until they do; never longer.
inline constexpr double kLeastArea = 0.4;
DeltaMushOptions with_least_area(const SkinnedMesh& mesh, DeltaMushOptions options);

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
