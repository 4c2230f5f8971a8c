// Step 6: the newt does what a graph says. The arrow up tells it to walk, space to reach; left alone it does both in
// turn.
#include "actor.h"
#include "ground.h"

struct Behaviour {
  marrow::Graph graph;
  marrow::GraphBinding binding;
  marrow::Animator animator;
  std::uint32_t speed, reach;

  Behaviour(const marrow::File& file, const marrow::Animations& animations) {
    must(file.graph(0, graph), "the file's first graph");
    marrow::GraphMisfit misfit;
    const auto memory = memory_of(graph_binding_bytes(graph, file));
    const marrow::Status bound = bind_graph(file, graph, file, {&animations, 1}, memory, binding, &misfit);
    must(bound, misfit.rule, misfit.name);
    must(make_animator(binding, {}, memory_of(animator_bytes(binding, {})), animator), "an animator");
    speed = find_parameter(binding, "speed");
    reach = find_parameter(binding, "reach");
  }
};

int main(int argc, char** argv) {
  Window window(argc, argv);
  window.eye = {1.6f, 1.0f, 1.6f};
  const marrow::File file = load_file(window.file);
  Programs programs;
  Actor newt(file, window, programs, 4);
  Behaviour behaviour(file, newt.animations);
  marrow::Animator& animator = behaviour.animator;
  Ground ground(level);
  ground.upload(window);

  marrow::Affine world_from_model{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  float time_s = 0;
  for (float dt_s; window.begin(dt_s); window.end()) {
    time_s += dt_s;
    const float round_s = std::fmod(time_s, 8.0f);
    const bool walks = window.pressed(GLFW_KEY_UP) || round_s < 2;
    must(set_number(animator, behaviour.speed, walks ? 0.4f : 0), "a speed");
    const bool reaches = window.pressed(GLFW_KEY_SPACE) || (round_s > 2.3f && round_s < 2.4f);
    if (reaches) must(fire(animator, behaviour.reach), "a wish");

    marrow::AnimatorStep step;
    must(update_animator(animator, dt_s, step), "update");
    world_from_model = move_root(world_from_model, step.root);
    for (const marrow::AnimatorEvent& event : step.events)
      std::printf("%.2f s: %s at %.2f m\n", double(time_s), event.name, double(world_from_model.rows[2][3]));
    must(pose_character(newt.body, animator), "pose");

    window.clear();
    ground.draw(window, world_from_model.rows[2][3]);
    newt.draw(window, programs);
  }
}
