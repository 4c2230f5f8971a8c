// The deformers that others are measured against, evaluated offline and slowly.
//
// All keep a reference to the mesh, which must outlive them.
#pragma once

#include "deform/mesh.h"
#include "deform/surface.h"

namespace marrow::deform {

// Every vertex follows its joint with the largest weight; of equal ones the first.
Deformer rigid(const SkinnedMesh& mesh);

// Linear blend skinning.
Deformer ssd(const SkinnedMesh& mesh);

// Dual quaternion skinning: Kavan, Collins, Žára, O'Sullivan, "Geometric skinning with approximate dual quaternion
// blending", ACM TOG 27(4), 2008. Quaternions take the sign that is nearest to that of the vertex's largest weight.
// What joints have beside rotation and translation is blended linearly first (section 4.2 there).
Deformer dual_quaternions(const SkinnedMesh& mesh);

// Le and Hodgins, "Real-time skeletal skinning with optimized centers of rotation", ACM TOG 35(4), 2016: rotations are
// blended as quaternions, about a centre a vertex, which moves by SSD. sigma: how alike weights must be, in that paper
// 0.1.
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

}  // namespace marrow::deform
