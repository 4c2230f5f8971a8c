// From the artist's floats to whole numbers, and what that costs.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "common/elementary.h"
#include "cook/geometry/owned_streams.h"
#include "unpack/octahedron.h"

namespace marrow::cook {
namespace {

OwnedStreams begin_streams(const RawPrimitive& p, const std::vector<Binding>& bindings, std::size_t joint_count) {
  OwnedStreams out;
  MeshStreams& m = out.mesh;
  m.flags = (p.normals.empty() ? 0u : format::kHasNormals) | (p.tangents.empty() ? 0u : format::kHasTangents) |
            (p.uvs.empty() ? 0u : format::kHasUvs) | (p.colours.empty() ? 0u : format::kHasColours);
  m.vertex_count = static_cast<std::uint32_t>(p.positions.size());
  m.joint_count = static_cast<std::uint32_t>(joint_count);
  for (const Binding& b : bindings) m.influences = std::max(m.influences, static_cast<std::uint32_t>(b.set.size()));
  out.indices = p.indices;
  m.triangle_count = static_cast<std::uint32_t>(p.indices.size() / 3);
  return out;
}

void add_tangent_signs(const RawPrimitive& p, OwnedStreams& out) {
  out.add(StreamKind::tangent_sign, 1, 1);
  for (const glm::vec4& t : p.tangents) out.values_of(StreamKind::tangent_sign)->push_back(t.w < 0 ? 0 : 1);
}

void add_colours(const RawPrimitive& p, OwnedStreams& out) {
  if (p.colours.empty()) return;
  out.add(StreamKind::colour, 4, 8);
  for (const glm::vec4& colour : p.colours)
    for (int c = 0; c < 4; ++c)
      out.values_of(StreamKind::colour)
          ->push_back(static_cast<std::int32_t>(std::lround(std::clamp(colour[c], 0.0f, 1.0f) * 255.0f)));
}

void add_joints(const std::vector<Binding>& bindings, OwnedStreams& out) {
  if (out.mesh.joint_count < 2) return;
  out.add(StreamKind::joints, out.mesh.influences, 15);
  for (const Binding& b : bindings)
    for (std::size_t j = 0; j < out.mesh.influences; ++j)
      out.values_of(StreamKind::joints)->push_back(b.set[std::min(j, b.set.size() - 1)]);
}

// Numbers on a grid from the smallest, or from a given origin.
struct Axis {
  double origin, step;
  std::int32_t quantise(double x) const { return static_cast<std::int32_t>(std::lround((x - origin) / step)); }
};

std::uint32_t bits_for(std::int32_t most) {
  return std::max<std::uint32_t>(1, static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint32_t>(most))));
}

void add_positions(const RawPrimitive& p, const MeshGrid& grid, OwnedStreams& out, MeshError& error) {
  Stream& s = out.add(StreamKind::position, 3, 0);
  s.step = static_cast<float>(grid.step);
  for (int c = 0; c < 3; ++c) s.origin[c] = static_cast<float>(grid.origin[c]);
  std::int32_t most = 0;
  for (const glm::vec3& v : p.positions) {
    glm::dvec3 miss;
    for (int c = 0; c < 3; ++c) {
      const Axis axis{double{s.origin[c]}, double{s.step}};
      const std::int32_t q = std::max(0, axis.quantise(double{v[c]}));
      most = std::max(most, q);
      out.values_of(StreamKind::position)->push_back(q);
      miss[c] = double{s.origin[c] + static_cast<float>(q) * s.step} - double{v[c]};
    }
    error.position = std::max(error.position, glm::length(miss));
  }
  s.bits = static_cast<std::uint8_t>(bits_for(most));
}

// Draco's order of the octahedron's points: those that fold onto each other have one name.
void canonical(std::int32_t& s, std::int32_t& t, std::int32_t most) {
  const std::int32_t middle = most / 2;
  if ((s == 0 && t == 0) || (s == 0 && t == most) || (s == most && t == 0)) {
    s = t = most;
  } else if (s == 0 && t > middle) {
    t = most - t;
  } else if (s == most && t < middle) {
    t = most - t;
  } else if (t == most && s < middle) {
    s = most - s;
  } else if (t == 0 && s > middle) {
    s = most - s;
  }
}

