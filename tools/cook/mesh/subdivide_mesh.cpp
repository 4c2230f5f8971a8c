#include "cook/mesh/subdivide_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "common/parallel.h"
#include "cook/skin/skin_binding.h"
#include "deform/simplify/subdivide.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kMostBetween = 16;  // joints a point, before it gets what a vertex may have
constexpr std::size_t kBatch = 4096;      // points whose joints are chosen with one metric
constexpr double kSameNormal = 0.99985;   // cosine of a degree

struct Follower {
  std::uint32_t joint;  // as BoundInfluence's
  double weight;        // of SSD
  glm::dvec4 q;         // of animation space; 0 without residuals
};
using Followers = std::vector<Follower>;  // by ascending joint

// What is smoothed, a point each.
struct Smoothed {
  std::vector<glm::dvec3> positions;
  std::vector<std::vector<glm::dvec3>> targets;   // a morph target
  std::vector<std::vector<Followers>> followers;  // a skin
};

// What goes along edges, a vertex each; zeros where a primitive has none.
struct AlongEdges {
  std::vector<std::uint32_t> point_of, primitive_of, normal_of;
  std::vector<glm::dvec2> uvs;
  std::vector<glm::dvec4> colours;
  std::vector<glm::dvec4> tangents;
  std::vector<std::vector<glm::dvec3>> target_normals, target_tangents;  // a morph target
  std::vector<std::uint32_t> indices;
};

// Normals that vertices share: those of one point within a degree.
struct SharedNormals {
  std::vector<glm::dvec3> source;  // unit, or 0
  std::vector<glm::dvec3> beside;  // the surface's
};

struct Fine {
  Smoothed points;
  AlongEdges vertices;
  SharedNormals normals;
};

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 1e-9 && std::isfinite(length) ? v / length : otherwise;
}

template <class T>
T at_or_zero(const std::vector<T>& values, std::size_t v) {
  return values.empty() ? T(0) : values[v];
}

Followers followers_of(const SkinBinding& binding, std::size_t p, std::size_t v, const glm::dvec3& position) {
  Followers out;
  if (binding.primitives[p].empty()) return out;  // not skinned
  for (const BoundInfluence& i : binding.primitives[p][v])
    out.push_back({i.joint, i.weight,
                   binding.residual_step_m > 0 ? i.residual + glm::dvec4(position, 1) * i.weight : glm::dvec4(0)});
  return out;
}

// Numbers points as they are met.
class PointFinder {
 public:
  std::uint32_t find(const RawPrimitive& primitive, std::size_t v, const Followers& followers, bool& is_new) {
    const glm::vec3& at = primitive.positions[v];
    std::vector<std::pair<std::uint32_t, double>> follows;
    for (const Follower& f : followers) follows.emplace_back(f.joint, f.weight);
    std::vector<float> changes;
    for (const RawTarget& t : primitive.targets) {
      const glm::vec3 change = at_or_zero(t.positions, v);
      changes.insert(changes.end(), {change.x, change.y, change.z});
    }
    const auto [found, added] =
        points_.try_emplace({at.x, at.y, at.z, !primitive.influences.empty(), std::move(follows), std::move(changes)},
                            static_cast<std::uint32_t>(points_.size()));
    is_new = added;
    return found->second;
  }

 private:
  using Key = std::tuple<float, float, float, bool, std::vector<std::pair<std::uint32_t, double>>, std::vector<float>>;
  std::map<Key, std::uint32_t> points_;
};

std::size_t target_count(const RawMesh& mesh) {
  std::size_t out = 0;
  for (const RawPrimitive& p : mesh.primitives) out = std::max(out, p.targets.size());
  return out;
}

