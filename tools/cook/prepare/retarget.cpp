#include "cook/prepare/retarget.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "asset/format.h"
#include "common/failure.h"
#include "cook/prepare/pair_joints.h"
#include "cook/prepare/retarget/retarget_plan.h"
#include "cook/prepare/retarget/retarget_puppet.h"
#include "cook/prepare/retarget/retarget_stand.h"
#include "cook/scene/matrices.h"
#include "text/nearest.h"

namespace marrow::cook {
namespace {

constexpr std::uint64_t kFewPoses = 1u << 22;
// A foot stands while it is not higher than so much of a leg's length above its lowest; what it is tilted then by up to
// twice the angle is how it rests.
constexpr double kStands = 0.02, kCosineOf12Degrees = 0.9781476007338057;
constexpr double kUnturned = 1 - 1e-9;  // of the cosine of half an angle

struct Pairing {
  int skeleton = kNone;
  std::vector<int> node_of_joint;
};

Pairing pair(const Character& character, const RawScene& capture, Notes& notes) {
  const std::vector<int>& joints = capture.skins.at(0).joints;
  std::vector<std::string> names;
  for (const int node : joints) names.push_back(capture.nodes[to_index(node)].name);
  Pairing out;
  std::ptrdiff_t most = 0;
  for (std::size_t s = 0; s < character.skeletons.size(); ++s) {
    std::vector<int> found = pair_joints(character.skeletons[s].joint_names, names);
    const auto count = static_cast<std::ptrdiff_t>(found.size()) - std::ranges::count(found, kNone);
    if (count <= most) continue;
    most = count;
    out = {static_cast<int>(s), std::move(found)};
  }
  if (most == 0)
    throw tools::Failure(tools::Exit::invalid, capture.source, "HIERARCHY",
                         "no joint is called as in " + character.file,
                         "rename joints: here are " + tools::listed(names) + "; there are " +
                             tools::listed(character.skeletons.at(0).joint_names));
  std::vector<char> used(names.size(), 0);
  for (int& node : out.node_of_joint) {
    if (node == kNone) continue;
    used[to_index(node)] = 1;
    node = joints[to_index(node)];
  }
  std::vector<std::string> strangers;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (used[i] == 0) strangers.push_back(names[i]);
  if (!strangers.empty())
    notes.warnings.push_back({"HIERARCHY", "no-such-joint",
                              std::to_string(strangers.size()) + " of " + std::to_string(names.size()) +
                                  " joints have no counterpart in " + character.file +
                                  " and are left out: " + tools::listed(strangers)});
  return out;
}

// A file of two megabytes can have 32767 joints and a million frames of one channel.
void check_size(const RawScene& capture, std::size_t joints) {
  const std::uint64_t frames = capture.clips.at(0).channels.at(0).times_s.size();
  if ((capture.nodes.size() + joints) * frames > std::max(8 * capture.source_bytes, kFewPoses))
    throw tools::Failure(tools::Exit::unsupported, capture.source, "MOTION", "too many frames for so few channels",
                         "split the take, or leave out joints without channels");
}

// The capture's nodes in the scene, at a frame.
struct Capture {
  const std::vector<RawNode>* nodes;
  std::vector<const RawChannel*> turn_keys, place_keys;  // a node; null: as at rest
  std::vector<glm::dquat> turns;
  std::vector<glm::dvec3> places;
};

Capture open_capture(const RawScene& scene) {
  const std::size_t size = scene.nodes.size();
  Capture out{&scene.nodes, {}, {}, std::vector<glm::dquat>(size), std::vector<glm::dvec3>(size)};
  out.turn_keys.resize(size);
  out.place_keys.resize(size);
  for (const RawChannel& channel : scene.clips.at(0).channels)
    (channel.path == RawPath::rotation ? out.turn_keys : out.place_keys)[to_index(channel.node)] = &channel;
  return out;
}

void pose(Capture& c, std::size_t frame) {
  for (std::size_t n = 0; n < c.turns.size(); ++n) {
    const RawNode& node = (*c.nodes)[n];
    c.turns[n] = {1, 0, 0, 0};
    if (c.turn_keys[n] != nullptr) {
      const glm::dvec4 key(c.turn_keys[n]->values[frame]);
      c.turns[n] = glm::normalize(glm::dquat(key.w, key.x, key.y, key.z));
    }
    c.places[n] = c.place_keys[n] == nullptr ? node.translation : glm::dvec3(c.place_keys[n]->values[frame]);
    if (node.parent == kNone) continue;
    const std::size_t up = to_index(node.parent);
    c.places[n] = c.places[up] + c.turns[up] * c.places[n];
    c.turns[n] = c.turns[up] * c.turns[n];
  }
}

// The keys that joints have got.
struct CapturedKeys {
  std::vector<std::vector<glm::vec4>> turns, places;
};

// Where the character of a joint stands.
glm::dvec3 origin_of(const RetargetPlan& plan, std::size_t joint) {
  while (plan.joints[joint].parent != kNone) joint = to_index(plan.joints[joint].parent);
  return glm::dvec3(plan.joints[joint].scene_above[3]);
}

// The rotation of a joint's counterpart, as the character faces.
glm::dquat captured_turn(const RetargetPlan& plan, const RetargetJoint& joint, const Capture& capture) {
  return plan.facing * capture.turns[to_index(joint.node)] * glm::conjugate(plan.facing);
}

FootHeights heights_above_ground(const CarriedJoint& carried, const Capture& capture) {
  FootHeights out;
  out.ankle.assign(carried.legs.tops.size(), std::numeric_limits<double>::infinity());
  out.lowest = out.ankle;
  for (const FootNode& node : carried.legs.nodes) {
    const double height = carried.scale * (capture.places[node.node].y - carried.legs.ground[node.level]);
    if (node.level == 0) out.ankle[node.leg] = std::min(out.ankle[node.leg], height);
    out.lowest[node.leg] = std::min(out.lowest[node.leg], height);
  }
  return out;
}

// Where a carried joint goes in the scene, once all others are posed below its place at rest.
glm::dvec3 place_of(const RetargetPlan& plan, const CarriedJoint& carried, const std::vector<Sole>& soles,
                    const Capture& capture, Puppet& puppet) {
  const auto captured = [&](std::size_t joint) { return capture.places[to_index(plan.joints[joint].node)]; };
  const glm::dvec3 origin = origin_of(plan, carried.joint);
  const Legs& legs = carried.legs;
  if (legs.tops.empty()) return origin + carried.scale * (plan.facing * captured(carried.joint));
  glm::dvec3 middle(0), captured_middle(0);
  for (const std::size_t top : legs.tops) {
    middle += puppet.place(top);
    captured_middle += captured(top);
  }
  const auto count = static_cast<double>(legs.tops.size());
  glm::dvec3 shift = origin + carried.scale * (plan.facing * captured_middle / count) - middle / count;
  shift.y = stand(plan, legs, soles, heights_above_ground(carried, capture), puppet);
  return puppet.place(carried.joint) + shift;
}

// False if a place comes out beyond what a file may hold.
bool carry(const RetargetPlan& plan, const std::vector<std::vector<Sole>>& soles, const Capture& capture,
           Puppet& puppet, CapturedKeys& keys) {
  for (std::size_t c = 0; c < plan.carried.size(); ++c) {
    const CarriedJoint& carried = plan.carried[c];
    const RetargetJoint& joint = plan.joints[carried.joint];
    const glm::dmat4& above =
        joint.parent == kNone ? joint.scene_above : puppet.model_from_joint[to_index(joint.parent)];
    const glm::dvec3 place(glm::inverse(above) * glm::dvec4(place_of(plan, carried, soles[c], capture, puppet), 1));
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(place[axis]) <= double{format::kFarthest})) return false;
    keys.places[carried.joint].emplace_back(glm::vec3(place), 0.0F);
  }
  return true;
}

