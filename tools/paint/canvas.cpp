#include "paint/canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "deform/weights/auto_weights.h"
#include "marrow/glm.h"

namespace marrow::tools {
namespace {

void add(std::uint32_t joint, double weight, Influences& to) {
  if (!(weight > 0)) return;
  const auto same = std::ranges::find(to, joint, &deform::Influence::joint);
  if (same == to.end()) {
    to.push_back({joint, weight});
  } else {
    same->weight += weight;
  }
}

// A helper's weight is its two joints'.
void add_entry(const Mesh& mesh, std::uint32_t entry, double weight, Influences& to) {
  if (entry < mesh.joint_count) return add(mesh.joints[entry], weight, to);
  const Helper& helper = mesh.helpers[entry - mesh.joint_count];
  const double share = static_cast<double>(helper.share);
  add(mesh.joints[helper.first], weight * (1 - share), to);
  add(mesh.joints[helper.second], weight * share, to);
}

// For each slot its place in the bind pose and its weights.
void for_each_slot(const Mesh& mesh, const auto& take) {
  const std::uint16_t* set = mesh.geometry.sets;
  const float* block = mesh.geometry.skin;
  for (const Run& run : mesh.geometry.runs) {
    for (std::uint32_t first = 0; first < run.vertex_count; first += 4) {
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        Influences influences;
        double left = 1;
        for (std::uint32_t j = 0; j + 1 < run.influences; ++j) {
          const double weight = static_cast<double>(block[12 + 4 * j + lane]);
          if (weight != 0) add_entry(mesh, set[j], weight, influences);
          left -= weight;
        }
        add_entry(mesh, set[run.influences - 1], left, influences);
        deform::keep_largest(influences, kMaxInfluences, 0);
        take(glm::vec3(block[lane], block[4 + lane], block[8 + lane]), std::move(influences));
      }
      block += 12 + std::size_t{4} * (run.influences - 1);
    }
    set += run.influences;
  }
}

std::uint32_t group_of(const Mesh& mesh, std::vector<CanvasGroup>& groups) {
  const auto same = [&](const CanvasGroup& g) { return g.name == mesh.name && g.skeleton == mesh.skeleton; };
  const auto found = std::ranges::find_if(groups, same);
  CanvasGroup& group = found != groups.end() ? *found : groups.emplace_back();
  group.name = mesh.name;
  group.skeleton = mesh.skeleton;
  for (std::uint32_t j = 0; j < mesh.joint_count; ++j)
    group.inverse_bind.emplace(mesh.joints[j], to_glm(mesh.inverse_bind[j]));
  return static_cast<std::uint32_t>(&group - groups.data());
}

bool alike(const glm::mat4& a, const glm::mat4& b) {
  float size = 0, difference = 0;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 3; ++r) {
      size += std::abs(a[c][r]);
      difference += std::abs(a[c][r] - b[c][r]);
    }
  }
  return difference <= 1e-3f * size;
}

// The one that most of its joints agree on, as some may rest otherwise than they were bound.
glm::mat4 model_from_mesh(const CanvasGroup& group, std::span<const Affine> rest) {
  constexpr std::size_t kMostAsked = 64;
  std::vector<glm::mat4> all;
  for (const auto& [joint, inverse_bind] : group.inverse_bind)
    if (all.size() < kMostAsked) all.push_back(to_glm(rest[joint]) * inverse_bind);
  const auto agreeing = [&](const glm::mat4& m) {
    return std::ranges::count_if(all, [&](const glm::mat4& other) { return alike(m, other); });
  };
  return *std::ranges::max_element(all, {}, agreeing);
}

void add_triangles(const Geometry& g, const std::vector<std::uint32_t>& place_of_slot, Canvas& canvas) {
  for (std::size_t i = 0; i < g.index_count; ++i) {
    const std::uint32_t slot = g.index_bytes == 2 ? static_cast<const std::uint16_t*>(g.indices)[i]
                                                  : static_cast<const std::uint32_t*>(g.indices)[i];
    canvas.corners.push_back(place_of_slot[slot]);
  }
}

// Through the inverse transpose, but for its length.
glm::vec3 turn_normal(const glm::mat3& m, const glm::vec3& n) {
  const glm::vec3 first = glm::cross(m[1], m[2]);
  const glm::vec3 turned = n.x * first + n.y * glm::cross(m[2], m[0]) + n.z * glm::cross(m[0], m[1]);
  return glm::dot(m[0], first) < 0 ? -turned : turned;
}

}  // namespace

Canvas canvas_of(const File& file, std::span<const std::vector<Affine>> rest) {
  Canvas out;
  std::map<std::tuple<std::uint32_t, float, float, float>, std::uint32_t> known;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Mesh mesh = file.mesh(m);
    const std::uint32_t group = group_of(mesh, out.groups);
    out.has_helpers |= !mesh.helpers.empty();
    std::vector<std::uint32_t>& places = out.place_of_slot.emplace_back();
    for_each_slot(mesh, [&](const glm::vec3& at, Influences influences) {
      const auto [place, is_new] =
          known.try_emplace({group, at.x, at.y, at.z}, static_cast<std::uint32_t>(out.bind.size()));
      places.push_back(place->second);
      if (!is_new) return;
      out.group_of.push_back(group);
      out.bind.push_back(at);
      out.influences.push_back(std::move(influences));
    });
    add_triangles(mesh.geometry, places, out);
  }
  std::vector<glm::mat4> to_scene;
  for (CanvasGroup& group : out.groups) {
    group.hangs = group.inverse_bind.size() == 1;
    to_scene.push_back(model_from_mesh(group, rest[group.skeleton]));
  }
  for (std::size_t p = 0; p < out.bind.size(); ++p)
    out.model.emplace_back(glm::vec3(to_scene[out.group_of[p]] * glm::vec4(out.bind[p], 1)));
  out.touched.assign(out.bind.size(), 0);
  deform::SkinnedMesh mesh;
  mesh.positions = out.model;
  mesh.indices = out.corners;
  out.surface.emplace_back(mesh);
  return out;
}

