#include "deform/rig/auto_skeleton.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "deform/rig/embed.h"
#include "deform/rig/room.h"
#include "deform/weights/voxels.h"

namespace marrow::deform {
namespace {

void measure_way(const SkeletonTemplate& skeleton, const glm::dvec3& from, Knot& knot) {
  glm::dvec3 at = from;
  for (const std::size_t joint : knot.chain) {
    knot.length += glm::length(skeleton[joint].place - at);
    knot.lengths.push_back(knot.length);
    at = skeleton[joint].place;
  }
  knot.length += glm::length(knot.place - at);
}

}  // namespace

std::vector<Knot> knots_of(const SkeletonTemplate& skeleton) {
  std::vector<double> children(skeleton.size(), 0);
  std::vector<glm::dvec3> below(skeleton.size(), glm::dvec3(0));  // sums of places
  for (const TemplateJoint& joint : skeleton) {
    if (joint.parent == kNoJoint) continue;
    ++children[static_cast<std::size_t>(joint.parent)];
    below[static_cast<std::size_t>(joint.parent)] += joint.place;
  }
  std::vector<Knot> out;
  std::vector<int> knot_of(skeleton.size(), kNoJoint);
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    if (j > 0 && children[j] == 1) continue;
    Knot knot;
    knot.joint = j;
    knot.is_leaf = children[j] == 0;
    knot.place = j == 0 || knot.is_leaf ? skeleton[j].place : below[j] / children[j];
    knot.chain = {j};
    for (int up = skeleton[j].parent; up != kNoJoint; up = skeleton[static_cast<std::size_t>(up)].parent) {
      knot.parent = knot_of[static_cast<std::size_t>(up)];
      if (knot.parent != kNoJoint) break;
      knot.chain.push_back(static_cast<std::size_t>(up));
    }
    std::ranges::reverse(knot.chain);
    if (knot.parent != kNoJoint) measure_way(skeleton, out[static_cast<std::size_t>(knot.parent)].place, knot);
    knot_of[j] = static_cast<int>(out.size());
    out.push_back(std::move(knot));
  }
  for (Knot& knot : out) {
    const int mirror = skeleton[knot.joint].mirror;
    if (mirror != kNoJoint) knot.mirror = knot_of[static_cast<std::size_t>(mirror)];
  }
  return out;
}

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
