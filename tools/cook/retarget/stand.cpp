#include "cook/retarget/planted_feet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <glm/geometric.hpp>

#include "common/elementary.h"
#include "cook/retarget/plan/limbs.h"
#include "cook/scene/influences.h"

namespace marrow::cook {
namespace {

// Ways in which a point may be the farthest: aslant, level, and aslant upwards, as a foot that swings may point farther
// than straight down.
constexpr std::size_t kAround = 12, kSlopes = 7, kUpwards = 3;
constexpr double kQuarterTurn = 1.5707963267948966;
constexpr double kHardlyCarried = 0.1;

using Ways = std::array<glm::dvec3, kAround * kSlopes + 1>;

Ways ways_down() {
  Ways out;
  out.back() = {0, -1, 0};
  for (std::size_t i = 0; i + 1 < out.size(); ++i) {
    const double slope = (static_cast<double>(i / kAround) - kUpwards) / (kSlopes - kUpwards);
    const double down = kQuarterTurn * slope;
    const double about = 4 * kQuarterTurn * static_cast<double>(i % kAround) / kAround;
    out[i] = {tools::cosine(down) * tools::cosine(about), -tools::sine(down), tools::cosine(down) * tools::sine(about)};
  }
  return out;
}

// A part of a sole, and its points that are farthest in each way.
struct Outermost {
  explicit Outermost(SolePart& of) : part(&of) { along.fill(-std::numeric_limits<double>::infinity()); }
  void add(const SolePoint& point, const Ways& ways) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const double length = glm::dot(point.rest, ways[i]);
      if (!(length > along[i])) continue;
      along[i] = length;
      points[i] = point;
    }
  }
  void finish() const {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto same = [&](const SolePoint& other) { return other.rest == points[i].rest; };
      if (!points[i].shares.empty() && std::ranges::none_of(part->points, same)) part->points.push_back(points[i]);
    }
  }

  SolePart* part;
  std::array<double, std::tuple_size_v<Ways>> along;
  std::array<SolePoint, std::tuple_size_v<Ways>> points;
};

// Soles without points, and which of their parts a joint moves, foot by foot: kNone, or an index into `parts`.
struct Feet {
  std::vector<Sole> soles;
  std::vector<int> part_of_joint;
  std::vector<std::pair<std::size_t, std::size_t>> parts;  // a sole, and a part of it
};

// Toes are the topmost paired joints below an ankle, or what hangs on it where there are none.
Feet find_parts(const RetargetPlan& plan, const Legs& legs) {
  const std::vector<RetargetJoint>& joints = plan.joints;
  std::vector<char> pairs(joints.size(), 0);  // a joint, or one below it
  for (std::size_t j = joints.size(); j-- > 0;) {
    if (joints[j].at.is_there()) pairs[j] = 1;
    if (pairs[j] != 0 && joints[j].parent != kNone) pairs[to_index(joints[j].parent)] = 1;
  }
  Feet out;
  out.part_of_joint.assign(joints.size(), kNone);
  std::vector<int> leg_of(joints.size(), kNone);  // an ankle
  for (const FootJoint& foot : legs.feet)
    if (foot.level == 0) leg_of[foot.joint] = static_cast<int>(foot.leg);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const int above = joints[j].parent == kNone ? kNone : out.part_of_joint[to_index(joints[j].parent)];
    out.part_of_joint[j] = above;
    const bool is_ankle = leg_of[j] != kNone;
    if (!is_ankle && above == kNone) continue;
    const bool hangs_on_ankle = above != kNone && out.parts[to_index(above)].second == 0;
    if (is_ankle) out.soles.emplace_back().leg = to_index(leg_of[j]);
    if (is_ankle || (hangs_on_ankle && (joints[j].at.is_there() || pairs[j] == 0))) {
      const std::size_t sole = is_ankle ? out.soles.size() - 1 : out.parts[to_index(above)].first;
      out.part_of_joint[j] = static_cast<int>(out.parts.size());
      out.parts.emplace_back(sole, out.soles[sole].parts.size());
      out.soles[sole].parts.push_back({j, {}, {}});
    }
    const auto [sole, part] = out.parts[to_index(out.part_of_joint[j])];
    if (joints[j].at.is_there() || out.soles[sole].parts[part].joint == j)
      out.soles[sole].parts[part].turned.push_back(j);
  }
  return out;
}

// The part of a foot that a vertex follows most; kNone: hardly any. Heels may follow the shin more than the foot.
int part_of(const SolePoint& point, const std::vector<int>& part_of_joint) {
  std::map<int, double> weights;
  for (const SolePoint::Share& share : point.shares)
    if (part_of_joint[share.joint] != kNone) weights[part_of_joint[share.joint]] += share.coordinate.w;
  const auto most = std::ranges::max_element(weights, {}, [](const auto& of) { return of.second; });
  return most == weights.end() || most->second < kHardlyCarried ? kNone : most->first;
}