// Which of a point's normals it is, of those met before.
std::uint32_t shared_normal(const glm::vec3& normal, std::vector<std::uint32_t>& of_point, SharedNormals& normals) {
  const glm::dvec3 n = unit_or(normal, glm::dvec3(0));
  for (const std::uint32_t k : of_point)
    if (normals.source[k] == n || glm::dot(normals.source[k], n) > kSameNormal) return k;
  of_point.push_back(static_cast<std::uint32_t>(normals.source.size()));
  normals.source.push_back(n);
  return of_point.back();
}

void add_point(const RawPrimitive& primitive, std::size_t v, std::vector<Followers> followers, Smoothed& points) {
  points.positions.emplace_back(primitive.positions[v]);
  for (std::size_t t = 0; t < points.targets.size(); ++t)
    points.targets[t].emplace_back(t < primitive.targets.size() ? at_or_zero(primitive.targets[t].positions, v)
                                                                : glm::vec3(0));
  for (std::size_t s = 0; s < followers.size(); ++s) points.followers[s].push_back(std::move(followers[s]));
}

void add_vertex(const RawPrimitive& primitive, std::size_t v, AlongEdges& vertices) {
  vertices.uvs.emplace_back(at_or_zero(primitive.uvs, v));
  vertices.colours.emplace_back(at_or_zero(primitive.colours, v));
  vertices.tangents.emplace_back(at_or_zero(primitive.tangents, v));
  for (std::size_t t = 0; t < vertices.target_normals.size(); ++t) {
    const bool has = t < primitive.targets.size();
    vertices.target_normals[t].emplace_back(has ? at_or_zero(primitive.targets[t].normals, v) : glm::vec3(0));
    vertices.target_tangents[t].emplace_back(has ? at_or_zero(primitive.targets[t].tangents, v) : glm::vec3(0));
  }
}

// Sums of the triangles' normals, by area, of unit length or 0.
std::vector<glm::dvec3> surface_normals(const Fine& fine) {
  std::vector<glm::dvec3> out(fine.normals.source.size(), glm::dvec3(0));
  const AlongEdges& v = fine.vertices;
  for (std::size_t i = 0; i + 2 < v.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return fine.points.positions[v.point_of[v.indices[i + k]]]; };
    const glm::dvec3 normal = glm::cross(at(1) - at(0), at(2) - at(0));
    for (std::size_t k = 0; k < 3; ++k) out[v.normal_of[v.indices[i + k]]] += normal;
  }
  for (glm::dvec3& n : out) {
    const double most = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    n = most > 0 && std::isfinite(most) ? glm::normalize(n / most) : glm::dvec3(0);
  }
  return out;
}

Fine as_it_is(const RawMesh& mesh, const std::vector<MovedBy>& skins) {
  Fine out;
  const std::size_t targets = target_count(mesh);
  out.points.targets.resize(targets);
  out.points.followers.resize(skins.size());
  out.vertices.target_normals.resize(targets);
  out.vertices.target_tangents.resize(targets);
  PointFinder finder;
  std::vector<std::vector<std::uint32_t>> normals_of;  // a point
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    const RawPrimitive& primitive = mesh.primitives[p];
    const auto first = static_cast<std::uint32_t>(out.vertices.point_of.size());
    for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
      std::vector<Followers> followers;
      followers.reserve(skins.size());
      for (const MovedBy& skin : skins) followers.push_back(followers_of(*skin.binding, p, v, primitive.positions[v]));
      bool is_new = false;
      const std::uint32_t point =
          finder.find(primitive, v, followers.empty() ? Followers() : followers.front(), is_new);
      if (is_new) {
        add_point(primitive, v, std::move(followers), out.points);
        normals_of.emplace_back();
      }
      out.vertices.point_of.push_back(point);
      out.vertices.primitive_of.push_back(static_cast<std::uint32_t>(p));
      out.vertices.normal_of.push_back(shared_normal(at_or_zero(primitive.normals, v), normals_of[point], out.normals));
      add_vertex(primitive, v, out.vertices);
    }
    for (const std::uint32_t i : primitive.indices) out.vertices.indices.push_back(first + i);
  }
  const std::vector<glm::dvec3> surface = surface_normals(out);
  for (std::size_t k = 0; k < surface.size(); ++k) out.normals.beside.push_back(out.normals.source[k] - surface[k]);
  return out;
}

