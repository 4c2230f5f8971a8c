#include "deform/weights/auto_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

#include "common/elementary.h"
#include "common/parallel.h"
#include "deform/weights/through_voxels.h"
#include "deform/weights/voxels.h"

namespace marrow::deform {
namespace {

constexpr std::size_t kChunk = 1024;  // vertices that a thread takes at a time
constexpr int kGeodesicPower = 8;
constexpr double kLeastWeight = 1e-3;    // less is not worth an influence
constexpr double kLeastDistance = 1e-6;  // shares of the mesh's size; nearer counts as on the bone

// A joint's bones, and how long they are.
struct BonesOfJoint {
  std::uint32_t joint;
  std::vector<Bone> bones;
  double length = 0;  // of the longest, in the mesh's units
};

std::vector<BonesOfJoint> by_joint(std::span<const Bone> bones) {
  std::vector<Bone> sorted(bones.begin(), bones.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const Bone& a, const Bone& b) { return a.joint < b.joint; });
  std::vector<BonesOfJoint> out;
  for (const Bone& bone : sorted) {
    if (out.empty() || out.back().joint != bone.joint) out.push_back({bone.joint, {}, 0});
    out.back().bones.push_back(bone);
    out.back().length = std::max(out.back().length, glm::length(bone.to - bone.from));
  }
  return out;
}

double distance_to(const BonesOfJoint& joint, const glm::dvec3& p) {
  double least = deform::distance_to(joint.bones.front(), p);
  for (const Bone& bone : joint.bones) least = std::min(least, deform::distance_to(bone, p));
  return least;
}

// Length of the diagonal of the box round all that triangles use, or of all there is.
double size_of(const Positions& positions, std::span<const std::uint32_t> indices) {
  const Box box = box_of(positions, indices);
  const double size = glm::length(box.high - box.low);
  return size > 0 ? size : 1.0;
}

using Distances = std::vector<JointDistance>;

Distances euclidean(const std::vector<BonesOfJoint>& joints, const glm::dvec3& p, std::size_t most) {
  Distances out;
  for (const BonesOfJoint& joint : joints) out.push_back({joint.joint, distance_to(joint, p)});
  const auto nearer = [](const JointDistance& a, const JointDistance& b) { return a.distance < b.distance; };
  std::stable_sort(out.begin(), out.end(), nearer);
  if (out.size() > most) out.resize(most);
  return out;
}

// (least / d)ⁿ: relative to the nearest, so that no power of any distance is too small a number. Distances ascend.
std::vector<Influence> by_power(const Distances& distances, double size, int power) {
  std::vector<Influence> out;
  const auto length = [&](const JointDistance& d) { return std::max(d.distance, size * kLeastDistance); };
  for (const JointDistance& d : distances) {
    const double share = length(distances.front()) / length(d);
    out.push_back({d.joint, 1});
    for (int i = 0; i < power; ++i) out.back().weight *= share;
  }
  return out;
}

std::vector<Influence> by_gaussian(const std::vector<BonesOfJoint>& joints, double mean_length, const glm::dvec3& p) {
  std::vector<Influence> out;
  double least = std::numeric_limits<double>::infinity();
  for (const BonesOfJoint& joint : joints) {
    const double share = distance_to(joint, p) / mean_length;
    out.push_back({joint.joint, kGaussianAlpha * share * share});
    least = std::min(least, out.back().weight);
  }
  // All are scaled up alike, so that the largest is 1 however far the vertex is.
  for (Influence& i : out) i.weight = tools::exponential(least - i.weight);
  return out;
}

double mean_length(const std::vector<BonesOfJoint>& joints, double size) {
  double sum = 0, count = 0;
  for (const BonesOfJoint& joint : joints) {
    if (!(joint.length > 0)) continue;
    sum += joint.length;
    ++count;
  }
  return count > 0 ? sum / count : size;
}

template <class F>
void for_each_vertex(std::size_t count, const F& f) {
  tools::for_each_in_parallel((count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    for (std::size_t v = chunk * kChunk; v < std::min(count, (chunk + 1) * kChunk); ++v) f(v);
  });
}

// Of vertices that have no weights yet.
void add_geodesic(const Voxels& voxels, const Positions& positions, std::span<const Bone> bones, double size,
                  const AutoWeightOptions& options, AutoWeights& out) {
  const Geodesic geodesic(voxels, bones, options.most);
  for_each_vertex(positions.size(), [&](std::size_t v) {
    if (out.influences[v].empty()) out.influences[v] = by_power(geodesic.at(positions[v]), size, kGeodesicPower);
  });
}

std::vector<std::size_t> without_weights(const AutoWeights& weights) {
  std::vector<std::size_t> out;
  for (std::size_t v = 0; v < weights.influences.size(); ++v)
    if (weights.influences[v].empty()) out.push_back(v);
  return out;
}

void add_through_voxels(const Positions& positions, std::span<const std::uint32_t> indices, std::span<const Bone> bones,
                        double size, const AutoWeightOptions& options, AutoWeights& out) {
  const Voxels voxels(positions, indices, options.resolution);
  out.voxels = voxels.size();
  if (options.method == WeightMethod::glow) {
    const Glow glow(voxels, positions, indices, bones);
    for_each_vertex(positions.size(), [&](std::size_t v) {
      out.influences[v] = glow.at(positions[v], v, options.most);
      // Relative to the brightest, so that no square is too small a number.
      const double brightest = out.influences[v].empty() ? 1 : out.influences[v].front().weight;
      for (Influence& i : out.influences[v]) i.weight = i.weight / brightest * (i.weight / brightest);
    });
    out.unlit = without_weights(out);
    if (out.unlit.empty()) return;
  }
  add_geodesic(voxels, positions, bones, size, options, out);
  out.unreached = without_weights(out);
}

}  // namespace

