// How much room there is inside a mesh, and along which ways.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "deform/weights/voxels.h"

namespace marrow::deform {

// Everything in grid coordinates of the voxels.
struct Sphere {
  glm::dvec3 centre;
  double radius;
};

// Distances of solid voxels' centres from the nearest centre outside, squared, exact.
std::vector<double> squared_distances_inside(const Voxels& voxels);

// Where a mesh mirrors itself: the plane x = `x`, and which share of the voxels has a solid one opposite.
struct MirrorPlane {
  double x = 0;
  double share = 0;
};
MirrorPlane mirror_plane(const Voxels& voxels);

// Spheres that fill a mesh, their centres on its medial surface, and the graph of those beside one another: after
// Baran and Popović, "Automatic rigging and animation of 3D characters", SIGGRAPH 2007.
class Room {
 public:
  explicit Room(const Voxels& voxels);

  const Voxels& voxels() const { return voxels_; }
  const std::vector<Sphere>& spheres() const { return spheres_; }
  std::size_t size() const { return spheres_.size(); }
  double widest() const { return spheres_.empty() ? 0 : spheres_.front().radius; }
  // Of what is solid, in parts that are further from all others than `kGap` of the mesh's height.
  double share_of_largest_part() const { return share_of_largest_part_; }
  // From sphere to sphere through the graph; all are of the largest part, so there is a way.
  double distance(std::size_t a, std::size_t b) const { return distances_[a * spheres_.size() + b]; }
  std::vector<std::size_t> way(std::size_t from, std::size_t to) const;
  // 0 in the middle of where a place is, 1 at the surface; more outside.
  double off_centre(const glm::dvec3& p) const;

 private:
  using Neighbours = std::vector<std::vector<std::pair<std::size_t, double>>>;
  std::vector<std::size_t> medial_cells() const;
  void pack(std::size_t most);
  void join();
  std::vector<std::uint32_t> pieces() const;
  void bridge_parts(std::vector<std::size_t>& part);
  void keep_largest_part(const std::vector<std::size_t>& part);
  void measure_ways();
  std::vector<std::size_t> sources_of(std::size_t from, std::vector<double>& distances) const;

  const Voxels& voxels_;
  std::vector<double> depth_;    // a cell: distance from outside
  std::vector<float> wide_;      // a cell: radius of the widest sphere that it is in
  std::vector<Sphere> spheres_;  // widest first
  Neighbours neighbours_;
  std::vector<double> distances_;
  double share_of_largest_part_ = 0;
};

}  // namespace marrow::deform
