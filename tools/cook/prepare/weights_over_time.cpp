#include "cook/prepare/weights_over_time.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "common/failure.h"
#include "cook/prepare/bind_bones.h"
#include "cook/scene/matrices.h"
#include "cook/scene/node_motion.h"
#include "cook/scene/views.h"
#include "deform/rotations.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::cook {
namespace {

constexpr double kKeysPerSecond = 60;
constexpr std::size_t kMostNewKeys = 1'000'000;  // of all clips and new joints of a rule
constexpr std::size_t kMostKeys = 10'000'000;    // of a clip, times the nodes above its joints

[[noreturn]] void refuse(const WeightsOverTime& rule, const std::string& why, const std::string& advice) {
  throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where, tools::printable(why), advice);
}

int node_named(const RawScene& scene, const std::string& name, const WeightsOverTime& rule) {
  std::vector<std::string> names;
  int found = kNone;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    if (!scene.nodes[n].in_scene) continue;
    if (!scene.nodes[n].name.empty()) names.push_back(scene.nodes[n].name);
    if (scene.nodes[n].name != name) continue;
    if (found != kNone) refuse(rule, "several nodes are called " + name, "give the joint a name of its own");
    found = static_cast<int>(n);
  }
  if (found == kNone)
    refuse(rule, "no node is called " + name,
           names.empty() ? "no node of the scene has a name" : tools::suggestion(name, names));
  return found;
}

// One rule at work.
struct Work {
  const WeightsOverTime* rule;
  int from = kNone, to = kNone;
  std::vector<int> made;    // the new nodes
  glm::dmat4 to_from_from;  // in the bind pose
};

std::string channel_of(const WeightsOverTime& rule, int spline) {
  return rule.splines == 1 ? rule.channel : fmt::format("{}[{}]", rule.channel, spline);
}

int joint_of(const RawSkin& skin, int node) {
  const auto at = std::ranges::find(skin.joints, node);
  return at == skin.joints.end() ? kNone : static_cast<int>(at - skin.joints.begin());
}

// What a rule's joints are to one another in the bind pose; a node that is no joint of the skin as at rest.
void bind_joints(const RawScene& scene, const RawSkin& skin, const std::vector<glm::dmat4>& rest, Work& work) {
  const glm::dmat4& from = skin.inverse_bind[to_index(joint_of(skin, work.from))];
  const int to = joint_of(skin, work.to);
  const glm::dmat4 at_rest = glm::inverse(rest[to_index(work.to)]) * rest[to_index(work.from)];
  if (is_usable(from)) work.to_from_from = to == kNone ? at_rest : skin.inverse_bind[to_index(to)] * glm::inverse(from);
  if (!is_usable(from) || !is_usable(work.to_from_from))
    throw tools::Failure(tools::Exit::invalid, scene.source, "/skins", "joint-without-volume",
                         work.rule->from + " or " + work.rule->to + " has no volume in the bind pose");
}

// Calls f(vertex, influence) for each influence of a joint.
void for_each_of(const RawScene& scene, const std::vector<std::size_t>& instances, int joint,
                 const std::function<void(const glm::dvec3&, const RawInfluence&)>& f) {
  for (const std::size_t i : instances)
    for (const RawPrimitive& p : scene.meshes[to_index(scene.instances[i].mesh)].primitives)
      for (std::size_t v = 0; v < p.influences.size(); ++v)
        for (const RawInfluence& influence : p.influences[v])
          if (influence.joint == static_cast<std::uint32_t>(joint) && influence.weight > 0)
            f(glm::dvec3(p.positions[v]), influence);
}

// Shares of the new joints in a vertex that follows `from`; what is left of 1 stays with that.
using Basis = std::function<void(const glm::dvec3& vertex, std::vector<double>& shares)>;

