// Largest disagreements between the GPU's vertices and the CPU's.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "gl/support/feedback.h"
#include "marrow/skin.h"

namespace marrow::test {

struct Worst {
  double position = 0;    // fraction of the diagonal
  double normal_deg = 0;  // where the blended matrix can be inverted
  double tangent_deg = 0;
  std::size_t vertices = 0, normals = 0, tangents = 0, wrong_signs = 0;

  void add(const Worst& other) {
    position = std::max(position, other.position);
    normal_deg = std::max(normal_deg, other.normal_deg);
    tangent_deg = std::max(tangent_deg, other.tangent_deg);
    vertices += other.vertices;
    normals += other.normals;
    tangents += other.tangents;
    wrong_signs += other.wrong_signs;
  }
};

inline double angle_deg(const float* a, const float* b) {
  double dot = 0, cross2 = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double c =
        static_cast<double>(a[j]) * static_cast<double>(b[k]) - static_cast<double>(a[k]) * static_cast<double>(b[j]);
    dot += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    cross2 += c * c;
  }
  return std::atan2(std::sqrt(cross2), dot) * 57.29577951308232;
}

// How far from singular each slot's blended matrix is: |det| over the product of its rows' lengths, 0 … 1. Where it is
// nearly 0 (a joint folded flat) a normal has no direction to agree on. residual_weights: blend by (q)_w, as animation
// space does.
std::vector<double> conditioning(const Geometry& geometry, Span<const Affine> palette, bool residual_weights);

// The same of tangents as vectors: how long each tangent is in this pose beside its vectors, times the sine of the
// angle between the two.
std::vector<double> surface_conditioning(const Geometry& geometry, Span<const float> tangents,
                                         Span<const Affine> palette);

// got: the GPU's. well: from conditioning(); normals below `least` are not compared.
Worst compare(const Geometry& geometry, const Skinned& got, const SkinOutput& want, double diagonal,
              const std::vector<double>& well, double least);

}  // namespace marrow::test
