// Hands that hold something: a rail, a wheel, the own hip. See docs/ik/cookbook.md.
#include "newt.h"

// About what the elbow bends: the axis of the hinge that the artist gave it, in its own space.
void set_bend_axis(const Newt& newt, std::uint32_t mid, marrow::TwoBone& reach) {
  const marrow::JointLimit* const limit = find_limit(newt.pose.skeleton.limits, mid);
  if (limit == nullptr || limit->kind != marrow::LimitKind::hinge) return;
  const float(&q)[4] = limit->joint_from_limit;  // the limit's x, turned into the joint's axes
  reach.bend_axis[0] = 1 - 2 * (q[1] * q[1] + q[2] * q[2]);
  reach.bend_axis[1] = 2 * (q[0] * q[1] + q[2] * q[3]);
  reach.bend_axis[2] = 2 * (q[0] * q[2] - q[1] * q[3]);
}

// A hand slides along a rail at the hip's height while the character walks.
void rail(Newt& newt, const char* folder) {
  const marrow::TwoBoneLimb arm{newt.joint("upper_arm.L"), newt.joint("forearm.L"), newt.joint("hand.L")};
  float worst_mm = 0;
  int frames = 0;
  for (float time_s = 0; time_s < 1.2f; time_s += 1.0f / 60, ++frames) {
    newt.play("walk", time_s);
    marrow::TwoBone reach;
    reach.target[0] = 0.38f;                                       // the wrist goes along z, 0.38 m to the left
    reach.target[1] = 0.62f;                                       // and 0.62 m high, 5 cm above the rail's middle
    reach.target[2] = 0.5f * newt.at(arm.end, 2) + 0.06f;          // the hand swings half as far as it would
    reach.pole[0] = 0.5f, reach.pole[1] = -1, reach.pole[2] = -1;  // the elbow points out, down and back
    set_bend_axis(newt, arm.mid, reach);
    reach.soft = 0.97f;
    bool reached = false;
    must(solve_two_bone(newt.pose, arm, reach, &reached));
    if (!reached) std::printf("rail: too far at %.2f s\n", double(time_s));
    worst_mm = std::fmax(worst_mm, newt.millimetres(arm.end, reach.target));
    if (frames == 18) newt.save(folder, "rail");
  }
  std::printf("rail: %d frames, the hand at most %.2f mm off\n", frames, double(worst_mm));
}

// The elbow goes where the animation has it, and not where a pole for all clips would have it.
void animated_pole(Newt& newt) {
  const marrow::TwoBoneLimb arm{newt.joint("upper_arm.R"), newt.joint("forearm.R"), newt.joint("hand.R")};
  newt.play("reach", 1.0f);
  marrow::TwoBone reach;
  for (int i = 0; i < 3; ++i) {
    reach.target[i] = newt.at(arm.end, i);
    // From the shoulder to the elbow of the clip, less what lies along the way to the hand: a direction in model space.
    reach.pole[i] = newt.at(arm.mid, i) - 0.5f * (newt.at(arm.start, i) + newt.at(arm.end, i));
  }
  const float elbow[3] = {newt.at(arm.mid, 0), newt.at(arm.mid, 1), newt.at(arm.mid, 2)};
  newt.play("idle", 0);  // another pose, in which the arm hangs
  must(solve_two_bone(newt.pose, arm, reach));
  std::printf("pole: the hand %.2f mm off, the elbow %.0f mm from the clip's\n",
              double(newt.millimetres(arm.end, reach.target)), double(newt.millimetres(arm.mid, elbow)));
}

// Both hands on a wheel of 13 cm that turns.
void wheel(Newt& newt, const char* folder) {
  const float middle[3] = {0, 0.78f, 0.3f}, radius = 0.13f;
  const std::uint16_t joints[] = {
      std::uint16_t(newt.joint("upper_arm.L")), std::uint16_t(newt.joint("upper_arm.R")),
      std::uint16_t(newt.joint("forearm.L")),   std::uint16_t(newt.joint("forearm.R")),
      std::uint16_t(newt.joint("hand.L")),      std::uint16_t(newt.joint("hand.R"))};  // parents first
  marrow::IkProblem problem;
  problem.joints = joints;
  problem.limits = newt.pose.skeleton.limits;  // elbows bend forwards
  marrow::IkOptions options;
  options.max_iterations = 24;
  options.tolerance_m = 1e-3f;
  float worst_mm = 0;
  for (int step = 0; step <= 30; ++step) {
    const float turned = 0.02f * float(step);  // radians, to the left
    newt.play("idle", 0.5f);
    marrow::IkGoal goals[2];
    for (int side = 0; side < 2; ++side) {
      const float angle = turned + (side == 0 ? 0.0f : 3.1415927f);
      goals[side].joint = joints[4 + side];
      goals[side].position[0] = middle[0] + radius * std::cos(angle);
      goals[side].position[1] = middle[1] + radius * std::sin(angle);
      goals[side].position[2] = middle[2];
    }
    problem.goals = goals;
    std::vector<std::byte> scratch(ik_scratch_bytes(newt.pose.skeleton, problem, options));
    must(solve_ik(newt.pose, problem, options, scratch));
    for (const marrow::IkGoal& goal : goals)
      worst_mm = std::fmax(worst_mm, newt.millimetres(goal.joint, goal.position));
    if (step == 30) newt.save(folder, "wheel");
  }
  std::printf("wheel: turned by 34 degrees, the hands at most %.2f mm off\n", double(worst_mm));
}

// A hand stays on the hip while the body goes over from one clip to another.
void hip(Newt& newt, const char* folder) {
  const marrow::TwoBoneLimb arm{newt.joint("upper_arm.R"), newt.joint("forearm.R"), newt.joint("hand.R")};
  const std::uint32_t pelvis = newt.joint("pelvis");
  const float place[3] = {-0.19f, 0.1f, 0.03f};  // of the wrist, in the pelvis's space
  float worst_mm = 0;
  for (int frame = 0; frame <= 60; ++frame) {
    const float share = float(frame) / 60;
    must(pose_character(newt.body, {{newt.clip("idle"), share, 1 - share}, {newt.clip("walk"), share, share}}));
    marrow::TwoBone reach;
    for (int i = 0; i < 3; ++i) {
      const float(&row)[4] = newt.pose.model_from_joint[pelvis].rows[i];
      reach.target[i] = row[0] * place[0] + row[1] * place[1] + row[2] * place[2] + row[3];
    }
    reach.pole[0] = -1, reach.pole[2] = -0.5f;
    set_bend_axis(newt, arm.mid, reach);
    must(solve_two_bone(newt.pose, arm, reach));
    worst_mm = std::fmax(worst_mm, newt.millimetres(arm.end, reach.target));
    if (frame == 45) newt.save(folder, "hip");
  }
  std::printf("hip: the hand at most %.2f mm off\n", double(worst_mm));
}

int main(int argc, char** argv) {
  if (argc < 2) return 1;
  const char* const folder = argc > 2 ? argv[2] : nullptr;
  Newt newt(argv[1]);
  rail(newt, folder);
  animated_pole(newt);
  wheel(newt, folder);
  hip(newt, folder);
}