// Linear B-splines over the distance from the joint, from the nearest vertex to the farthest; or a bump about the
// joint `to`, (1 - r²)². Distances are those at rest.
Basis basis_of(const RawScene& scene, const RawSkin& skin, const std::vector<std::size_t>& instances,
               const std::vector<glm::dmat4>& rest, const Work& work) {
  const int joint = joint_of(skin, work.from);
  const glm::dmat4 joint_from_mesh = skin.inverse_bind[to_index(joint)];
  const glm::dmat3 scale(rest[to_index(work.from)]);
  const auto distance = [=](const glm::dvec3& vertex, const glm::dvec3& centre) {
    return glm::length(scale * (glm::dvec3(joint_from_mesh * glm::dvec4(vertex, 1)) - centre));
  };
  if (work.rule->radius_m > 0) {
    const glm::dvec3 centre(glm::inverse(work.to_from_from)[3]);
    const double radius = work.rule->radius_m;
    return [=](const glm::dvec3& vertex, std::vector<double>& shares) {
      const double r = std::min(distance(vertex, centre) / radius, 1.0);
      shares.assign(1, (1 - r * r) * (1 - r * r));
    };
  }
  const int count = work.rule->splines;
  double nearest = std::numeric_limits<double>::max(), farthest = 0;
  for_each_of(scene, instances, joint, [&](const glm::dvec3& vertex, const RawInfluence&) {
    const double d = distance(vertex, glm::dvec3(0));
    nearest = std::min(nearest, d);
    farthest = std::max(farthest, d);
  });
  return [=](const glm::dvec3& vertex, std::vector<double>& shares) {
    shares.assign(to_index(count), 0);
    const double way = farthest > nearest ? (distance(vertex, glm::dvec3(0)) - nearest) / (farthest - nearest) : 0;
    const double place = std::clamp(way, 0.0, 1.0) * (count - 1);
    const int below = std::min(static_cast<int>(place), std::max(count - 2, 0));
    if (count > 1) shares[to_index(below) + 1] = place - below;
    shares[to_index(below)] = count > 1 ? 1 - shares[to_index(below) + 1] : 1;
  };
}

void share_out(RawPrimitive& p, std::uint32_t from, std::uint32_t first_made, const Basis& basis) {
  std::vector<double> shares;
  for (std::size_t v = 0; v < p.influences.size(); ++v) {
    std::vector<RawInfluence> out;
    for (const RawInfluence& influence : p.influences[v]) {
      if (influence.joint != from || !(influence.weight > 0)) {
        out.push_back(influence);
        continue;
      }
      basis(glm::dvec3(p.positions[v]), shares);
      double left = 1;
      for (std::size_t b = 0; b < shares.size(); ++b) {
        left -= shares[b];
        const auto weight = static_cast<float>(static_cast<double>(influence.weight) * shares[b]);
        if (weight > 0) out.push_back({first_made + static_cast<std::uint32_t>(b), weight});
      }
      const auto stays = static_cast<float>(static_cast<double>(influence.weight) * left);
      if (stays > influence.weight * 1e-6F) out.push_back({from, stays});
    }
    p.influences[v] = std::move(out);
  }
}

// The meshes of a skin follow the new joints. A mesh that others draw too is copied.
void follow(const RawSkin& before, int skin_index, const std::vector<std::size_t>& instances,
            const std::vector<glm::dmat4>& rest, const Work& work, RawScene& scene) {
  const auto from = static_cast<std::uint32_t>(joint_of(before, work.from));
  const Basis basis = basis_of(scene, before, instances, rest, work);
  std::vector<int> copies(scene.meshes.size(), kNone);
  for (const std::size_t i : instances) {
    const int mesh = scene.instances[i].mesh;
    int& copy = copies[to_index(mesh)];
    if (copy == kNone) {
      const bool is_shared = std::ranges::any_of(
          scene.instances, [&](const RawInstance& other) { return other.mesh == mesh && other.skin != skin_index; });
      copy = is_shared ? static_cast<int>(scene.meshes.size()) : mesh;
      if (is_shared) scene.meshes.push_back(RawMesh(scene.meshes[to_index(mesh)]));
      for (RawPrimitive& p : scene.meshes[to_index(copy)].primitives)
        share_out(p, from, static_cast<std::uint32_t>(before.joints.size()), basis);
    }
    scene.instances[i].mesh = copy;
  }
}

Transform transform_of(const glm::dmat4& m) {
  Transform out;
  const glm::dmat3 rotation = deform::rotation_of(glm::dmat3(m));
  out.translation = glm::dvec3(m[3]);
  out.rotation = deform::quaternion_of(rotation);
  for (int i = 0; i < 3; ++i) out.scale[i] = glm::dot(rotation[i], glm::dvec3(m[i]));
  return out;
}

