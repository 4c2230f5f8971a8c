#include "cook/motion/foot_points.h"

#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "cook/roles/role_body.h"
#include "cook/scene/influences.h"

namespace marrow::cook {
namespace {

// Of the leg: of a foot whose ankle is higher the heel does not stand.
constexpr double kHighAnkle = 0.2;
constexpr std::size_t kMostFootJoints = 8;  // of a foot, that points are kept of
// The directions in which the farthest vertex is kept: down, and by 30 and 60 degrees from that to eight sides.
constexpr std::size_t kDirections = 17;

constexpr std::array<std::array<Role, 2>, 4> kLegs = {{{Role::left_foot, Role::left_upper_leg},
                                                       {Role::right_foot, Role::right_upper_leg},
                                                       {Role::left_hand, Role::left_upper_arm},
                                                       {Role::right_hand, Role::right_upper_arm}}};

glm::dvec3 direction(std::size_t number) {
  constexpr double kSide[8][2] = {
      {1, 0},  {0.7071067811865476, 0.7071067811865476},   {0, 1},  {-0.7071067811865476, 0.7071067811865476},
      {-1, 0}, {-0.7071067811865476, -0.7071067811865476}, {0, -1}, {0.7071067811865476, -0.7071067811865476}};
  if (number == 0) return {0, -1, 0};
  const auto& side = kSide[(number - 1) % 8];
  const bool steep = number <= 8;
  const double across = steep ? 0.5 : 0.8660254037844386, down = steep ? 0.8660254037844386 : 0.5;
  return {across * side[0], -down, across * side[1]};
}

// The farthest vertices of a joint so far; model space.
struct Extremes {
  std::array<double, kDirections> far;
  std::array<glm::dvec3, kDirections> places;
  Extremes() { far.fill(-HUGE_VAL); }
  void add(const glm::dvec3& place) {
    for (std::size_t d = 0; d < kDirections; ++d)
      if (const double along = glm::dot(direction(d), place); along > far[d]) far[d] = along, places[d] = place;
  }
};

using ExtremesOfJoints = std::map<std::uint16_t, Extremes>;

// Which foot a joint belongs to; as many as there are feet: none.
std::size_t foot_above(const Body& body, const std::vector<std::uint16_t>& feet, std::uint16_t joint) {
  std::size_t f = 0;
  while (f < feet.size() && !body.is_at_or_above(feet[f], joint)) ++f;
  return f;
}

void add_vertices(const Body& body, const std::vector<std::uint16_t>& feet, Mesh mesh,
                  std::vector<ExtremesOfJoints>& out) {
  mesh.geometry.as_residual = nullptr;  // as linear blend skinning has it
  for_each_vertex(mesh.geometry, [&](std::size_t, const std::vector<Influence>& influences) {
    glm::dvec4 place(0);
    double most = 0;
    std::uint16_t joint = 0;
    for (const Influence& i : influences)
      for_each_joint(mesh, i.entry, [&](std::uint16_t of, const Affine& bind, double share) {
        place += body.model_from_joint[of] * (transformed(bind, i.coordinate) * share);
        if (i.weight * share > most) most = i.weight * share, joint = of;
      });
    const std::size_t f = most > 0 ? foot_above(body, feet, joint) : feet.size();
    if (f == feet.size() || (out[f].size() == kMostFootJoints && !out[f].contains(joint))) return;
    out[f][joint].add(glm::dvec3(place));
  });
}

FootPoint point_of(const Body& body, std::uint16_t joint, const glm::dvec3& place) {
  return {joint, glm::dvec3(glm::inverse(body.model_from_joint[joint]) * glm::dvec4(place, 1))};
}

void keep(const Body& body, const ExtremesOfJoints& extremes, std::vector<FootPoint>& out) {
  for (const auto& [joint, of] : extremes)
    for (std::size_t d = 0; d < kDirections; ++d) {
      bool is_new = true;
      for (std::size_t e = 0; e < d; ++e) is_new = is_new && of.places[e] != of.places[d];
      if (is_new) out.push_back(point_of(body, joint, of.places[d]));
    }
}

}  // namespace

std::vector<FootShape> find_foot_points(const BuiltSkeleton& skeleton, const std::vector<Mesh>& meshes) {
  const Roles roles{skeleton.roles.roles, skeleton.roles.pairs, skeleton.roles.soles};
  if (roles.soles.empty()) return {};
  const Body body = body_of(skeleton);
  std::vector<FootShape> out;
  std::vector<std::uint16_t> feet;
  for (const auto& [foot_role, top_role] : kLegs) {
    const std::uint16_t joint = joint_of(roles, foot_role), top = joint_of(roles, top_role);
    const JointSole* const sole = joint != kNoJoint ? sole_of(roles, joint) : nullptr;
    if (sole == nullptr || top == kNoJoint) continue;
    const glm::dvec4 ball(sole->place[0], sole->place[1], sole->place[2], 1);
    const glm::dvec3 ground(body.model_from_joint[joint] * ball), ankle = body.place(joint);
    const double leg = glm::length(body.place(top) - ground);
    if (!(leg > 0) || !std::isfinite(leg)) continue;
    const FootPoint of_ball{joint, glm::dvec3(ball)};
    FootShape& foot = out.emplace_back(FootShape{foot_role, leg, ground.y, of_ball, {of_ball}});
    if (ankle.y - ground.y < kHighAnkle * leg)
      foot.points.push_back(point_of(body, joint, {ankle.x, ground.y, ankle.z}));
    feet.push_back(joint);
  }
  std::vector<ExtremesOfJoints> extremes(feet.size());
  for (const Mesh& mesh : meshes) add_vertices(body, feet, mesh, extremes);
  for (std::size_t f = 0; f < out.size(); ++f) {
    if (extremes[f].empty()) continue;
    out[f].points.clear();
    keep(body, extremes[f], out[f].points);
  }
  return out;
}

}  // namespace marrow::cook
