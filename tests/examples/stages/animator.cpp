// A character that walks, is asked to reach, and is taken back in time.
// $ animator behaving.mrw
#include <marrow/draco.h>
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
  must(make_owned(bytes, {draco_decoder()}, file));
  must(make_owned(file, {}, animator));
  must(make_owned(file, {.layers = 4}, hero));
  const std::uint32_t speed = find_parameter(animator.bound, "speed"), reach = find_parameter(animator.bound, "reach");
  const std::uint32_t body = find_graph_node(animator.bound, "body");
  constexpr std::uint32_t kLeftFoot = event_id("left_foot");

  Affine world_from_model{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  const auto play = [&](float seconds) {
    int steps = 0;
    for (int frame = 0; frame < int(seconds * 60); ++frame) {
      AnimatorStep step;
      must(update_animator(animator, 1.0f / 60, step));
      for (const AnimatorEvent& event : step.events) steps += event.id == kLeftFoot;
      world_from_model = move_root(world_from_model, step.root);
      must(pose_character(hero, animator));
      must(finish_character(hero));
    }
    const std::uint32_t state = state_of(animator, body);
    std::printf("%s at %.2f m, left foot came down %d times\n",
                file.text(animator.bound.graph.states[animator.bound.graph.machines[0].first_state + state].name),
                double(world_from_model.rows[2][3]), steps);
  };

  must(set_number(animator, speed, 0.3f));
  play(4);
  const std::vector<std::byte> saved(animator.state.begin(), animator.state.end());
  must(set_number(animator, speed, 0));
  must(fire(animator, reach));
  play(1);
  play(3);
  must(restore_animator(animator, saved));
  play(4);
}

// Prints:
//   moves at 1.20 m, left foot came down 3 times
//   reaches at 1.20 m, left foot came down 1 times
//   moves at 1.20 m, left foot came down 1 times
//   moves at 2.40 m, left foot came down 3 times
