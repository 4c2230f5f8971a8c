#include "cook/paint/paint_places.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "common/failure.h"
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

std::vector<std::string> names_of(const RawScene& scene, const RawSkin& skin) {
  std::vector<std::string> out;
  for (const int joint : skin.joints) out.push_back(scene.nodes[to_index(joint)].name);
  return out;
}

// Of each joint that was painted the skin's joint of that name; kNone: it has none.
std::vector<int> joints_of(const std::vector<std::string>& names, const PaintedMesh& painted) {
  std::map<std::string, int> by_name;
  for (std::size_t j = 0; j < names.size(); ++j) by_name.emplace(names[j], static_cast<int>(j));
  std::vector<int> out;
  for (const std::string& name : painted.joints) {
    const auto found = by_name.find(name);
    out.push_back(found == by_name.end() ? kNone : found->second);
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

std::vector<RawInfluence> to_raw(const PaintedVertex& vertex, const std::vector<int>& joints) {
  std::vector<RawInfluence> out;
  for (const deform::Influence& i : vertex.influences)
    out.push_back({static_cast<std::uint32_t>(joints[i.joint]), static_cast<float>(i.weight)});
  return out;
}

// How many painted vertices are on no vertex of it.
std::size_t paint(RawMesh& mesh, const PaintedMesh& painted, const std::vector<int>& joints) {
  const deform::Places places = deform::places_of(weighted_positions(mesh));
  const PaintMatch match = match_painted(places.positions, painted.vertices);
  std::size_t vertex = 0;
  for (RawPrimitive& primitive : mesh.primitives) {
    for (std::vector<RawInfluence>& influences : primitive.influences) {
      const PaintedVertex* const from = match.of_place[places.of_vertex[vertex++]];
      if (from != nullptr) influences = to_raw(*from, joints);
    }
  }
  return match.off;
}

[[noreturn]] void refuse_joint(const std::vector<std::string>& names, const PaintedMesh& painted,
                               const std::string& path, const std::string& where) {
  const std::vector<int> joints = joints_of(names, painted);
  const auto unknown = static_cast<std::size_t>(std::ranges::find(joints, kNone) - joints.begin());
  throw tools::Failure(tools::Exit::invalid, path, fmt::format("{}/joints/{}", where, unknown),
                       tools::printable("the mesh's skin has no joint \"" + painted.joints[unknown] + '"'),
                       tools::suggestion(painted.joints[unknown], names));
}

void say_off(const Painted& to, const PaintedMesh& painted, std::size_t off, Notes& notes) {
  if (off > 0)
    notes.warnings.push_back({to.pointer, "paint-off-the-mesh",
                              fmt::format("{} of {} vertices that were painted are not there; was it changed since?",
                                          off, painted.vertices.size())});
}

}  // namespace

PaintMatch match_painted(const deform::Positions& places, std::span<const PaintedVertex> painted) {
  PaintMatch out{std::vector<const PaintedVertex*>(places.size(), nullptr), painted.size()};
  if (places.empty() || painted.empty()) return out;
  const double side = longest_side(places), reach = kReach * side;
  deform::Positions at;
  for (const PaintedVertex& v : painted) at.emplace_back(v.place);
  const deform::PlaceTree place_tree(places), painted_tree(at);
  std::vector<double> nearest(at.size(), -1);  // below 0: none
  for (std::size_t v = 0; v < at.size(); ++v) {
    const auto found = place_tree.nearest(at[v], reach);
    if (!found) continue;
    nearest[v] = found->distance;
    --out.off;
  }
  for (std::size_t p = 0; p < places.size(); ++p) {
    const auto found = painted_tree.nearest(places[p], reach);
    if (found && found->distance <= nearest[found->index] + kStep * side) out.of_place[p] = &painted[found->index];
  }
  return out;
}

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
    bool known = meshes.empty();
    for (const Painted& to : meshes) {
      const std::vector<int> joints = joints_of(names_of(scene, *to.skin), painted[m]);
      if (std::ranges::find(joints, kNone) != joints.end()) continue;
      known = true;
      say_off(to, painted[m], paint(*to.mesh, painted[m], joints), notes);
    }
    if (!known) refuse_joint(names_of(scene, *meshes.front().skin), painted[m], path, where);
  }
  if (!fits) notes.warnings.push_back({"/meshes", "rule-fits-nothing", "paint: none of its meshes is in the scene"});
}

}  // namespace marrow::cook
