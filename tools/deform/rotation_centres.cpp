#include <algorithm>
#include <map>

#include <glm/geometric.hpp>

#include "common/elementary.h"
#include "common/parallel.h"
#include "deform/deformers.h"

namespace marrow::deform {
namespace {

// A triangle as two of its joints see it.
struct Patch {
  double a, b;  // weights of the two
  double area;
  glm::dvec3 centre;
};
using JointPair = std::pair<std::uint32_t, std::uint32_t>;

std::map<JointPair, std::vector<Patch>> patches_of(const SkinnedMesh& mesh) {
  std::map<JointPair, std::vector<Patch>> out;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const std::uint32_t* const corner = &mesh.indices[t];
    const glm::dvec3 &a = mesh.positions[corner[0]], &b = mesh.positions[corner[1]], &c = mesh.positions[corner[2]];
    const double area = glm::length(glm::cross(b - a, c - a)) / 2;
    std::map<std::uint32_t, double> weights;
    for (int i = 0; i < 3; ++i)
      for (const Influence& influence : mesh.influences[corner[i]]) weights[influence.joint] += influence.weight / 3;
    for (auto j = weights.begin(); j != weights.end(); ++j)
      for (auto k = std::next(j); k != weights.end(); ++k)
        out[{j->first, k->first}].push_back({j->second, k->second, area, (a + b + c) / 3.0});
  }
  return out;
}

}  // namespace

// Equation 1 and 2 there: the mean of the surface, weighted by how alike weights are. Their sum over pairs of joints
// can be taken pair by pair, so each vertex meets only triangles that follow two of its joints.
Positions rotation_centres(const SkinnedMesh& mesh, double sigma) {
  const std::map<JointPair, std::vector<Patch>> patches = patches_of(mesh);
  Positions out = mesh.positions;
  tools::for_each_in_parallel(mesh.positions.size(), [&](std::size_t v) {
    const std::vector<Influence>& influences = mesh.influences[v];
    glm::dvec3 sum(0);
    double total = 0;
    for (std::size_t j = 0; j < influences.size(); ++j) {
      for (std::size_t k = j + 1; k < influences.size(); ++k) {
        const auto found = patches.find({influences[j].joint, influences[k].joint});
        if (found == patches.end()) continue;
        const double a = influences[j].weight, b = influences[k].weight;
        for (const Patch& patch : found->second) {
          const double apart = a * patch.b - b * patch.a;
          const double alike =
              a * b * patch.a * patch.b * tools::exponential(-apart * apart / (sigma * sigma)) * patch.area;
          sum += patch.centre * alike;
          total += alike;
        }
      }
    }
    if (total > 0) out[v] = sum / total;
  });
  return out;
}

}  // namespace marrow::deform
