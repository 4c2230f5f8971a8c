#include "deform/elastic/links.h"

#include <algorithm>

namespace marrow::deform {
namespace {

constexpr double kLeastInCommon = 0.15;

// Σ of the lesser of a joint's two shares.
double in_common(const std::vector<Influence>& a, double sum_a, const std::vector<Influence>& b, double sum_b) {
  double out = 0;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (i->joint == j->joint) out += std::min(i->weight / sum_a, j->weight / sum_b);
    const bool first = i->joint <= j->joint, second = j->joint <= i->joint;
    i += first;
    j += second;
  }
  return out;
}

bool any_in_common(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (*i == *j) return true;
    if (*i < *j) {
      ++i;
    } else {
      ++j;
    }
  }
  return false;
}

}  // namespace

Links::Links(const Voxels& voxels, const SkinnedMesh& mesh) : number_(voxels.cells(), kNone) {
  std::vector<std::size_t> touched;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    touched.clear();
    const auto at = [&](std::size_t i) { return mesh.positions[mesh.indices[t + i]]; };
    voxels.add_touched(at(0), at(1), at(2), touched);
    std::ranges::sort(touched);
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const std::size_t cell : touched) {
      if (number_[cell] == kNone) {
        number_[cell] = static_cast<std::uint32_t>(surfaces_.size());
        surfaces_.emplace_back();
      }
      add(t, mesh, surfaces_[number_[cell]]);
    }
  }
}

void Links::add(std::size_t triangle, const SkinnedMesh& mesh, Surface& surface) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = mesh.indices[triangle + i];
    const auto place = std::ranges::lower_bound(surface.vertices, v);
    if ((place == surface.vertices.end() || *place != v) && surface.vertices.size() < kMostVertices)
      surface.vertices.insert(place, v);
    for (const Influence& influence : mesh.influences[v]) {
      const auto joint = std::ranges::lower_bound(surface.weights, influence.joint, {}, &Influence::joint);
      if (joint != surface.weights.end() && joint->joint == influence.joint) {
        joint->weight += influence.weight;
      } else if (surface.weights.size() < kMostJoints) {
        surface.weights.insert(joint, influence);
      }
      surface.sum += influence.weight;
    }
  }
}

bool Links::linked(std::size_t a, std::size_t b) const {
  if (number_[a] == kNone || number_[b] == kNone) return true;
  const Surface &first = surfaces_[number_[a]], &second = surfaces_[number_[b]];
  return any_in_common(first.vertices, second.vertices) ||
         !(in_common(first.weights, first.sum, second.weights, second.sum) < kLeastInCommon);
}

}  // namespace marrow::deform
