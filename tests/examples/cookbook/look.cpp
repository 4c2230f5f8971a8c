// Heads, eyes and a weapon that point at something. See docs/ik/cookbook.md.
#include "newt.h"

// By how many degrees a joint's z misses the point.
float degrees_off(const Newt& newt, std::uint32_t joint, const float (&point)[3]) {
  float along = 0, squared = 0;
  for (int i = 0; i < 3; ++i) {
    const float way = point[i] - newt.at(joint, i);
    along += way * newt.pose.model_from_joint[joint].rows[i][2];
    squared += way * way;
  }
  return std::acos(std::fmin(1.0f, along / std::sqrt(squared))) * 57.29578f;
}

// Neck and head turn as far as they may, and the eyes do what is left.
void look(Newt& newt, const char* folder) {
  const std::uint32_t chain[] = {newt.joint("neck"), newt.joint("head")};
  const std::uint32_t eyes[] = {newt.joint("eye.L"), newt.joint("eye.R")};
  const float target[3] = {0.9f, 1.5f, 0.8f};

  // Once a character: what is forwards and upwards for the head, taken from the rest pose.
  must(pose_character(newt.body, {}));
  marrow::Aim head;
  must(direction_in_joint(newt.pose.model_from_joint[chain[1]], {0, 0, 1}, head.forward));
  must(direction_in_joint(newt.pose.model_from_joint[chain[1]], {0, 1, 0}, head.up));
  head.offset[1] = 0.19f, head.offset[2] = 0.09f;  // between the eyes
  head.pole[1] = 1;                                // the head stays upright
  for (int i = 0; i < 3; ++i) head.target[i] = target[i];

  newt.play("idle", 0.5f);
  head.weight = 0.7f;  // a head turns less far than the eyes
  must(solve_look_at(newt.pose, chain, head, 0.5f));
  must(limit_pose(newt.pose.skeleton.limits, newt.pose.local));  // a neck turns by 50 degrees and no farther
  must(local_to_model_below(newt.pose.skeleton, newt.pose.local, chain[0], newt.pose.model_from_joint));
  marrow::Aim eye;  // the eyes of this character look along their z
  for (int i = 0; i < 3; ++i) eye.target[i] = target[i];
  for (const std::uint32_t joint : eyes) must(solve_aim(newt.pose, joint, eye));
  std::printf("look: the eyes %.2f and %.2f degrees off\n", double(degrees_off(newt, eyes[0], target)),
              double(degrees_off(newt, eyes[1], target)));
  newt.save(folder, "look");
}

// An aiming pose laid over a walk, and what it lacks done by a look-at whose ray begins at the muzzle.
void weapon(Newt& newt, const char* folder) {
  const marrow::Clip reach = newt.file.clip(newt.file.find_clip("reach"));
  const std::size_t groups = newt.pose.skeleton.soa_size();
  std::vector<marrow::SoaTransform> aiming(groups), before(groups);
  std::vector<marrow::AdditiveTransform> change(groups);

  // Once a load: what the aiming pose changes. A clip that is cooked with --additive has this in it.
  must(sample(newt.pose.skeleton, reach, 0, before));
  must(sample(newt.pose.skeleton, reach, 1.0f, aiming));
  must(make_additive(newt.pose.skeleton, aiming, before, change));
  std::vector<float> upper_body(4 * groups, 0.0f);
  for (const char* name : {"spine_1", "spine_2", "chest", "clavicle.R", "upper_arm.R", "forearm.R", "hand.R"})
    upper_body[newt.joint(name)] = 1;

  const std::uint32_t chain[] = {newt.joint("chest"), newt.joint("upper_arm.R"), newt.joint("hand.R")};
  marrow::Aim muzzle;
  muzzle.target[0] = -0.6f, muzzle.target[1] = 1.1f, muzzle.target[2] = 2;
  muzzle.forward[1] = 1, muzzle.forward[2] = 0;  // along the fingers, the hand's y
  muzzle.offset[1] = 0.09f;                      // from their roots
  int seen = 0;
  for (int frame = 0; frame < 60; ++frame) {
    newt.play("walk", float(frame) / 50);
    must(add(newt.pose.skeleton, {change, 1, upper_body}, newt.pose.local));
    must(local_to_model(newt.body));
    bool reached = false;
    must(solve_look_at(newt.pose, chain, muzzle, 0.3f, &reached));
    seen += reached;
    if (frame == 20) newt.save(folder, "weapon");
  }
  // How far the ray misses the target, in the last frame.
  float way[3], along = 0, off = 0;
  const marrow::Affine& hand = newt.pose.model_from_joint[chain[2]];
  for (int i = 0; i < 3; ++i) way[i] = muzzle.target[i] - hand.rows[i][3] - 0.09f * hand.rows[i][1];
  for (int i = 0; i < 3; ++i) along += way[i] * hand.rows[i][1];
  for (int i = 0; i < 3; ++i) off += (way[i] - along * hand.rows[i][1]) * (way[i] - along * hand.rows[i][1]);
  std::printf("weapon: the target seen in %d frames of 60, the ray %.2f mm off\n", seen, double(1000 * std::sqrt(off)));
}

int main(int argc, char** argv) {
  if (argc < 2) return 1;
  const char* const folder = argc > 2 ? argv[2] : nullptr;
  Newt newt(argv[1]);
  look(newt, folder);
  weapon(newt, folder);
}
