// A skeleton as roles are looked for in it, what its names say, and the roles found so far.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "cook/roles/name_words.h"
#include "cook/scene/built.h"
#include "cook/skeleton/build_skeletons.h"
#include "marrow/roles.h"

namespace marrow::cook {

enum class Part : std::uint8_t {
  none,     // the name says nothing
  unknown,  // it has a word that nobody knows
  other,    // it says something that has no role
  root,
  hips,
  spine,
  chest,
  upper_chest,
  neck,
  head,
  jaw,
  eye,
  tail,
  // Of legs, from the body out. A hip with a side is a girdle or the leg's first joint.
  leg_girdle,
  hip,
  upper_leg,
  leg,
  lower_leg,
  ankle,
  foot,
  toes,
  // Of arms and front legs, likewise.
  arm_girdle,
  shoulder,
  upper_arm,
  arm,
  lower_arm,
  wrist,
  hand,
  palm,
  thumb,
  index,
  middle,
  ring,
  little,
};

struct JointPart {
  Part part = Part::none;
  Side side = Side::none;  // of the name, or of the nearest joint above that has one
  bool own_side = false;
  bool is_end = false;    // the name says that it is no joint but an end
  bool is_front = false;  // of a front leg
  bool is_humerus = false;
  int number = -1;  // of a finger's joint; -1: none
};

// Of all joints of a skeleton, since what their names have in common says nothing. parents: 65535 for roots.
std::vector<JointPart> parts_of(const std::vector<std::string>& names, const std::vector<std::uint16_t>& parents);

// What is said of a joint that was left out.
using Doubt = std::function<void(int joint, const std::string& why)>;

struct Body {
  std::vector<std::string> names;
  std::vector<int> parents;  // kNone: a root; before their children
  std::vector<std::vector<int>> children;
  std::vector<JointPart> parts;
  Descent descent;
  std::vector<glm::dmat4> model_from_joint;  // at rest
  std::vector<glm::dvec3> places;            // the same
  std::vector<char> carries;                 // whether vertices follow a joint; empty: not known
  int trunk = kNone;                         // where it begins: the hips, or what is so called and carries no legs
  bool is_nameless = false;                  // limbs were found by their shape

  std::size_t size() const { return parents.size(); }
  const JointPart& part(int joint) const { return parts[to_index(joint)]; }
  Role role(int joint) const { return roles_[to_index(joint)]; }
  int parent(int joint) const { return parents[to_index(joint)]; }
  const glm::dvec3& place(int joint) const { return places[to_index(joint)]; }

  // Itself, or somewhere above.
  bool is_at_or_above(int above, int joint) const {
    return above != kNone && joint != kNone && descent.is_at_or_above(above, joint);
  }
  // The lowest joint that is at or above both; kNone: they have different roots, or one is kNone.
  int common(int a, int b) const;
  // From below `above`, which is at or above `joint` or kNone, down to `joint`.
  std::vector<int> way(int above, int joint) const;
  // An end in name and in fact: nothing but ends hangs on it.
  bool is_end(int joint) const;

  // The first; kNone: nothing has it. O(1).
  int joint_of(Role role) const { return first_[static_cast<std::size_t>(role)]; }
  // A joint keeps the first role that it is given, and a role its first joint.
  void give(Role role, int joint);
  void take(Role role);
  void set(Role role, int joint);  // instead of what both had; a tail may have more joints

 private:
  friend Body body_of(const BuiltSkeleton& skeleton);
  std::vector<Role> roles_;              // a joint
  std::array<int, kRoleCount> first_{};  // the first joint of each
};

// Without the roles and `carries`.
Body body_of(const BuiltSkeleton& skeleton);

// The role of the other side: of left_hand right_hand, of spine itself.
Role other_side(Role role);
// A left role, or the right one that mirrors it.
inline Role on_side(Role left, Side side) {
  return side == Side::right ? other_side(left) : left;
}

// Gives upper_leg, lower_leg, foot and toes, shoulder, upper_arm, lower_arm and hand of both sides.
void find_limbs(Body& body, const Doubt& doubt);

// Gives the three joints of each finger, from the palm out, that hang below the hand, or without a hand below the lower
// arm. Call it after find_limbs().
void find_fingers(Body& body);

// Of characters that stand upright in the scene and look along z or against it. Two chains that mirror each other and
// reach the lowest joints are legs; two more, farther up from where those meet, are front legs if they too reach the
// ground, else arms are the longest such chains. Does nothing where a name says anything.
void find_by_shape(Body& body);

// Gives hips, spine, chest, neck, head, jaw, eyes, root and tail; call it after find_limbs(). Hips are where the legs
// meet each other and the trunk; the trunk goes from there to where the arms meet, the neck on to the head. Names
// decide where they agree with that.
void find_trunk(Body& body, const Doubt& doubt);

}  // namespace marrow::cook
