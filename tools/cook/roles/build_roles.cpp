#include "cook/roles/build_roles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "asset/sections/role_section.h"
#include "common/failure.h"
#include "cook/roles/role_body.h"
#include "cook/scene/influences.h"
#include "marrow/file.h"
#include "text/nearest.h"

namespace marrow::cook {
namespace {

// "leftUpperArm" → "left_upper_arm".
std::string with_underscores(const std::string& bone) {
  std::string out;
  for (const char c : bone) {
    if (is_capital(c)) out += '_';
    out += small_letter(c);
  }
  return out;
}

const std::string* bone_of(const RawScene& scene, int node) {
  if (node == kNone) return nullptr;
  for (const RawProperty& p : scene.nodes[to_index(node)].extras)
    if (p.name == "vrm/humanoid" && p.type == PropertyType::text) return &p.text;
  return nullptr;
}

// VRM 0 calls the thumb's joints as those of other fingers.
std::string as_in_vrm_1(std::string bone) {
  for (const std::string side : {"left", "right"})
    if (bone.starts_with(side + "Thumb")) {
      if (bone.ends_with("Proximal")) return side + "ThumbMetacarpal";
      if (bone.ends_with("Intermediate")) return side + "ThumbProximal";
    }
  return bone;
}

int joint_called(const Body& body, const std::string& name) {
  const auto found = std::ranges::find(body.names, name);
  return found == body.names.end() ? kNone : static_cast<int>(found - body.names.begin());
}

void set_tail(Body& body, int first) {
  body.take(Role::tail);
  for (int j = first; j != kNone;) {
    body.set(Role::tail, j);
    const std::vector<int>& below = body.children[to_index(j)];
    j = below.size() == 1 ? below[0] : kNone;
  }
}

// Those of "vrm/humanoid" properties. False: there are no hips among them, and the body is as it was.
bool give_avatar_roles(const RawScene& scene, const BuiltSkeleton& skeleton, Body& body) {
  std::vector<std::string> bones(body.size());
  bool is_0 = false;
  for (std::size_t j = 0; j < body.size(); ++j)
    if (const std::string* const bone = bone_of(scene, skeleton.node_of_joint[j])) {
      bones[j] = *bone;
      is_0 = is_0 || bone->ends_with("ThumbIntermediate");
    }
  if (std::ranges::find(bones, "hips") == bones.end()) return false;
  for (std::size_t j = 0; j < body.size(); ++j)
    if (const Role role = find_role(with_underscores(is_0 ? as_in_vrm_1(bones[j]) : bones[j]).c_str());
        role != Role::none && role != Role::root && role != Role::tail)
      body.give(role, static_cast<int>(j));
  return true;
}

// Those of the rules whose joints the body has. Of a tail the joint named and what hangs below it one by one.
void give_ruled_roles(const std::vector<RoleRule>& rules, Body& body) {
  for (const RoleRule& rule : rules) {
    if (rule.joint.empty()) {
      body.take(rule.role);
      continue;
    }
    const int joint = joint_called(body, rule.joint);
    if (joint == kNone) continue;
    if (rule.role == Role::tail)
      set_tail(body, joint);
    else
      body.set(rule.role, joint);
  }
}

// Throws tools::Failure (usage) for a joint that no skeleton has. Of settings for many files only where another rule
// fits, or the name is nearly that of a joint.
void check_rules_of_roles(const std::vector<RoleRule>& rules, const std::vector<BuiltSkeleton>& skeletons) {
  std::vector<std::string> names;
  for (const BuiltSkeleton& s : skeletons) names.insert(names.end(), s.joint_names.begin(), s.joint_names.end());
  const auto is_there = [&](const RoleRule& rule) { return std::ranges::count(names, rule.joint) > 0; };
  const bool one_fits = std::ranges::any_of(rules, is_there);
  for (const RoleRule& rule : rules) {
    if (rule.joint.empty() || is_there(rule)) continue;
    if (!rule.origin.must_fit && !one_fits && tools::nearest_name(rule.joint, names).empty()) continue;
    throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where,
                         "no joint \"" + rule.joint + "\" for " + role_name(rule.role),
                         tools::suggestion(rule.joint, names));
  }
}

constexpr double kMirroredPlaces = 0.02;    // of the body's size: how far mirrored places may be off
constexpr std::size_t kMostSiblings = 256;  // of a joint of a body

// A name without its side, and which that is.
std::string without_side(const NameWords& words, const std::string& name) {
  std::string out = name;
  for (char& c : out) c = small_letter(c);
  for (const auto& [left, right] : {std::pair{"left", "right"}, {"lft", "rgt"}}) {
    const std::string side = words.side == Side::left ? left : right;
    if (const std::size_t at = out.find(side); at != std::string::npos) return out.replace(at, side.size(), "?");
  }
  const char letter = words.side == Side::left ? 'l' : 'r';
  const auto is_letter = [&](std::size_t i) { return i < out.size() && out[i] >= 'a' && out[i] <= 'z'; };
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool stands_alone = (i == 0 || !is_letter(i - 1)) && !is_letter(i + 1);
    const bool before_capital = i + 1 < name.size() && is_capital(name[i + 1]);
    const bool first = i == 0 || !is_letter(i - 1);
    if (out[i] == letter && (stands_alone || (first && before_capital))) return out.replace(i, 1, "?");
  }
  return out;
}

