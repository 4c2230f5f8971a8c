// Step 3: the walking character of step 2, skinned by the GPU.
#include "actor.h"

int main(int argc, char** argv) {
  Window window(argc, argv);
  const marrow::File file = load_file(window.file);
  Programs programs;
  Actor newt(file, window, programs);
  const marrow::Animation& walk = find(newt.animations, "walk");

  marrow::Playback playback;
  for (float dt_s; window.begin(dt_s); window.end()) {
    must(advance(playback, walk.duration_s, dt_s), "time");
    must(pose_character(newt.body, {{&walk, clip_time(playback)}}), "pose");
    window.clear();
    newt.draw(window, programs);
  }
}
