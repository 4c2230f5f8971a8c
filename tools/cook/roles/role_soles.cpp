#include "cook/roles/role_soles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/matrix.hpp>

#include "asset/sections/role_section.h"
#include "cook/scene/influences.h"

namespace marrow::cook {
namespace {

constexpr double kTouches = 0.1;        // of the ankle's height: what is so low stands on the ground
constexpr double kMostHandRises = 0.2;  // of the hips' height: how high a hand may be that is a foot

constexpr std::array<Role, 4> kStanding = {Role::left_foot, Role::right_foot, Role::left_hand, Role::right_hand};

// What follows one foot.
struct Footing {
  int joint = kNone;
  Role role = Role::none;
  std::vector<glm::dvec3> places;  // of vertices at rest
  double low() const {
    double out = places[0].y;
    for (const glm::dvec3& place : places) out = std::min(out, place.y);
    return out;
  }
};

std::vector<Footing> feet_of(const Body& body) {
  std::vector<Footing> out;
  for (const Role role : kStanding)
    if (const int joint = body.joint_of(role); joint != kNone) out.push_back({joint, role, {}});
  return out;
}

void add_vertices(const Body& body, Mesh mesh, std::vector<Footing>& feet) {
  mesh.geometry.as_residual = nullptr;  // as linear blend skinning has it
  std::vector<double> shares(feet.size());
  for_each_vertex(mesh.geometry, [&](std::size_t, const std::vector<Influence>& influences) {
    std::ranges::fill(shares, 0.0);
    glm::dvec4 place(0);
    for (const Influence& i : influences)
      for_each_joint(mesh, i.entry, [&](std::uint16_t joint, const Affine& bind, double share) {
        place += body.model_from_joint[joint] * (transformed(bind, i.coordinate) * share);
        for (std::size_t f = 0; f < feet.size(); ++f)
          if (body.is_at_or_above(feet[f].joint, joint)) shares[f] += i.weight * share;
      });
    for (std::size_t f = 0; f < feet.size(); ++f)
      if (shares[f] > 0.5) feet[f].places.emplace_back(place);
  });
}

void add_joints(const Body& body, Footing& foot) {
  for (std::size_t j = 0; j < body.size(); ++j)
    if (body.is_at_or_above(foot.joint, static_cast<int>(j))) foot.places.push_back(body.places[j]);
}

// On the ground below the ball; of the model.
glm::dvec3 sole_of(const Body& body, const Footing& foot, bool of_joints) {
  const double low = foot.low(), ankle = body.place(foot.joint).y;
  const double touches = low + kTouches * std::max(ankle - low, 0.0);
  glm::dvec3 least(HUGE_VAL), most(-HUGE_VAL);
  for (const glm::dvec3& place : foot.places)
    if (place.y <= touches) {
      least = glm::min(least, place);
      most = glm::max(most, place);
    }
  glm::dvec3 out = 0.5 * (least + most);
  const Role toes_role = foot.role == Role::left_foot ? Role::left_toes : Role::right_toes;
  const bool has_toes = foot.role == Role::left_foot || foot.role == Role::right_foot;
  if (const int toes = has_toes ? body.joint_of(toes_role) : kNone; toes != kNone) {
    const glm::dvec3& ball = body.place(toes);
    const bool within = ball.x >= least.x && ball.x <= most.x && ball.z >= least.z && ball.z <= most.z;
    if (within || of_joints) out = ball;
  } else if (of_joints) {
    out = body.place(foot.joint);
  }
  return {out.x, low, out.z};
}

bool reaches_ground(const Body& body, const Footing& hand, double ground) {
  int high = body.joint_of(Role::hips);
  if (high == kNone) high = body.joint_of(Role::left_upper_leg);
  return high != kNone && ground < HUGE_VAL && hand.low() - ground <= kMostHandRises * (body.place(high).y - ground);
}

bool is_foot(Role role) {
  return role == Role::left_foot || role == Role::right_foot;
}

}  // namespace

std::vector<char> carried_by(const std::vector<Mesh>& meshes, std::size_t joint_count) {
  std::vector<char> out(joint_count, 0);
  for (const Mesh& mesh : meshes)
    for_each_vertex(mesh.geometry, [&](std::size_t, const std::vector<Influence>& influences) {
      for (const Influence& i : influences)
        for_each_joint(mesh, i.entry, [&](std::uint16_t joint, const Affine&, double) { out[joint] = 1; });
    });
  return out;
}

std::vector<JointSole> find_soles_of_roles(const Body& body, const std::vector<Mesh>& meshes) {
  std::vector<Footing> feet = feet_of(body);
  for (const Mesh& mesh : meshes) add_vertices(body, mesh, feet);
  std::vector<char> of_joints;
  for (Footing& foot : feet) {
    of_joints.push_back(foot.places.empty());
    if (foot.places.empty()) add_joints(body, foot);
  }
  double ground = HUGE_VAL;
  for (const Footing& foot : feet)
    if (is_foot(foot.role)) ground = std::min(ground, foot.low());
  std::vector<JointSole> out;
  for (std::size_t f = 0; f < feet.size(); ++f) {
    const Footing& foot = feet[f];
    if (!is_foot(foot.role) && !reaches_ground(body, foot, ground)) continue;
    const glm::dmat4 joint_from_model = glm::inverse(body.model_from_joint[to_index(foot.joint)]);
    const glm::dvec4 place = joint_from_model * glm::dvec4(sole_of(body, foot, of_joints[f] != 0), 1);
    JointSole sole;
    sole.joint = static_cast<std::uint16_t>(foot.joint);
    bool good = true;
    for (int c = 0; c < 3; ++c) {
      good = good && std::abs(place[c]) < double{format::kFarthestSole};
      sole.place[c] = static_cast<float>(place[c]) + 0.0f;
    }
    if (good) out.push_back(sole);
  }
  std::ranges::sort(out, {}, &JointSole::joint);
  return out;
}

}  // namespace marrow::cook