class PairFinder {
 public:
  explicit PairFinder(const Body& body) : body_(body), other_(body.size(), kNone) {}

  void add_roles() {
    for (std::size_t j = 0; j < body_.size(); ++j)
      if (const Role role = body_.role(static_cast<int>(j)); other_side(role) > role)
        if (const int right = body_.joint_of(other_side(role)); right != kNone) add(static_cast<int>(j), right);
  }

  void add_names() {
    std::map<std::string, std::vector<int>> sides[2];
    for (std::size_t j = 0; j < body_.size(); ++j) {
      const NameWords words = words_of(body_.names[j]);
      if (other_[j] == kNone && words.side != Side::none)
        sides[words.side == Side::left ? 0 : 1][without_side(words, body_.names[j])].push_back(static_cast<int>(j));
    }
    for (const auto& [name, lefts] : sides[0])
      if (const auto rights = sides[1].find(name);
          rights != sides[1].end() && lefts.size() == 1 && rights->second.size() == 1)
        add(lefts[0], rights->second[0]);
  }

  // Once there are some pairs, they say where the middle is.
  void add_places() {
    if (lefts_.empty()) return;
    glm::dvec3 across(0), middle(0);
    for (const int left : lefts_) {
      across += body_.place(left) - body_.place(other_[to_index(left)]);
      middle += 0.5 * (body_.place(left) + body_.place(other_[to_index(left)]));
    }
    const double length = glm::length(across);
    if (!(length > 0)) return;
    across /= length;
    middle /= static_cast<double>(lefts_.size());
    double size = 0;
    for (const glm::dvec3& place : body_.places) size = std::max(size, glm::length(place - middle));
    // Parents come before their children, so a pair of parents is known by then.
    for (std::size_t j = 0; j < body_.size(); ++j) {
      const double aside = glm::dot(body_.places[j] - middle, across);
      if (other_[j] != kNone || body_.role(static_cast<int>(j)) != Role::none || !(aside > kMirroredPlaces * size))
        continue;
      const glm::dvec3 mirrored = body_.places[j] - 2 * aside * across;
      if (const int right = only_at(mirrored, body_.parents[j], kMirroredPlaces * size); right != kNone)
        add(static_cast<int>(j), right);
    }
  }

  std::vector<JointPair> finish() {
    std::ranges::sort(lefts_);
    std::vector<JointPair> out;
    for (const int left : lefts_)
      out.push_back({static_cast<std::uint16_t>(left), static_cast<std::uint16_t>(other_[to_index(left)])});
    return out;
  }

 private:
  void add(int left, int right) {
    other_[to_index(left)] = right;
    other_[to_index(right)] = left;
    lefts_.push_back(left);
  }
  // A joint without a pair at this place, below what mirrors a parent.
  int only_at(const glm::dvec3& place, int parent, double within) const {
    if (parent == kNone) return kNone;
    const int there = other_[to_index(parent)] != kNone ? other_[to_index(parent)] : parent;
    const std::vector<int>& children = body_.children[to_index(there)];
    if (children.size() > kMostSiblings) return kNone;
    int found = kNone;
    for (const int j : children) {
      if (other_[to_index(j)] != kNone || body_.role(j) != Role::none) continue;
      if (!(glm::length(body_.place(j) - place) <= within)) continue;
      if (found != kNone) return kNone;
      found = j;
    }
    return found;
  }

  const Body& body_;
  std::vector<int> other_, lefts_;
};

// Ascending by the left joint: by roles, then by names that differ in their side alone, then by places that mirror each
// other, of joints whose parents do or are one. After all roles.
std::vector<JointPair> find_pairs(const Body& body) {
  PairFinder pairs(body);
  pairs.add_roles();
  pairs.add_names();
  pairs.add_places();
  return pairs.finish();
}

