#include "cook/mesh/lod.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include <fmt/format.h>

#include "common/parallel.h"
#include "cook/skin/deform_source.h"
#include "cook/skin/primitive_palette.h"
#include "cook/skin/skin_binding.h"
#include "deform/pose_metric.h"
#include "deform/simplify/surface_error.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kShapes = 24;       // poses that simplification looks at
constexpr std::size_t kMostTargets = 64;  // morph targets that it looks at
constexpr double kEnough = 1.02;          // of the triangles asked for, before there is a warning

// The mesh as simplification takes it; vertices that differ in nothing are one.
struct Source {
  struct Vertex {
    std::size_t primitive;
    std::uint32_t vertex;  // the first of the primitive that is the same
    std::uint32_t part;    // of the primitive
  };
  deform::SeamedSurface surface;
  std::vector<Vertex> vertices;            // of the surface
  deform::Coordinates coordinates;         // of points
  std::vector<deform::Pose> poses;         // the bind pose first
  std::vector<deform::Positions> targets;  // morph targets at 1, in the bind pose
};

template <class T>
void append(const std::vector<T>& values, std::size_t v, std::vector<float>& key) {
  if (values.empty()) return;
  for (int c = 0; c < T::length(); ++c) key.push_back(values[v][c]);
}

// Numbers for vertices that differ, and for those that differ in what stands in the way of a collapse.
struct VertexNumbers {
  using Key = std::tuple<std::size_t, std::uint32_t, std::uint32_t, std::vector<float>>;  // primitive, part, point
  std::map<Key, std::uint32_t> charts, vertices;
};

std::uint32_t add_vertex(const RawPrimitive& primitive, const Source::Vertex& vertex, std::uint32_t point,
                         VertexNumbers& numbers, Source& out) {
  const std::uint32_t v = vertex.vertex;
  std::vector<float> key;
  append(primitive.uvs, v, key);
  append(primitive.colours, v, key);
  const auto chart =
      numbers.charts
          .try_emplace({vertex.primitive, vertex.part, point, key}, static_cast<std::uint32_t>(numbers.charts.size()))
          .first;
  append(primitive.normals, v, key);
  append(primitive.tangents, v, key);
  for (const RawTarget& target : primitive.targets) {
    append(target.positions, v, key);
    append(target.normals, v, key);
    append(target.tangents, v, key);
  }
  const auto [at, is_new] = numbers.vertices.try_emplace({vertex.primitive, vertex.part, point, std::move(key)},
                                                         static_cast<std::uint32_t>(out.vertices.size()));
  if (!is_new) return at->second;
  out.vertices.push_back(vertex);
  out.surface.point_of.push_back(point);
  out.surface.chart_of.push_back(chart->second);
  out.surface.normals.emplace_back(primitive.normals.empty() ? glm::vec3(0) : primitive.normals[v]);
  return at->second;
}

void add_vertices(const RawMesh& mesh, const std::vector<std::vector<std::uint32_t>>& point_of,
                  const SkinBinding* binding, Source& out) {
  VertexNumbers numbers;
  for (std::size_t p = 0; p < point_of.size(); ++p) {
    if (point_of[p].empty()) continue;  // not skinned
    const RawPrimitive& primitive = mesh.primitives[p];
    std::vector<std::uint32_t> number(point_of[p].size());
    std::uint32_t part_number = 0;
    for (const PrimitivePart& part :
         parts_of(primitive, binding == nullptr ? std::vector<std::uint32_t>() : binding->part_of[p])) {
      for (const std::uint32_t v : part.vertices)
        number[v] = add_vertex(primitive, {p, v, part_number}, point_of[p][v], numbers, out);
      for (const std::uint32_t i : part.indices) out.surface.indices.push_back(number[i]);
      ++part_number;
    }
  }
}

void add_targets(const RawMesh& mesh, const deform::Positions& bind, Source& out) {
  std::size_t count = 0;
  for (const RawPrimitive& p : mesh.primitives) count = std::max(count, p.targets.size());
  for (std::size_t t = 0; t < std::min(count, kMostTargets); ++t) {
    deform::Positions& at = out.targets.emplace_back(bind);
    for (std::size_t v = 0; v < out.vertices.size(); ++v) {
      const Source::Vertex& from = out.vertices[v];
      const std::vector<RawTarget>& targets = mesh.primitives[from.primitive].targets;
      if (t < targets.size() && !targets[t].positions.empty())
        at[out.surface.point_of[v]] = bind[out.surface.point_of[v]] + glm::dvec3(targets[t].positions[from.vertex]);
    }
  }
}