// Turns joints as their counterparts, and lets others rest.
void pose(const RetargetPlan& plan, const Capture& capture, Puppet& puppet) {
  for (std::size_t j = 0; j < plan.joints.size(); ++j) {
    const RetargetJoint& joint = plan.joints[j];
    puppet.is_turned[j] = joint.node != kNone ? 1 : 0;
    if (joint.node != kNone) puppet.wanted[j] = captured_turn(plan, joint, capture) * joint.aligned;
  }
  puppet.pose(plan);
}

// How high the nodes of each captured foot are in the mean.
std::vector<double> heights_of(const Legs& legs, const Capture& capture) {
  std::vector<double> heights(legs.tops.size(), 0), count(legs.tops.size(), 0);
  for (const FootNode& node : legs.nodes) {
    heights[node.leg] += capture.places[node.node].y;
    ++count[node.leg];
  }
  for (std::size_t leg = 0; leg < heights.size(); ++leg) heights[leg] /= count[leg];
  return heights;
}

// Where the capture's feet are lowest in the clip: a leg. Finds the ground as well.
std::vector<double> find_lowest(Capture& capture, std::size_t frames, Legs& legs) {
  std::vector<double> nodes(legs.ground.size(), std::numeric_limits<double>::infinity());
  std::vector<double> feet(legs.tops.size(), std::numeric_limits<double>::infinity());
  for (std::size_t frame = 0; frame < frames; ++frame) {
    pose(capture, frame);
    for (const FootNode& node : legs.nodes)
      nodes[node.level] = std::min(nodes[node.level], capture.places[node.node].y);
    const std::vector<double> heights = heights_of(legs, capture);
    for (std::size_t leg = 0; leg < feet.size(); ++leg) feet[leg] = std::min(feet[leg], heights[leg]);
  }
  find_ground(legs, std::move(nodes));
  return feet;
}

