// Step 8: the context is lost, with all that was in it, and the newt walks on in another. L loses it; so does the
// driver.
#include "actor.h"
#include "ground.h"

void restore(Window& window, Programs& programs, Actor& newt, Ground& ground) {
  on_context_lost(programs.set);
  for (gles3::Skinner& skinner : newt.skinners) on_context_lost(skinner);
  window.open();
  must(on_context_restored(window.gl, window.caps, programs.set), "programs of the new context");
  for (gles3::Skinner& skinner : newt.skinners)
    must(on_context_restored(window.gl, window.caps, skinner), "a mesh in the new context");
  ground.upload(window);
}

int main(int argc, char** argv) {
  Window window(argc, argv);
  const marrow::File file = load_file(window.file);
  Programs programs;
  Actor newt(file, window, programs);
  const marrow::Animation& walk = find(newt.animations, "walk");
  Ground ground(level);
  ground.upload(window);

  marrow::Playback playback;
  float walked = 0;
  bool held = false;
  for (float dt_s; window.begin(dt_s); window.end()) {
    const bool l = window.pressed(GLFW_KEY_L);
    if (gles3::context_was_reset(window.gl) || window.frame == window.lose || (l && !held))
      restore(window, programs, newt, ground);
    held = l;
    walked += 0.375f * dt_s;
    must(advance(playback, walk.duration_s, dt_s), "time");
    must(pose_character(newt.body, {{&walk, clip_time(playback)}}), "pose");
    window.clear();
    ground.draw(window, walked);
    newt.draw(window, programs);
  }
}
