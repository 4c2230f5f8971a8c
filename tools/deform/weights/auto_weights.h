// Skin weights from nothing but a mesh and its bones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "deform/skinned_mesh.h"

namespace marrow::deform {

// A piece of what a joint moves, in the mesh's space: a joint with several children has several, one without a point or
// a short continuation.
struct Bone {
  std::uint32_t joint;
  glm::dvec3 from, to;
};

enum class WeightMethod {
  nearest,   // 1/R of the nearest joints, R the distance to a joint's bones
  gaussian,  // exp(-α (R / L)²), L the mean length of bones
  // d⁻⁸, d the distance through the mesh's voxels: Dionne and de Lasa, "Geodesic voxel binding for production character
  // meshes", SCA 2013, whose falloff (1 / ((1 - α) d + α d²))² is d⁻⁴ for α = 1; squared once more it comes closer to
  // artists' weights, see docs/deformers/weights.md.
  geodesic,
  glow,  // the light of bones, see through_voxels.h
};

// α of `gaussian`.
inline constexpr double kGaussianAlpha = 20;

struct AutoWeightOptions {
  WeightMethod method = WeightMethod::geodesic;
  std::size_t most = 4;  // influences that a vertex gets, the largest
  int resolution = 192;  // of geodesic and glow: voxels on the mesh's longest side; fewer where they would be too many
};

struct AutoWeights {
  std::vector<std::vector<Influence>> influences;  // a vertex: by ascending joint; they sum to 1 exactly
  glm::ivec3 voxels{0};                            // of geodesic and glow: the grid
  std::vector<std::size_t> unlit;                  // of glow: dark vertices, bound as by `geodesic`; ascending
  // Of geodesic and of what is unlit: vertices that no way through the mesh leads to, bound as by `nearest`; ascending.
  std::vector<std::size_t> unreached;
};

// indices: 3 a triangle, each below positions.size(). bones: at least one. Coordinates are finite and within ±1e30.
AutoWeights auto_weights(const Positions& positions, std::span<const std::uint32_t> indices,
                         std::span<const Bone> bones, const AutoWeightOptions& options = {});

// The closest point of a bone to `p`, and how far it is.
glm::dvec3 closest_on(const Bone& bone, const glm::dvec3& p);
double distance_to(const Bone& bone, const glm::dvec3& p);

// The `most` largest, scaled to sum to 1 exactly, by ascending joint. Weights that would be below `least` are left out.
// Of weights that are all 0 nothing is left.
void keep_largest(std::vector<Influence>& influences, std::size_t most, double least);

}  // namespace marrow::deform
