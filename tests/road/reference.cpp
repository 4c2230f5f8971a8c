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

struct Blend {
  Map map;    // Σ w_j M_j
  Map rigid;  // M_j of the largest weight
  bool rigid_unique = true;
};

Blend blend(const std::vector<SourceInfluence>& influences, const std::vector<Map>& palette) {
  Blend b;
  for (auto& r : b.map.rows) std::fill(std::begin(r), std::end(r), 0.0);
  for (const SourceInfluence& influence : influences) {
    const Map& m = palette[static_cast<std::size_t>(influence.joint)];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) b.map.rows[r][c] += influence.weight * m.rows[r][c];
  }
  b.rigid = palette[static_cast<std::size_t>(influences[0].joint)];
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

void add_vertex(ReferencePose& pose, const SourcePrimitive& p, std::size_t v, const std::vector<double>& weights,
                const Blend& b) {
  const Vec3 none{0, 0, 0};
  const MorphedVertex m = morphed(p, v, weights);
  const bool invertible = invertibility(b.map) > kLeastInvertibility && m.directed;
  pose.positions.push_back(point(b.map, m.position));
  pose.rigid.push_back(point(b.rigid, m.position));
  pose.rigid_unique.push_back(b.rigid_unique);
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

Reference::Reference(const std::string& path) : source_(read_source(path)) {
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

std::vector<Map> Reference::scene_from_node(const SourceAnimation* animation, double time_s) const {
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
  std::vector<Map> out(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Map m;
    for (int n = static_cast<int>(i); n >= 0; n = nodes[static_cast<std::size_t>(n)].parent) {
      const SourceNode& node = nodes[static_cast<std::size_t>(n)];
      m = (node.has_matrix ? node.matrix : from_trs(node.translation, node.rotation, node.scale)) * m;
    }
    out[i] = m;
  }
  return out;
}

ReferencePose Reference::pose(const SourceAnimation* animation, double time_s, const std::vector<float>& cycle) const {
  const std::vector<Map> global = scene_from_node(animation, time_s);
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
    std::vector<Map> palette;
    if (node.skin >= 0) {
      const SourceSkin& skin = source_.skins[static_cast<std::size_t>(node.skin)];
      for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        palette.push_back(global[static_cast<std::size_t>(skin.joints[j])] * skin.inverse_bind[j]);
      }
    }
    for (const SourcePrimitive& p : source_.meshes[static_cast<std::size_t>(node.mesh)]) {
      const bool skinned = node.skin >= 0 && !p.influences.empty();
      for (std::size_t v = 0; v < p.positions.size(); ++v) {
        const bool unbound = skinned && p.influences[v].empty();
        add_vertex(pose, p, v, weights,
                   skinned && !unbound ? blend(p.influences[v], palette) : Blend{global[i], global[i], true});
      }
    }
  }
  return pose;
}

}  // namespace marrow::test
