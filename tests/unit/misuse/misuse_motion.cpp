// A clip's motion: events, root motion, phase, blend spaces.
#include <gtest/gtest.h>

#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

const std::vector<ClipEvent> kEvents = {{0, 0, 1, 0}, {0.5f, 0.75f, 2, 1}, {1, 1, 3, 2}};
const std::vector<float> kMarks = {0.25f, 0.75f};
const std::vector<RootKey> kRoot = {{0, {0, 0, 0, 1}, {0, 0, 0}}, {1, {0, 0.6f, 0, 0.8f}, {0, 0, 1.5f}}};
const std::vector<PlanePoint> kPoints = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
const std::vector<PlaneTriangle> kTriangles = {{{0, 1, 2}}, {{3, 2, 1}}};
const std::vector<SpeedPoint> kSpeeds = {{1, 1}, {3, 0.75f}};

// What a function reads of a motion; the rest is good.
enum class Reads { events, marks, root, all };

ClipMotion motion_of(Misuse& m, Reads reads) {
  const auto of = [&]<class T>(Reads part, const std::vector<T>& good) {
    return reads == part || reads == Reads::all ? m.in(good, Length::any) : Span<const T>(good);
  };
  return {.duration_s = m.number(1),
          .speed_m_s = 1.5f,
          .heading = {0, 0, 1},
          .events = of(Reads::events, kEvents),
          .phase_marks = of(Reads::marks, kMarks),
          .root = of(Reads::root, kRoot)};
}

Playback playback_of(Misuse& m, float time_s) {
  return {.time_s = static_cast<double>(m.number(time_s)),
          .speed = m.number(1),
          .mode = m.kind(PlayMode::loop),
          .returning = m.truth(false),
          .turns = static_cast<std::int32_t>(m.index(0))};
}

Phase phase_of(Misuse& m) {
  return {static_cast<double>(m.number(0.5f)), m.index(1), static_cast<std::int32_t>(m.index(1))};
}

RigidStep step_of(Misuse& m) {
  return {{0, m.number(0.6f), 0, m.number(0.8f)}, {m.number(1), 0, 2}};
}

}  // namespace