// The turn about y in a rotation.
glm::dquat heading_of(const glm::dquat& q) {
  const double length = std::sqrt(q.w * q.w + q.y * q.y);
  return length > 0 ? glm::dquat(q.w / length, 0, q.y / length, 0) : glm::dquat(1, 0, 0, 0);
}

glm::dquat arc_of(const RetargetJoint& joint) {
  return joint.aligned * glm::conjugate(joint.turn);
}

// Whether an ankle and the bone above it rest as in the capture.
bool rests_alike(const RetargetPlan& plan, std::size_t ankle) {
  const RetargetJoint& joint = plan.joints[ankle];
  return std::min(std::abs(arc_of(joint).w), std::abs(arc_of(plan.joints[to_index(joint.upper)]).w)) > kUnturned;
}

// Where a captured foot stands, the character's stands as at rest: the capture's soles may not be level at rest.
void level_feet(RetargetPlan& plan, Capture& capture, std::size_t frames, Legs& legs) {
  const std::vector<double> lowest = find_lowest(capture, frames, legs);
  const double near = kStands * legs.captured_length / static_cast<double>(legs.tops.size());
  std::vector<glm::dquat> sums(legs.feet.size(), glm::dquat(0, 0, 0, 0));
  for (std::size_t frame = 0; frame < frames; ++frame) {
    pose(capture, frame);
    const std::vector<double> heights = heights_of(legs, capture);
    for (std::size_t f = 0; f < sums.size(); ++f) {
      const FootJoint& foot = legs.feet[f];
      if (heights[foot.leg] > lowest[foot.leg] + near) continue;
      const RetargetJoint& joint = plan.joints[foot.joint];
      const glm::dquat turn = captured_turn(plan, joint, capture);
      const glm::dquat arc = arc_of(joint);
      const glm::dquat level = glm::conjugate(turn) * heading_of(turn * arc);
      sums[f] = sums[f] + (glm::dot(level, arc) < 0 ? -level : level);
    }
  }
  std::vector<char> keeps(legs.tops.size(), 0);
  for (const FootJoint& foot : legs.feet)
    if (foot.level == 0) keeps[foot.leg] = rests_alike(plan, foot.joint) ? 1 : 0;
  for (std::size_t f = 0; f < sums.size(); ++f) {
    RetargetJoint& joint = plan.joints[legs.feet[f].joint];
    const glm::dquat level = glm::normalize(sums[f]);
    if (keeps[legs.feet[f].leg] == 0 && glm::dot(level, arc_of(joint)) >= kCosineOf12Degrees)
      joint.aligned = level * joint.turn;
  }
}

