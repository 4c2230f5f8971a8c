#include "cook/retarget/planted_feet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

constexpr double kTouches = 0.02;  // of a leg's length above the ground
constexpr double kSame = 0.01;     // of a leg's length: offsets at both ends of a clip that goes round

glm::dvec3 own_hold(const FootHold& hold, const Puppet& puppet) {
  return glm::dvec3(puppet.model_from_joint[hold.joint] * glm::dvec4(hold.place, 1));
}

glm::dvec3 taken_hold(const FootHold& hold, const Take& take) {
  return take.place(hold.node, hold.taken);
}

// From `first` to before `end`, and by how much its offset is changed at both ends.
struct Stance {
  std::size_t first = 0, end = 0;
  glm::dvec3 mean{0};
};

std::vector<Stance> contacts_in(const std::vector<FootFrame>& frames) {
  std::vector<Stance> out;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!frames[i].touches) continue;
    if (i == 0 || !frames[i - 1].touches) out.push_back({i, i, glm::dvec3(0)});
    out.back().end = i + 1;
  }
  return out;
}

glm::dvec3 sum_of(const std::vector<FootFrame>& frames, const Stance& contact) {
  glm::dvec3 out(0);
  for (std::size_t i = contact.first; i < contact.end; ++i) out += frames[i].offset;
  return out;
}

void find_means(const std::vector<FootFrame>& frames, double leg_length, std::vector<Stance>& contacts) {
  const auto length = [](const Stance& c) { return static_cast<double>(c.end - c.first); };
  for (Stance& contact : contacts) contact.mean = sum_of(frames, contact) / length(contact);
  if (contacts.size() < 2) return;
  Stance &first = contacts.front(), &last = contacts.back();
  const bool goes_round = first.first == 0 && last.end == frames.size() &&
                          glm::length(frames.front().offset - frames.back().offset) <= kSame * leg_length;
  if (!goes_round) return;
  const double whole = length(first) + length(last);
  first.mean = last.mean = (first.mean * length(first) + last.mean * length(last)) / whole;
}

// A foot stands while it is not higher than so much of a leg's length above its lowest; what it is tilted then by up to
// twice the angle is how it rests.
constexpr double kStands = 0.02, kCosineOf12Degrees = 0.9781476007338057;
constexpr double kUnturned = 1 - 1e-9;  // of the cosine of half an angle

// How high the nodes of each foot are in the mean.
std::vector<double> heights_of(const Legs& legs, const Take& take) {
  std::vector<double> heights(legs.tops.size(), 0), count(legs.tops.size(), 0);
  for (const FootNode& node : legs.nodes) {
    heights[node.leg] += take.place(node.node).y;
    ++count[node.leg];
  }
  for (std::size_t leg = 0; leg < heights.size(); ++leg) heights[leg] /= count[leg];
  return heights;
}