Source hung_source(const RawMesh& mesh) {
  Source out;
  std::map<std::tuple<float, float, float>, std::uint32_t> points;
  std::vector<std::vector<std::uint32_t>> point_of;
  deform::Positions bind;
  for (const RawPrimitive& primitive : mesh.primitives) {
    std::vector<std::uint32_t>& to = point_of.emplace_back();
    for (const glm::vec3& v : primitive.positions) {
      const auto [at, is_new] = points.try_emplace({v.x, v.y, v.z}, static_cast<std::uint32_t>(bind.size()));
      if (is_new) {
        bind.emplace_back(v);
        out.coordinates.push_back({{0, glm::dvec4(v, 1)}});
      }
      to.push_back(at->second);
    }
  }
  add_vertices(mesh, point_of, nullptr, out);
  add_targets(mesh, bind, out);
  out.poses.assign(1, deform::Pose(1, deform::Matrix(1.0)));
  return out;
}

Source skinned_source(const RawMesh& mesh, const RawSkin& skin, const SkinBinding& binding, const BuiltScene& built) {
  const DeformSource source = deform_source(mesh, skin, binding, built);
  Source out;
  add_vertices(mesh, source.vertex_of, &binding, out);
  add_targets(mesh, source.mesh.positions, out);
  out.coordinates.resize(source.mesh.positions.size());
  for (std::size_t v = 0; v < out.vertices.size(); ++v) {
    const Source::Vertex& from = out.vertices[v];
    const std::uint32_t point = out.surface.point_of[v];
    if (!out.coordinates[point].empty()) continue;
    out.coordinates[point] =
        coordinates_of(binding.primitives[from.primitive][from.vertex], source.mesh.positions[point]);
  }
  out.poses = poses_of_clips(source, binding, built);
  return out;
}

std::vector<deform::Shape> shapes_of(const Source& source) {
  const deform::Deformer deformer = deform::animation_space(source.coordinates);
  std::vector<deform::Shape> out;
  for (const deform::Representative& r : deform::representative_poses(deformer, source.poses, 0, kShapes)) {
    deform::Shape& shape = out.emplace_back();
    deformer(source.poses[r.pose], shape.positions);
    shape.weight = r.weight;
  }
  for (const deform::Positions& target : source.targets)
    out.push_back({target, 1.0 / static_cast<double>(source.targets.size())});
  return out;
}

template <class T>
void pick(std::vector<T>& values, const std::vector<std::uint32_t>& which) {
  if (values.empty()) return;
  std::vector<T> out;
  for (const std::uint32_t v : which) out.push_back(values[v]);
  values = std::move(out);
}

// A primitive with some of its vertices, and triangles of those.
RawPrimitive with_vertices(const RawPrimitive& primitive, const std::vector<std::uint32_t>& vertices,
                           std::vector<std::uint32_t> indices) {
  RawPrimitive out = primitive;
  pick(out.positions, vertices);
  pick(out.normals, vertices);
  pick(out.tangents, vertices);
  pick(out.uvs, vertices);
  pick(out.colours, vertices);
  pick(out.influences, vertices);
  for (RawTarget& t : out.targets) {
    pick(t.positions, vertices);
    pick(t.normals, vertices);
    pick(t.tangents, vertices);
  }
  out.indices = std::move(indices);
  return out;
}

// Which vertices and triangles of a primitive a level has.
struct KeptParts {
  std::vector<std::uint32_t> vertices, indices, part_of;
};

// Parts that have lost all their triangles get one without area.
void keep_parts(const RawPrimitive& primitive, const std::vector<std::uint32_t>& part_of, KeptParts& kept) {
  if (part_of.empty()) return;
  std::vector<char> has(std::size_t{1} + std::ranges::max(part_of), 0);
  for (const std::uint32_t part : kept.part_of) has[part] = 1;
  for (std::size_t t = 0; t < part_of.size(); ++t) {
    if (has[part_of[t]] != 0) continue;
    has[part_of[t]] = 1;
    kept.indices.insert(kept.indices.end(), 3, static_cast<std::uint32_t>(kept.vertices.size()));
    kept.vertices.push_back(primitive.indices[3 * t]);
    kept.part_of.push_back(part_of[t]);
  }
}

std::vector<KeptParts> kept_of(const Source& source, const deform::SimplerSurface& surface, std::size_t primitives) {
  std::vector<KeptParts> out(primitives);
  std::vector<std::uint32_t> number;
  for (const deform::Combination& v : surface.vertices) {
    const Source::Vertex& from = source.vertices[v.front().vertex];
    std::vector<std::uint32_t>& vertices = out[from.primitive].vertices;
    number.push_back(static_cast<std::uint32_t>(vertices.size()));
    vertices.push_back(from.vertex);
  }
  for (std::size_t i = 0; i < surface.indices.size(); ++i) {
    const std::uint32_t v = surface.indices[i];
    const Source::Vertex& from = source.vertices[surface.vertices[v].front().vertex];
    out[from.primitive].indices.push_back(number[v]);
    if (i % 3 == 0) out[from.primitive].part_of.push_back(from.part);
  }
  return out;
}

