#include "cook/retarget/play_take.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "asset/format.h"
#include "common/failure.h"
#include "cook/retarget/feet/hold_feet.h"
#include "cook/retarget/feet/level_feet.h"
#include "cook/retarget/feet/retarget_stand.h"
#include "cook/retarget/meet_hands.h"
#include "cook/retarget/plan/retarget_puppet.h"
#include "cook/retarget/twist_joints.h"

namespace marrow::cook {
namespace {

// Of each carried joint's legs and frames.
using Offsets = std::vector<std::vector<std::vector<glm::dvec3>>>;

// offsets: a leg.
FootGoals goals_of(const RetargetPlan& plan, const CarriedJoint& carried, const std::vector<glm::dvec3>& offsets,
                   const Take& take, const Puppet& puppet) {
  const Legs& legs = carried.legs;
  FootGoals out;
  out.ankle.assign(legs.tops.size(), std::numeric_limits<double>::infinity());
  out.lowest = out.ankle;
  for (const FootNode& node : legs.nodes) {
    const double height = carried.scale * (take.place(node.node).y - legs.ground[node.kind]);
    if (node.level == 0) out.ankle[node.leg] = std::min(out.ankle[node.leg], height);
    out.lowest[node.leg] = std::min(out.lowest[node.leg], height);
  }
  for (std::size_t leg = 0; leg < legs.tops.size(); ++leg) {
    const Limb& limb = legs.limbs[leg];
    out.place.push_back(ankle_at(plan, carried, leg, offsets[leg], take, puppet));
    out.knee.push_back(taken_bend(plan, limb, take));
  }
  return out;
}

// Where a carried joint goes in the scene, once all others are posed below its place at rest.
glm::dvec3 place_of(const RetargetPlan& plan, const CarriedJoint& carried, const std::vector<Sole>& soles,
                    const std::vector<glm::dvec3>& offsets, const Take& take, Puppet& puppet) {
  const Legs& legs = carried.legs;
  if (legs.tops.empty()) {
    const glm::dvec3 gone = take.place(plan.joints[carried.joint].at) - carried.taken_zero;
    return carried.zero + carried.scale * (plan.facing * gone);
  }
  const Middle middle = middle_of(plan, legs, take, puppet);
  glm::dvec3 shift = carried.zero + carried.scale * (plan.facing * (middle.taken - carried.taken_zero)) - middle.own;
  shift.y = stand(plan, legs, soles, goals_of(plan, carried, offsets, take, puppet), puppet);
  return puppet.place(carried.joint) + shift;
}

// False if a place comes out beyond what a file may hold.
bool carry(const RetargetPlan& plan, const std::vector<std::vector<Sole>>& soles, const Offsets& offsets,
           std::size_t frame, const Take& take, Puppet& puppet, TakenKeys& keys) {
  for (std::size_t c = 0; c < plan.carried.size(); ++c) {
    const CarriedJoint& carried = plan.carried[c];
    std::vector<glm::dvec3> now;
    for (const std::vector<glm::dvec3>& leg : offsets[c]) now.push_back(leg[frame]);
    puppet.put(plan, carried.joint, place_of(plan, carried, soles[c], now, take, puppet));
    puppet.pose(plan);
    const glm::dvec3& place = puppet.local_place[carried.joint];
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(place[axis]) <= double{format::kFarthest})) return false;
    keys.places[carried.joint].emplace_back(glm::vec3(place), 0.0F);
  }
  return true;
}

// Turns joints as their counterparts, and lets others rest.
void pose(const RetargetPlan& plan, const Take& take, Puppet& puppet) {
  std::ranges::fill(puppet.is_put, 0);
  for (std::size_t j = 0; j < plan.joints.size(); ++j) {
    const RetargetJoint& joint = plan.joints[j];
    puppet.is_turned[j] = joint.at.is_there() ? 1 : 0;
    if (joint.at.is_there()) puppet.wanted[j] = taken_turn(plan, joint, take) * joint.aligned;
  }
  puppet.pose(plan);
}

// Of the leg's foot; null where they are not known.
const FootSpans* contacts_of(const BuiltSkeleton& skeleton, const Limb& leg, const std::vector<FootSpans>& contacts) {
  const auto foot = std::ranges::find(skeleton.roles.roles, leg.end, &JointRole::joint);
  if (foot == skeleton.roles.roles.end()) return nullptr;
  const auto found = std::ranges::find(contacts, foot->role, &FootSpans::foot);
  return found == contacts.end() ? nullptr : &*found;
}

