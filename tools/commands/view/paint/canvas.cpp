#include "commands/view/paint/canvas.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

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

}  // namespace marrow::tools