glm::dvec3 closest_on(const Bone& bone, const glm::dvec3& p) {
  const glm::dvec3 along = bone.to - bone.from;
  const double squared = glm::dot(along, along);
  if (!(squared > 0)) return bone.from;
  return bone.from + along * std::clamp(glm::dot(p - bone.from, along) / squared, 0.0, 1.0);
}

double distance_to(const Bone& bone, const glm::dvec3& p) {
  return glm::length(p - closest_on(bone, p));
}

void keep_largest(std::vector<Influence>& influences, std::size_t most, double least) {
  std::stable_sort(influences.begin(), influences.end(),
                   [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  if (influences.size() > most) influences.resize(most);
  const auto sum = [&] {
    return std::accumulate(influences.begin(), influences.end(), 0.0,
                           [](double s, const Influence& i) { return s + i.weight; });
  };
  const double first = sum();
  std::erase_if(influences, [&](const Influence& i) { return !(i.weight > 0) || i.weight < least * first; });
  if (influences.empty()) return;
  // Multiples of 2⁻³² add up without rounding, in any order; the largest takes what is over.
  constexpr double kSteps = 4294967296.0;
  const double kept = sum();
  double rest = kSteps;
  for (Influence& i : influences) rest -= i.weight = std::round(i.weight / kept * kSteps);
  influences.front().weight += rest;
  std::erase_if(influences, [](const Influence& i) { return i.weight == 0; });
  for (Influence& i : influences) i.weight /= kSteps;
  std::sort(influences.begin(), influences.end(),
            [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
}

AutoWeights auto_weights(const Positions& positions, std::span<const std::uint32_t> indices,
                         std::span<const Bone> bones, const AutoWeightOptions& options) {
  AutoWeights out;
  out.influences.resize(positions.size());
  const std::vector<BonesOfJoint> joints = by_joint(bones);
  const double size = size_of(positions, indices), length = mean_length(joints, size);
  if (options.method == WeightMethod::geodesic || options.method == WeightMethod::glow)
    add_through_voxels(positions, indices, bones, size, options, out);
  for_each_vertex(positions.size(), [&](std::size_t v) {
    std::vector<Influence>& vertex = out.influences[v];
    if (options.method == WeightMethod::gaussian) vertex = by_gaussian(joints, length, positions[v]);
    // All of `nearest`, and what no voxel reached.
    if (vertex.empty()) vertex = by_power(euclidean(joints, positions[v], options.most), size, 1);
    keep_largest(vertex, options.most, kLeastWeight);
  });
  return out;
}

}  // namespace marrow::deform
