// Poses of another rig on a character, frame by frame.
// $ pose_maps mapped.mrw hero.mrw
#include "asset.h"

using marrow::Status;

int main(int argc, char** argv) {
  Asset hero, rig;
  if (argc < 3 || hero.open(argv[1]) != Status::ok || rig.open(argv[2]) != Status::ok) return 1;

  // Once a load: the map, the skeleton that it is for, and that poses are of the rig that it was made for.
  const marrow::PoseMap map = hero.file.pose_map(hero.file.find_pose_map("hero"));
  if (map.rig_hash != skeleton_hash(rig.file, 0)) return 1;
  const marrow::Skeleton skeleton = hero.file.skeleton(map.skeleton);
  std::vector<marrow::SoaTransform> captured(marrow::soa_count(map.rig_joint_count)), local(skeleton.soa_size());

  // Each frame: what a suit, a network or another character gives. Here a clip of the rig stands in for it.
  const marrow::Clip walk = rig.file.clip(rig.file.find_clip("walk"));
  if (sample(rig.file.skeleton(0), walk, 0.3f, captured) != Status::ok) return 1;
  if (retarget_pose(map, captured, skeleton, local) != Status::ok) return 1;  // the frame before stays

  // Then it is a pose like any other: local_to_model(), place_feet(), springs.
  marrow::JointTransform hand;
  if (get_joint(local, hero.file.find_joint(skeleton, "hand.L"), hand) != Status::ok) return 1;
  std::printf("hand.L turns by %.4f %.4f %.4f %.4f\n", double(hand.rotation[0]), double(hand.rotation[1]),
              double(hand.rotation[2]), double(hand.rotation[3]));
}

// Prints:
//   hand.L turns by 0.0194 0.0018 -0.1099 0.9938
