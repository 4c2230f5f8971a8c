// How much light of bones that glow reaches a vertex from inside the mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deform/weights/auto_weights.h"
#include "deform/weights/voxels.h"

namespace marrow::deform {

// After Wareham and Lasenby, "Bone Glow: an improved method for the assignment of weights for mesh deformation", AMDO
// 2008: a bone is a glowing rod. A point of it sends light by the sine between the rod and the ray; the vertex takes it
// by the cosine between its normal and the ray, divided by the squared distance; none comes where the ray leaves the
// mesh.
class Glow {
 public:
  Glow(const Voxels& voxels, const Positions& positions, std::span<const std::uint32_t> indices,
       std::span<const Bone> bones);

  // Joints that shine on a vertex: the `most` brightest, brightest first. Empty where none does.
  std::vector<Influence> at(const glm::dvec3& p, std::size_t vertex, std::size_t most) const;

 private:
  struct Rod {
    std::uint32_t joint;
    glm::dvec3 from, axis;  // in grid coordinates; the axis is unit
    double length;
  };
  // A rod as a vertex sees it: points along it by s, from the foot of the vertex's perpendicular.
  struct View {
    const Rod* rod;
    double foot, height;  // along the rod; from its line
    double low, high;     // s / √(s² + height²) of its ends
    double most_light() const { return (high - low) / height; }
  };
  View view_of(const Rod& rod, const glm::dvec3& p) const;
  // Some lesser number where it cannot be more than `needed`.
  double light_of(const View& view, const glm::dvec3& p, const glm::dvec3& normal, double needed) const;

  const Voxels& voxels_;
  std::vector<Rod> rods_;            // by ascending joint
  std::vector<glm::dvec3> normals_;  // of vertices, outwards; 0 where there is none
};

}  // namespace marrow::deform