double angle_deg(const glm::dvec3& a, const float (&b)[3]) {
  const glm::dvec3 other(b[0], b[1], b[2]);
  return glm::degrees(tools::angle_of(glm::length(glm::cross(a, other)), glm::dot(a, other)));
}

// The nearest of the grid's points round the projection. Returns how far it is off, in degrees.
double to_octahedron(const glm::vec3& v, std::uint32_t bits, std::int32_t& best_s, std::int32_t& best_t) {
  const std::int32_t most = (1 << bits) - 2, middle = most / 2;
  const glm::dvec3 n = glm::normalize(glm::dvec3(v));
  const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
  double y = n.y / sum, z = n.z / sum;
  if (n.x < 0) {
    const double folded_y = 1 - std::abs(z), folded_z = 1 - std::abs(y);
    y = y < 0 ? -folded_y : folded_y;
    z = z < 0 ? -folded_z : folded_z;
  }
  const auto s0 = static_cast<std::int32_t>(std::floor((y + 1) * middle));
  const auto t0 = static_cast<std::int32_t>(std::floor((z + 1) * middle));
  double best = 1e9;
  for (std::int32_t ds = 0; ds < 2; ++ds) {
    for (std::int32_t dt = 0; dt < 2; ++dt) {
      std::int32_t s = std::clamp(s0 + ds, 0, most), t = std::clamp(t0 + dt, 0, most);
      canonical(s, t, most);
      float unit[3];
      from_octahedron(s, t, bits, unit);
      const double off = angle_deg(n, unit);
      if (off >= best) continue;
      best = off;
      best_s = s;
      best_t = t;
    }
  }
  return best;
}

// As few bits as keep `allowed_deg`.
template <class Direction>
double add_directions(StreamKind kind, std::size_t count, const Direction& direction, double allowed_deg,
                      OwnedStreams& out) {
  constexpr std::uint32_t kFewest = 4;
  Stream& stream = out.add(kind, 2, 0);
  std::vector<std::int32_t>& values = *out.values_of(kind);
  double worst = 0;
  for (std::uint32_t bits = kFewest; bits <= packed::kMaxDirectionBits; ++bits) {
    stream.bits = static_cast<std::uint8_t>(bits);
    values.clear();
    worst = 0;
    for (std::size_t v = 0; v < count && (worst <= allowed_deg || bits == packed::kMaxDirectionBits); ++v) {
      std::int32_t s = 0, t = 0;
      worst = std::max(worst, to_octahedron(direction(v), bits, s, t));
      values.insert(values.end(), {s, t});
    }
    if (worst <= allowed_deg) break;
  }
  return worst;
}

void add_uvs(const RawPrimitive& p, double allowed, OwnedStreams& out, MeshError& error) {
  if (p.uvs.empty()) return;
  glm::dvec2 low(p.uvs.front()), high(low);
  for (const glm::vec2& uv : p.uvs) {
    low = glm::min(low, glm::dvec2(uv));
    high = glm::max(high, glm::dvec2(uv));
  }
  const double range = std::max({high.x - low.x, high.y - low.y, allowed});
  const double most = std::min(std::ceil(range / (2 * allowed)), double{(1 << packed::kMaxValueBits) - 1});
  Stream& s = out.add(StreamKind::uv, 2, bits_for(static_cast<std::int32_t>(most)));
  s.step = static_cast<float>(range / most);
  for (int c = 0; c < 2; ++c) s.origin[c] = static_cast<float>(low[c]);
  for (const glm::vec2& uv : p.uvs) {
    for (int c = 0; c < 2; ++c) {
      const Axis axis{double{s.origin[c]}, double{s.step}};
      const std::int32_t q = std::clamp(axis.quantise(double{uv[c]}), 0, static_cast<std::int32_t>(most));
      out.values_of(StreamKind::uv)->push_back(q);
      error.uv = std::max(error.uv, std::abs(double{s.origin[c] + static_cast<float>(q) * s.step} - double{uv[c]}));
    }
  }
}

