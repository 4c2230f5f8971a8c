// Evaluates glTF 2.0 in double precision; written for clearness, not speed.
#include "road/reference.h"

#include <algorithm>

namespace marrow::test {
namespace {

// Below this the normal of a blend is noise: float rounding moves it by more than the tolerance that is asked.
constexpr double kLeastInvertibility = 1e-3;

Quat hermite(const SourceChannel& c, std::size_t key, double t, double interval_s) {
  const Quat &v0 = c.values[key * 3 + 1], &out0 = c.values[key * 3 + 2];
  const Quat &in1 = c.values[key * 3 + 3], &v1 = c.values[key * 3 + 4];
  const double t2 = t * t, t3 = t2 * t;
  Quat v{};
  for (std::size_t i = 0; i < 4; ++i) {
    v[i] = (2 * t3 - 3 * t2 + 1) * v0[i] + interval_s * (t3 - 2 * t2 + t) * out0[i] + (-2 * t3 + 3 * t2) * v1[i] +
           interval_s * (t3 - t2) * in1[i];
  }
  return v;
}

Quat interpolate(const SourceChannel& c, std::size_t key, double time_s) {
  const double interval_s = c.times_s[key + 1] - c.times_s[key];
  const double t = (time_s - c.times_s[key]) / interval_s;
  if (c.interpolation == "CUBICSPLINE") return hermite(c, key, t, interval_s);
  const Quat &a = c.values[key], &b = c.values[key + 1];
  if (c.path == "rotation") return slerp(normalised(a), normalised(b), t);
  Quat v{};
  for (std::size_t i = 0; i < 4; ++i) v[i] = a[i] + (b[i] - a[i]) * t;
  return v;
}

double size_of(const Map& m) {
  double squared = 0;
  for (int r = 0; r < 3; ++r) squared += dot(row(m, r), row(m, r));
  return std::sqrt(squared);
}

double distance_of(const Map& m) {
  return length(Vec3{m.rows[0][3], m.rows[1][3], m.rows[2][3]});
}

// A palette's entry, and how far floats may take what it places.
struct Entry {
  Map map;
  double levels = 0, largest = 0;                 // above the joint: how often lengths are rounded, and the largest
  double in_scene = 0, in_scene_of_unit = 0;      // what the inverse bind moves, as long as it is in the scene
  double in_palette = 0, in_palette_of_unit = 0;  // the same of both maps as one

  // A level multiplies and adds up three products and a translation, each rounded by at most half of 2^-23 of the
  // largest length that takes part, up or down. They go against each other more often than with each other: for a
  // level all of one rounding and a half. What makes the joint's own matrix, its inverse bind and the blend are three
  // levels more.
  double noise(double distance) const {
    constexpr double kRounding = 1.5 * 0x1p-24;
    return kRounding * (levels + 3) *
           std::max({largest, in_scene + in_scene_of_unit * distance, in_palette + in_palette_of_unit * distance});
  }
};

struct Blend {
  Map map;    // Σ w_j M_j
  Map rigid;  // M_j of the largest weight
  bool rigid_unique = true;
  double noise = 0;
};

// distance: of the vertex from the origin of the mesh's space.
Blend blend(const std::vector<SourceInfluence>& influences, const std::vector<Entry>& palette, double distance) {
  Blend b;
  for (auto& r : b.map.rows) std::fill(std::begin(r), std::end(r), 0.0);
  for (const SourceInfluence& influence : influences) {
    const Entry& entry = palette[static_cast<std::size_t>(influence.joint)];
    const Map& m = entry.map;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) b.map.rows[r][c] += influence.weight * m.rows[r][c];
    b.noise += influence.weight * entry.noise(distance);
  }
  b.rigid = palette[static_cast<std::size_t>(influences[0].joint)].map;
  b.rigid_unique = influences.size() == 1 || influences[0].weight - influences[1].weight > 1e-6;
  return b;
}

// A morphed direction shorter than this turns by more than is asked when it is rounded.
constexpr double kLeastDirection = 0.05;

struct MorphedVertex {
  Vec3 position, normal, tangent;
  bool directed = true;  // normal and tangent are long enough to be compared
};

// glTF 2.0, section 3.7.2.2: attribute + Σ weight · change, before skinning.
MorphedVertex morphed(const SourcePrimitive& p, std::size_t v, const std::vector<double>& weights) {
  const auto sum = [&](const std::vector<Vec3>& base, std::vector<Vec3> SourceTarget::*changes) {
    Vec3 out = base.empty() ? Vec3{0, 0, 0} : base[v];
    for (std::size_t t = 0; t < p.targets.size(); ++t) {
      const std::vector<Vec3>& change = p.targets[t].*changes;
      for (std::size_t i = 0; i < 3 && !change.empty(); ++i) out[i] += weights.at(t) * change[v][i];
    }
    return out;
  };
  MorphedVertex m{sum(p.positions, &SourceTarget::positions), sum(p.normals, &SourceTarget::normals),
                  sum(p.tangents, &SourceTarget::tangents)};
  m.directed = (p.normals.empty() || length(m.normal) > kLeastDirection) &&
               (p.tangents.empty() || length(m.tangent) > kLeastDirection);
  return m;
}

void add_vertex(ReferencePose& pose, const SourcePrimitive& p, std::size_t v, const MorphedVertex& m, const Blend& b) {
  const Vec3 none{0, 0, 0};
  const bool invertible = invertibility(b.map) > kLeastInvertibility && m.directed;
  pose.positions.push_back(point(b.map, m.position));
  pose.rigid.push_back(point(b.rigid, m.position));
  pose.rigid_unique.push_back(b.rigid_unique);
  pose.float_noise.push_back(b.noise);
  pose.normals.push_back(invertible && !p.normals.empty() ? normal(b.map, m.normal) : none);
  pose.tangents.push_back(invertible && !p.tangents.empty() ? normalised(direction(b.map, m.tangent)) : none);
  // A mirror turns cross(normal, tangent) round but not the bitangent.
  const double mirror = determinant(b.map) < 0 ? -1 : 1;
  pose.tangent_signs.push_back(invertible && !p.tangents.empty() ? mirror * p.tangent_signs[v] : 0);
}

}  // namespace

