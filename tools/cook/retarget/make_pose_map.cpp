#include "cook/retarget/make_pose_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "asset/format.h"
#include "asset/skeleton_hash.h"
#include "common/failure.h"
#include "cook/retarget/plan/retarget_plan.h"
#include "marrow/roles.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kMostSteps = 1u << 20;
constexpr double kSameTurn = 1e-6;

std::uint64_t hash_of_joints(const BuiltSkeleton& skeleton) {
  Fnv64 hash;
  for (std::size_t j = 0; j < skeleton.parents.size(); ++j)
    add_joint(hash, skeleton.joint_names[j].c_str(), skeleton.parents[j], skeleton.rest.data(), j);
  return hash.value();
}

// Which joints move from their places.
std::vector<std::size_t> carried_joints(const BuiltSkeleton& skeleton, const std::vector<Counterpart>& pairs) {
  const std::vector<RetargetJoint> joints = lay_out(skeleton, pairs);
  std::vector<std::size_t> out;
  if (const int hips = joint_with(skeleton, Role::hips); hips != kNone && pairs[to_index(hips)].is_there()) {
    for (int joint = hips; joint != kNone; joint = joints[to_index(joint)].upper) out.push_back(to_index(joint));
    std::ranges::reverse(out);
    return out;
  }
  std::vector<std::size_t> root(joints.size()), count(joints.size(), 0);  // of a tree its topmost pairs
  const auto is_topmost = [&](std::size_t j) { return joints[j].at.is_there() && joints[j].upper == kNone; };
  for (std::size_t j = 0; j < joints.size(); ++j) {
    root[j] = joints[j].parent == kNone ? j : root[to_index(joints[j].parent)];
    if (is_topmost(j)) ++count[root[j]];
  }
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (is_topmost(j) && count[root[j]] == 1) out.push_back(j);
  return out;
}

// One of the joints of the rig that a joint turns as; kNone: what is above the rig's root.
struct WeighedJoint {
  int joint = kNone;
  double weight = 1;
};

std::vector<WeighedJoint> joints_at(const Counterpart& at) {
  if (at.other == kNone || at.share < double{format::kLeastTurnWeight}) return {{at.node, 1}};
  if (at.share > 1 - double{format::kLeastTurnWeight}) return {{at.other, 1}};
  return {{at.node, 1 - at.share}, {at.other, at.share}};
}

class PoseMapMaker {
 public:
  PoseMapMaker(const Character& character, const RawScene& source, const RigPairing& pairing)
      : source_(source),
        pairs_(pairing.pairs),
        rig_(lay_out(pairing.rig_skeleton, std::vector<Counterpart>(pairing.rig_skeleton.parents.size()))),
        take_(source),
        plan_(plan_carrying(carried_joints(character.skeletons[pairing.skeleton], pairing.pairs),
                            character.skeletons[pairing.skeleton], pairing.rig_skeleton, nodes_of_pairs(pairing),
                            take_)),
        puppet_(plan_.joints.size()) {
    // As the rig rests.
    for (std::size_t j = 0; j < plan_.joints.size(); ++j) {
      puppet_.is_turned[j] = pairs_[j].is_there() ? 1 : 0;
      puppet_.wanted[j] = plan_.joints[j].aligned;
    }
    puppet_.pose(plan_);
    for (const RetargetJoint& joint : rig_)
      depth_.push_back(joint.parent == kNone ? 0 : depth_[to_index(joint.parent)] + 1);
    for (const RetargetJoint& joint : plan_.joints)
      if (joint.at.is_there()) lowest_ = std::min(lowest_, take_.rest(joint.at).y);
  }

  void add_turns() {
    out_.groups.resize(soa_count(pairs_.size()));
    for (std::size_t j = 0; j < 4 * out_.groups.size(); ++j) set_group(j, {1, 0, 0, 0}, {1, 0, 0, 0}, kNoJoint);
    for (std::size_t j = 0; j < pairs_.size(); ++j) {
      set_group(j, plan_.joints[j].rest.rotation, {1, 0, 0, 0}, kNoJoint);
      if (!pairs_[j].is_there()) continue;
      const int upper = plan_.joints[j].upper;
      const std::vector<WeighedJoint> above =
          upper == kNone ? std::vector<WeighedJoint>{{}} : joints_at(pairs_[to_index(upper)]);
      for (const WeighedJoint& from : above)
        for (const WeighedJoint& to : joints_at(pairs_[j]))
          if (from.weight * to.weight >= double{format::kLeastTurnWeight})
            add_turn(j, from.joint, to.joint, from.weight * to.weight);
      take_alone(j);
    }
  }

  void add_places() {
    for (const CarriedJoint& carried : plan_.carried) add_place(carried);
  }

