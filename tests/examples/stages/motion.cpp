// What a walk does: how fast it goes, and which feet stand when.
// $ motion hero.mrw walk
#include "asset.h"

// Whether a foot stands at a time; `foot` is the name of its events.
bool stands(const marrow::ClipMotion& motion, std::uint32_t foot, float time_s) {
  for (const marrow::ClipEvent& e : motion.events)
    if (e.name == foot && is_within(e, time_s, motion.duration_s)) return true;
  return false;
}

int main(int argc, char** argv) {
  Asset asset;
  if (argc < 3 || asset.open(argv[1]) != marrow::Status::ok) return 1;
  const marrow::ClipMotion walk = asset.file.motion(asset.file.find_clip(argv[2]));
  std::printf("%.2f m/s along z: %.0f, in %zu steps of %.1f s\n", double(walk.speed_m_s), double(walk.heading[2]),
              walk.phase_marks.size, double(walk.duration_s) / double(walk.phase_marks.size));
  std::uint32_t feet[2];
  for (int i = 0; i < 2; ++i) {
    const std::uint32_t step = asset.file.find_event(walk, i == 0 ? "left_foot" : "right_foot");
    if (step == walk.events.size) return 1;
    feet[i] = walk.events[step].name;
  }
  for (const float time_s : {0.3f, 0.65f, 0.9f})
    std::printf("%.2f s:%s%s\n", double(time_s), stands(walk, feet[0], time_s) ? " left foot stands" : "",
                stands(walk, feet[1], time_s) ? " right foot stands" : "");
}

// Prints:
//   0.38 m/s along z: 1, in 2 steps of 0.6 s
//   0.30 s: left foot stands
//   0.65 s: left foot stands right foot stands
//   0.90 s: right foot stands