// Whole numbers that sum to `one`, each at most one from its share: the largest remainders are rounded up.
std::vector<std::int32_t> rounded_weights(const std::vector<double>& weights, std::int32_t one) {
  std::vector<std::pair<double, std::size_t>> remainders;
  std::vector<std::int32_t> all;
  std::int32_t left = one;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    const double share = weights[j] * one;
    all.push_back(std::min(left, static_cast<std::int32_t>(share)));
    left -= all.back();
    remainders.emplace_back(static_cast<double>(all.back()) - share, j);
  }
  std::sort(remainders.begin(), remainders.end());
  for (std::size_t i = 0; left > 0; ++i, --left) ++all[remainders[i % remainders.size()].second];
  return all;
}

// A residual as it is stored: relative to the vertex, which the w carry along, so that it is small wherever the origin
// lies.
using RoundedResidual = std::array<std::int32_t, 4>;

std::vector<RoundedResidual> rounded_residual(const Binding& b, const glm::vec3& v, const MeshGrid& grid) {
  constexpr double kMost = (1 << (packed::kMaxValueBits - 2)) - 1;
  std::vector<RoundedResidual> out;
  std::int32_t sum = 0;
  glm::dvec4 carry(0);  // what one influence is rounded by goes to the next: joints that move alike hardly notice
  for (const glm::dvec4& r : b.residual) {
    const glm::dvec3 d = (glm::dvec3(r) - glm::dvec3(v) * r.w) / grid.residual_step;
    const glm::dvec4 steps = glm::dvec4(d, r.w / grid.residual_weight_step) + carry;
    RoundedResidual& to = out.emplace_back();
    for (int c = 0; c < 4; ++c) {
      const double most = c < 3 ? kMost : kMost / 8, whole = std::round(std::clamp(steps[c], -most, most));
      carry[c] = steps[c] - whole;
      to[static_cast<std::size_t>(c)] = static_cast<std::int32_t>(whole);
    }
    sum += to[3];
  }
  // They sum to 0; what rounding made of that goes where it is the least of its share.
  if (!out.empty())
    (*std::max_element(out.begin(), out.end(), [](const RoundedResidual& x, const RoundedResidual& y) {
      return std::abs(x[3]) < std::abs(y[3]);
    }))[3] -= sum;
  return out;
}

// A vertex's influences in whole numbers; those that have neither weight nor residual are left out.
struct RoundedBinding {
  Binding kept;
  std::vector<std::int32_t> weights;
  std::vector<RoundedResidual> residual;
};

RoundedBinding rounded(const Binding& b, const glm::vec3& v, std::int32_t one, const MeshGrid& grid) {
  const std::vector<std::int32_t> weights = rounded_weights(b.weights, one);
  const std::vector<RoundedResidual> residual = rounded_residual(b, v, grid);
  RoundedBinding out;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    const bool moves = !residual.empty() && residual[j] != RoundedResidual{};
    if (weights[j] == 0 && !moves) continue;
    out.kept.set.push_back(b.set[j]);
    out.kept.weights.push_back(b.weights[j]);
    out.weights.push_back(weights[j]);
    if (!residual.empty()) out.residual.push_back(residual[j]);
  }
  return out;
}

double weight_error(const Binding& b, const RoundedBinding& r, std::int32_t one) {
  double worst = 0;
  for (std::size_t j = 0, k = 0; j < b.set.size(); ++j) {
    const bool is_kept = k < r.kept.set.size() && r.kept.set[k] == b.set[j];
    const double now = is_kept ? static_cast<double>(r.weights[k++]) / one : 0.0;
    worst = std::max(worst, std::abs(now - b.weights[j]));
  }
  return worst;
}