// Of more joints those that carry most; the heaviest of SSD is always one. They take over the rest.
void keep_joints(std::size_t most, Followers& followers) {
  if (followers.size() <= most) return;
  const auto heaviest = std::ranges::max_element(followers, {}, &Follower::weight)->joint;
  const auto carries = [&](const Follower& f) {
    return std::pair(f.joint == heaviest, std::max(f.weight, std::abs(f.q.w)));
  };
  std::ranges::stable_sort(followers, std::ranges::greater(), carries);
  glm::dvec4 lost(0);
  for (std::size_t i = most; i < followers.size(); ++i) lost += followers[i].q;
  followers.resize(most);
  double sum = 0;
  for (const Follower& f : followers) sum += f.weight;
  for (Follower& f : followers) {
    f.weight /= sum;
    f.q += lost * f.weight;
  }
  std::ranges::sort(followers, {}, &Follower::joint);
}

Followers combined_followers(const deform::Combination& shares, const std::vector<Followers>& of) {
  Followers all, out;
  for (const deform::Share& s : shares)
    for (const Follower& f : of[s.vertex]) all.push_back({f.joint, f.weight * s.share, f.q * s.share});
  std::ranges::stable_sort(all, {}, &Follower::joint);
  for (const Follower& f : all) {
    if (out.empty() || out.back().joint != f.joint) {
      out.push_back(f);
    } else {
      out.back().weight += f.weight;
      out.back().q += f.q;
    }
  }
  return out;
}

template <class T>
void combine(const std::vector<deform::Combination>& shares, std::vector<T>& values) {
  std::vector<T> out(shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i) out[i] = deform::combined(shares[i], values);
  values = std::move(out);
}

void smooth(const std::vector<deform::Combination>& shares, Smoothed& points) {
  combine(shares, points.positions);
  for (std::vector<glm::dvec3>& target : points.targets) combine(shares, target);
  for (std::vector<Followers>& followers : points.followers) {
    std::vector<Followers> out(shares.size());
    tools::for_each_in_parallel(shares.size(), [&](std::size_t i) {
      out[i] = combined_followers(shares[i], followers);
      keep_joints(kMostBetween, out[i]);
    });
    followers = std::move(out);
  }
}

// A vertex of the source, which stays one, or the middle between two.
void share_normals(const std::vector<deform::Combination>& shares, AlongEdges& vertices, SharedNormals& normals) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  for (std::size_t v = vertices.normal_of.size(); v < shares.size(); ++v) {
    const std::pair<std::uint32_t, std::uint32_t> ends =
        std::minmax(vertices.normal_of[shares[v].front().vertex], vertices.normal_of[shares[v].back().vertex]);
    const auto [at, is_new] = middles.try_emplace(ends, static_cast<std::uint32_t>(normals.source.size()));
    vertices.normal_of.push_back(at->second);
    if (!is_new) continue;
    normals.source.push_back((normals.source[ends.first] + normals.source[ends.second]) / 2.0);
    normals.beside.push_back((normals.beside[ends.first] + normals.beside[ends.second]) / 2.0);
  }
}

void go_along_edges(const deform::FinerSurface& finer, AlongEdges& vertices) {
  for (std::size_t v = vertices.primitive_of.size(); v < finer.vertices.size(); ++v)
    vertices.primitive_of.push_back(vertices.primitive_of[finer.vertices[v].front().vertex]);
  std::vector<double> signs;
  for (const deform::Combination& c : finer.vertices) signs.push_back(vertices.tangents[c.front().vertex].w);
  combine(finer.vertices, vertices.tangents);
  for (std::size_t v = 0; v < signs.size(); ++v) vertices.tangents[v].w = signs[v];
  combine(finer.vertices, vertices.uvs);
  combine(finer.vertices, vertices.colours);
  for (std::vector<glm::dvec3>& target : vertices.target_normals) combine(finer.vertices, target);
  for (std::vector<glm::dvec3>& target : vertices.target_tangents) combine(finer.vertices, target);
}

