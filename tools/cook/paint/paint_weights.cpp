#include "cook/paint/paint_weights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <glm/vec2.hpp>

#include "common/decode.h"
#include "common/failure.h"
#include "deform/weights/edit_weights.h"
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

struct Mask {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> grey;  // top row first

  // Bilinear, repeated; (0, 0) is the upper left corner of the first pixel.
  double at(const glm::vec2& uv) const {
    std::size_t x[2], y[2];
    const double u = split(static_cast<double>(uv.x), width, x), v = split(static_cast<double>(uv.y), height, y);
    const auto pixel = [&](int i, int j) { return static_cast<double>(grey[y[j] * width + x[i]]); };
    const double upper = pixel(0, 0) * (1 - u) + pixel(1, 0) * u, lower = pixel(0, 1) * (1 - u) + pixel(1, 1) * u;
    return (upper * (1 - v) + lower * v) / 255;
  }

 private:
  // The pixels on both sides, and how far from the first to the second.
  static double split(double coordinate, std::size_t count, std::size_t (&pixels)[2]) {
    const double place =
        (coordinate - std::floor(coordinate)) * static_cast<double>(count) + static_cast<double>(count) - 0.5;
    const double first = std::floor(place);
    pixels[0] = static_cast<std::size_t>(first) % count;
    pixels[1] = (pixels[0] + 1) % count;
    return place - first;
  }
};

std::string name_of(const PaintRule& rule) {
  return tools::printable("paint " + rule.joint);
}

Mask read_mask(const PaintRule& rule) {
  const tools::Pixels pixels = tools::decode_image(*rule.bytes, rule.file, name_of(rule));
  Mask mask{static_cast<std::size_t>(pixels.width), static_cast<std::size_t>(pixels.height), {}};
  mask.grey.resize(mask.width * mask.height);
  for (std::size_t i = 0; i < mask.grey.size(); ++i) {
    const std::uint8_t* const c = &pixels.rgba[i * 4];
    mask.grey[i] = static_cast<std::uint8_t>((77 * c[0] + 150 * c[1] + 29 * c[2]) / 256);  // of a grey one: as it is
  }
  return mask;
}

// A primitive, and what is painted on it.
struct Canvas {
  RawPrimitive* primitive;
  const RawSkin* skin;
  std::map<std::uint32_t, std::vector<double>> painted;  // by joint: a weight a vertex
};

std::vector<Canvas> canvases(RawScene& scene) {
  std::vector<Canvas> out;
  std::set<int> seen;
  for (const RawInstance& instance : scene.instances) {
    if (instance.skin == kNone || !seen.insert(instance.mesh).second) continue;
    for (RawPrimitive& primitive : scene.meshes[to_index(instance.mesh)].primitives)
      if (!primitive.influences.empty()) out.push_back({&primitive, &scene.skins[to_index(instance.skin)], {}});
  }
  return out;
}

// kNone: the skin has no such joint.
int joint_called(const RawScene& scene, const RawSkin& skin, const std::string& name) {
  const auto found =
      std::ranges::find_if(skin.joints, [&](int joint) { return scene.nodes[to_index(joint)].name == name; });
  return found == skin.joints.end() ? kNone : static_cast<int>(found - skin.joints.begin());
}

// The joints that meshes are bound to.
std::vector<std::string> bound_joints(const RawScene& scene, const std::vector<Canvas>& canvases) {
  std::vector<std::string> out;
  for (const Canvas& canvas : canvases)
    for (const int joint : canvas.skin->joints) out.push_back(scene.nodes[to_index(joint)].name);
  return out;
}

// A rule that fits nothing is a mistake, or, where it need not fit, a warning.
void refuse_paint(const PaintRule& rule, const std::string& why, const std::string& advice, Notes& notes) {
  if (rule.origin.must_fit)
    throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where, tools::printable(why), advice);
  notes.warnings.push_back({"/meshes", "rule-fits-nothing", "paint: " + tools::printable(why)});
}

void apply(const RawScene& scene, const PaintRule& rule, std::vector<Canvas>& canvases, Notes& notes) {
  const Mask mask = read_mask(rule);
  bool has_joint = false, has_uvs = false;
  std::vector<RawWarning> without;
  for (Canvas& canvas : canvases) {
    const int joint = joint_called(scene, *canvas.skin, rule.joint);
    if (joint == kNone) continue;
    has_joint = true;
    if (canvas.primitive->uvs.empty()) {
      without.push_back({canvas.primitive->pointer, "paint-without-uvs",
                         "\"" + tools::printable(rule.joint) + "\" cannot be painted on a mesh without UVs"});
      continue;
    }
    has_uvs = true;
    std::vector<double>& weights = canvas.painted[static_cast<std::uint32_t>(joint)];
    weights.clear();
    for (const glm::vec2& uv : canvas.primitive->uvs) weights.push_back(mask.at(uv));
  }
  if (!has_joint)
    return refuse_paint(rule, "no joint that a mesh is bound to is called \"" + rule.joint + "\"",
                        tools::suggestion(rule.joint, bound_joints(scene, canvases)), notes);
  if (!has_uvs)
    return refuse_paint(rule, "no mesh that \"" + rule.joint + "\" could move has UVs", "export the meshes with UVs",
                        notes);
  notes.warnings.insert(notes.warnings.end(), without.begin(), without.end());
}

void paint_vertex(const std::vector<deform::Influence>& painted, std::vector<RawInfluence>& vertex) {
  std::vector<deform::Influence> out;
  for (const RawInfluence& i : vertex) out.push_back({i.joint, static_cast<double>(i.weight)});
  if (!deform::set_weights(painted, kMaxInfluences, out)) return;
  vertex.clear();
  for (const deform::Influence& i : out) vertex.push_back({i.joint, static_cast<float>(i.weight)});
}

// What masks have painted so far goes to the vertices.
void apply_masks(std::vector<Canvas>& canvases) {
  for (Canvas& canvas : canvases) {
    for (std::size_t v = 0; v < canvas.primitive->positions.size() && !canvas.painted.empty(); ++v) {
      std::vector<deform::Influence> painted;
      for (const auto& [joint, weights] : canvas.painted) painted.push_back({joint, weights[v]});
      paint_vertex(painted, canvas.primitive->influences[v]);
    }
    canvas.painted.clear();
  }
}

void apply_file(RawScene& scene, const PaintRule& rule, Notes& notes) {
  const std::string_view text(reinterpret_cast<const char*>(rule.bytes->data()), rule.bytes->size());
  paint_places(scene, rule.file, read_painted(rule.file, text), rule.origin.must_fit, notes);
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

RawScene paint_weights(RawScene scene, const std::vector<PaintRule>& rules, Notes& notes) {
  std::vector<Canvas> all = canvases(scene);
  for (const PaintRule& rule : rules) {
    if (!rule.joint.empty()) {
      apply(scene, rule, all, notes);
      continue;
    }
    apply_masks(all);
    apply_file(scene, rule, notes);
  }
  apply_masks(all);
  return scene;
}
}  // namespace marrow::cook