bool is_within(const FootSpans& spans, double time_s) {
  return std::ranges::any_of(spans.spans_s, [&](const auto& s) { return s.first <= time_s && time_s <= s.second; });
}

Offsets find_offsets(const BuiltSkeleton& skeleton, const RetargetPlan& plan, const std::vector<FootSpans>& contacts,
                     Take& take, Puppet& puppet) {
  std::vector<std::vector<std::vector<FootFrame>>> frames(plan.carried.size());
  for (std::size_t c = 0; c < frames.size(); ++c) frames[c].resize(plan.carried[c].legs.tops.size());
  for (std::size_t frame = 0; frame < take.times_s().size(); ++frame) {
    take.pose(frame);
    pose(plan, take, puppet);
    for (std::size_t c = 0; c < frames.size(); ++c)
      for (std::size_t leg = 0; leg < frames[c].size(); ++leg) {
        const CarriedJoint& of = plan.carried[c];
        const FootSpans* const spans = contacts_of(skeleton, of.legs.limbs[leg], contacts);
        const bool stands =
            spans != nullptr ? is_within(*spans, double{take.times_s()[frame]}) : touches(of, leg, take);
        frames[c][leg].push_back({offset_of(plan, of, leg, take, puppet), stands});
      }
  }
  Offsets out(frames.size());
  for (std::size_t c = 0; c < frames.size(); ++c)
    for (const std::vector<FootFrame>& leg : frames[c]) out[c].push_back(held(leg, plan.carried[c].legs.mean_length()));
  return out;
}

// With the sign that is next to the key before it. False: it is no number.
bool add_rotation(const glm::dquat& q, std::vector<glm::vec4>& keys) {
  const glm::vec4 key(glm::dvec4(q.x, q.y, q.z, q.w));
  keys.push_back(!keys.empty() && glm::dot(keys.back(), key) < 0 ? -key : key);
  return std::isfinite(glm::dot(key, key));
}

bool add_rotations(const Puppet& puppet, std::vector<char>& turns, TakenKeys& keys) {
  bool good = true;
  for (std::size_t j = 0; j < turns.size(); ++j) {
    turns[j] = static_cast<char>(turns[j] | puppet.is_turned[j]);
    good = add_rotation(puppet.local[j], keys.turns[j]) && good;
  }
  return good;
}

}  // namespace

TakenKeys play_take(const BuiltSkeleton& skeleton, RetargetPlan& plan, Take& take,
                    const std::vector<FootSpans>& contacts, const std::vector<Mesh>& meshes, const std::string& file) {
  Puppet puppet(plan.joints.size());
  TakenKeys keys{std::vector<std::vector<glm::vec4>>(plan.joints.size()), {}};
  keys.places = keys.turns;
  std::vector<char> turns(plan.joints.size(), 0);  // ever
  const std::optional<Hands> hands = find_hands(skeleton, plan, take);
  const std::vector<TwistJoint> twists = find_twists(skeleton, plan);
  std::vector<std::vector<Sole>> soles(plan.carried.size());
  for (std::size_t c = 0; c < soles.size(); ++c) {
    Legs& legs = plan.carried[c].legs;
    if (legs.tops.empty()) continue;
    find_stance(plan, take, legs);
    soles[c] = find_soles(plan, legs, meshes);
  }
  const Offsets offsets = find_offsets(skeleton, plan, contacts, take, puppet);
  for (std::size_t frame = 0; frame < take.times_s().size(); ++frame) {
    take.pose(frame);
    pose(plan, take, puppet);
    if (hands) meet_hands(plan, *hands, take, puppet);
    const bool good = carry(plan, soles, offsets, frame, take, puppet, keys);
    twist(plan, twists, puppet);
    if (!add_rotations(puppet, turns, keys) || !good)
      throw tools::Failure(
          tools::Exit::invalid, take.scene().source, take.scene().is_capture ? "MOTION" : "/animations",
          "a place beyond 1e12",
          "in frame " + std::to_string(frame + 1) + ", at the size of " + file + "; check the lengths of the legs");
  }
  for (std::size_t j = 0; j < turns.size(); ++j)
    if (turns[j] == 0) keys.turns[j].clear();
  return keys;
}

}  // namespace marrow::cook
