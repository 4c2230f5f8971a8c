// Step 5: the newt looks at a fly: chest, neck and head turn after it, and the eyes are on it at once.
#include "actor.h"
#include "ground.h"

const char* const kFlyVertex = R"(
uniform mat4 clip_from_model;
uniform vec3 fly;
void main() {
  gl_Position = clip_from_model * vec4(fly, 1.0);
  gl_PointSize = 24.0 / gl_Position.w;
}
)";

const char* const kFlyFragment = R"(
precision mediump float;
out vec4 pixel;
void main() {
  if (length(gl_PointCoord - 0.5) > 0.5) discard;
  pixel = vec4(0.1, 0.1, 0.1, 1.0);
}
)";

struct Gaze {
  std::uint32_t chain[3], eyes[2];
  marrow::PointFollower attention;  // what the head is turned to: it comes after the fly

  Gaze(const marrow::File& file, const marrow::Skeleton& skeleton)
      : chain{find(file, skeleton, "chest"), find(file, skeleton, "neck"), find(file, skeleton, "head")},
        eyes{find(file, skeleton, "eye.L"), find(file, skeleton, "eye.R")} {}

  void look(const marrow::Pose& pose, const float (&fly)[3], float dt_s) {
    must(follow_point(attention, fly, dt_s, {.speed = 1.5f, .acceleration = 6}), "attention");
    marrow::Aim aim;
    for (int i = 0; i < 3; ++i) aim.target[i] = attention.point[i];
    aim.weight = 0.8f;      // eyes do the rest
    aim.offset[1] = 0.19f;  // so high above the joint of the head are the eyes
    aim.pole[1] = 1;        // the head's up stays above
    must(solve_look_at(pose, chain, aim, 0.5f), "the head");
    for (const std::uint32_t eye : eyes) {
      marrow::Aim at_fly;
      for (int i = 0; i < 3; ++i) at_fly.target[i] = fly[i];
      must(solve_aim(pose, eye, at_fly), "an eye");
    }
  }
};

int main(int argc, char** argv) {
  Window window(argc, argv);
  window.eye = {0.6f, 1.0f, 1.8f};
  window.at = {0.05f, 0.85f, 0};
  const marrow::File file = load_file(window.file);
  Programs programs;
  Actor newt(file, window, programs);
  const marrow::Animation& idle = find(newt.animations, "idle");
  Gaze gaze(file, newt.body.skeletons[0].pose.skeleton);
  Ground ground(level);
  ground.upload(window);
  const unsigned fly_program = window.compile(kFlyVertex, kFlyFragment);

  marrow::Playback playback;
  float time_s = 0;
  for (float dt_s; window.begin(dt_s); window.end()) {
    time_s += dt_s;
    const float fly[3] = {0.6f * std::sin(2 * time_s), 1.05f + 0.25f * std::sin(3.1f * time_s), 0.7f};
    must(advance(playback, idle.duration_s, dt_s), "time");
    must(pose_character(newt.body, {{&idle, clip_time(playback)}}), "pose");
    gaze.look(newt.body.skeletons[0].pose, fly, dt_s);
    window.clear();
    ground.draw(window, 0);
    newt.draw(window, programs);
    const float white[] = {1, 1, 1};
    window.use(fly_program, white);
    window.gl.Uniform3fv(window.gl.GetUniformLocation(fly_program, "fly"), 1, fly);
    window.gl.BindVertexArray(0);
    window.gl.DrawArrays(GL_POINTS, 0, 1);
  }
}
