// Feet, head and mirrored joints of any character, without one of its names.
// $ roles hero.mrw
#include "asset.h"

using marrow::Role;
using marrow::Status;

// All that stands: two feet, or four of an animal.
std::vector<marrow::Foot> feet_of(const marrow::Roles& roles) {
  std::vector<marrow::Foot> feet;
  for (const Role role : {Role::left_foot, Role::right_foot, Role::left_hand, Role::right_hand})
    if (marrow::Foot foot; foot_of(roles, role, foot) == Status::ok) feet.push_back(foot);
  return feet;
}

int main(int argc, char** argv) {
  Asset asset;
  if (argc < 2 || asset.open(argv[1]) != Status::ok) return 1;
  const marrow::Roles roles = asset.file.roles(0);
  const marrow::Skeleton skeleton = asset.file.skeleton(0);
  const auto name = [&](std::uint16_t joint) {
    return joint == marrow::kNoJoint ? "none" : asset.file.text(skeleton.names[joint]);
  };

  const std::vector<marrow::Foot> feet = feet_of(roles);
  marrow::Feet all;
  all.feet = {feet.data(), feet.size()};
  all.pelvis = joint_of(roles, Role::hips);
  std::printf("%zu feet under \"%s\"\n", feet.size(), name(joint_of(roles, Role::hips)));

  const std::uint16_t hand = joint_of(roles, Role::left_hand);
  std::printf("\"%s\" mirrors \"%s\", and \"%s\" looks\n", name(mirror_of(roles, hand)), name(hand),
              name(joint_of(roles, Role::head)));
}
//   2 feet under "pelvis"
//   "hand.R" mirrors "hand.L", and "head" looks
