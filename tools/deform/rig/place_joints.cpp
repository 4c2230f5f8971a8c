#include "deform/rig/place_joints.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::deform {
namespace {

constexpr double kCentre = 1, kProportion = 0.3, kSymmetry = 60, kStay = 12;  // of squares of heights the last two
constexpr int kSamples = 6;                                                   // along a bone
constexpr double kFirstStep = 0.02;                                           // heights
constexpr int kHalvings = 5, kRounds = 8;
constexpr double kSymmetric = 0.85;  // share of voxels with one opposite, from which on sides are to be alike

// The point at `share` of a polyline's length.
glm::dvec3 along(const std::vector<glm::dvec3>& line, double share) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += glm::length(line[i] - line[i - 1]);
  double left = share * length;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = glm::length(line[i] - line[i - 1]);
    if (left <= step && step > 0) return line[i - 1] + (line[i] - line[i - 1]) * (left / step);
    left -= step;
  }
  return line.back();
}

// Of the last bone, to go on from a sphere's centre to the mesh's surface.
glm::dvec3 end_direction(const SkeletonTemplate& skeleton, const Knot& knot) {
  const TemplateJoint& end = skeleton[knot.joint];
  const glm::dvec3 along = end.place - skeleton[static_cast<std::size_t>(end.parent)].place;
  return along / std::max(glm::length(along), 1e-12);
}

class Refinement {
 public:
  Refinement(const Embedding& of, std::vector<glm::dvec3>& places) : of_(of), places_(places), start_(places) {
    children_.resize(places.size());
    for (std::size_t j = 1; j < places.size(); ++j)
      children_[static_cast<std::size_t>(of.skeleton[j].parent)].push_back(j);
    double wanted = 0, now = 0;
    low_ = high_ = of.skeleton.front().place.y;
    for (std::size_t j = 0; j < places.size(); ++j) {
      low_ = std::min(low_, of.skeleton[j].place.y);
      high_ = std::max(high_, of.skeleton[j].place.y);
      if (j == 0) continue;
      wanted += wanted_length(j);
      now += glm::length(places[j] - parent_of(j));
    }
    height_ = of.scale * std::max(high_ - low_, 1e-9);
    scale_ = wanted > 0 && now > 0 ? now / wanted : of.scale;
  }

  void run() {
    double step = kFirstStep * height_;
    for (int halving = 0; halving < kHalvings; ++halving, step /= 2)
      for (int round = 0; round < kRounds; ++round)
        if (!move_all(step)) break;
  }

 private:
  double wanted_length(std::size_t joint) const {
    const auto parent = static_cast<std::size_t>(of_.skeleton[joint].parent);
    return glm::length(of_.skeleton[joint].place - of_.skeleton[parent].place);
  }
  const glm::dvec3& parent_of(std::size_t joint) const {
    return places_[static_cast<std::size_t>(of_.skeleton[joint].parent)];
  }

  // Of the bone that ends at a joint.
  double bone(std::size_t joint) const {
    const glm::dvec3 &from = parent_of(joint), &to = places_[joint];
    double off = 0;
    for (int i = 1; i <= kSamples; ++i) {
      const double o = of_.room.off_centre(from + (to - from) * (static_cast<double>(i) / kSamples));
      off += o * o / kSamples;
    }
    const double length = std::max(glm::length(to - from), 1e-6 * height_);
    const double wanted = std::max(wanted_length(joint) * scale_, 1e-6 * height_);
    const double share = wanted * of_.scale / (scale_ * height_);  // long bones count more
    return share * (kCentre * off + kProportion * (length / wanted + wanted / length - 2));
  }

  double around(std::size_t joint) const {
    double sum = joint > 0 ? bone(joint) : 0;
    for (const std::size_t child : children_[joint]) sum += bone(child);
    const glm::dvec3 moved = (places_[joint] - start_[joint]) / height_;
    sum += kStay * glm::dot(moved, moved);
    const int mirror = of_.skeleton[joint].mirror;
    const glm::dvec3 other = places_[mirror == kNoJoint ? joint : static_cast<std::size_t>(mirror)];
    const glm::dvec3 apart = (places_[joint] - glm::dvec3(2 * of_.plane.x - other.x, other.y, other.z)) / height_;
    return sum + kSymmetry * of_.plane.share * glm::dot(apart, apart);
  }

  bool move_all(double step) {
    bool moved = false;
    for (std::size_t j = 0; j < places_.size(); ++j)
      for (int axis = 0; axis < 3; ++axis)
        for (const double by : {step, -step}) {
          const double before = around(j);
          places_[j][axis] += by;
          if (around(j) < before - 1e-12) {
            moved = true;
            break;
          }
          places_[j][axis] -= by;
        }
    return moved;
  }

  const Embedding& of_;
  std::vector<glm::dvec3>& places_;
  const std::vector<glm::dvec3> start_;
  std::vector<std::vector<std::size_t>> children_;
  double low_ = 0, high_ = 1, height_ = 1, scale_ = 1;
};

// Of a symmetric mesh: both sides at the mean of both.
void mirror_joints(const Embedding& of, std::vector<glm::dvec3>& places) {
  if (of.plane.share < kSymmetric) return;
  for (std::size_t j = 0; j < places.size(); ++j) {
    const int mirror = of.skeleton[j].mirror;
    const std::size_t other = mirror == kNoJoint ? j : static_cast<std::size_t>(mirror);
    if (other < j) continue;
    const glm::dvec3 image(2 * of.plane.x - places[other].x, places[other].y, places[other].z);
    const glm::dvec3 mean = (places[j] + image) * 0.5;
    places[j] = mean;
    places[other] =
        other == j ? glm::dvec3(of.plane.x, mean.y, mean.z) : glm::dvec3(2 * of.plane.x - mean.x, mean.y, mean.z);
  }
}

}  // namespace

std::vector<glm::dvec3> place_joints(const Embedding& of, const std::vector<std::size_t>& spheres) {
  std::vector<glm::dvec3> out(of.skeleton.size());
  for (std::size_t k = 0; k < of.knots.size(); ++k) {
    const Knot& knot = of.knots[k];
    if (knot.parent == kNoJoint) {
      out[knot.joint] = of.room.spheres()[spheres[k]].centre;
      continue;
    }
    std::vector<glm::dvec3> line;
    for (const std::size_t s : of.room.way(spheres[static_cast<std::size_t>(knot.parent)], spheres[k]))
      line.push_back(of.room.spheres()[s].centre);
    if (knot.is_leaf)
      line.push_back(line.back() + end_direction(of.skeleton, knot) * of.room.spheres()[spheres[k]].radius);
    for (std::size_t i = 0; i < knot.chain.size(); ++i)
      out[knot.chain[i]] = along(line, knot.length > 0 ? knot.lengths[i] / knot.length : 1);
  }
  mirror_joints(of, out);
  return out;
}

void refine_joints(const Embedding& of, std::vector<glm::dvec3>& places) {
  Refinement(of, places).run();
  mirror_joints(of, places);
}

}  // namespace marrow::deform