// From the identity to `all`, the turn by the side that is next to the one before.
Transform part_of(const Transform& all, double share, glm::dquat& before) {
  Transform out;
  const glm::dquat turn = glm::dot(all.rotation, before) < 0 ? -all.rotation : all.rotation;
  before = turn;
  out.translation = all.translation * share;
  out.rotation = glm::normalize(glm::dquat(1, 0, 0, 0) * (1 - share) + turn * share);
  out.scale = glm::dvec3(1 - share) + all.scale * share;
  return out;
}

double share_of(float value) {
  return std::clamp(static_cast<double>(value), 0.0, 1.0);
}

// The whole way from `from` to where it would be if it hung on `to`.
Transform whole_way(const RawScene& scene, const Work& work, const glm::dmat4& from, const glm::dmat4& to) {
  if (is_usable(from) && is_usable(to)) {
    const glm::dmat4 way = glm::inverse(from) * to * work.to_from_from;
    if (is_usable(way) && std::abs(way[3][0]) + std::abs(way[3][1]) + std::abs(way[3][2]) < 1e12)
      return transform_of(way);
  }
  throw tools::Failure(tools::Exit::invalid, scene.source, "/animations", "joint-without-volume",
                       work.rule->from + " or " + work.rule->to + " loses its volume, or goes too far away");
}

