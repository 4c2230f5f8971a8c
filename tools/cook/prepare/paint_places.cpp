#include "cook/prepare/paint_places.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "common/failure.h"
#include "cook/prepare/bind_bones.h"
#include "deform/weights/place_tree.h"
#include "deform/weights/places.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::cook {
namespace {

constexpr double kReach = 1e-3;  // of the longest side, from a painted vertex to the scene's
// What lies so much farther than the nearest counts as near: the steps that cooked positions are rounded to.
constexpr double kStep = 1.0 / 16383;

// A mesh with the skin that draws it.
struct Painted {
  RawMesh* mesh;
  const RawSkin* skin;
  std::string pointer;
};

std::vector<Painted> skinned_meshes(RawScene& scene, const std::string& name, std::vector<std::string>& names) {
  std::vector<Painted> out;
  std::set<int> seen;
  for (const RawInstance& instance : scene.instances) {
    RawMesh& mesh = scene.meshes[to_index(instance.mesh)];
    const bool has_weights = std::ranges::any_of(mesh.primitives, [](const auto& p) { return !p.influences.empty(); });
    if (instance.skin == kNone || !has_weights) continue;
    const std::string own = mesh.name.empty() ? scene.nodes[to_index(instance.node)].name : mesh.name;
    names.push_back(own);
    if (own == name && seen.insert(instance.mesh).second)
      out.push_back({&mesh, &scene.skins[to_index(instance.skin)], "/meshes/" + std::to_string(instance.mesh)});
  }
  return out;
}

// Of each joint that was painted the skin's joint of that name.
std::vector<std::uint32_t> joints_of(const RawScene& scene, const RawSkin& skin, const PaintedMesh& painted,
                                     const std::string& path, const std::string& where) {
  std::map<std::string, std::uint32_t> by_name;
  std::vector<std::string> names;
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    names.push_back(scene.nodes[to_index(skin.joints[j])].name);
    by_name.emplace(names.back(), static_cast<std::uint32_t>(j));
  }
  std::vector<std::uint32_t> out;
  for (std::size_t j = 0; j < painted.joints.size(); ++j) {
    const auto found = by_name.find(painted.joints[j]);
    if (found == by_name.end())
      throw tools::Failure(tools::Exit::invalid, path, fmt::format("{}/joints/{}", where, j),
                           tools::printable("the mesh's skin has no joint \"" + painted.joints[j] + '"'),
                           tools::suggestion(painted.joints[j], names));
    out.push_back(found->second);
  }
  return out;
}

// Of all primitives that have weights, one after the other.
deform::Positions weighted_positions(const RawMesh& mesh) {
  deform::Positions out;
  for (const RawPrimitive& primitive : mesh.primitives)
    if (!primitive.influences.empty()) out.insert(out.end(), primitive.positions.begin(), primitive.positions.end());
  return out;
}

double longest_side(const deform::Positions& positions) {
  glm::dvec3 low = positions.front(), high = low;
  for (const glm::dvec3& p : positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::dvec3 size = high - low;
  return std::max({size.x, size.y, size.z});
}

std::vector<RawInfluence> to_raw(const PaintedVertex& vertex, const std::vector<std::uint32_t>& joints) {
  std::vector<RawInfluence> out;
  for (const deform::Influence& i : vertex.influences) out.push_back({joints[i.joint], static_cast<float>(i.weight)});
  return out;
}

// How many painted vertices are on no vertex of it.
std::size_t paint(RawMesh& mesh, const PaintedMesh& painted, const std::vector<std::uint32_t>& joints) {
  const deform::Places places = deform::places_of(weighted_positions(mesh));
  if (places.positions.empty() || painted.vertices.empty()) return painted.vertices.size();
  const double side = longest_side(places.positions), reach = kReach * side;
  deform::Positions at;
  for (const PaintedVertex& v : painted.vertices) at.emplace_back(v.place);
  const deform::PlaceTree scene_tree(places.positions), painted_tree(at);
  std::vector<double> nearest(at.size(), -1);  // below 0: none
  std::size_t off = 0;
  for (std::size_t v = 0; v < at.size(); ++v) {
    const auto found = scene_tree.nearest(at[v], reach);
    off += !found;
    if (found) nearest[v] = found->distance;
  }
  std::vector<const PaintedVertex*> of_place(places.positions.size(), nullptr);
  for (std::size_t p = 0; p < of_place.size(); ++p) {
    const auto found = painted_tree.nearest(places.positions[p], reach);
    if (found && found->distance <= nearest[found->index] + kStep * side) of_place[p] = &painted.vertices[found->index];
  }
  std::size_t vertex = 0;
  for (RawPrimitive& primitive : mesh.primitives) {
    for (std::vector<RawInfluence>& influences : primitive.influences) {
      const PaintedVertex* const from = of_place[places.of_vertex[vertex++]];
      if (from != nullptr) influences = to_raw(*from, joints);
    }
  }
  return off;
}

}  // namespace

void paint_places(RawScene& scene, const std::string& path, std::span<const PaintedMesh> painted, bool must_fit,
                  Notes& notes) {
  bool fits = painted.empty();
  for (std::size_t m = 0; m < painted.size(); ++m) {
    const std::string where = "/meshes/" + std::to_string(m);
    std::vector<std::string> names;
    const std::vector<Painted> meshes = skinned_meshes(scene, painted[m].name, names);
    if (meshes.empty() && must_fit)
      throw tools::Failure(tools::Exit::invalid, path, where,
                           tools::printable("no mesh with skin weights is called \"" + painted[m].name + '"'),
                           tools::suggestion(painted[m].name, names));
    fits |= !meshes.empty();
    for (const Painted& to : meshes) {
      const std::size_t off = paint(*to.mesh, painted[m], joints_of(scene, *to.skin, painted[m], path, where));
      if (off > 0)
        notes.warnings.push_back(
            {to.pointer, "paint-off-the-mesh",
             fmt::format("{} of {} vertices that were painted are not there; was it changed since?", off,
                         painted[m].vertices.size())});
    }
  }
  if (!fits) notes.warnings.push_back({"/meshes", "rule-fits-nothing", "paint: none of its meshes is in the scene"});
}

}  // namespace marrow::cook
