// What a step of a clip meets and moves, clips in step, and spaces: on motions of noise.
#include "bits/stages.h"
#include "marrow/blend_space.h"
#include "marrow/events.h"
#include "marrow/phase.h"
#include "marrow/pose_map.h"
#include "marrow/root_motion.h"

namespace marrow::test {
namespace {

// Eight events, three marks that begin in the middle of the clip, and nine keys that turn by 90 degrees in all.
struct NoiseMotion {
  explicit NoiseMotion(Random& random) {
    const auto number = [&](double least, double most) { return static_cast<float>(random.between(least, most)); };
    motion.duration_s = number(0.5, 2);
    for (int i = 0; i < 8; ++i) {
      const float time_s = motion.duration_s * static_cast<float>(i) / 8;
      events.push_back({time_s, time_s + 0.0625f, 0, number(-1, 1)});
    }
    marks = {0.75f * motion.duration_s, 0.125f * motion.duration_s, 0.5f * motion.duration_s};
    for (int i = 0; i < 9; ++i) {
      const float share = static_cast<float>(i) / 8, sine = 0.7071f * share;
      root.push_back({share * motion.duration_s, {0, sine, 0, 1 - 0.2929f * share}, {share, 0, 2 * share}});
      const float squared = sine * sine + root.back().rotation[3] * root.back().rotation[3];
      for (float& q : root.back().rotation) q *= 1.5f - 0.5f * squared;  // nearly of length 1
    }
    root[0] = {0, {0, 0, 0, 1}, {0, 0, 0}};
    motion.events = events;
    motion.phase_marks = marks;
    motion.root = root;
  }
  std::vector<ClipEvent> events;
  std::vector<float> marks;
  std::vector<RootKey> root;
  ClipMotion motion;
};

std::uint64_t steps_hash(Random& random) {
  std::uint64_t h = kHashStart;
  for (int i = 0; i < 300; ++i) {
    const NoiseMotion one(random);
    Playback now{.speed = static_cast<float>(random.between(-3, 3)), .mode = static_cast<PlayMode>(i % 3)};
    for (int frame = 0; frame < 20; ++frame) {
      const Playback before = now;
      must(advance(now, one.motion.duration_s, static_cast<float>(random.between(0, 2))));
      EventHit hits[8];
      std::size_t met = 0;
      must(events_between(one.motion, before, now, frame == 0, hits, met));
      h = hash(h, hits, met * sizeof *hits);
      RigidStep steps[2];
      must(root_step(one.motion, before, now, steps[0]));
      const float weights[] = {0.75f, static_cast<float>(random.between(0, 1))};
      must(blend_root_steps(steps, weights, steps[1]));
      h = hash(h, steps, sizeof steps);
    }
  }
  return h;
}

std::uint64_t phases_hash(Random& random) {
  std::uint64_t h = kHashStart;
  const NoiseMotion clips[3] = {NoiseMotion(random), NoiseMotion(random), NoiseMotion(random)};
  Phase phase;
  for (int frame = 0; frame < 2000; ++frame) {
    const Phase before = phase;
    const SpeedPoint speeds[] = {{0, 2}, {1.25f, 1}, {4, 0.75f}};
    float weights[3], rate = 1;
    must(match_speed(speeds, static_cast<float>(random.between(0, 6)), weights, rate));
    const PhaseClip group[] = {
        {&clips[0].motion, weights[0]}, {&clips[1].motion, weights[1]}, {&clips[2].motion, weights[2]}};
    must(advance_phase(group, rate * static_cast<float>(random.between(-0.5, 1)), phase));
    h = hash(hash(h, weights, sizeof weights), &phase, sizeof phase);
    for (const NoiseMotion& clip : clips) {
      Playback was, now;
      must(follow_phase(clip.motion, before, phase, was, now));
      h = hash(hash(h, &was.time_s, sizeof was.time_s), &now.time_s, sizeof now.time_s);
    }
  }
  return h;
}

void make_turn(Random& random, float (&before)[4], float (&after)[4]) {
  const Quat one = random.rotation(), other = random.rotation();
  for (std::size_t c = 0; c < 4; ++c) {
    before[c] = static_cast<float>(one[c]);
    after[c] = static_cast<float>(other[c]);
  }
}

// A rig of noise on a skeleton of noise: joints in groups, four between two joints each, ways up and down, and places.
std::uint64_t retargets_hash(Random& random) {
  const TestCharacter rig = make_character(61, 40, 8, false), hero = make_character(67, 67, 8, false);
  const Skeleton skeleton = hero.skeleton.view();
  const auto rig_joints = static_cast<std::uint32_t>(rig.skeleton.joints.size());
  const auto some_joint = [&] { return static_cast<std::uint16_t>(random.below(rig_joints)); };
  std::vector<MappedGroup> groups(skeleton.soa_size());
  std::vector<MappedTurn> turns;
  std::vector<MappedPlace> places(2);
  std::vector<RigStep> steps;
  for (std::uint32_t j = 0; j < 4 * groups.size(); ++j) {
    float before[4], after[4];
    make_turn(random, before, after);
    for (int c = 0; c < 4; ++c) {
      groups[j / 4].before[c][j % 4] = before[c];
      groups[j / 4].after[c][j % 4] = after[c];
    }
    groups[j / 4].rig_joints[j % 4] = j % 9 == 0 ? kNoJoint : some_joint();
  }
  for (std::uint16_t i = 0; i < 12; ++i) {
    MappedTurn turn;
    turn.joint = i < 8 ? i / 2 : i;
    turn.step_count = i % 4;
    turn.weight = static_cast<float>(random.between(0.25, 1));
    make_turn(random, turn.before, turn.after);
    for (std::uint32_t s = 0; s < turn.step_count; ++s)
      steps.push_back({some_joint(), static_cast<std::uint8_t>(s == 0), static_cast<std::uint8_t>(i % 5 == 0)});
    turns.push_back(turn);
  }
  for (std::uint16_t p = 0; p < 2; ++p) {
    places[p].joint = p;
    places[p].step_count = 2;
    for (auto& row : places[p].parent_from_rig)
      for (float& x : row) x = static_cast<float>(random.between(-1, 1));
    for (std::uint16_t s = 0; s < 2; ++s) steps.push_back({static_cast<std::uint16_t>(s + p), 0, 0});
  }
  PoseMap map;
  map.rig_joint_count = rig_joints;
  map.groups = groups;
  map.turns = turns;
  map.places = places;
  map.steps = steps;
  std::vector<SoaTransform> pose(rig.skeleton.rest.size()), out(skeleton.soa_size());
  std::uint64_t h = kHashStart;
  const Clip clip = rig.clip.view();
  for (int frame = 0; frame < 200; ++frame) {
    must(sample(rig.skeleton.view(), clip, clip.duration_s * static_cast<float>(random.between(0, 1)), pose));
    must(retarget_pose(map, pose, skeleton, out));
    h = hash_of(out, h);
  }
  return h;
}

}  // namespace

void hash_motions(StageHashes& out) {
  Random random(57);
  out.push_back({"events, root steps", steps_hash(random)});
  out.push_back({"phases, speeds", phases_hash(random)});
  out.push_back({"retarget_pose", retargets_hash(random)});
}

}  // namespace marrow::test
