// Footsteps and a blow: what each frame of a playing clip meets.
// $ events
#include <marrow/events.h>

#include <cstdio>

using marrow::Status;

int main() {
  // A cycle of one second: the left foot stands over the clip's end, and the right one in its middle.
  enum Name : unsigned { foot_left, foot_right };
  const char* const names[] = {"left", "right"};
  const marrow::ClipEvent steps[] = {{.time_s = 0.25f, .until_s = 0.75f, .name = foot_right},
                                     {.time_s = 0.75f, .until_s = 1.25f, .name = foot_left}};
  const marrow::ClipMotion walk{.duration_s = 1, .events = steps};
  if (!is_valid(walk)) return 1;  // once, where a motion is made by hand

  marrow::Playback playback;
  bool first = true;
  for (int frame = 1; frame <= 5; ++frame) {
    const marrow::Playback before = playback;
    marrow::EventHit hits[4];
    std::size_t met = 0;
    if (advance(playback, walk.duration_s, 0.3f) != Status::ok ||
        events_between(walk, before, playback, first, hits, met) != Status::ok)
      return 1;
    first = false;
    std::printf("%.1f s:", 0.3 * frame);
    for (std::size_t i = 0; i < met; ++i) std::printf(" %s foot comes down", names[steps[hits[i].event].name]);
    for (const marrow::ClipEvent& step : steps)
      if (is_within(step, clip_time(playback), walk.duration_s)) std::printf(" (%s foot stands)", names[step.name]);
    std::printf("\n");
  }

  // A frame that took a minute loses nothing.
  const marrow::Playback before = playback;
  marrow::EventHit hits[4];
  std::size_t met = 0;
  if (advance(playback, walk.duration_s, 60) != Status::ok ||
      events_between(walk, before, playback, first, hits, met) != Status::ok)
    return 1;
  for (std::size_t i = 0; i < met; ++i)
    std::printf("in a minute: %s foot, %u times\n", names[steps[hits[i].event].name], hits[i].count);
}

// Prints:
//   0.3 s: right foot comes down (right foot stands)
//   0.6 s: (right foot stands)
//   0.9 s: left foot comes down (left foot stands)
//   1.2 s: (left foot stands)
//   1.5 s: right foot comes down (right foot stands)
//   in a minute: left foot, 60 times
//   in a minute: right foot, 60 times