  int facing_deg() const { return plan_.facing_deg; }
  BuiltPoseMap take() { return std::move(out_); }

 private:
  [[noreturn]] void fail(tools::Exit code, const std::string& rule, const std::string& advice) const {
    throw tools::Failure(code, source_.source, source_.is_capture ? "HIERARCHY" : "/nodes", rule, advice);
  }
  std::size_t root_of(int joint) const {
    while (rig_[to_index(joint)].parent != kNone) joint = rig_[to_index(joint)].parent;
    return to_index(joint);
  }
  int parent_of(int joint) const { return joint == kNone ? kNone : rig_[to_index(joint)].parent; }

  // The way down to a joint from below one at or above it; from the root for kNone. False: that is not above it.
  bool way_down(int above, int joint, std::vector<int>& out) const {
    out.clear();
    for (; joint != above && joint != kNone; joint = parent_of(joint)) out.push_back(joint);
    std::ranges::reverse(out);
    return joint == above;
  }
  void add_step(int joint, bool is_inverse, bool is_mirrored) {
    if (out_.steps.size() >= kMostSteps)
      fail(tools::Exit::unsupported, "joints too far apart", "a map has a million steps from joint to joint at most");
    out_.steps.push_back({static_cast<std::uint16_t>(joint), static_cast<std::uint8_t>(is_inverse ? 1 : 0),
                          static_cast<std::uint8_t>(is_mirrored ? 1 : 0)});
  }

  // Up from `from`, as far as there is a way down to `to`. Returns how many steps.
  std::size_t add_way(int from, int to, bool is_in_mirror) {
    const std::size_t before = out_.steps.size();
    const auto differs = [&](int joint) { return rig_[to_index(joint)].is_in_mirror != is_in_mirror; };
    const auto depth = [&](int joint) { return joint == kNone ? -1 : depth_[to_index(joint)]; };
    int top = from;
    std::vector<int> down;
    for (int low = to; top != low;) {
      if (depth(top) > depth(low)) {
        add_step(top, true, differs(top));
        top = parent_of(top);
      } else {
        down.push_back(low);
        low = parent_of(low);
      }
    }
    if (from != kNone && top == kNone) check_roots(from, to);
    for (auto joint = down.rbegin(); joint != down.rend(); ++joint) add_step(*joint, false, differs(*joint));
    return out_.steps.size() - before;
  }
  void check_roots(int a, int b) const {
    const glm::dquat &one = rig_[root_of(a)].turn_above, &other = rig_[root_of(b)].turn_above;
    if (std::abs(glm::dot(one, other)) < 1 - kSameTurn)
      fail(tools::Exit::unsupported, "roots that are turned otherwise", "hang the rig's roots on one node");
  }

  void add_turn(std::size_t j, int from, int to, double weight) {
    const RetargetJoint& joint = plan_.joints[j];
    const glm::dquat& above = joint.parent == kNone ? joint.turn_above : puppet_.turns[to_index(joint.parent)];
    const glm::dquat start = from == kNone ? rig_[root_of(to)].turn_above : rig_[to_index(from)].turn;
    glm::dquat before = glm::conjugate(above) * plan_.facing * start;
    glm::dquat after = glm::conjugate(plan_.facing * rig_[to_index(to)].turn) * puppet_.turns[j];
    if (joint.is_in_mirror) {
      before = in_mirrored(before);
      after = in_mirrored(after);
    }
    const std::size_t steps = add_way(from, to, joint.is_in_mirror);
    turns_.push_back({{glm::normalize(before), glm::normalize(after)}, steps, weight});
  }
  // The turns of a joint: one of one step or none goes into its group, where it is quicker.
  void take_alone(std::size_t j) {
    const Turn& first = turns_.front();
    const RigStep* const step = first.steps == 1 ? &out_.steps.back() : nullptr;
    const bool is_plain = step == nullptr || (step->inverse == 0 && step->mirrored == 0);
    if (turns_.size() == 1 && first.steps < 2 && is_plain) {
      set_group(j, first.before_after[0], first.before_after[1], step == nullptr ? kNoJoint : step->joint);
      if (step != nullptr) out_.steps.pop_back();
    } else {
      for (const Turn& of : turns_) {
        MappedTurn turn;
        turn.joint = static_cast<std::uint16_t>(j);
        turn.step_count = static_cast<std::uint16_t>(of.steps);
        turn.weight = static_cast<float>(of.weight);
        for (int i = 0; i < 4; ++i) {
          turn.before[i] = component(of.before_after[0], i);
          turn.after[i] = component(of.before_after[1], i);
        }
        out_.turns.push_back(turn);
      }
    }
    turns_.clear();
  }
  void set_group(std::size_t j, const glm::dquat& before, const glm::dquat& after, std::uint16_t rig_joint) {
    MappedGroup& group = out_.groups[j / 4];
    for (int i = 0; i < 4; ++i) {
      group.before[i][j % 4] = component(before, i);
      group.after[i][j % 4] = component(after, i);
    }
    group.rig_joints[j % 4] = rig_joint;
  }
  // x, y, z or w.
  float component(const glm::dquat& q, int i) const {
    const double value = i == 0 ? q.x : i == 1 ? q.y : i == 2 ? q.z : q.w;
    if (!std::isfinite(value))
      fail(tools::Exit::invalid, "a joint that is turned nohow", "check the scales of nodes above the skeleton");
    return static_cast<float>(value) + 0.0f;
  }

