// Multi-weight enveloping: Wang and Phillips, "Multi-weight enveloping: least-squares approximation techniques for skin
// animation", SCA 2002.
#pragma once

#include <array>
#include <vector>

#include <glm/vec4.hpp>

#include "deform/fit/fit.h"
#include "deform/skinned_mesh.h"

namespace marrow::deform {

// Twelve weights instead of one: rows[r][c] multiplies element (r, c) of the joint's matrix, column 3 its translation.
struct MultiWeight {
  std::uint32_t joint;
  std::array<glm::dvec4, 3> rows;
};
using MultiWeights = std::vector<std::vector<MultiWeight>>;  // a vertex: by ascending joint

// v' = R Σ_j (Ω_j ∘ R⁻¹ M_j) (v, 1), ∘ element by element.
//
// Elements have meaning in one frame only, so the sum alone would not move with the character: R is the rigid part of
// joint `root`, rotation_of() its linear part and its translation. Scale and shear of that joint stay in the sum.
Deformer multi_weight(const SkinnedMesh& mesh, const MultiWeights& weights, std::uint32_t root);

// SSD exactly: all twelve are w_j.
MultiWeights single_weights(const SkinnedMesh& mesh);

struct MultiWeightOptions {
  // Tried by cross-validation, beside keeping SSD; with one fold the first is taken.
  std::vector<double> ridges = {1e-4, 1e-6, 1e-5, 1e-3, 1e-2, 1e-1, 1};
  Progress progress = {};  // of sets of joints
};

struct MultiWeightFit {
  MultiWeights weights;
  FitQuality quality;  // the reference is SSD
};

// Least squares a vertex and row: 4 unknowns an influence, x, y and z apart. The ridge pulls each of the weights to
// w_j, and is chosen a distinct set of joints. All lengths are in diagonals of the bind pose.
//
// Of one set's vertices the normal matrices differ by a scaling with (v, 1) on both sides. A ridge on the scaled
// unknowns would need one factorisation for all, but where a coordinate is near 0 nothing would hold its weights, which
// have to be stored; so each vertex has a factorisation of its own, of a matrix that is summed up once a set.
// On all cores; the same result on every run. Memory: 12 bytes · vertices · poses.
MultiWeightFit fit_multi_weights(const SkinnedMesh& mesh, std::uint32_t root, std::vector<TrainingPose> poses,
                                 const Deformer& truth, const MultiWeightOptions& options = {});

}  // namespace marrow::deform