void subdivide_once(Fine& fine) {
  deform::SeamedSurface surface;
  surface.point_of = std::move(fine.vertices.point_of);
  surface.indices = std::move(fine.vertices.indices);
  deform::FinerSurface finer = deform::subdivide(surface, fine.points.positions.size());
  share_normals(finer.vertices, fine.vertices, fine.normals);
  go_along_edges(finer, fine.vertices);
  fine.vertices.point_of = std::move(finer.point_of);
  fine.vertices.indices = std::move(finer.indices);
  smooth(finer.points, fine.points);
}

std::vector<glm::dvec3> finished_normals(const Fine& fine) {
  std::vector<glm::dvec3> out = surface_normals(fine);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const glm::dvec3 otherwise = unit_or(out[k], glm::dvec3(0, 1, 0));
    out[k] = unit_or(out[k] + fine.normals.beside[k], unit_or(fine.normals.source[k], otherwise));
  }
  return out;
}

// At right angles to the normal.
glm::vec4 finished_tangent(const glm::dvec4& tangent, const glm::dvec3& normal) {
  const glm::dvec3 t(tangent);
  const glm::dvec3 axis = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 any = unit_or(glm::cross(normal, axis), axis);
  return {glm::vec3(unit_or(t - normal * glm::dot(normal, t), any)), tangent.w < 0 ? -1.0f : 1.0f};
}

template <class T>
void refill(std::vector<T>& values, const std::vector<std::uint32_t>& which, const auto& from) {
  if (values.empty()) return;
  values.clear();
  for (const std::uint32_t v : which) values.push_back(from(v));
}

void write_targets(const Fine& fine, const std::vector<std::uint32_t>& which, std::vector<RawTarget>& targets) {
  for (std::size_t t = 0; t < targets.size(); ++t) {
    // A primitive that a target leaves alone may touch one that it moves.
    targets[t].positions.clear();
    for (const std::uint32_t v : which)
      targets[t].positions.emplace_back(fine.points.targets[t][fine.vertices.point_of[v]]);
    if (std::ranges::all_of(targets[t].positions, [](const glm::vec3& d) { return d == glm::vec3(0); }))
      targets[t].positions.clear();
    refill(targets[t].normals, which, [&](std::uint32_t v) { return glm::vec3(fine.vertices.target_normals[t][v]); });
    refill(targets[t].tangents, which, [&](std::uint32_t v) { return glm::vec3(fine.vertices.target_tangents[t][v]); });
  }
}

BoundVertex bound_vertex(const Followers& followers, const glm::dvec3& position, bool has_residual) {
  BoundVertex out;
  for (const Follower& f : followers) {
    out.push_back({f.joint, f.weight});
    if (has_residual) out.back().residual = f.q - glm::dvec4(position, 1) * f.weight;
  }
  return out;
}

// A point each, on as many joints as a vertex may have. Adds those that had more to `cut`.
std::vector<BoundVertex> finished_points(const Fine& fine, std::size_t s, const MovedBy& skin, std::size_t& cut) {
  const bool has_residual = skin.binding->residual_step_m > 0;
  const auto place = [&](std::size_t i) { return glm::dvec3(glm::vec3(fine.points.positions[i])); };
  std::vector<BoundVertex> out;
  std::vector<std::size_t> full;
  for (std::size_t i = 0; i < fine.points.positions.size(); ++i) {
    out.push_back(bound_vertex(fine.points.followers[s][i], place(i), has_residual));
    if (out.back().size() > kMaxInfluences) full.push_back(i);
  }
  cut += full.size();
  if (full.empty()) return out;
  const std::vector<deform::Pose> poses = skin.poses();
  for (std::size_t first = 0; first < full.size(); first += kBatch) {
    const std::size_t count = std::min(kBatch, full.size() - first);
    deform::Coordinates coordinates;
    for (std::size_t i = first; i < first + count; ++i)
      coordinates.push_back(coordinates_of(out[full[i]], place(full[i])));
    const deform::PoseMetric metric(poses, coordinates);
    tools::for_each_in_parallel(count, [&](std::size_t i) {
      BoundVertex& vertex = out[full[first + i]];
      vertex = with_fewer_joints(metric, vertex, place(full[first + i]), has_residual, kMaxInfluences);
    });
  }
  return out;
}