  // Whether the rig's lowest paired joint is so far below the ground, and this one so near it, that it rests hung up.
  bool hangs_from_ground(std::size_t joint) const {
    const double height = take_.rest(plan_.joints[joint].at).y, half = 0.5 * (height - lowest_);
    return lowest_ < -half && height < half;
  }
  void add_place(const CarriedJoint& carried) {
    const RetargetJoint& joint = plan_.joints[carried.joint];
    const int to = pairs_[carried.joint].node, from = joint.upper == kNone ? kNone : pairs_[to_index(joint.upper)].node;
    std::vector<int> way;
    if (!way_down(from, to, way) || way.empty()) return;
    glm::dvec3 rest(0);  // where the last is, in the space above the first
    for (auto step = way.rbegin(); step != way.rend(); ++step)
      rest = glm::dvec3(matrix_of(rig_[to_index(*step)].rest) * glm::dvec4(rest, 1));
    const glm::dmat4 parent =
        joint.parent == kNone ? joint.scene_above : puppet_.model_from_joint[to_index(joint.parent)];
    const glm::dmat3 turned = carried.scale * glm::mat3_cast(plan_.facing);
    glm::dmat4 map(1.0);
    if (from == kNone) {
      const bool is_where_it_says = source_.is_capture || hangs_from_ground(carried.joint);
      const glm::dmat4& above = rig_[root_of(to)].scene_above;
      const glm::dvec3 zero = is_where_it_says ? origin_of(plan_.joints, carried.joint) : joint.place;
      const glm::dvec3 taken_zero = is_where_it_says ? glm::dvec3(0) : glm::dvec3(above * glm::dvec4(rest, 1));
      map = glm::inverse(parent) * glm::translate(glm::dmat4(1.0), zero) * glm::dmat4(turned) *
            glm::translate(glm::dmat4(1.0), -taken_zero) * above;
    } else {
      const glm::dmat3 linear =
          glm::inverse(glm::dmat3(parent)) * turned * glm::dmat3(rig_[to_index(from)].model_from_joint);
      map = glm::dmat4(linear);
      map[3] = glm::dvec4(joint.rest.translation - linear * rest, 1);
    }
    MappedPlace place;
    place.joint = static_cast<std::uint16_t>(carried.joint);
    place.step_count = static_cast<std::uint16_t>(way.size());
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) {
        if (!(std::abs(map[column][row]) <= double{format::kFarthest}))
          fail(tools::Exit::invalid, "a place beyond 1e12", "check the lengths of the legs, and scales");
        place.parent_from_rig[row][column] = static_cast<float>(map[column][row]) + 0.0f;
      }
    for (const int step : way) add_step(step, false, false);
    out_.places.push_back(place);
  }

  const RawScene& source_;
  const std::vector<Counterpart>& pairs_;  // counterparts are joints of the rig
  std::vector<RetargetJoint> rig_;
  Take take_;
  RetargetPlan plan_;
  Puppet puppet_;
  struct Turn {
    glm::dquat before_after[2];
    std::size_t steps;
    double weight;
  };
  std::vector<Turn> turns_;  // of one joint
  std::vector<int> depth_;   // of the rig's joints
  double lowest_ = 0;        // of the rig's paired joints at rest, if that is below the ground
  BuiltPoseMap out_;
};

}  // namespace

BuiltPoseMap make_pose_map(const Character& character, const RawScene& rig, const RetargetMap* map, Notes& notes) {
  const RigPairing pairing = pair_with(character, rig, map, notes);
  PoseMapMaker maker(character, rig, pairing);
  maker.add_turns();
  maker.add_places();
  warn_of_facing(character, rig, maker.facing_deg(), notes);
  BuiltPoseMap out = maker.take();
  out.skeleton = static_cast<std::uint32_t>(pairing.skeleton);
  out.rig_hash = hash_of_joints(pairing.rig_skeleton);
  out.rig_joint_count = static_cast<std::uint32_t>(pairing.rig_skeleton.parents.size());
  return out;
}

}  // namespace marrow::cook