// Vectors as their stream has them; of a target that moves nothing there is none.
std::vector<glm::dvec3> rounded_vectors(const OwnedStreams& out, StreamKind kind, std::uint32_t target,
                                        std::size_t count) {
  std::vector<glm::dvec3> vectors(count, glm::dvec3(0));
  for (std::size_t i = 0; i < out.streams.size(); ++i) {
    const Stream& s = out.streams[i];
    if (s.kind != kind || s.target != target || s.attribute != 0) continue;
    const std::int32_t nothing = is_centred(kind) ? 1 << (s.bits - 1) : 0;
    for (std::size_t n = 0; n < 3 * count; ++n)
      vectors[n / 3][static_cast<int>(n % 3)] =
          double{s.origin[n % 3] + static_cast<float>(out.values[i][n] - nothing) * s.step};
  }
  return vectors;
}

// The farthest that a vertex is from where the source has it when all joints rest, its weights rounded, too. w: 1 of
// places, 0 of changes.
double rest_error(const std::vector<glm::vec3>& source, const std::vector<glm::dvec3>& rounded, double w,
                  const std::vector<Binding>& bindings, const std::vector<RoundedBinding>& vertices, std::int32_t one,
                  const MeshGrid& grid) {
  double worst = 0;
  for (std::size_t v = 0; v < source.size(); ++v) {
    if (w == 0 && source[v] == glm::vec3(0) && rounded[v] == glm::dvec3(0)) continue;  // most, of a face
    const auto place = [&](std::uint16_t entry, const glm::dvec3& at) {
      return glm::dvec3(grid.rest[entry] * glm::dvec4(at, w));
    };
    glm::dvec3 off(0);
    for (std::size_t j = 0; j < bindings[v].set.size(); ++j)
      off -= bindings[v].weights[j] * place(bindings[v].set[j], source[v]);
    const RoundedBinding& r = vertices[v];
    for (std::size_t j = 0; j < r.weights.size(); ++j)
      off += static_cast<double>(r.weights[j]) / one * place(r.kept.set[j], rounded[v]);
    worst = std::max(worst, glm::length(off));
  }
  return worst;
}

// Of positions and of what morph targets change of them. All stand in `out`.
void measure_rest(const RawPrimitive& p, const std::vector<Binding>& bindings,
                  const std::vector<RoundedBinding>& vertices, std::int32_t one, const MeshGrid& grid,
                  const OwnedStreams& out, MeshError& error) {
  if (grid.rest.empty()) return;
  const auto measured = [&](const std::vector<glm::vec3>& source, StreamKind kind, std::uint32_t target) {
    return rest_error(source, rounded_vectors(out, kind, target, source.size()), kind == StreamKind::position ? 1 : 0,
                      bindings, vertices, one, grid);
  };
  error.rest_m = measured(p.positions, StreamKind::position, 0);
  for (std::size_t t = 0; t < p.targets.size(); ++t)
    error.targets_rest_m.push_back(measured(p.targets[t].positions, StreamKind::target, static_cast<std::uint32_t>(t)));
}

void add_residuals(const std::vector<RoundedBinding>& vertices, const MeshGrid& grid, OwnedStreams& out) {
  std::int32_t most = 0;
  for (const RoundedBinding& r : vertices)
    for (const RoundedResidual& four : r.residual)
      for (const std::int32_t n : four) most = std::max(most, std::abs(n));
  if (most == 0) return;
  out.mesh.flags |= format::kHasAsResidual;
  for (std::uint32_t j = 0; j < out.mesh.influences; ++j) {
    Stream& s = out.add(StreamKind::residual, 4, bits_for(most) + 1);
    s.target = j;
    s.step = static_cast<float>(grid.residual_step);
    s.origin[0] = static_cast<float>(grid.residual_weight_step);
    const std::int32_t nothing = 1 << (s.bits - 1);
    for (const RoundedBinding& r : vertices)
      for (std::size_t c = 0; c < 4; ++c)
        out.values.back().push_back(nothing + (j < r.residual.size() ? r.residual[j][c] : 0));
  }
}

std::uint32_t weight_bits(double allowed) {
  std::uint32_t bits = 1;
  while (bits < packed::kMaxWeightBits && 1.0 / ((1 << bits) - 1) > allowed) ++bits;
  return bits;
}

