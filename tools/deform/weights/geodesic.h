// How far joints' bones are through a mesh, not through the air.
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

}  // namespace marrow::deform