void add_mesh(Mesh mesh, const Feet& feet, const std::vector<glm::dmat4>& at_rest, std::vector<Outermost>& farthest) {
  const Ways ways = ways_down();
  mesh.geometry.as_residual = nullptr;  // as linear blend skinning has it
  SolePoint point;
  for_each_vertex(mesh.geometry, [&](std::size_t, const std::vector<Influence>& influences) {
    point.shares.clear();
    for (const Influence& i : influences)
      for_each_joint(mesh, i.entry, [&](std::uint16_t joint, const Affine& bind, double share) {
        point.shares.push_back({joint, transformed(bind, i.coordinate) * share});
      });
    const int part = part_of(point, feet.part_of_joint);
    if (part == kNone) return;
    point.rest = point.at(at_rest);
    farthest[to_index(part)].add(point, ways);
  });
}

// Of a foot that has no vertices.
void add_joints(const RetargetPlan& plan, Sole& sole) {
  double ground = std::numeric_limits<double>::infinity();
  for (const SolePart& part : sole.parts) ground = std::min(ground, plan.joints[part.joint].place.y);
  for (SolePart& part : sole.parts) {
    const RetargetJoint& joint = plan.joints[part.joint];
    const glm::dvec3 place(joint.place.x, ground, joint.place.z);
    part.points = {{{{part.joint, glm::dvec4(0)}}, place}};
  }
}

void finish(const RetargetPlan& plan, const std::vector<glm::dmat4>& at_rest, Sole& sole) {
  if (std::ranges::all_of(sole.parts, [](const SolePart& part) { return part.points.empty(); })) {
    add_joints(plan, sole);
    for (SolePart& part : sole.parts)
      for (SolePoint& point : part.points)
        point.shares[0].coordinate = glm::inverse(at_rest[part.joint]) * glm::dvec4(point.rest, 1);
  }
  const glm::dvec3 ankle = plan.joints[sole.parts[0].joint].place;
  sole.ground = std::numeric_limits<double>::infinity();
  double farthest = 0;
  for (const SolePart& part : sole.parts)
    for (const SolePoint& point : part.points) {
      sole.ground = std::min(sole.ground, point.rest.y);
      const glm::dvec3 ahead(point.rest.x - ankle.x, 0, point.rest.z - ankle.z);
      const double length = glm::length(ahead);
      if (!(length > farthest)) continue;
      farthest = length;
      sole.forward = ahead / length;
    }
}

constexpr double kFull = 0.05, kHardly = 0.2;  // of a leg's length above the ground, feet are moved in full, or hardly

double arc_sine(double x) {
  return kQuarterTurn - tools::arc_cosine(x);
}

// How far what rests on the ground may slope downwards, with the joint that it bends about so high above it.
double steepest(const SolePart& part, const glm::dvec3& joint, const glm::dvec3& forward, double height) {
  double out = kQuarterTurn;
  for (const SolePoint& point : part.points) {
    const double ahead = glm::dot(point.rest - joint, forward), below = joint.y - point.rest.y;
    const double radius = tools::length_of(ahead, below, 0, 0);
    if (!(ahead > 0) || radius <= height) continue;
    out = std::min(out, arc_sine(std::max(0.0, height) / radius) - tools::angle_of(below, ahead));
  }
  return std::max(0.0, out);
}

// Raises what is ahead of a joint until it slopes no more than the ground lets it.
void bend(const RetargetPlan& plan, const Sole& sole, const SolePart& part, double height, Puppet& puppet) {
  const RetargetJoint& joint = plan.joints[part.joint];
  const glm::dquat moved = puppet.turns[part.joint] * glm::conjugate(joint.turn);
  const double slope = arc_sine(std::clamp(-(moved * sole.forward).y, -1.0, 1.0));
  const double over = slope - steepest(part, joint.place, sole.forward, height);
  if (!(over > 0)) return;
  const glm::dvec3 across = moved * glm::cross(sole.forward, glm::dvec3(0, 1, 0));
  const double half_sine = tools::sine(over / 2);
  const glm::dquat raised(tools::cosine(over / 2), half_sine * across.x, half_sine * across.y, half_sine * across.z);
  for (const std::size_t j : part.turned) puppet.turn(j, raised);
}

// How high the lowest of a sole is above the ankle.
double lowest_of(const Sole& sole, const Puppet& puppet) {
  double out = std::numeric_limits<double>::infinity();
  for (const SolePart& part : sole.parts)
    for (const SolePoint& point : part.points) out = std::min(out, point.at(puppet.model_from_joint).y);
  return out - puppet.place(sole.parts[0].joint).y;
}

// A foot of a frame: where its ankle and its sole's lowest go.
class Foot {
 public:
  Foot(const RetargetPlan& plan, const Legs& legs, const Sole& sole, const FootGoals& goals)
      : sole_(sole),
        limb_(legs.limbs[sole.leg]),
        goal_(goals.place[sole.leg]),
        captured_lowest_(goals.lowest[sole.leg]),
        most_(length_at(plan, legs.limbs[sole.leg], goals.knee[sole.leg])) {
    const double leg = legs.mean_length();
    share_ = std::clamp((kHardly - captured_lowest_ / leg) / (kHardly - kFull), 0.0, 1.0);
    height_ = goals.ankle[sole.leg] + plan.joints[ankle()].place.y - sole.ground;
  }
  std::size_t ankle() const { return sole_.parts[0].joint; }

