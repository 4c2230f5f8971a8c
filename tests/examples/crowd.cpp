// A hundred characters walk over hills: two animations blended, and feet on the ground. Of a file that is not packed.
#include <marrow/marrow.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

struct Walker {
  marrow::Character body;
  marrow::Playback idle, walk;
  marrow::FootMotion feet[2] = {};
  float x = 0, z = 0;
};

float height(float x, float z) {
  return 0.1f * std::sin(2 * x) * std::cos(3 * z);
}

marrow::FootGround ground_below(const float (&sole)[3]) {
  const float x = sole[0], z = sole[2], step = 0.01f;
  const float slope_x = (height(x + step, z) - height(x - step, z)) / (2 * step);
  const float slope_z = (height(x, z + step) - height(x, z - step)) / (2 * step);
  return {true, {x, height(x, z), z}, {-slope_x, 1, -slope_z}};
}

marrow::Status move(Walker& w, const marrow::Animation& idle, const marrow::Animation& walk, float walking,
                    const marrow::Feet& feet, float dt_s) {
  marrow::Status status = advance(w.idle, idle.duration_s, dt_s);
  if (status == marrow::Status::ok) status = advance(w.walk, walk.duration_s, dt_s);
  if (status == marrow::Status::ok)
    status = pose_character(w.body, {{&idle, clip_time(w.idle), 1 - walking}, {&walk, clip_time(w.walk), walking}});

  const marrow::Pose& pose = w.body.skeletons[0].pose;
  marrow::FeetFrame frame;
  frame.dt_s = dt_s;
  frame.world_from_model = {{{1, 0, 0, w.x}, {0, 1, 0, 0}, {0, 0, 1, w.z}}};
  marrow::FootGround ground[2];
  for (int i = 0; i < 2 && status == marrow::Status::ok; ++i) {
    float sole[3];
    status = foot_sole(feet.feet[std::size_t(i)], frame.world_from_model, pose.model_from_joint, sole);
    if (status == marrow::Status::ok) ground[i] = ground_below(sole);
  }
  if (status == marrow::Status::ok) status = place_feet(pose, feet, frame, {ground, 2}, {w.feet, 2});
  return status == marrow::Status::ok ? finish_character(w.body) : status;
}

int main(int argc, char** argv) {
  const char* const path = argc > 1 ? argv[1] : "newt.mrw";
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::perror(path), 1;
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  marrow::File file;
  if (load({reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()}, file) != marrow::Status::ok) return 1;

  const std::size_t own = character_bytes(file, {});
  std::vector<std::byte> shared(animations_bytes(file, file)), memory(100 * own);
  marrow::Animations animations;
  if (make_animations(file, file, shared, animations) != marrow::Status::ok) return 1;
  const marrow::Animation* const idle = find_animation(animations, "idle");
  const marrow::Animation* const walk = find_animation(animations, "walk");
  if (idle == nullptr || walk == nullptr) return 1;

  const marrow::Roles roles = file.roles(0);
  marrow::Foot legs[2];
  if (foot_of(roles, marrow::Role::left_foot, legs[0]) != marrow::Status::ok ||
      foot_of(roles, marrow::Role::right_foot, legs[1]) != marrow::Status::ok)
    return 1;
  marrow::Feet feet;
  feet.feet = legs;
  feet.pelvis = joint_of(roles, marrow::Role::hips);

  std::vector<Walker> walkers(100);
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    Walker& w = walkers[i];
    if (make_character(file, {}, {memory.data() + i * own, own}, w.body) != marrow::Status::ok) return 1;
    w.walk.time_s = w.idle.time_s = 0.01 * double(i);
    w.x = float(i % 10);
    w.z = float(i / 10);
  }
  for (int frame = 0; frame < 60; ++frame) {  // nothing here allocates; walkers may be moved by many threads
    const float walking = float(frame) / 60;
    for (Walker& w : walkers)
      if (move(w, *idle, *walk, walking, feet, 1.0f / 60) != marrow::Status::ok) return 1;
  }
  int reached = 0;
  for (const Walker& w : walkers)
    for (const marrow::FootMotion& foot : w.feet) reached += foot.reached;
  std::printf("%zu characters, %d feet on the ground\n", walkers.size(), reached);
}