std::vector<MisuseRow> rows_of_motion() {
  return {
      {"is_valid",
       [](Misuse& m) {
         (void)is_valid(motion_of(m, Reads::all));
         m.returned_ok();
       }},
      {"events_between",
       [](Misuse& m) {
         const Span<EventHit> out = m.out<EventHit>(3, Length::any);
         std::size_t& met = m.one(std::size_t{0});
         const Playback before = playback_of(m, 0.25f);
         m.returned(
             events_between(motion_of(m, Reads::events), before, playback_of(m, 0.75f), m.truth(false), out, met));
       }},
      {"is_within",
       [](Misuse& m) {
         (void)is_within({m.number(0.5f), m.number(0.75f), 0, 0}, m.number(0.5f), m.number(1));
         m.returned_ok();
       }},
      {"sample_root",
       [](Misuse& m) {
         RigidStep& out = m.one(RigidStep{});
         m.returned(sample_root(motion_of(m, Reads::root), m.number(0.5f), out));
       }},
      {"root_step",
       [](Misuse& m) {
         RigidStep& out = m.one(RigidStep{});
         const Playback before = playback_of(m, 0.25f);
         m.returned(root_step(motion_of(m, Reads::root), before, playback_of(m, 0.75f), out));
       }},
      {"blend_root_steps",
       [](Misuse& m) {
         RigidStep& out = m.one(RigidStep{});
         const std::vector<RigidStep> steps = {step_of(m), step_of(m)};
         const std::vector<float> weights = {m.number(0.5f), 0.5f};
         const Span<const RigidStep> given = m.in(steps, Length::any);
         m.returned(blend_root_steps(given, m.in(weights), out));
       }},
      {"move_root",
       [](Misuse& m) {
         (void)move_root({{{1, 0, 0, m.number(1)}, {0, m.number(1), 0, 0}, {0, 0, 1, 0}}}, step_of(m));
         const double x = static_cast<double>(m.number(1));
         (void)move_root(RootPlace{{0, x, 0, 1}, {x, 0, 0}}, step_of(m));
         m.returned_ok();
       }},
      {"world_from_model",
       [](Misuse& m) {
         const double x = static_cast<double>(m.number(1));
         (void)world_from_model({{0, x, 0, 1}, {x, 0, 0}});
         m.returned_ok();
       }},
      {"retarget_pose",
       [](Misuse& m) {
         const std::vector<MappedTurn> turns = {{0, 1, 1, {0, 0, 0, 1}, {0, 0.6f, 0, 0.8f}},
                                                {3, 2, 0.5f, {0, 0, 0, 1}, {0, 0, 0, 1}},
                                                {3, 0, m.number(0.5f), {0, 0, 0, 1}, {m.number(0), 0, 0, 1}}};
         std::vector<MappedPlace> places(1);
         places[0].parent_from_rig[1][3] = m.number(1);
         const std::vector<RigStep> steps = {{0, 0, 0}, {4, 1, 0}, {5, 0, 1}, {0, 0, 0}};
         std::vector<MappedGroup> groups(stage().skeleton.soa_size());
         for (MappedGroup& g : groups)
           for (std::uint16_t lane = 0; lane < 4; ++lane) {
             g.before[3][lane] = g.after[3][lane] = m.number(1);
             g.rig_joints[lane] = static_cast<std::uint16_t>(m.index(lane));
           }
         PoseMap map;
         map.groups = m.in(groups);
         map.rig_joint_count = stage().skeleton.joint_count;
         map.turns = m.in(turns, Length::any);
         map.places = m.in(places, Length::any);
         map.steps = m.in(steps, Length::any);
         const Span<const SoaTransform> rig = m.in(stage().other);
         const Skeleton& skeleton = m.either(stage().skeleton, stage().smaller);
         m.returned(retarget_pose(map, rig, skeleton, m.out(stage().pose)));
       }},
      {"phase_at",
       [](Misuse& m) {
         Phase& out = m.one(Phase{});
         m.returned(phase_at(motion_of(m, Reads::marks), m.number(0.5f), out));
       }},
      {"advance_phase",
       [](Misuse& m) {
         Phase& phase = m.one(phase_of(m));
         const ClipMotion motions[] = {motion_of(m, Reads::marks), motion_of(m, Reads::marks)};
         const std::vector<PhaseClip> clips = {{m.pointer(&motions[0]), m.number(1)}, {&motions[1], m.number(0.5f)}};
         m.returned(advance_phase(m.in(clips, Length::any), m.number(0.1f), phase));
       }},
      {"follow_phase",
       [](Misuse& m) {
         Playback &from = m.one(Playback{}), &to = m.one(Playback{});
         const Phase before = phase_of(m);
         m.returned(follow_phase(motion_of(m, Reads::marks), before, phase_of(m), from, to));
       }},
      {"line_weights",
       [](Misuse& m) {
         const std::vector<float> points = {0, 1, m.number(3)};
         const Span<float> out = m.out<float>(3);
         m.returned(line_weights(m.in(points, Length::any), m.number(0.5f), out));
       }},
      {"plane_weights",
       [](Misuse& m) {
         const Span<float> out = m.out<float>(4);
         const Span<const PlaneTriangle> triangles = m.in(kTriangles, Length::any);
         m.returned(plane_weights(m.in(kPoints, Length::any), triangles, {m.number(0.5f), m.number(0.25f)}, out));
       }},
      {"match_speed",
       [](Misuse& m) {
         const Span<float> out = m.out<float>(2);
         float& rate = m.one(0.0f);
         m.returned(match_speed(m.in(kSpeeds, Length::any), m.number(2), out, rate));
       }},
  };
}

}  // namespace marrow::test
