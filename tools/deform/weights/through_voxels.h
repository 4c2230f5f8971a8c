// How near joints' bones are inside a mesh: by ways through its voxels, and by light that glows through them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deform/weights/auto_weights.h"
#include "deform/weights/voxels.h"

namespace marrow::deform {

struct JointDistance {
  std::uint32_t joint;
  double distance;
};

// The nearest few joints of every solid voxel, by steps from voxel to voxel, diagonal ones too, that never leave the
// solid. A path starts where a joint's bones run through solid voxels; of a joint all of whose bones lie outside, at
// the solid voxels that are nearest to them.
class Geodesic {
 public:
  Geodesic(const Voxels& voxels, std::span<const Bone> bones, std::size_t most);

  // By distance, in the mesh's units; at most `most`, none where no path leads.
  std::vector<JointDistance> at(const glm::dvec3& p) const;

 private:
  struct Start {
    std::size_t voxel;  // among the solid
    JointDistance distance;
  };
  void number_solid();
  bool on_surface(std::size_t cell) const;
  std::vector<Start> starts_of(std::span<const Bone> joint) const;
  void start_within(const Bone& bone, std::vector<Start>& out) const;
  void start_nearby(std::span<const Bone> joint, std::vector<Start>& out) const;
  bool offer(std::size_t voxel, const JointDistance& distance);
  void spread(const std::vector<Start>& starts);

  static constexpr std::uint32_t kNotSolid = 0xFFFFFFFF;
  const Voxels& voxels_;
  std::size_t most_;
  std::vector<std::uint32_t> number_;   // of a cell, among the solid
  std::vector<std::size_t> cell_;       // of a solid voxel
  std::vector<JointDistance> nearest_;  // most_ a solid voxel, by distance, then joint; in voxels
  std::vector<std::uint32_t> found_;    // of a solid voxel, how many of them
  std::vector<std::size_t> surface_;    // solid voxels beside one that is not
};

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
