// Idle, walk and run by speed: weights that give exactly the speed asked for, and clips whose feet agree.
// $ blend_spaces
#include <marrow/blend_space.h>
#include <marrow/events.h>
#include <marrow/phase.h>

#include <cstdio>

using marrow::Status;

int main() {
  // A step of the left foot, then one of the right: two marks a cycle.
  const float idle_marks[] = {0, 1}, walk_marks[] = {0, 0.5f}, run_marks[] = {0.1f, 0.4f};
  const marrow::ClipMotion clips[] = {{.duration_s = 2, .speed_m_s = 0, .phase_marks = idle_marks},
                                      {.duration_s = 1, .speed_m_s = 1.2f, .phase_marks = walk_marks},
                                      {.duration_s = 0.6f, .speed_m_s = 3.6f, .phase_marks = run_marks}};
  marrow::SpeedPoint points[3];
  for (int i = 0; i < 3; ++i) points[i] = {clips[i].speed_m_s, clips[i].duration_s};

  marrow::Phase phase;
  for (const float speed : {0.6f, 1.2f, 2.4f, 5.4f}) {
    float weights[3], rate = 1;
    if (match_speed(points, speed, weights, rate) != Status::ok) return 1;
    marrow::PhaseClip group[3];
    for (int i = 0; i < 3; ++i) group[i] = {&clips[i], weights[i]};
    const marrow::Phase before = phase;
    if (advance_phase(group, rate * 0.25f, phase) != Status::ok) return 1;
    std::printf("%.1f m/s: idle %.2f walk %.2f run %.2f, %.1f times as fast; step %u, %.2f of it; times", double(speed),
                double(weights[0]), double(weights[1]), double(weights[2]), double(rate), phase.segment, phase.share);
    for (const marrow::ClipMotion& clip : clips) {
      marrow::Playback was, now;
      if (follow_phase(clip, before, phase, was, now) != Status::ok) return 1;
      std::printf(" %.2f", now.time_s);  // sample each clip there; events_between() and root_step() take both
    }
    std::printf(" s\n");
  }

  // In a plane: forwards and sideways, four clips and one in the middle.
  const marrow::PlanePoint places[] = {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const marrow::PlaneTriangle triangles[] = {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 4}}, {{0, 4, 1}}};
  float weights[5];
  for (const marrow::PlanePoint& at : {marrow::PlanePoint{0.25f, 0.5f}, marrow::PlanePoint{2, 2}}) {
    if (plane_weights(places, triangles, at, weights) != Status::ok) return 1;
    std::printf("at %.2f %.2f: middle %.2f right %.2f front %.2f left %.2f back %.2f\n", double(at.x), double(at.y),
                double(weights[0]), double(weights[1]), double(weights[2]), double(weights[3]), double(weights[4]));
  }
}

// Prints:
//   0.6 m/s: idle 0.33 walk 0.67 run 0.00, 1.0 times as fast; step 0, 0.38 of it; times 0.38 0.19 0.21 s
//   1.2 m/s: idle 0.00 walk 1.00 run 0.00, 1.0 times as fast; step 0, 0.88 of it; times 0.88 0.44 0.36 s
//   2.4 m/s: idle 0.00 walk 0.37 run 0.63, 1.0 times as fast; step 1, 0.54 of it; times 1.54 0.77 0.56 s
//   5.4 m/s: idle 0.00 walk 0.00 run 1.00, 1.5 times as fast; step 0, 0.79 of it; times 0.79 0.40 0.34 s
//   at 0.25 0.50: middle 0.25 right 0.25 front 0.50 left 0.00 back 0.00
//   at 2.00 2.00: middle 0.00 right 0.50 front 0.50 left 0.00 back 0.00