  void bend_part(const RetargetPlan& plan, std::size_t part, Puppet& puppet) const {
    const double above_ankle = puppet.place(sole_.parts[part].joint).y - puppet.place(ankle()).y;
    bend(plan, sole_, sole_.parts[part], height_ + above_ankle - floor(), puppet);
  }
  void bend_toes(const RetargetPlan& plan, Puppet& puppet) const {
    for (std::size_t part = 1; part < sole_.parts.size(); ++part) bend_part(plan, part, puppet);
  }
  // Returns by how much the character is to be raised so that the leg keeps its length. `nearest`: of all feet.
  double find_place(const Puppet& puppet, double ground, double nearest) {
    lowest_ = lowest_of(sole_, puppet);
    const double above = height_ + lowest_;
    const double moved = above < floor() ? floor() - above : std::min(0.0, captured_lowest_ - above);
    place_ = ground + height_ + moved;
    least_ = ground + floor() - lowest_;
    return place_ - puppet.place(ankle()).y + captured_lowest_ - nearest;
  }
  // How far the character may be raised for the leg not to be too straight, beyond so much only in part.
  double give_way(const Puppet& puppet, double raised) const {
    if (limb_.middle == kNone) return raised;
    const glm::dvec3 top = puppet.place(limb_.top);
    const double most = std::max(most_, glm::length(puppet.place(ankle()) - top));
    const double x = goal_.x - top.x, z = goal_.z - top.z;
    const double highest = place_ + std::sqrt(std::max(0.0, most * most - x * x - z * z)) - top.y;
    return raised - share_ * std::max(0.0, raised - highest);
  }
  void move(const RetargetPlan& plan, double raised, Puppet& puppet) const {
    const glm::dvec3 now = puppet.place(ankle());
    const double up = std::max(share_ * (place_ - now.y - raised), least_ - now.y - raised);
    const glm::dvec3 to(now.x + share_ * (goal_.x - now.x), now.y + up, now.z + share_ * (goal_.z - now.z));
    const glm::dquat moved = puppet.turns[ankle()] * glm::conjugate(plan.joints[ankle()].turn);
    reach(limb_, to, moved * sole_.forward, most_, puppet);
  }

 private:
  // What the sole may not come below, above the ground.
  double floor() const { return share_ * captured_lowest_; }

  const Sole& sole_;
  const Limb& limb_;
  glm::dvec3 goal_;
  double captured_lowest_, most_, share_ = 0, height_ = 0, lowest_ = 0, place_ = 0, least_ = 0;
};

}  // namespace

glm::dvec3 SolePoint::at(const std::vector<glm::dmat4>& model_from_joint) const {
  glm::dvec4 sum(0);
  for (const Share& share : shares) sum += model_from_joint[share.joint] * share.coordinate;
  return glm::dvec3(sum);
}

std::vector<Sole> find_soles(const RetargetPlan& plan, const Legs& legs, const std::vector<Mesh>& meshes) {
  Feet feet = find_parts(plan, legs);
  std::vector<Outermost> farthest;
  for (const auto& [sole, part] : feet.parts) farthest.emplace_back(feet.soles[sole].parts[part]);
  Puppet rest(plan.joints.size());
  rest.pose(plan);
  for (const Mesh& mesh : meshes) add_mesh(mesh, feet, rest.model_from_joint, farthest);
  for (const Outermost& of : farthest) of.finish();
  for (Sole& sole : feet.soles) finish(plan, rest.model_from_joint, sole);
  return std::move(feet.soles);
}

double stand(const RetargetPlan& plan, const Legs& legs, const std::vector<Sole>& soles, const FootGoals& goals,
             Puppet& puppet) {
  double ground = std::numeric_limits<double>::infinity(), raised = ground;
  for (const Sole& sole : soles) ground = std::min(ground, sole.ground);
  const double nearest = *std::ranges::min_element(goals.lowest);
  std::vector<Foot> feet;
  for (const Sole& sole : soles) feet.emplace_back(plan, legs, sole, goals);
  for (const Foot& foot : feet) foot.bend_part(plan, 0, puppet);
  puppet.pose(plan);
  for (const Foot& foot : feet) foot.bend_toes(plan, puppet);
  puppet.pose(plan);
  for (Foot& foot : feet) raised = std::min(raised, foot.find_place(puppet, ground, nearest));
  for (const Foot& foot : feet) raised = foot.give_way(puppet, raised);
  for (const Foot& foot : feet) foot.move(plan, raised, puppet);
  puppet.pose(plan);
  return raised;
}
}  // namespace marrow::cook
