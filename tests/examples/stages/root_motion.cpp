// A character that walks as its clips do: straight, in a curve, and half of each.
// $ root_motion
#include <marrow/root_motion.h>

#include <cmath>
#include <cstdio>

using marrow::Status;

int main() {
  // A second of each: 1.5 m straight ahead, and a quarter turn to the left along an arc, 30 keys a second.
  const marrow::RootKey ahead[] = {{0, {0, 0, 0, 1}, {0, 0, 0}}, {1, {0, 0, 0, 1}, {0, 0, 1.5f}}};
  marrow::RootKey left[31];
  for (int i = 0; i <= 30; ++i) {
    const float turn = 1.57079633f * float(i) / 30, radius = 1.5f / 1.57079633f;
    left[i] = {float(i) / 30,
               {0, std::sin(turn / 2), 0, std::cos(turn / 2)},
               {radius * (1 - std::cos(turn)), 0, radius * std::sin(turn)}};
  }
  const marrow::ClipMotion clips[] = {{.duration_s = 1, .root = ahead}, {.duration_s = 1, .root = left}};
  if (!is_valid(clips[0]) || !is_valid(clips[1])) return 1;

  const struct {
    const char* name;
    float weights[2];
  } ways[] = {{"straight", {1, 0}}, {"left", {0, 1}}, {"half and half", {0.5f, 0.5f}}};
  for (const auto& way : ways) {
    for (const int frames_a_second : {60, 4}) {
      marrow::Affine world_from_model{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
      marrow::Playback playbacks[2];
      for (int frame = 0; frame < 3 * frames_a_second; ++frame) {
        marrow::RigidStep steps[2], step;
        for (int i = 0; i < 2; ++i) {
          const marrow::Playback before = playbacks[i];
          if (advance(playbacks[i], clips[i].duration_s, 1.0f / float(frames_a_second)) != Status::ok ||
              root_step(clips[i], before, playbacks[i], steps[i]) != Status::ok)
            return 1;
        }
        if (blend_root_steps(steps, way.weights, step) != Status::ok) return 1;
        world_from_model = move_root(world_from_model, step);
      }
      std::printf("%s, %d frames a second: after 3 s at %.2f %.2f m\n", way.name, frames_a_second,
                  double(world_from_model.rows[0][3]), double(world_from_model.rows[2][3]));
    }
  }
}

// Prints:
//   straight, 60 frames a second: after 3 s at 0.00 4.50 m
//   straight, 4 frames a second: after 3 s at 0.00 4.50 m
//   left, 60 frames a second: after 3 s at 0.95 -0.95 m
//   left, 4 frames a second: after 3 s at 0.95 -0.95 m
//   half and half, 60 frames a second: after 3 s at 3.26 1.35 m
//   half and half, 4 frames a second: after 3 s at 3.26 1.35 m