// Whether the left leg is on the other side than the left arm.
bool sides_are_crossed(const Body& body) {
  const auto across = [&](Role role) {
    const int left = body.joint_of(role), right = body.joint_of(other_side(role));
    return left == kNone || right == kNone ? glm::dvec3(0) : body.place(left) - body.place(right);
  };
  return glm::dot(across(Role::left_upper_leg), across(Role::left_upper_arm)) < 0;
}

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

// For each joint 1 if a vertex of one of the meshes, which are of the body, follows it.
std::vector<char> carried_by(const std::vector<Mesh>& meshes, std::size_t joint_count) {
  std::vector<char> out(joint_count, 0);
  for (const Mesh& mesh : meshes)
    for_each_vertex(mesh.geometry, [&](std::size_t, const std::vector<Influence>& influences) {
      for (const Influence& i : influences)
        for_each_joint(mesh, i.entry, [&](std::uint16_t joint, const Affine&, double) { out[joint] = 1; });
    });
  return out;
}

// Ascending by joint: of the feet, and of hands that reach the ground. A sole is as low as the lowest vertex that
// follows the foot more than anything else, below the ball, which is where the toes' joint is, or else in the middle of
// what touches the ground. Without vertices it is as low as the lowest joint. After all roles.
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

// Roles with a side, which is then in doubt.
void take_sides(Body& body, const Doubt& doubt) {
  doubt(body.joint_of(Role::left_upper_arm), "by its name it is on the other side than the leg of that name");
  for (std::size_t r = 1; r < kRoleCount; ++r)
    if (const auto role = static_cast<Role>(r); other_side(role) != role) body.take(role);
}

void find_roles(Body& body, const Doubt& doubt) {
  find_limbs(body, doubt);
  find_by_shape(body);
  if (sides_are_crossed(body)) take_sides(body, doubt);
  find_trunk(body, doubt);
  find_fingers(body);
}

BuiltRoles roles_in(const Body& body, const std::vector<Mesh>& meshes) {
  BuiltRoles out;
  for (std::size_t j = 0; j < body.size(); ++j)
    if (const Role role = body.role(static_cast<int>(j)); role != Role::none)
      out.roles.push_back({static_cast<std::uint16_t>(j), role, 0});
  if (out.roles.empty()) return out;
  out.pairs = find_pairs(body);
  out.soles = find_soles_of_roles(body, meshes);
  return out;
}

BuiltRoles build_roles_of(const RawScene& scene, const BuiltSkeleton& skeleton, const std::vector<Mesh>& meshes,
                          const std::vector<RoleRule>& rules, Notes& notes) {
  Body body = body_of(skeleton);
  if (!meshes.empty()) body.carries = carried_by(meshes, body.size());
  const auto is_ruled = [&](const std::string& name) {
    return std::ranges::any_of(rules, [&](const RoleRule& r) { return r.joint == name; });
  };
  std::size_t doubted = 0;
  const Doubt doubt = [&](int joint, const std::string& why) {
    const std::string& name = body.names[to_index(joint)];
    const int node = skeleton.node_of_joint[to_index(joint)];
    if (node == kNone || is_ruled(name)) return;
    ++doubted;
    notes.warnings.push_back(
        {"/nodes/" + std::to_string(node), "role-in-doubt",
         "\"" + name + "\" gets no role: " + why + "; [roles] in marrow.toml, or --roles, says what it is"});
  };
  if (give_avatar_roles(scene, skeleton, body)) {
    int root = body.joint_of(Role::hips);
    while (body.parent(root) != kNone) root = body.parent(root);
    body.give(Role::root, root);
  } else {
    find_roles(body, doubt);
  }
  give_ruled_roles(rules, body);
  BuiltRoles out = roles_in(body, meshes);
  out.doubted = doubted;
  return out;
}

}  // namespace

std::vector<BuiltRoles> build_roles(const RawScene& scene, const BuiltScene& built, const std::vector<Mesh>& meshes,
                                    const std::vector<RoleRule>& rules, Notes& notes) {
  check_rules_of_roles(rules, built.skeletons);
  std::vector<BuiltRoles> out;
  for (std::size_t s = 0; s < built.skeletons.size(); ++s)
    out.push_back(build_roles_of(scene, built.skeletons[s], meshes_of(meshes, s), rules, notes));
  return out;
}

void find_roles(const RawScene& scene, const std::vector<Mesh>& meshes, const std::vector<RoleRule>& rules,
                BuiltScene& built, Notes& notes) {
  std::vector<BuiltRoles> roles = build_roles(scene, built, meshes, rules, notes);
  for (std::size_t s = 0; s < roles.size(); ++s) built.skeletons[s].roles = std::move(roles[s]);
}
}  // namespace marrow::cook
