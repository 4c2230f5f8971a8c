// A whole body that gives way, a tail that follows, and joints that keep to their limits. See docs/ik/cookbook.md.
#include "newt.h"

// Reaches for a handle that is too far for the arm: the feet stay, the pelvis goes along.
void door(Newt& newt, const char* folder) {
  newt.play("idle", 0);
  const float handle[3] = {0.25f, 0.4f, 0.6f};
  const std::uint32_t stay[] = {newt.joint("foot.L"), newt.joint("foot.R"), newt.joint("toes.L"), newt.joint("toes.R")};
  const std::uint32_t hand = newt.joint("hand.L");

  marrow::IkGoal goals[5];
  for (int g = 0; g < 4; ++g) {  // ankles and toes stay where they are: the urgent ones
    goals[g].joint = std::uint16_t(stay[g]);
    for (int i = 0; i < 3; ++i) goals[g].position[i] = newt.at(stay[g], i);
  }
  goals[4].joint = std::uint16_t(hand);
  goals[4].priority = 1;  // reaches as far as the feet allow
  for (int i = 0; i < 3; ++i) goals[4].position[i] = handle[i];

  // What may turn: legs, back and arm, ascending. The back is stiff, so that arm and legs do most.
  std::vector<std::uint16_t> joints;
  std::vector<float> stiffness;
  for (std::uint32_t j = 0; j < newt.pose.skeleton.joint_count; ++j)
    for (const char* name : {"pelvis", "thigh.L", "thigh.R", "shin.L", "shin.R", "foot.L", "foot.R", "spine_1",
                             "spine_2", "chest", "clavicle.L", "upper_arm.L", "forearm.L"})
      if (newt.joint(name) == j) {
        joints.push_back(std::uint16_t(j));
        stiffness.push_back(std::string(name).find("spine") == 0 ? 0.8f : 0.0f);
      }

  marrow::IkProblem problem;
  problem.goals = goals;
  problem.joints = joints;
  problem.stiffness = stiffness;
  problem.limits = newt.pose.skeleton.limits;
  problem.root_travel_m = 0.5f;  // the pelvis gives way: half a metre is as easy as a radian
  marrow::IkOptions options;
  options.max_iterations = 16;
  options.tolerance_m = 1e-3f;
  std::vector<std::byte> scratch(ik_scratch_bytes(newt.pose.skeleton, problem, options));
  const float before = newt.at(newt.joint("pelvis"), 1);
  marrow::IkReport report;
  must(solve_ik(newt.pose, problem, options, scratch, &report));
  float feet_mm = 0;
  for (int g = 0; g < 4; ++g) feet_mm = std::fmax(feet_mm, newt.millimetres(stay[g], goals[g].position));
  std::printf("door: the hand %.2f mm off, the feet at most %.2f, the pelvis %.0f mm down, %u iterations\n",
              double(newt.millimetres(hand, handle)), double(feet_mm),
              double(1000 * (before - newt.at(newt.joint("pelvis"), 1))), report.iterations);
  newt.save(folder, "door");
}

// The end of the tail follows a point that is limited in speed and acceleration, so that it neither jumps nor shakes.
void tail(Newt& newt, const char* folder) {
  const char* const names[] = {"tail_1", "tail_2", "tail_3", "tail_4", "tail_5", "tail_6", "tail_7"};
  std::vector<std::uint16_t> joints;
  for (const char* name : names) joints.push_back(std::uint16_t(newt.joint(name)));
  marrow::IkGoal goal;
  goal.joint = std::uint16_t(newt.joint("tail_8"));
  marrow::IkProblem problem;
  problem.goals = {&goal, 1};
  problem.joints = joints;
  marrow::IkOptions options;
  options.method = marrow::IkMethod::fabrik;  // a chain without limits
  std::vector<std::byte> scratch(ik_scratch_bytes(newt.pose.skeleton, problem, options));

  marrow::PointFollower tip;
  const marrow::RateLimit slow{1.5f, 12};  // metres a second, and a second squared
  float fastest = 0, worst_mm = 0, last[3] = {};
  for (int frame = 0; frame < 90; ++frame) {
    newt.play("idle", float(frame) / 60);
    const float side = frame < 30 ? 0.5f : -0.5f;  // the toy jumps to the other side
    const float toy[3] = {side, 0.3f, -0.8f};
    must(follow_point(tip, toy, 1.0f / 60, slow));
    for (int i = 0; i < 3; ++i) goal.position[i] = tip.point[i];
    must(solve_ik(newt.pose, problem, options, scratch));
    worst_mm = std::fmax(worst_mm, newt.millimetres(goal.joint, goal.position));
    if (frame > 0) fastest = std::fmax(fastest, newt.millimetres(goal.joint, last) * 60 / 1000);
    for (int i = 0; i < 3; ++i) last[i] = newt.at(goal.joint, i);
    if (frame == 20) newt.save(folder, "tail");
  }
  std::printf("tail: at most %.2f mm off its point, and %.2f m/s fast\n", double(worst_mm), double(fastest));
}

// A hand to the head, without the limits of the asset and within them.
void limits(Newt& newt, const char* folder) {
  const std::uint16_t joints[] = {std::uint16_t(newt.joint("upper_arm.L")), std::uint16_t(newt.joint("forearm.L"))};
  const std::uint32_t elbow = joints[1];
  marrow::IkGoal goal;
  goal.joint = std::uint16_t(newt.joint("hand.L"));
  goal.position[0] = 0.1f, goal.position[1] = 1.2f;
  for (const bool keep : {false, true}) {
    newt.play("idle", 0);
    marrow::IkProblem problem;
    problem.goals = {&goal, 1};
    problem.joints = joints;
    if (keep) problem.limits = newt.pose.skeleton.limits;
    marrow::IkOptions options;
    options.max_iterations = 32;
    std::vector<std::byte> scratch(ik_scratch_bytes(newt.pose.skeleton, problem, options));
    must(solve_ik(newt.pose, problem, options, scratch));
    marrow::JointTransform turned;
    must(get_joint(newt.pose.local, elbow, turned));
    const float over = limit_excess(*find_limit(newt.pose.skeleton.limits, elbow), turned.rotation);
    std::printf("limits %s: the hand %.2f mm off, the elbow %.1f degrees beyond its limit\n", keep ? "kept" : "ignored",
                double(newt.millimetres(goal.joint, goal.position)), double(over * 57.29578f));
    newt.save(folder, keep ? "limits" : "no-limits");
  }
}

int main(int argc, char** argv) {
  if (argc < 2) return 1;
  const char* const folder = argc > 2 ? argv[2] : nullptr;
  Newt newt(argv[1]);
  door(newt, folder);
  tail(newt, folder);
  limits(newt, folder);
}
