#include "cook/retarget/feet/retarget_soles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <glm/geometric.hpp>

#include "common/elementary.h"
#include "cook/retarget/plan/retarget_puppet.h"
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

}  // namespace marrow::cook