// Returns the vertices' rounded influences.
std::vector<RoundedBinding> add_influences(const RawPrimitive& p, const std::vector<Binding>& bindings,
                                           const MeshGrid& grid, std::uint32_t bits, OwnedStreams& out,
                                           MeshError& error) {
  const std::int32_t one = (1 << bits) - 1;
  std::vector<RoundedBinding> vertices;
  std::vector<Binding> kept;
  out.mesh.influences = 1;
  for (std::size_t v = 0; v < bindings.size(); ++v) {
    vertices.push_back(rounded(bindings[v], p.positions[v], one, grid));
    kept.push_back(vertices.back().kept);
    out.mesh.influences = std::max(out.mesh.influences, static_cast<std::uint32_t>(kept.back().set.size()));
    error.weight = std::max(error.weight, weight_error(bindings[v], vertices.back(), one));
  }
  add_joints(kept, out);
  if (out.mesh.influences > 1) {
    out.add(StreamKind::weights, out.mesh.influences - 1, bits).step = weight_step(bits);
    for (const RoundedBinding& r : vertices)
      for (std::size_t j = 0; j + 1 < out.mesh.influences; ++j)
        out.values_of(StreamKind::weights)->push_back(j + 1 < r.weights.size() ? r.weights[j] : 0);
  }
  add_residuals(vertices, grid, out);
  return vertices;
}

// position_step: of the grid, or 0. A change of a unit vector of less than a thousandth of a degree is noise.
void add_targets(const RawPrimitive& p, double position_step, double direction_step, OwnedStreams& out,
                 MeshError& error) {
  bool moves = false;
  double of_directions = 0;  // which nobody asks for
  error.targets.resize(p.targets.size(), 0);
  for (std::size_t t = 0; t < p.targets.size(); ++t) {
    const RawTarget& target = p.targets[t];
    const auto number = static_cast<std::uint32_t>(t);
    const auto add = [&](const std::vector<glm::vec3>& changes, std::uint8_t attribute, double finest, double& worst) {
      const std::vector<glm::dvec3> exact(changes.begin(), changes.end());
      moves |= add_changes(StreamKind::target, exact, number, attribute, finest, out, worst);
    };
    add(target.positions, 0, position_step, error.targets[t]);
    if (!p.normals.empty()) add(target.normals, 1, direction_step, of_directions);
    if (!p.tangents.empty()) add(target.tangents, 2, direction_step, of_directions);
  }
  if (!moves) return;
  out.mesh.target_count = static_cast<std::uint32_t>(p.targets.size());
  out.mesh.flags |= format::kHasMorphTargets;
}

template <class Vectors>
void add_floats(StreamKind kind, const Vectors& vectors, int components, OwnedStreams& out) {
  if (vectors.empty()) return;
  out.add(kind, static_cast<std::uint32_t>(components), 0);
  for (const auto& v : vectors)
    for (int c = 0; c < components; ++c) out.values_of(kind)->push_back(std::bit_cast<std::int32_t>(v[c]));
}

void add_verbatim_residuals(const std::vector<Binding>& bindings, OwnedStreams& out) {
  if (bindings.empty() || bindings.front().residual.empty()) return;
  out.mesh.flags |= format::kHasAsResidual;
  for (std::uint32_t j = 0; j < out.mesh.influences; ++j) {
    out.add(StreamKind::residual, 4, 0).target = j;
    for (const Binding& b : bindings)
      for (int c = 0; c < 4; ++c)
        out.values.back().push_back(
            std::bit_cast<std::int32_t>(j < b.residual.size() ? static_cast<float>(b.residual[j][c]) : 0.0f));
  }
}

}  // namespace