Quat sample_channel(const SourceChannel& c, double time_s) {
  const bool cubic = c.interpolation == "CUBICSPLINE";
  const auto at_key = [&](std::size_t k) { return cubic ? c.values[k * 3 + 1] : c.values[k]; };
  Quat v{};
  const auto after = std::upper_bound(c.times_s.begin(), c.times_s.end(), time_s);
  if (after == c.times_s.begin()) {
    v = at_key(0);
  } else {
    const auto key = static_cast<std::size_t>(after - c.times_s.begin()) - 1;
    v = after == c.times_s.end() || c.interpolation == "STEP" ? at_key(key) : interpolate(c, key, time_s);
  }
  return c.path == "rotation" ? normalised(v) : v;
}

std::vector<SourceInfluence> kept_influences(const std::vector<SourceInfluence>& all) {
  std::vector<SourceInfluence> kept;
  for (const SourceInfluence& influence : all) {
    if (!(influence.weight > 0)) continue;
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const auto& k) { return k.joint == influence.joint; });
    if (same == kept.end())
      kept.push_back(influence);
    else
      same->weight += influence.weight;
  }
  std::stable_sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.weight > b.weight; });
  if (kept.size() > 8) kept.resize(8);
  double sum = 0;
  for (const SourceInfluence& k : kept) sum += k.weight;
  for (SourceInfluence& k : kept) k.weight /= sum;
  return kept;
}

Reference::Reference(Source source) : source_(std::move(source)) {
  for (auto& mesh : source_.meshes) {
    for (SourcePrimitive& p : mesh) {
      for (auto& influences : p.influences) influences = kept_influences(influences);
    }
  }
  for (const SourceNode& node : source_.nodes) {
    if (!node.in_scene || node.mesh < 0) continue;
    for (const SourcePrimitive& p : source_.meshes[static_cast<std::size_t>(node.mesh)]) {
      for (std::size_t v = 0; v < p.positions.size(); ++v) {
        const bool skinned = node.skin >= 0 && !p.influences.empty();
        bound_.push_back(!skinned || !p.influences[v].empty());
        if (!bound_.back()) ++unbound_count_;
      }
    }
  }
  const ReferencePose pose = rest();
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (std::size_t v = 0; v < pose.positions.size(); ++v) {
    for (std::size_t i = 0; bound_[v] && i < 3; ++i) {
      low[i] = std::min(low[i], pose.positions[v][i]);
      high[i] = std::max(high[i], pose.positions[v][i]);
    }
  }
  diagonal_ = pose.positions.empty() ? 0 : length(minus(high, low));
}