std::vector<glm::mat4> bind_matrices(const CanvasGroup& group, std::span<const Affine> rest) {
  const glm::mat4 to_scene = model_from_mesh(group, rest);
  std::vector<glm::mat4> out;
  for (std::uint32_t j = 0; j < rest.size(); ++j) {
    const auto known = group.inverse_bind.find(j);
    out.push_back(known != group.inverse_bind.end() ? known->second : glm::inverse(to_glm(rest[j])) * to_scene);
  }
  return out;
}

double weight_of(const Influences& influences, std::uint32_t joint) {
  const auto found = std::ranges::find(influences, joint, &deform::Influence::joint);
  return found == influences.end() ? 0 : found->weight;
}

void pose_canvas(const Canvas& canvas, std::span<const std::vector<glm::mat4>> binds,
                 std::span<const std::vector<Affine>> model_from_joint, PosedCanvas& out) {
  std::vector<std::vector<glm::mat4>> palettes;
  for (std::size_t g = 0; g < canvas.groups.size(); ++g) {
    std::vector<glm::mat4>& palette = palettes.emplace_back();
    const std::vector<Affine>& joints = model_from_joint[canvas.groups[g].skeleton];
    for (std::size_t j = 0; j < joints.size(); ++j) palette.push_back(to_glm(joints[j]) * binds[g][j]);
  }
  out.places.resize(canvas.bind.size());
  out.matrices.resize(canvas.bind.size());
  for (std::size_t p = 0; p < canvas.bind.size(); ++p) {
    const std::vector<glm::mat4>& palette = palettes[canvas.group_of[p]];
    glm::mat4 blend(0);
    for (const deform::Influence& i : canvas.influences[p]) blend += static_cast<float>(i.weight) * palette[i.joint];
    out.matrices[p] = blend;
    out.places[p] = glm::vec3(blend * glm::vec4(canvas.bind[p], 1));
  }
}

PosedMesh posed_mesh(const Mesh& mesh, std::span<const std::uint32_t> place_of_slot, const PosedCanvas& posed) {
  PosedMesh out;
  for (const std::uint32_t place : place_of_slot) {
    const glm::vec3& at = posed.places[place];
    out.positions.insert(out.positions.end(), {at.x, at.y, at.z});
  }
  const float* const normals = mesh.geometry.normals;
  for (std::size_t slot = 0; normals != nullptr && slot < place_of_slot.size(); ++slot) {
    const float* const n = normals + slot / 4 * 12 + slot % 4;
    const glm::vec3 turned = turn_normal(posed.matrices[place_of_slot[slot]], {n[0], n[4], n[8]});
    const float length = glm::length(turned);
    const glm::vec3 unit = length > 0 ? turned / length : glm::vec3(0, 1, 0);
    out.normals.insert(out.normals.end(), {unit.x, unit.y, unit.z});
  }
  return out;
}

Ray ray_through(const glm::mat4& clip_from_model, glm::vec2 at) {
  const glm::mat4 model_from_clip = glm::inverse(clip_from_model);
  const auto place = [&](float depth) {
    const glm::vec4 p = model_from_clip * glm::vec4(at, depth, 1);
    return glm::vec3(p) / p.w;
  };
  const glm::vec3 from = place(-1);
  return {from, glm::normalize(place(0.5f) - from)};
}

std::optional<SurfaceHit> first_hit(const Ray& ray, std::span<const glm::vec3> positions,
                                    std::span<const std::uint32_t> corners) {
  float nearest = std::numeric_limits<float>::infinity();
  SurfaceHit hit;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const glm::vec3 &a = positions[corners[i]], ab = positions[corners[i + 1]] - a, ac = positions[corners[i + 2]] - a;
    const glm::vec3 p = glm::cross(ray.along, ac);
    const float determinant = glm::dot(ab, p);
    if (determinant == 0) continue;
    const float inverse = 1 / determinant;
    const glm::vec3 to = ray.from - a;
    const float u = glm::dot(to, p) * inverse;
    if (!(u >= 0 && u <= 1)) continue;
    const glm::vec3 q = glm::cross(to, ab);
    const float v = glm::dot(ray.along, q) * inverse, distance = glm::dot(ac, q) * inverse;
    if (!(v >= 0 && u + v <= 1 && distance >= 0 && distance < nearest)) continue;
    nearest = distance;
    hit.triangle = static_cast<std::uint32_t>(i / 3);
    hit.place = ray.from + distance * ray.along;
    const glm::vec3 normal = glm::normalize(glm::cross(ab, ac));
    hit.normal = glm::dot(normal, ray.along) > 0 ? -normal : normal;
  }
  if (nearest == std::numeric_limits<float>::infinity()) return std::nullopt;
  return hit;
}

}  // namespace marrow::tools
