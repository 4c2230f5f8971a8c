// A whole character: it stands, walks and runs as fast as it is asked to, strikes, is heard to step, looks at a point,
// and goes where its clips take it.
// $ hero hero.mrw idle walk run strike
#include <marrow/owned.h>

#include <cstdio>
#include <fstream>
#include <iterator>

using namespace marrow;

struct Hero : OwnedCharacter {
  static constexpr int kGaits = 3;          // idle, walk, run; behind them the strike
  AnimationLayer layers[kGaits + 1];        // what is played
  SpeedPoint speeds[kGaits];                // the gaits' own, and how long their steps take
  Phase phase;                              // that the gaits go by
  Playback strike{.mode = PlayMode::once};  // of the last layer
  std::vector<float> upper_body;            // its mask
  std::vector<std::uint32_t> gaze;          // neck and head
  Aim look{.weight = 0.5f};                 // along the head's own axis that is forwards at rest
  Affine world_from_model{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

  Hero(const OwnedFile& owner, char** names) {
    must(make_owned(owner, {.layers = kGaits + 1}, *this));
    for (AnimationLayer& layer : layers) layer.animation = find_animation(owner.animations, *names++);
    for (int i = 0; i < kGaits; ++i) {
      const ClipMotion& m = layers[i].animation->motion;
      speeds[i] = {m.speed_m_s, m.duration_s / float(m.phase_marks.empty() ? 1 : m.phase_marks.size)};
    }
    upper_body.resize(4 * skeletons[0].pose.skeleton.soa_size());
    const Roles roles = file.roles(0);
    must(mask_below(skeletons[0].pose.skeleton, joint_of(roles, Role::spine), 2, upper_body));
    layers[kGaits].mask = upper_body;
    for (const Role role : {Role::neck, Role::head})
      if (joint_of(roles, role) != kNoJoint) gaze.push_back(joint_of(roles, role));
    must(pose_character(*this, {}));
    must(direction_in_joint(skeletons[0].pose.model_from_joint[gaze.back()], {0, 0, 1}, look.forward));
  }

  void update(float dt_s, float speed_m_s, const float (&point)[3]) {
    float weights[kGaits], rate = 1;
    must(match_speed(speeds, speed_m_s, weights, rate));
    PhaseClip group[kGaits];
    for (int i = 0; i < kGaits; ++i) group[i] = {&layers[i].animation->motion, layers[i].weight = weights[i]};
    const Phase before = phase;
    must(advance_phase(group, dt_s * rate, phase));
    for (int i = 0; i < kGaits; ++i) {
      const ClipMotion& motion = *group[i].motion;
      Playback was, now;
      must(follow_phase(motion, before, phase, was, now));
      must(step_layer(was, now, layers[i]));
      EventHit hits[16];
      std::size_t met = 0;
      if (weights[i] >= 0.5f) must(events_between(motion, was, now, false, hits, met));
      for (std::size_t e = 0; e < met && e < 16; ++e)
        std::printf("%s at %.2f m\n", file.text(motion.events[hits[e].event].name), way_m());
    }
    AnimationLayer& over = layers[kGaits];
    const float length_s = over.animation->duration_s, left_s = length_s - clip_time(strike);
    must(advance(strike, length_s, dt_s));
    over.time_s = clip_time(strike);
    over.weight = std::min({1.0f, over.time_s / 0.1f, left_s / 0.2f});
    must(pose_character(*this, layers));
    std::copy(point, point + 3, look.target);
    must(solve_look_at(skeletons[0].pose, gaze, look, 0.5f));
    must(finish_character(*this));
    RigidStep step;
    must(character_root_step(*this, layers, step));
    world_from_model = move_root(world_from_model, step);
  }
  double way_m() const { return double(world_from_model.rows[2][3]); }
};

int main(int argc, char** argv) {
  std::ifstream stream(argc == 6 ? argv[1] : "", std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  OwnedFile file;
  must(make_owned(bytes, file));
  Hero hero(file, argv + 2);
  for (int frame = 0; frame < 240; ++frame)  // faster by 1 m/s each second; it strikes at once
    hero.update(1.0f / 60, float(frame) / 60, {1, 1.5f, 3});
  std::printf("went %.2f m\n", hero.way_m());
}
