#include "cook/retarget/play_take.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "asset/format.h"
#include "common/elementary.h"
#include "common/failure.h"
#include "cook/clip/build_tracks.h"
#include "cook/motion/find_contacts.h"
#include "cook/motion/trace_clip.h"
#include "cook/retarget/plan/limbs.h"
#include "cook/retarget/plan/pair_rigs.h"
#include "cook/roles/name_words.h"

namespace marrow::cook {
namespace {

constexpr double kWholeTurn = 6.283185307179586;

struct Bones {
  Role upper, lower, end;
};
constexpr Bones kLimbs[] = {{Role::left_upper_arm, Role::left_lower_arm, Role::left_hand},
                            {Role::right_upper_arm, Role::right_lower_arm, Role::right_hand},
                            {Role::left_upper_leg, Role::left_lower_leg, Role::left_foot},
                            {Role::right_upper_leg, Role::right_lower_leg, Role::right_foot}};

// From `from` to `to`, in the space of `from` at rest.
glm::dvec3 way_in(const RetargetJoint& from, const glm::dvec3& to) {
  return glm::dvec3(glm::inverse(from.model_from_joint) * glm::dvec4(to, 1));
}

// The angle of a rotation about an axis, from minus half a turn to half a turn.
double twist_of(const glm::dquat& q, const glm::dvec3& axis) {
  const double angle = 2 * tools::angle_of(glm::dot(glm::dvec3(q.x, q.y, q.z), axis), q.w);
  return angle > kWholeTurn / 2 ? angle - kWholeTurn : angle < -kWholeTurn / 2 ? angle + kWholeTurn : angle;
}

struct Hands {
  Limb left, right;
  double scale = 1;  // lengths of the character's arms in those of the take's
};

constexpr double kNear = 0.5, kFar = 1;  // of an arm's length
constexpr int kSteps = 2;                // where one arm is too short the other goes farther

std::optional<Limb> arm_of(const BuiltSkeleton& skeleton, const RetargetPlan& plan, Role top, Role middle, Role end) {
  const int joints[] = {joint_with(skeleton, top), joint_with(skeleton, middle), joint_with(skeleton, end)};
  for (const int joint : joints)
    if (joint == kNone || !plan.joints[to_index(joint)].at.is_there()) return std::nullopt;
  if (std::ranges::find(skeleton.roles.soles, joints[2], &JointSole::joint) != skeleton.roles.soles.end())
    return std::nullopt;
  const Limb out = limb_of(plan.joints, to_index(joints[0]), joints[1], to_index(joints[2]));
  return out.middle == kNone ? std::nullopt : std::optional(out);
}

// By roles, where both arms have counterparts and no front legs are meant.
std::optional<Hands> find_hands(const BuiltSkeleton& skeleton, const RetargetPlan& plan, const Take& take) {
  const std::optional<Limb> left = arm_of(skeleton, plan, Role::left_upper_arm, Role::left_lower_arm, Role::left_hand);
  const std::optional<Limb> right =
      arm_of(skeleton, plan, Role::right_upper_arm, Role::right_lower_arm, Role::right_hand);
  if (!left || !right) return std::nullopt;
  const double own = length_of(plan, *left) + length_of(plan, *right);
  const double theirs = taken_length(plan, *left, take) + taken_length(plan, *right, take);
  if (!(own > 0) || !(theirs > 0)) return std::nullopt;
  return Hands{*left, *right, own / theirs};
}

// Bends the arms of a puppet that is posed so that the way from hand to hand is the take's, scaled; each hand goes half
// of it. This is so for hands that are less than half an arm apart, and fades until they are a whole one apart.
void meet_hands(const RetargetPlan& plan, const Hands& hands, const Take& take, Puppet& puppet) {
  const auto place = [&](std::size_t joint) { return take.place(plan.joints[joint].at); };
  const glm::dvec3 wanted = hands.scale * (plan.facing * (place(hands.left.end) - place(hands.right.end)));
  const double arm = (length_of(plan, hands.left) + length_of(plan, hands.right)) / 2;
  const double fade = std::clamp((kFar - glm::length(wanted) / arm) / (kFar - kNear), 0.0, 1.0);
  if (!(fade > 0)) return;
  const glm::dvec3 own = puppet.place(hands.left.end) - puppet.place(hands.right.end);
  const glm::dvec3 goal = own + fade * fade * (3 - 2 * fade) * (wanted - own);
  const auto bend = [&](const Limb& limb, const glm::dvec3& by) {
    const glm::dvec3 backwards =
        puppet.turns[limb.top] * glm::conjugate(plan.joints[limb.top].aligned) * plan.facing * glm::dvec3(0, 0, -1);
    reach(limb, puppet.place(limb.end) + by, backwards, length_of(plan, limb), puppet);
  };
  for (int step = 0; step < kSteps; ++step) {
    const glm::dvec3 off = goal - (puppet.place(hands.left.end) - puppet.place(hands.right.end));
    bend(hands.left, 0.5 * off);
    bend(hands.right, -0.5 * off);
    puppet.pose(plan);
  }
}

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

std::vector<FootSpans> taken_contacts(const BuiltSkeleton& rig, const RawClip& clip) {
  int last = kNone;
  for (const int node : rig.node_of_joint) last = std::max(last, node);
  for (const RawChannel& channel : clip.channels) last = std::max(last, channel.node);
  std::vector<int> joint_of_node(to_index(last + 1), kNone);
  for (std::size_t j = 0; j < rig.node_of_joint.size(); ++j)
    joint_of_node[to_index(rig.node_of_joint[j])] = static_cast<int>(j);
  const ClipTrace trace = trace_clip(build_tracks(clip, joint_of_node), rig, find_foot_points(rig, {}));
  if (!(trace.frame_s > 0)) return {};
  const Contacts contacts = find_contacts(trace);
  std::vector<FootSpans> out;
  for (std::size_t foot = 0; foot < trace.feet.size(); ++foot) {
    FootSpans& of = out.emplace_back();
    of.foot = trace.feet[foot].role;
    for (const Contact& span : contacts.spans) {
      if (span.foot != foot) continue;
      const double from = static_cast<double>(span.from) * trace.frame_s;
      const double to = static_cast<double>(span.to) * trace.frame_s;
      of.spans_s.emplace_back(from, std::min(to, trace.duration_s()));
      if (to > trace.duration_s()) of.spans_s.emplace_back(0, to - trace.duration_s());
    }
    std::ranges::sort(of.spans_s);
  }
  return out;
}

std::vector<TwistJoint> find_twists(const BuiltSkeleton& skeleton, const RetargetPlan& plan) {
  std::vector<TwistJoint> out;
  const auto add = [&](int bone, int end, bool is_upper) {
    if (bone == kNone || end == kNone || !plan.joints[to_index(bone)].at.is_there()) return;
    const RetargetJoint& of = plan.joints[to_index(bone)];
    if (plan.joints[to_index(end)].parent != bone || glm::determinant(of.model_from_joint) == 0) return;
    const glm::dvec3 whole = way_in(of, plan.joints[to_index(end)].place);
    const double length = glm::length(whole);
    if (!(length > 0)) return;
    for (std::size_t j = 0; j < plan.joints.size(); ++j) {
      const RetargetJoint& joint = plan.joints[j];
      if (joint.parent != bone || joint.at.is_there() || !words_of(skeleton.joint_names[j]).has(Word::twist)) continue;
      const double along = std::clamp(glm::dot(way_in(of, joint.place), whole) / (length * length), 0.0, 1.0);
      out.push_back({j, to_index(is_upper ? bone : end), whole / length, is_upper ? along - 1 : along});
    }
  };
  for (const Bones& limb : kLimbs) {
    const int lower = joint_with(skeleton, limb.lower);
    add(joint_with(skeleton, limb.upper), lower, true);
    add(lower, joint_with(skeleton, limb.end), false);
  }
  return out;
}

void twist(const RetargetPlan& plan, const std::vector<TwistJoint>& joints, Puppet& puppet) {
  for (const TwistJoint& of : joints) {
    const glm::dquat &rest = plan.joints[of.follows].rest.rotation, &now = puppet.local[of.follows];
    // In the bone's space: before an upper bone's own rotation, after a hand's.
    const glm::dquat turned = of.share < 0 ? glm::conjugate(rest) * now : now * glm::conjugate(rest);
    const double half = of.share * twist_of(turned, of.axis) / 2, sine = tools::sine(half);
    const glm::dquat by(tools::cosine(half), sine * of.axis.x, sine * of.axis.y, sine * of.axis.z);
    puppet.local[of.joint] = by * plan.joints[of.joint].rest.rotation;
    puppet.is_turned[of.joint] = 1;
  }
}

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