// before: what a primitive that has lost all its triangles keeps.
MeshLevel level_of(const RawMesh& mesh, const SkinBinding* binding, const Source& source,
                   const deform::SimplerSurface& surface, const MeshLevel& before) {
  std::vector<KeptParts> kept = kept_of(source, surface, mesh.primitives.size());
  MeshLevel out;
  for (std::size_t p = 0; p < kept.size(); ++p) {
    const bool lost = kept[p].indices.empty();
    if (!lost && binding != nullptr) keep_parts(mesh.primitives[p], binding->part_of[p], kept[p]);
    out.primitives.push_back(lost ? before.primitives[p]
                                  : with_vertices(mesh.primitives[p], kept[p].vertices, std::move(kept[p].indices)));
    if (binding == nullptr) continue;
    out.vertices.push_back(lost ? before.vertices[p] : binding->primitives[p]);
    if (!lost) pick(out.vertices.back(), kept[p].vertices);
    if (!lost && binding->part_of[p].empty()) kept[p].part_of.clear();
    out.part_of.push_back(lost ? before.part_of[p] : std::move(kept[p].part_of));
  }
  return out;
}

void reduce_joints(const deform::PoseMetric& metric, bool has_residual, std::size_t most, MeshLevel& level) {
  for (std::size_t p = 0; p < level.vertices.size(); ++p)
    tools::for_each_in_parallel(level.vertices[p].size(), [&](std::size_t v) {
      BoundVertex& vertex = level.vertices[p][v];
      if (vertex.size() > most)
        vertex = with_fewer_joints(metric, vertex, level.primitives[p].positions[v], has_residual, most);
    });
}

void measure(const Source& source, const std::vector<deform::Shape>& shapes, const deform::SimplerSurface& surface,
             MeshLevel& level) {
  deform::Coordinates coordinates;
  std::vector<std::uint32_t> from, next(level.primitives.size(), 0);  // a point of the level: which of the source
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    const std::uint32_t point = surface.point_of[v], first = surface.vertices[v].front().vertex;
    const std::size_t p = source.vertices[first].primitive;
    from.resize(std::max<std::size_t>(from.size(), point + 1));
    coordinates.resize(from.size());
    from[point] = source.surface.point_of[first];
    const std::uint32_t number = next[p]++;
    coordinates[point] = level.vertices.empty()
                             ? source.coordinates[from[point]]
                             : coordinates_of(level.vertices[p][number], level.primitives[p].positions[number]);
  }
  std::vector<deform::Shape> simpler = shapes;
  for (deform::Shape& shape : simpler) pick(shape.positions, from);
  const deform::SurfaceError error =
      deform::surface_error(deform::animation_space(source.coordinates), deform::animation_space(coordinates),
                            deform::anchor(surface, shapes, simpler), surface.home, source.poses);
  level.rms_error_m = error.rms;
  level.max_error_m = error.worst;
}

void check_reached(const RawMesh& mesh, std::size_t level, double ratio, double reached, Notes& notes) {
  if (reached <= ratio * kEnough) return;
  notes.warnings.push_back(
      {mesh.primitives.front().pointer, "lod-not-reached",
       fmt::format(
           "level {} keeps {:.0f} % of the triangles instead of {:.0f} %: seams, borders and folds hold the rest",
           level + 1, reached * 100, ratio * 100)});
}

}  // namespace

std::vector<MeshLevel> make_levels(const RawMesh& mesh, const RawSkin* skin, const SkinBinding* binding,
                                   const BuiltScene& built, const std::vector<LodRule>& rules, Notes& notes) {
  const Source source = skin == nullptr ? hung_source(mesh) : skinned_source(mesh, *skin, *binding, built);
  const std::size_t triangles = source.surface.indices.size() / 3;
  std::vector<std::size_t> targets;
  for (const LodRule& rule : rules)
    targets.push_back(static_cast<std::size_t>(std::lround(rule.ratio * static_cast<double>(triangles))));
  const std::vector<deform::Shape> shapes = shapes_of(source);
  const std::vector<deform::SimplerSurface> surfaces =
      deform::simplify(source.surface, shapes, targets, deform::Placement::ends);
  MeshLevel full{mesh.primitives, {}, {}};
  if (binding != nullptr) full.vertices = binding->primitives;
  if (binding != nullptr) full.part_of = binding->part_of;
  std::optional<deform::PoseMetric> metric;
  if (binding != nullptr &&
      std::ranges::any_of(rules, [](const LodRule& rule) { return rule.influences < kMaxInfluences; }))
    metric.emplace(source.poses, source.coordinates);
  std::vector<MeshLevel> out;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (surfaces[i].indices.empty()) {
      out.push_back(full);
      continue;
    }
    out.push_back(level_of(mesh, binding, source, surfaces[i], i == 0 ? full : out.back()));
    if (metric && rules[i].influences < kMaxInfluences)
      reduce_joints(*metric, binding->residual_step_m > 0, rules[i].influences, out.back());
    measure(source, shapes, surfaces[i], out.back());
    check_reached(mesh, i, rules[i].ratio,
                  static_cast<double>(surfaces[i].indices.size() / 3) / static_cast<double>(triangles), notes);
  }
  return out;
}

}  // namespace marrow::cook