bool add_changes(StreamKind kind, const std::vector<glm::dvec3>& changes, std::uint32_t target, std::uint8_t attribute,
                 double finest, OwnedStreams& out, double& worst) {
  constexpr double kMost = (1 << (packed::kMaxTargetBits - 1)) - 1;
  double most = 0;
  for (const glm::dvec3& d : changes)
    for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(d[c]));
  const double step = double{static_cast<float>(std::max(most / kMost, finest))};
  if (!(step > 0) || most * 2 < step) {
    for (const glm::dvec3& d : changes) worst = std::max(worst, glm::length(d));
    return false;
  }
  const auto largest = static_cast<std::int32_t>(std::lround(std::min(most / step, kMost)));
  Stream& s = out.add(kind, 3, bits_for(largest) + 1);
  s.target = target;
  s.attribute = attribute;
  s.step = static_cast<float>(step);
  const std::int32_t nothing = 1 << (s.bits - 1);
  for (const glm::dvec3& d : changes) {
    glm::dvec3 miss;
    for (int c = 0; c < 3; ++c) {
      const double steps = std::clamp(std::round(d[c] / step), -kMost, kMost);
      out.values.back().push_back(nothing + static_cast<std::int32_t>(steps));
      miss[c] = steps * step - d[c];
    }
    worst = std::max(worst, glm::length(miss));
  }
  return true;
}

OwnedStreams verbatim_streams(const RawPrimitive& p, const std::vector<Binding>& bindings, std::size_t joint_count,
                              MeshError& error) {
  OwnedStreams out = begin_streams(p, bindings, joint_count);
  add_floats(StreamKind::position, p.positions, 3, out);
  add_floats(StreamKind::normal, p.normals, 3, out);
  add_floats(StreamKind::tangent, p.tangents, 3, out);
  if (!p.tangents.empty()) add_tangent_signs(p, out);
  add_floats(StreamKind::uv, p.uvs, 2, out);
  add_colours(p, out);
  add_joints(bindings, out);
  if (out.mesh.influences > 1) {
    out.add(StreamKind::weights, out.mesh.influences - 1, 0);
    for (const Binding& b : bindings)
      for (std::size_t j = 0; j + 1 < out.mesh.influences; ++j)
        out.values_of(StreamKind::weights)
            ->push_back(std::bit_cast<std::int32_t>(j + 1 < b.set.size() ? static_cast<float>(b.weights[j]) : 0.0f));
  }
  add_verbatim_residuals(bindings, out);
  constexpr double kNoise = 0x1p-15;  // of a unit vector, two thousandths of a degree
  add_targets(p, 0, kNoise, out, error);
  return out;
}

OwnedStreams quantised_streams(const RawPrimitive& p, const std::vector<Binding>& bindings, std::size_t joint_count,
                               const MeshGrid& grid, const MeshPrecision& precision, MeshError& error) {
  OwnedStreams out = begin_streams(p, bindings, joint_count);
  add_positions(p, grid, out, error);
  if (!p.normals.empty())
    error.normal_deg = add_directions(
        StreamKind::normal, p.normals.size(), [&](std::size_t v) { return p.normals[v]; }, precision.normal_error_deg,
        out);
  if (!p.tangents.empty()) {
    const double off = add_directions(
        StreamKind::tangent, p.tangents.size(), [&](std::size_t v) { return glm::vec3(p.tangents[v]); },
        precision.normal_error_deg, out);
    error.normal_deg = std::max(error.normal_deg, off);
    add_tangent_signs(p, out);
  }
  add_uvs(p, precision.uv_error, out, error);
  add_colours(p, out);
  const std::uint32_t bits = weight_bits(precision.weight_error);
  const std::vector<RoundedBinding> vertices = add_influences(p, bindings, grid, bits, out, error);
  add_targets(p, grid.step, glm::radians(precision.normal_error_deg), out, error);
  measure_rest(p, bindings, vertices, (1 << bits) - 1, grid, out, error);
  return out;
}

Binding quantised_binding(const Binding& binding, const glm::vec3& position, const MeshGrid& grid,
                          const MeshPrecision& precision) {
  const std::int32_t one = (1 << weight_bits(precision.weight_error)) - 1;
  RoundedBinding r = rounded(binding, position, one, grid);
  for (std::size_t j = 0; j < r.weights.size(); ++j) r.kept.weights[j] = static_cast<double>(r.weights[j]) / one;
  return r.kept;
}

}  // namespace marrow::cook
