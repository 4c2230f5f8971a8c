// Step 4: the newt walks over hills, and its feet stand on them.
#include "actor.h"
#include "ground.h"

constexpr float kWalk_mps = 0.375f;  // how fast the clip's feet go over the ground
constexpr float kBall_m = 0.03f;     // how high the ball of a standing foot is in the clip

struct Legs {
  marrow::Foot legs[2];
  marrow::Feet feet;
  marrow::FootMotion motion[2];

  Legs(const marrow::File& file, const marrow::Skeleton& skeleton) {
    for (int i = 0; i < 2; ++i) {
      const std::string side = i == 0 ? ".L" : ".R";
      legs[i].hip = find(file, skeleton, "thigh" + side);
      legs[i].knee = find(file, skeleton, "shin" + side);
      legs[i].ankle = find(file, skeleton, "foot" + side);
      legs[i].sole[1] = 0.119f;  // the ball of the foot: so far from the ankle, along the foot
    }
    feet.feet = legs;
    feet.pelvis = find(file, skeleton, "pelvis");
  }

  void stand(const marrow::Pose& pose, Height height, float walked, float dt_s) {
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
      ground[i].planted = ball[1] < kBall_m + 0.002f;  // as low as a foot of the clip that stands
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
  Legs legs(file, newt.body.skeletons[0].pose.skeleton);
  Ground ground(hills);
  ground.upload(window);

  marrow::Playback playback;
  float walked = 0;
  for (float dt_s; window.begin(dt_s); window.end()) {
    walked += kWalk_mps * dt_s;
    must(advance(playback, walk.duration_s, dt_s), "time");
    must(pose_character(newt.body, {{&walk, clip_time(playback)}}), "pose");
    legs.stand(newt.body.skeletons[0].pose, ground.height, walked, dt_s);
    window.clear();
    ground.draw(window, walked);
    newt.draw(window, programs);
  }
}
