// Limbs, aims, chains, feet and springs, on a creature of noise that stands in a pose of its clip.
#include <cmath>

#include "bits/stages.h"
#include "support/aligned.h"

namespace marrow::test {
namespace {

// A trunk of joints, each a little turned, with two legs of three bones at its foot.
TestSkeleton make_walker() {
  Random random(71);
  std::vector<TestJoint> joints;
  const auto add = [&](int parent, const Vec3& translation) {
    const double a = random.between(-0.25, 0.25), b = random.between(-0.25, 0.25), c = random.between(-0.25, 0.25);
    const double length = std::sqrt(1 + a * a + b * b + c * c);
    joints.push_back({parent, translation, {a / length, b / length, c / length, 1 / length}, {1, 1, 1}});
  };
  add(-1, {0, 1, 0});                                                          // 0: the pelvis
  add(0, {0, 0.25, 0});                                                        // 1: the spine
  add(0, {0.125, 0, 0});                                                       // 2: the left hip
  add(0, {-0.125, 0, 0});                                                      // 3: the right hip
  add(1, {0, 0.25, 0});                                                        // 4: the chest
  add(2, {0, -0.5, 0});                                                        // 5: the left knee
  add(3, {0, -0.5, 0});                                                        // 6: the right knee
  add(4, {0, 0.25, 0});                                                        // 7: the head
  add(5, {0, -0.5, 0});                                                        // 8: the left ankle
  add(6, {0, -0.5, 0});                                                        // 9: the right ankle
  for (int j = 7; j < 15; ++j) add(j == 7 ? 7 : j + 2, {0, -0.125, -0.0625});  // 10 … 17: a plait
  return TestSkeleton(joints);
}

struct Walker {
  Walker() : source(make_walker()), skeleton(source.view()), local(source.rest), scene(skeleton.joint_count) {
    pose(0);
  }
  // The rest pose with its joints turned a little further.
  void pose(std::uint64_t seed) {
    Random random(seed + 100);
    local = source.rest;
    for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) {
      JointTransform t;
      must(get_joint(local, j, t));
      float squared = 0;
      for (float& q : t.rotation) {
        q += static_cast<float>(random.between(-0.125, 0.125));
        squared += q * q;
      }
      for (float& q : t.rotation) q /= std::sqrt(squared);
      must(set_joint(local, j, t));
    }
    must(local_to_model(skeleton, local, scene));
  }
  std::uint64_t hashed(std::uint64_t state) const { return hash_of(scene, hash_of(local, state)); }

