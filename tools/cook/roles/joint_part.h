// Which part of a body a joint's name says that it is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cook/roles/name_words.h"

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

}  // namespace marrow::cook