// With the sign that is next to the key before it.
void add_rotation(const glm::dquat& q, std::vector<glm::vec4>& keys) {
  const glm::vec4 key(glm::dvec4(q.x, q.y, q.z, q.w));
  keys.push_back(!keys.empty() && glm::dot(keys.back(), key) < 0 ? -key : key);
}

CapturedKeys play(RetargetPlan& plan, const RawScene& scene, const Character& character,
                  const std::vector<Mesh>& meshes) {
  Capture capture = open_capture(scene);
  Puppet puppet(plan.joints.size());
  CapturedKeys keys{std::vector<std::vector<glm::vec4>>(plan.joints.size()), {}};
  keys.places = keys.turns;
  std::vector<char> turns(plan.joints.size(), 0);  // ever
  const std::size_t frames = scene.clips.at(0).channels.at(0).times_s.size();
  std::vector<std::vector<Sole>> soles(plan.carried.size());
  for (std::size_t c = 0; c < soles.size(); ++c) {
    Legs& legs = plan.carried[c].legs;
    if (legs.tops.empty()) continue;
    level_feet(plan, capture, frames, legs);
    soles[c] = find_soles(plan, legs, meshes);
  }
  for (std::size_t frame = 0; frame < frames; ++frame) {
    pose(capture, frame);
    pose(plan, capture, puppet);
    if (!carry(plan, soles, capture, puppet, keys))
      throw tools::Failure(tools::Exit::invalid, scene.source, "MOTION", "a place beyond 1e12",
                           "in frame " + std::to_string(frame + 1) + ", at the size of " + character.file +
                               "; check the offsets of the legs");
    for (std::size_t j = 0; j < turns.size(); ++j) {
      turns[j] = static_cast<char>(turns[j] | puppet.is_turned[j]);
      add_rotation(puppet.local[j], keys.turns[j]);
    }
  }
  for (std::size_t j = 0; j < turns.size(); ++j)
    if (turns[j] == 0) keys.turns[j].clear();
  return keys;
}

// The character's joints as a scene, which they move.
Matched match(const Pairing& pairing, const RetargetPlan& plan, const Character& character, CapturedKeys keys,
              RawScene scene) {
  Matched out;
  out.built.skeletons = character.skeletons;
  RawClip& clip = scene.clips.at(0);
  const std::vector<float> times_s = clip.channels.at(0).times_s;
  clip.channels.clear();
  scene.nodes.clear();
  scene.skins.clear();
  for (std::size_t j = 0; j < plan.joints.size(); ++j) {
    const auto add = [&](RawPath path, std::vector<glm::vec4>& values) {
      if (!values.empty())
        clip.channels.push_back({static_cast<int>(j), path, RawInterpolation::linear, times_s, std::move(values)});
    };
    add(RawPath::translation, keys.places[j]);
    add(RawPath::rotation, keys.turns[j]);
    RawNode& node = scene.nodes.emplace_back();
    node.name = character.skeletons[to_index(pairing.skeleton)].joint_names[j];
    node.parent = plan.joints[j].parent;
    out.built.joint_of_node.push_back(static_cast<int>(j));
    out.built.nearest.push_back({pairing.skeleton, static_cast<int>(j), glm::dmat4(1.0)});
  }
  out.scene = std::move(scene);
  return out;
}

}  // namespace

Matched retarget(const Character& character, RawScene capture, Notes& notes) {
  expect_skeletons(character);
  const Pairing pairing = pair(character, capture, notes);
  check_size(capture, pairing.node_of_joint.size());
  RetargetPlan plan = plan_retarget(character.skeletons[to_index(pairing.skeleton)], pairing.node_of_joint, capture);
  if (plan.facing_deg != 0)
    notes.warnings.push_back({"HIERARCHY", "turned",
                              character.file + " faces another way at rest; the clip is turned about y by " +
                                  std::to_string(plan.facing_deg) + " degrees"});
  std::vector<Mesh> meshes;
  for (const Mesh& mesh : character.meshes)
    if (mesh.skeleton == to_index(pairing.skeleton)) meshes.push_back(mesh);
  CapturedKeys keys = play(plan, capture, character, meshes);
  return match(pairing, plan, character, std::move(keys), std::move(capture));
}

}  // namespace marrow::cook