// Where the take's feet are lowest in the clip: a leg. Finds the ground as well.
std::vector<double> find_lowest(Take& take, Legs& legs) {
  std::vector<double> nodes(legs.ground.size(), std::numeric_limits<double>::infinity());
  std::vector<double> feet(legs.tops.size(), std::numeric_limits<double>::infinity());
  for (std::size_t frame = 0; frame < take.times_s().size(); ++frame) {
    take.pose(frame);
    for (const FootNode& node : legs.nodes) nodes[node.kind] = std::min(nodes[node.kind], take.place(node.node).y);
    const std::vector<double> heights = heights_of(legs, take);
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

// Where a foot stands, the character's stands as at rest: the capture's soles may not be level at rest.
void level_feet(RetargetPlan& plan, Take& take, const std::vector<double>& lowest, const Legs& legs) {
  const double near = kStands * legs.mean_taken_length();
  std::vector<glm::dquat> sums(legs.feet.size(), glm::dquat(0, 0, 0, 0));
  for (std::size_t frame = 0; frame < take.times_s().size(); ++frame) {
    take.pose(frame);
    const std::vector<double> heights = heights_of(legs, take);
    for (std::size_t f = 0; f < sums.size(); ++f) {
      const FootJoint& foot = legs.feet[f];
      if (heights[foot.leg] > lowest[foot.leg] + near) continue;
      const RetargetJoint& joint = plan.joints[foot.joint];
      const glm::dquat turn = taken_turn(plan, joint, take);
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

}  // namespace

Middle middle_of(const RetargetPlan& plan, const Legs& legs, const Take& take, const Puppet& puppet) {
  Middle out;
  const auto count = static_cast<double>(legs.carrier_count);
  for (std::size_t leg = 0; leg < legs.carrier_count; ++leg) {
    out.own += puppet.place(legs.tops[leg]) / count;
    out.taken += take.place(plan.joints[legs.tops[leg]].at) / count;
  }
  return out;
}

glm::dvec3 offset_of(const RetargetPlan& plan, const CarriedJoint& carried, std::size_t leg, const Take& take,
                     const Puppet& puppet) {
  const Limb& limb = carried.legs.limbs[leg];
  const FootHold& hold = carried.legs.holds[leg];
  const Middle middle = middle_of(plan, carried.legs, take, puppet);
  const auto taken = [&](std::size_t joint) { return take.place(plan.joints[joint].at); };
  const auto scaled = [&](const glm::dvec3& way) { return carried.scale * (plan.facing * way); };
  const glm::dvec3 own = puppet.place(limb.top) + scaled(taken(limb.end) - taken(limb.top)) + own_hold(hold, puppet) -
                         puppet.place(limb.end);
  return own - middle.own - scaled(taken_hold(hold, take) - middle.taken);
}

glm::dvec3 ankle_at(const RetargetPlan& plan, const CarriedJoint& carried, std::size_t leg, const glm::dvec3& offset,
                    const Take& take, const Puppet& puppet) {
  const FootHold& hold = carried.legs.holds[leg];
  const Middle middle = middle_of(plan, carried.legs, take, puppet);
  const glm::dvec3 way = taken_hold(hold, take) - middle.taken;
  return middle.own + carried.scale * (plan.facing * way) + offset - own_hold(hold, puppet) +
         puppet.place(carried.legs.limbs[leg].end);
}

bool touches(const CarriedJoint& carried, std::size_t leg, const Take& take) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const FootNode& node : carried.legs.nodes)
    if (node.leg == leg) lowest = std::min(lowest, take.place(node.node).y - carried.legs.ground[node.kind]);
  return lowest <= kTouches * carried.legs.mean_taken_length();
}

std::vector<glm::dvec3> held(const std::vector<FootFrame>& frames, double leg_length) {
  std::vector<glm::dvec3> out;
  for (const FootFrame& frame : frames) out.push_back(frame.offset);
  std::vector<Stance> contacts = contacts_in(frames);
  if (contacts.empty()) return out;
  find_means(frames, leg_length, contacts);
  for (const Stance& contact : contacts)
    std::fill(out.begin() + static_cast<std::ptrdiff_t>(contact.first),
              out.begin() + static_cast<std::ptrdiff_t>(contact.end), contact.mean);
  // What changes at the ends goes over from one to the next.
  const auto change = [&](std::size_t frame) { return out[frame] - frames[frame].offset; };
  const glm::dvec3 at_first = change(contacts.front().first), at_last = change(contacts.back().end - 1);
  for (std::size_t i = 0; i < contacts.front().first; ++i) out[i] += at_first;
  for (std::size_t i = contacts.back().end; i < out.size(); ++i) out[i] += at_last;
  for (std::size_t c = 0; c + 1 < contacts.size(); ++c) {
    const std::size_t from = contacts[c].end - 1, to = contacts[c + 1].first;
    const glm::dvec3 before = change(from), after = change(to);
    for (std::size_t i = from + 1; i < to; ++i) {
      const double x = static_cast<double>(i - from) / static_cast<double>(to - from);
      out[i] += before + x * x * (3 - 2 * x) * (after - before);
    }
  }
  return out;
}

glm::dquat taken_turn(const RetargetPlan& plan, const RetargetJoint& joint, const Take& take) {
  return plan.facing * take.turn(joint.at) * glm::conjugate(plan.facing);
}

void find_stance(RetargetPlan& plan, Take& take, Legs& legs) {
  const std::vector<double> lowest = find_lowest(take, legs);
  if (take.scene().is_capture) level_feet(plan, take, lowest, legs);
}
}  // namespace marrow::cook