std::vector<float> key_times(const RawScalar* scalar, float first_s, float last_s) {
  std::vector<float> out;
  const double frames = std::floor((static_cast<double>(last_s) - static_cast<double>(first_s)) * kKeysPerSecond);
  if (!(frames < kMostKeys)) return {};
  for (double k = 0; k <= frames; ++k)
    out.push_back(static_cast<float>(static_cast<double>(first_s) + k / kKeysPerSecond));
  out.push_back(last_s);
  if (scalar != nullptr) out.insert(out.end(), scalar->times_s.begin(), scalar->times_s.end());
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

struct Keys {
  std::vector<float> times_s;
  std::vector<glm::vec4> translation, rotation, scale;

  void add(float time_s, const Transform& t) {
    times_s.push_back(time_s);
    translation.emplace_back(glm::vec3(t.translation), 0);
    rotation.emplace_back(static_cast<float>(t.rotation.x), static_cast<float>(t.rotation.y),
                          static_cast<float>(t.rotation.z), static_cast<float>(t.rotation.w));
    scale.emplace_back(glm::vec3(t.scale), 0);
  }
};

// The keys of a new joint in a clip; none if it stays with `from`.
Keys keys_of(const RawScene& scene, const RawClip& clip, const Work& work, const RawScalar* scalar, double rest) {
  if (scalar == nullptr && rest == 0) return {};
  const NodeMotion motion(scene, clip, {work.from, work.to});
  auto [first, last] = motion.range();
  if (scalar != nullptr) {
    first = std::min(first, scalar->times_s.front());
    last = std::max(last, scalar->times_s.back());
  }
  const std::vector<float> times_s = key_times(scalar, first, last);
  if (times_s.empty() || times_s.size() > kMostKeys / motion.step_count())
    throw tools::Failure(tools::Exit::unsupported, scene.source, "/animations", "too-many-keys",
                         "a clip that moves weights is too long for 60 keys a second");
  Keys out;
  glm::dquat before(1, 0, 0, 0);
  for (const float time_s : times_s) {
    const double share = scalar != nullptr ? share_of(value_at(*scalar, time_s)) : rest;
    const std::vector<glm::dmat4> at = motion.at(time_s);
    out.add(time_s, part_of(whole_way(scene, work, at[0], at[1]), share, before));
  }
  return out;
}

const RawScalar* scalar_of(const RawClip& clip, const std::string& name) {
  const auto at = std::ranges::find(clip.scalars, name, &RawScalar::name);
  return at == clip.scalars.end() || at->times_s.empty() ? nullptr : &*at;
}

// How the new joints move, and how they stand where no clip moves them.
void animate(const std::vector<glm::dmat4>& rest_matrices, const Work& work, RawScene& scene, Notes& notes) {
  bool driven = false;
  std::size_t keys_made = 0;
  const Transform rest_way =
      whole_way(scene, work, rest_matrices[to_index(work.from)], rest_matrices[to_index(work.to)]);
  for (std::size_t b = 0; b < work.made.size(); ++b) {
    const std::string name = channel_of(*work.rule, static_cast<int>(b));
    double rest = 0;
    for (const RawClip& clip : scene.clips)
      if (const RawScalar* const scalar = scalar_of(clip, name)) {
        rest = share_of(scalar->rest);
        driven = true;
      }
    glm::dquat before(1, 0, 0, 0);
    const Transform stands = part_of(rest_way, rest, before);
    RawNode& node = scene.nodes[to_index(work.made[b])];
    node.translation = stands.translation, node.rotation = stands.rotation, node.scale = stands.scale;
    for (RawClip& clip : scene.clips) {
      Keys keys = keys_of(scene, clip, work, scalar_of(clip, name), rest);
      keys_made += keys.times_s.size();
      if (keys_made > kMostNewKeys)
        throw tools::Failure(tools::Exit::unsupported, scene.source, "/animations", "too-many-keys",
                             "the clips that move weights are too long for 60 keys a second");
      if (keys.times_s.empty()) continue;
      const auto add = [&](RawPath path, std::vector<glm::vec4>& values) {
        clip.channels.push_back({work.made[b], path, RawInterpolation::linear, keys.times_s, std::move(values)});
      };
      add(RawPath::translation, keys.translation);
      add(RawPath::rotation, keys.rotation);
      add(RawPath::scale, keys.scale);
    }
  }
  if (!driven)
    notes.warnings.push_back({"/animations", "weights-never-move",
                              "no clip has the channel " + tools::printable(channel_of(*work.rule, 0)) +
                                  ": joints are made, and a game may turn them"});
}

void apply(const WeightsOverTime& rule, RawScene& scene, Notes& notes) {
  Work work{&rule, node_named(scene, rule.from, rule), node_named(scene, rule.to, rule), {}, glm::dmat4(1)};
  if (work.from == work.to) refuse(rule, "weights go from a joint to itself", "give two joints");
  const std::vector<glm::dmat4> rest = rest_of_nodes(scene);
  for (std::size_t s = 0; s < scene.skins.size(); ++s) {
    if (joint_of(scene.skins[s], work.from) == kNone) continue;
    std::vector<std::size_t> instances;
    for (std::size_t i = 0; i < scene.instances.size(); ++i)
      if (scene.instances[i].skin == static_cast<int>(s)) instances.push_back(i);
    if (instances.empty()) continue;
    if (work.made.empty()) {
      bind_joints(scene, scene.skins[s], rest, work);
      for (int b = 0; b < rule.splines; ++b) {
        RawNode node;
        node.name = rule.from + "/" + channel_of(rule, b);
        node.parent = work.from;
        if (std::ranges::find(scene.nodes, node.name, &RawNode::name) != scene.nodes.end())
          refuse(rule, "there is a joint " + node.name + " already", "give each channel of a joint once");
        node.in_scene = scene.nodes[to_index(work.from)].in_scene;
        work.made.push_back(static_cast<int>(scene.nodes.size()));
        scene.nodes.push_back(std::move(node));
      }
    }
    follow(RawSkin(scene.skins[s]), static_cast<int>(s), instances, rest, work, scene);
    RawSkin& skin = scene.skins[s];
    const glm::dmat4 bind_of_from = skin.inverse_bind[to_index(joint_of(skin, work.from))];
    for (const int node : work.made) {
      skin.joints.push_back(node);
      skin.inverse_bind.push_back(bind_of_from);
    }
  }
  if (work.made.empty()) refuse(rule, "no mesh follows " + rule.from, "name a joint that vertices have weights of");
  animate(rest, work, scene, notes);
}

}  // namespace

RawScene weights_over_time(RawScene scene, const std::vector<WeightsOverTime>& rules, Notes& notes) {
  for (const WeightsOverTime& rule : rules) apply(rule, scene, notes);
  return scene;
}

}  // namespace marrow::cook
