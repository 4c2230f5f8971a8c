// Step 4: the newt walks over hills, and its feet stand on them.
#include "actor.h"
#include "ground.h"

struct Legs {
  marrow::Foot legs[2];
  std::uint32_t steps[2];  // names of the events in which each foot stands
  marrow::Feet feet;
  marrow::FootMotion motion[2];

  Legs(const marrow::File& file, const marrow::ClipMotion& walk) {
    const marrow::Roles roles = file.roles(0);
    for (int i = 0; i < 2; ++i) {
      const marrow::Role role = i == 0 ? marrow::Role::left_foot : marrow::Role::right_foot;
      must(foot_of(roles, role, legs[i]), "a leg");
      const std::uint32_t step = file.find_event(walk, role_name(role));
      if (step == walk.events.size) fail("the walk has no steps");
      steps[i] = walk.events[step].name;
    }
    feet.feet = legs;
    feet.pelvis = joint_of(roles, marrow::Role::hips);
  }

  // Whether a foot of the walk stands at a time.
  bool stands(int foot, const marrow::ClipMotion& walk, float time_s) const {
    for (const marrow::ClipEvent& e : walk.events)
      if (e.name == steps[foot] && is_within(e, time_s, walk.duration_s)) return true;
    return false;
  }

  void stand(const marrow::Pose& pose, const marrow::ClipMotion& walk, float time_s, Height height, float walked,
             float dt_s) {
    marrow::FeetFrame frame;
    frame.dt_s = dt_s;
    frame.world_from_model = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, walked}}};
    marrow::FootGround ground[2];
    for (int i = 0; i < 2; ++i) {
      float ball[3];
      must(foot_sole(legs[i], frame.world_from_model, pose.model_from_joint, ball), "a foot");
      const float x = ball[0], z = ball[2];  // a game casts a ray down from here
      const Vec3 n = normal_of(height, x, z);
      ground[i].hit = true;
      ground[i].point[0] = x;
      ground[i].point[1] = height(x, z);
      ground[i].point[2] = z;
      ground[i].normal[0] = n.x;
      ground[i].normal[1] = n.y;
      ground[i].normal[2] = n.z;
      ground[i].planted = stands(i, walk, time_s);
    }
    must(place_feet(pose, feet, frame, ground, motion), "feet");
  }
};

int main(int argc, char** argv) {
  Window window(argc, argv);
  window.eye = {1.2f, 0.8f, 2.1f};
  window.at = {0, 0.62f, 0};
  const marrow::File file = load_file(window.file);
  Programs programs;
  Actor newt(file, window, programs);
  const marrow::Animation& walk = find(newt.animations, "walk");
  Legs legs(file, walk.motion);
  Ground ground(hills);
  ground.upload(window);

  marrow::Playback playback;
  float walked = 0;
  for (float dt_s; window.begin(dt_s); window.end()) {
    walked += walk.motion.speed_m_s * dt_s;
    must(advance(playback, walk.duration_s, dt_s), "time");
    must(pose_character(newt.body, {{&walk, clip_time(playback)}}), "pose");
    legs.stand(newt.body.skeletons[0].pose, walk.motion, clip_time(playback), ground.height, walked, dt_s);
    window.clear();
    ground.draw(window, walked);
    newt.draw(window, programs);
  }
}
