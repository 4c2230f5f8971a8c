#include "deform/rig/auto_skeleton.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "deform/rig/embed.h"
#include "deform/rig/place_joints.h"
#include "deform/rig/room.h"
#include "deform/weights/voxels.h"

namespace marrow::deform {
namespace {

constexpr int kResolution = 128, kMostResolution = 256;  // voxels on the longest side
constexpr int kLeastUpwards = 64;                        // voxels of the height, if that is not too many
constexpr double kLeastRoom = 2;                         // voxels: the widest sphere of what has an inside
constexpr double kLeastShare = 0.9;                      // of the volume in one part

// Voxels a unit of the template, by its longer side upwards or to the front: arms may be held any way.
double scale_of(const SkeletonTemplate& skeleton, const Room& room) {
  glm::dvec3 low = skeleton.front().place, high = low;
  for (const TemplateJoint& joint : skeleton) {
    low = glm::min(low, joint.place);
    high = glm::max(high, joint.place);
  }
  glm::dvec3 bottom = room.spheres().front().centre, top = bottom;
  for (const Sphere& s : room.spheres()) {
    bottom = glm::min(bottom, s.centre - s.radius);
    top = glm::max(top, s.centre + s.radius);
  }
  const glm::dvec3 wanted = high - low, there = top - bottom;
  return wanted.y >= wanted.z ? there.y / wanted.y : there.z / wanted.z;
}

int resolution_for(const Positions& positions, std::span<const std::uint32_t> indices) {
  const Box box = box_of(positions, indices);
  const glm::dvec3 sides = box.high - box.low;
  const double longest = std::max({sides.x, sides.y, sides.z});
  const double wanted = sides.y > 0 ? kLeastUpwards * longest / sides.y : kResolution;
  return static_cast<int>(std::clamp<double>(wanted, kResolution, kMostResolution));
}

}  // namespace

AutoSkeleton auto_skeleton(const Positions& positions, std::span<const std::uint32_t> indices,
                           const SkeletonTemplate& skeleton) {
  AutoSkeleton out;
  const Voxels voxels(positions, indices, resolution_for(positions, indices));
  const Room room(voxels);
  out.voxels = voxels.size();
  out.spheres = room.size();
  if (!(room.widest() >= kLeastRoom)) {
    out.failure = RigFailure::no_room;
    return out;
  }
  if (room.share_of_largest_part() < kLeastShare) {
    out.failure = RigFailure::several_parts;
    return out;
  }
  const std::vector<Knot> knots = knots_of(skeleton);
  const Embedding embedding = {skeleton, knots, room, mirror_plane(voxels), scale_of(skeleton, room)};
  const std::optional<std::vector<std::size_t>> spheres = embed(embedding);
  if (!spheres) {
    out.failure = RigFailure::no_fit;
    return out;
  }
  out.places = place_joints(embedding, *spheres);
  refine_joints(embedding, out.places);
  for (glm::dvec3& place : out.places) place = voxels.from_grid(place);
  return out;
}

}  // namespace marrow::deform