std::vector<RawInfluence> raw_influences(const BoundVertex& vertex) {
  std::vector<RawInfluence> out;
  for (const BoundInfluence& i : vertex)
    if (i.weight > 0) out.push_back({i.joint, static_cast<float>(i.weight)});
  return out;
}

// which: of the fine vertices those of the primitive.
void write_primitive(const Fine& fine, const std::vector<glm::dvec3>& normals, const std::vector<std::uint32_t>& which,
                     RawPrimitive& to) {
  const AlongEdges& from = fine.vertices;
  const auto normal = [&](std::uint32_t v) { return normals[from.normal_of[v]]; };
  const bool has_normals = !to.normals.empty();
  refill(to.positions, which, [&](std::uint32_t v) { return glm::vec3(fine.points.positions[from.point_of[v]]); });
  refill(to.normals, which, [&](std::uint32_t v) { return glm::vec3(normal(v)); });
  refill(to.tangents, which,
         [&](std::uint32_t v) { return finished_tangent(from.tangents[v], has_normals ? normal(v) : glm::dvec3(0)); });
  refill(to.uvs, which, [&](std::uint32_t v) { return glm::vec2(from.uvs[v]); });
  refill(to.colours, which, [&](std::uint32_t v) { return glm::vec4(from.colours[v]); });
  write_targets(fine, which, to.targets);
}

}  // namespace

FinerMesh subdivide_mesh(const RawMesh& mesh, const std::vector<MovedBy>& skins, int steps) {
  Fine fine = as_it_is(mesh, skins);
  for (int step = 0; step < steps; ++step) subdivide_once(fine);
  FinerMesh out{mesh, {}, 0};
  std::vector<std::vector<BoundVertex>> bound;  // a skin: a point each
  for (std::size_t s = 0; s < skins.size(); ++s) {
    bound.push_back(finished_points(fine, s, skins[s], out.cut));
    out.bindings.push_back(*skins[s].binding);
  }
  std::vector<std::vector<std::uint32_t>> which(mesh.primitives.size());
  std::vector<std::uint32_t> number;  // a fine vertex: in its primitive
  for (std::size_t v = 0; v < fine.vertices.primitive_of.size(); ++v) {
    std::vector<std::uint32_t>& of = which[fine.vertices.primitive_of[v]];
    number.push_back(static_cast<std::uint32_t>(of.size()));
    of.push_back(static_cast<std::uint32_t>(v));
  }
  const std::vector<glm::dvec3> normals = finished_normals(fine);
  std::size_t corner = 0;  // triangles stay in the primitives' order
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    RawPrimitive& to = out.mesh.primitives[p];
    write_primitive(fine, normals, which[p], to);
    if (!to.influences.empty()) to.influences.resize(which[p].size());
    for (std::size_t s = 0; s < skins.size(); ++s) {
      const auto of = [&](std::uint32_t v) -> const BoundVertex& { return bound[s][fine.vertices.point_of[v]]; };
      refill(out.bindings[s].primitives[p], which[p], of);
      refill(to.influences, which[p], [&](std::uint32_t v) { return raw_influences(of(v)); });
    }
    to.indices.resize(to.indices.size() << (2 * steps));
    for (std::uint32_t& i : to.indices) i = number[fine.vertices.indices[corner++]];
  }
  return out;
}

}  // namespace marrow::cook