  TestSkeleton source;
  Skeleton skeleton;
  std::vector<SoaTransform> local;
  std::vector<Affine> scene;
};

void put(Random& random, double most, float (&out)[3]) {
  for (float& x : out) x = static_cast<float>(random.between(-most, most));
}

std::uint64_t two_bone_hash() {
  Walker w;
  Random random(72);
  std::uint64_t h = kHashStart;
  for (std::uint64_t i = 0; i < 200; ++i) {
    w.pose(i);
    TwoBone goal;
    put(random, 1, goal.target);
    if (i % 2 == 1) put(random, 1, goal.pole);
    goal.twist_rad = i % 3 == 2 ? 0.5f : 0.0f;
    goal.weight = i % 5 == 4 ? 0.75f : 1.0f;
    goal.soft = i % 7 == 6 ? 0.97f : 1.0f;
    goal.max_stretch = i % 4 == 3 ? 1.5f : 1.0f;
    goal.bend_axis[0] = i % 6 == 5 ? 1.0f : 0.0f;
    must(solve_two_bone({w.skeleton, w.local, w.scene}, {2, 5, 8}, goal));
    const TwoBoneJoints joints[] = {{&w.scene[3], &w.scene[6], &w.scene[9]},
                                    {&w.scene[2], &w.scene[5], &w.scene[8]},
                                    {&w.scene[0], &w.scene[1], &w.scene[4]},
                                    {&w.scene[1], &w.scene[4], &w.scene[7]}};
    const TwoBone goals[] = {goal, goal, goal, goal};
    TwoBoneTurns turns[4];
    must(two_bone_x4(joints, goals, turns));
    for (const TwoBoneTurns& t : turns) h = hash(hash(hash(h, t.start, 16), t.mid, 16), &t.stretch, 4);
    h = w.hashed(h);
  }
  return h;
}

std::uint64_t aim_hash() {
  Walker w;
  Random random(73);
  std::uint64_t h = kHashStart;
  for (std::uint64_t i = 0; i < 200; ++i) {
    w.pose(i);
    Aim goal;
    put(random, 2, goal.target);
    if (i % 2 == 1) put(random, 1, goal.pole);
    goal.twist_rad = i % 3 == 2 ? -0.5f : 0.0f;
    goal.weight = i % 5 == 4 ? 0.75f : 1.0f;
    goal.offset[1] = i % 4 == 3 ? 0.125f : 0.0f;
    const std::uint32_t chain[] = {1, 4, 7};
    must(solve_look_at({w.skeleton, w.local, w.scene}, chain, goal, 0.5f));
    must(solve_aim({w.skeleton, w.local, w.scene}, 7, goal));
    h = w.hashed(h);
  }
  return h;
}

std::uint64_t chains_hash(IkMethod method) {
  Walker w;
  Random random(74);
  std::uint64_t h = kHashStart;
  for (std::uint64_t i = 0; i < 40; ++i) {
    w.pose(i);
    IkGoal goals[2] = {{.joint = 9, .position = {0, 0, 0}}, {.joint = 17, .position = {0, 0, 0}}};
    for (IkGoal& goal : goals) put(random, 1.5, goal.position);
    const std::uint16_t joints[] = {1, 3, 4, 6, 7, 10, 11, 12, 13};
    const IkProblem problem{.goals = goals, .joints = joints};
    const IkOptions options{.method = method};
    std::vector<std::byte> scratch(ik_scratch_bytes(w.skeleton, problem, options));
    IkReport report;
    must(solve_ik({w.skeleton, w.local, w.scene}, problem, options, scratch, &report));
    h = hash(w.hashed(h), &report.error_m, sizeof report.error_m);
  }
  return h;
}

std::uint64_t genetic_hash() {
  Walker w;
  Random random(75);
  IkGoal goal{.joint = 17};
  put(random, 1, goal.position);
  const std::uint16_t joints[] = {1, 4, 7, 10, 11, 12, 13};
  const IkProblem problem{.goals = {&goal, 1}, .joints = joints};
  std::vector<std::byte> scratch(ik_genetic_scratch_bytes(w.skeleton, problem));
  must(solve_ik_genetic({w.skeleton, w.local, w.scene}, problem, {.max_iterations = 8, .seed = 5}, scratch));
  return w.hashed(kHashStart);
}

std::uint64_t feet_hash() {
  Walker w;
  Random random(76);
  const Foot legs[] = {{.hip = 2, .knee = 5, .ankle = 8, .sole = {0, -0.0625f, 0.125f}},
                       {.hip = 3, .knee = 6, .ankle = 9, .sole = {0, -0.0625f, 0.125f}}};
  FootMotion motion[2];
  std::uint64_t h = kHashStart;
  for (std::uint64_t i = 0; i < 120; ++i) {
    w.pose(i / 8);
    FootGround ground[2];
    for (FootGround& g : ground) {
      g.hit = i % 16 != 15;
      g.point[1] = static_cast<float>(random.between(-0.125, 0.125));
      g.normal[0] = static_cast<float>(random.between(-0.25, 0.25));
      g.planted = i % 8 < 4;
    }
    FeetFrame frame;
    frame.dt_s = 1.0f / 60;
    must(place_feet({w.skeleton, w.local, w.scene}, {.feet = legs, .pelvis = 0}, frame, ground, motion));
    h = w.hashed(h);
  }
  return h;
}

std::uint64_t springs_hash() {
  Walker w;
  std::vector<SpringJoint> plait;
  for (std::uint16_t j = 10; j < 18; ++j)
    plait.push_back({.joint = j, .frequency_hz = 1.5f, .damping_ratio = 0.25f, .drag = 0.5f, .radius_m = 0.02f});
  const SpringChain chain{plait, {0, -0.125f, 0}};
  AlignedBlock memory(springs_bytes(w.skeleton, {&chain, 1}));
  Springs springs;
  must(make_springs(w.skeleton, {&chain, 1}, {memory.data(), memory.size()}, springs));
  const SpringCollider chest{.joint = 4, .from = {0, 0, 0}, .to = {0, 0.25f, 0}, .radius_m = 0.25f};
  std::uint64_t h = kHashStart;
  for (std::uint64_t i = 0; i < 120; ++i) {
    w.pose(i / 12);
    SpringFrame frame;
    frame.dt_s = 1.0f / static_cast<float>(24 + 12 * (i % 4));
    frame.world_from_model.rows[0][3] = 0.015625f * static_cast<float>(i);
    frame.wind[2] = 2;
    frame.colliders = {&chest, 1};
    must(simulate_springs({w.skeleton, w.local, w.scene}, frame, springs));
    h = w.hashed(h);
  }
  return h;
}

}  // namespace

void hash_reach(StageHashes& out) {
  out.push_back({"two_bone", two_bone_hash()});
  out.push_back({"aim, look_at", aim_hash()});
  out.push_back({"FABRIK", chains_hash(IkMethod::fabrik)});
  out.push_back({"CCD", chains_hash(IkMethod::ccd)});
  out.push_back({"damped least squares", chains_hash(IkMethod::damped_least_squares)});
  out.push_back({"Gauss-Newton", chains_hash(IkMethod::gauss_newton)});
  out.push_back({"genetic", genetic_hash()});
  out.push_back({"place_feet", feet_hash()});
  out.push_back({"simulate_springs", springs_hash()});
}

}  // namespace marrow::test
