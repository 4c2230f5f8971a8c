// Step 9: what a game ships with: bad calls that are heard of, a GPU that was tried, poses made by several threads.
#include <marrow/gles3_self_test.h>

#include <cstring>
#include <thread>

#include "actor.h"
#include "ground.h"

constexpr std::uint32_t kNewts = 12, kThreads = 2;

void tell(const char* function, const char* condition) {
  std::fprintf(stderr, "bad call of %s: it asks for %s\n", function, condition);
}

// Which paths this driver can be trusted with: from the start before, or tried now.
gles3::SelfTest try_driver(const Window& window, const char* store) {
  gles3::SelfTestOptions options;
  options.as = false;  // this game draws by SSD alone
  options.seconds = [](void*) { return glfwGetTime(); };
  gles3::SelfTest test;
  char saved[gles3::kSavedSelfTestBytes] = {};
  std::ifstream(store, std::ios::binary).read(saved, sizeof saved);
  marrow::Span<std::byte> bytes(reinterpret_cast<std::byte*>(saved), sizeof saved);
  if (restore(window.gl, window.caps, options, bytes, test) == marrow::Status::ok) return test;
  must(self_test(window.gl, window.caps, options, memory_of(self_test_bytes(options)), test), "the self-test");
  must(save(test, bytes), "saving the self-test");
  std::ofstream(store, std::ios::binary).write(saved, sizeof saved);
  for (std::uint32_t i = 0; i < gles3::kPathCount; ++i) {
    const gles3::PathResult& path = test.paths[i];
    std::printf("%s: %s, %.1f ns a vertex\n", to_string(gles3::SkinningPath(i)), to_string(path.verdict),
                double(path.ns_per_vertex));
  }
  return test;
}

int main(int argc, char** argv) {
  marrow::set_call_error_handler(tell);
  Window window(argc, argv);
  window.eye = {0, 1.9f, 4.2f};
  const marrow::File file = load_file(window.file);
  Programs programs;
  marrow::Animations animations;
  must(make_animations(file, file, memory_of(animations_bytes(file, file)), animations), "animations");
  const marrow::Animation& walk = find(animations, "walk");
  const gles3::SelfTest test = try_driver(window, "self_test.bin");

  // One skinner a mesh, for all newts.
  const marrow::CharacterOptions on_gpu{.layers = 1, .level = 0, .skin = false, .animation_space = false};
  marrow::Character newts[kNewts];
  marrow::Playback playbacks[kNewts];
  for (std::uint32_t i = 0; i < kNewts; ++i) {
    must(make_character(file, on_gpu, memory_of(character_bytes(file, on_gpu)), newts[i]), "character");
    playbacks[i].time_s = 0.17 * i;
  }
  std::vector<gles3::Skinner> skinners;
  for (const marrow::CharacterMesh& m : newts[0].meshes) {
    gles3::SkinnerOptions options;
    options.instances = kNewts;
    must(choose(test, {.passes = 1, .characters = kNewts, .joints = m.mesh.palette_size()}, options.path), "a path");
    if (skinners.empty()) std::printf("skinned by %s\n", to_string(options.path));
    must(create_skinner(window.gl, window.caps, m.mesh, options, programs.set,
                        memory_of(gles3::skinner_bytes(m.mesh, options)), skinners.emplace_back()),
         "putting a mesh on the GPU", programs.log);
  }
  Ground ground(level);
  ground.upload(window);

  for (float dt_s; window.begin(dt_s); window.end()) {
    // No two threads touch the same newt. None of this calls GL.
    const auto work = [&](std::uint32_t first) {
      for (std::uint32_t i = first; i < kNewts; i += kThreads) {
        must(advance(playbacks[i], walk.duration_s, dt_s), "time");
        must(pose_character(newts[i], {{&walk, clip_time(playbacks[i])}}), "pose");
        const marrow::Span<marrow::Affine> joints = newts[i].skeletons[0].pose.model_from_joint;
        for (marrow::Affine& joint : joints) {  // where this newt stands
          joint.rows[0][3] += 1.1f * (float(i % 4) - 1.5f);
          joint.rows[2][3] -= 1.1f * float(i / 4);
        }
        for (std::size_t m = 0; m < skinners.size(); ++m)
          must(pose(skinners[m], i, joints, newts[i].meshes[m].weights), "posing");
      }
    };
    std::thread other(work, 1);  // a game has threads that wait for work
    work(0);
    other.join();
    window.clear();
    ground.draw(window, 0);
    for (gles3::Skinner& skinner : skinners) {
      must(update(window.gl, skinner, programs.set, kNewts), "sending poses");
      const gles3::Program& program = program_of(skinner, programs.set, 0);
      window.use(program.id, skinner.mesh.base_colour);
      must(gles3::draw(window.gl, skinner, programs.set, program, 0, kNewts), "drawing");
    }
  }
}
