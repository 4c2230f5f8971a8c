#include "deform/rig/skeleton_template.h"

#include <algorithm>

#include <glm/geometric.hpp>

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

}  // namespace marrow::deform