double Reference::duration_s(std::size_t animation) const {
  double duration = 0;
  for (const SourceChannel& c : source_.animations.at(animation).channels)
    duration = std::max(duration, c.times_s.back());
  for (const SourceWeight& w : source_.animations.at(animation).weights)
    duration = std::max(duration, w.channel.times_s.back());
  return duration;
}

Reference::Placed Reference::model_from_node(const SourceAnimation* animation, double time_s) const {
  std::vector<SourceNode> nodes = source_.nodes;
  if (animation) {
    for (const SourceChannel& c : animation->channels) {
      const Quat v = sample_channel(c, time_s);
      SourceNode& n = nodes[static_cast<std::size_t>(c.node)];
      if (c.path == "rotation")
        n.rotation = v;
      else
        (c.path == "translation" ? n.translation : n.scale) = {v[0], v[1], v[2]};
    }
  }
  Placed out{std::vector<Map>(nodes.size()), std::vector<double>(nodes.size()), std::vector<double>(nodes.size())};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::vector<Map> chain;  // from the node up
    for (int n = static_cast<int>(i); n >= 0; n = nodes[static_cast<std::size_t>(n)].parent) {
      const SourceNode& node = nodes[static_cast<std::size_t>(n)];
      chain.push_back(node.has_matrix ? node.matrix : from_trs(node.translation, node.rotation, node.scale));
    }
    Map m;
    for (auto below = chain.rbegin(); below != chain.rend(); ++below) {
      const double moved = size_of(m) * distance_of(*below);
      m = m * *below;
      out.largest[i] = std::max({out.largest[i], moved, distance_of(m)});
    }
    out.nodes[i] = m;
    out.levels[i] = static_cast<double>(chain.size());
  }
  return out;
}

std::vector<double> Reference::node_noise_at(std::size_t animation, double time_s) const {
  const Placed placed = model_from_node(&source_.animations.at(animation), time_s);
  std::vector<double> out;
  for (std::size_t i = 0; i < placed.nodes.size(); ++i)
    out.push_back(Entry{{}, placed.levels[i], placed.largest[i]}.noise(0));
  return out;
}

ReferencePose Reference::pose(const SourceAnimation* animation, double time_s, const std::vector<float>& cycle) const {
  const Placed placed = model_from_node(animation, time_s);
  const auto entry = [&](std::size_t node, const Map& bind) {
    const Map& m = placed.nodes[node];
    const Map both = m * bind;
    return Entry{both,
                 placed.levels[node],
                 placed.largest[node],
                 size_of(m) * distance_of(bind),
                 size_of(m) * size_of(bind),
                 distance_of(both),
                 size_of(both)};
  };
  ReferencePose pose;
  for (std::size_t i = 0; i < source_.nodes.size(); ++i) {
    const SourceNode& node = source_.nodes[i];
    if (!node.in_scene || node.mesh < 0) continue;
    std::vector<double> weights = node.weights;
    for (std::size_t w = 0; animation && w < animation->weights.size(); ++w) {
      const SourceWeight& weight = animation->weights[w];
      if (weight.channel.node == static_cast<int>(i))
        weights.at(weight.target) = sample_channel(weight.channel, time_s)[0];
    }
    for (std::size_t t = 0; t < weights.size() && !cycle.empty(); ++t)
      weights[t] = static_cast<double>(cycle[t % cycle.size()]);
    std::vector<Entry> palette;
    const std::vector<Entry> hung = {entry(i, Map{})};
    const std::vector<SourceInfluence> all = {{0, 1}};
    if (node.skin >= 0) {
      const SourceSkin& skin = source_.skins[static_cast<std::size_t>(node.skin)];
      for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        palette.push_back(entry(static_cast<std::size_t>(skin.joints[j]), skin.inverse_bind[j]));
      }
    }
    for (const SourcePrimitive& p : source_.meshes[static_cast<std::size_t>(node.mesh)]) {
      const bool skinned = node.skin >= 0 && !p.influences.empty();
      for (std::size_t v = 0; v < p.positions.size(); ++v) {
        const bool unbound = skinned && p.influences[v].empty();
        const MorphedVertex m = morphed(p, v, weights);
        const double distance = length(m.position);
        add_vertex(pose, p, v, m,
                   skinned && !unbound ? blend(p.influences[v], palette, distance) : blend(all, hung, distance));
      }
    }
  }
  return pose;
}

}  // namespace marrow::test
