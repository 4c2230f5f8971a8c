// A whole character whose behaviour stands in behave.anim.toml: it stands, walks and runs as fast as it is asked to,
// strikes, is heard to step, looks at a point, and goes where its clips take it: behave hero.mrw
#include <marrow/owned.h>

#include <cstdio>
#include <fstream>
#include <iterator>
using namespace marrow;

int main(int argc, char** argv) {
  std::ifstream stream(argc == 2 ? argv[1] : "", std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  OwnedFile file;
  OwnedAnimator animator;
  OwnedCharacter hero;
  must(make_owned(bytes, file));
  must(make_owned(file, {}, animator));
  must(make_owned(file, {.layers = 8}, hero));
  const std::uint32_t speed = find_parameter(animator.bound, "speed"),
                      strike = find_parameter(animator.bound, "strike"), head = joint_of(file.roles(0), Role::head);
  if (head == kNoJoint) return 1;
  const std::uint32_t gaze[] = {hero.skeletons[0].pose.skeleton.parents[head], head};
  Aim look{.target = {1, 1.5f, 3}, .weight = 0.5f};
  must(pose_character(hero, {}));  // at rest a head looks along z, whatever axes its joint has
  must(direction_in_joint(hero.skeletons[0].pose.model_from_joint[head], {0, 0, 1}, look.forward));
  Affine world_from_model{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  for (int frame = 0; frame < 240; ++frame) {
    must(set_number(animator, speed, float(frame) / 60));  // faster by 1 m/s each second
    if (frame == 60) must(fire(animator, strike));
    AnimatorStep step;
    must(update_animator(animator, 1.0f / 60, step));
    world_from_model = move_root(world_from_model, step.root);
    for (const AnimatorEvent& event : step.events)
      std::printf("%s at %.2f m\n", event.name, double(world_from_model.rows[2][3]));
    must(pose_character(hero, animator));
    must(solve_look_at(hero.skeletons[0].pose, gaze, look, 0.5f));
    must(finish_character(hero));
  }
  std::printf("went %.2f m\n", double(world_from_model.rows[2][3]));
}
