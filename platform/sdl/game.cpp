// A game by SDL 2: a hero whose feet follow the ground, and a crowd beside it. See docs/platforms/sdl.md.
#include <marrow/gles3_skinner.h>
#include <marrow/marrow.h>

#include <algorithm>
#include <vector>

#include "asset.h"
#include "crowd.h"
#include "stage.h"

constexpr float kWalk_mps = 0.375f;  // by how much the clip's feet go over the ground in a second
constexpr float kBall_m = 0.03f;     // how high the ball of a foot is that stands

// One character, posed on the CPU in every frame, so that its feet can stand on what is there.
struct Hero {
  marrow::Character body;
  const marrow::Animation* walk = nullptr;
  marrow::Playback playback;
  marrow::Foot legs[2];
  marrow::Feet feet;
  marrow::FootGround ground[2];  // in this frame
  marrow::FootMotion motion[2];
  std::vector<gles3::Skinner> skinners;  // one a mesh
  float off_ground_m = 0;                // the farthest that a standing foot was from the ground

  void make(const marrow::File& file) {
    marrow::Animations animations;
    must(make_animations(file, file, block_of(animations_bytes(file, file)), animations), "animations");
    walk = find_animation(animations, "walk");
    if (walk == nullptr) fail(options.file + ": has no animation \"walk\"" + kCookSample);
    const marrow::CharacterOptions on_gpu{.layers = 1, .level = 0, .skin = false, .animation_space = false};
    must(make_character(file, on_gpu, block_of(character_bytes(file, on_gpu)), body), "the hero");
    const marrow::Roles roles = file.roles(0);
    const marrow::Role feet_roles[2] = {marrow::Role::left_foot, marrow::Role::right_foot};
    for (int i = 0; i < 2; ++i) {
      if (foot_of(roles, feet_roles[i], legs[i]) != marrow::Status::ok)
        fail(options.file + ": has no " + role_name(feet_roles[i]) + kCookSample);
      const float ball[3] = {0, 0.119f, 0};  // about which the foot rolls: so far along it
      std::copy(ball, ball + 3, legs[i].sole);
    }
    feet.feet = legs;
    feet.pelvis = joint_of(roles, marrow::Role::hips);
  }

  void upload(const Stage& stage, gles3::ProgramSet& programs) {
    for (const marrow::CharacterMesh& m : body.meshes) {
      const marrow::Span<std::byte> memory = block_of(gles3::skinner_bytes(m.mesh, {}));
      must(create_skinner(stage.gl, stage.caps, m.mesh, {}, programs, memory, skinners.emplace_back()),
           "the hero on the GPU", programs.log.data);
    }
  }

  // The scene walks along with the hero, and the world stays: there the ground is.
  void move(float dt_s, float walked) {
    must(advance(playback, walk->duration_s, dt_s), "playback");
    must(pose_character(body, {{walk, clip_time(playback)}}), "the pose");
    const marrow::Pose& pose = body.skeletons[0].pose;
    marrow::FeetFrame frame;
    frame.dt_s = dt_s;
    frame.world_from_model = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, walked}}};
    for (int i = 0; i < 2; ++i) {
      float ball[3];
      must(foot_sole(legs[i], frame.world_from_model, pose.model_from_joint, ball), "a foot");
      const float x = ball[0], z = ball[2], d = 0.02f;
      const bool stands = ball[1] < kBall_m + 0.002f;  // as animated; then it stays where it is
      ground[i] = {
          true, {x, hill(x, z), z}, {hill(x - d, z) - hill(x + d, z), 2 * d, hill(x, z - d) - hill(x, z + d)}, stands};
    }
    must(place_feet(pose, feet, frame, {ground, 2}, {motion, 2}), "feet");
    for (int i = 0; i < 2; ++i)
      if (ground[i].planted) {
        const float* const at = motion[i].place;
        off_ground_m = std::max(off_ground_m, std::abs(at[1] - kBall_m - hill(at[0], at[2])));
      }
  }

  void update(const Stage& stage, const gles3::ProgramSet& programs) {
    for (std::size_t i = 0; i < skinners.size(); ++i) {
      const marrow::CharacterMesh& m = body.meshes[i];
      must(pose(skinners[i], 0, body.skeletons[m.mesh.skeleton].pose.model_from_joint, m.weights), "posing");
      must(gles3::update(stage.gl, skinners[i], programs, 1), "updating");
    }
  }

  void draw(const Stage& stage, const gles3::ProgramSet& programs, Role role) const {
    for (const gles3::Skinner& skinner : skinners) {
      const gles3::Program& program = program_of(skinner, programs, role);
      stage.use(program, skinner.mesh, role);
      must(gles3::draw(stage.gl, skinner, programs, program, 0, 1), "drawing the hero");
    }
  }
};

struct Game {
  Stage stage;
  gles3::ProgramSet programs;
  Hero hero;
  Crowd crowd;
  char log[1024] = "";  // what the driver says of a shader
  double time_s = 0;
  bool hidden = false, paused = false;
  Clock clock;
  Times until_swap, marrow;

  void open(const marrow::File& file) {
    stage.open();
    programs.roles[kColour] = {kSkinVertex.c_str(), kSkinFragment.c_str(), {}};
    programs.roles[kShadow] = {kShadowVertex, kShadowFragment, {}};
    programs.role_count = 2;
    programs.role_features[kShadow] = 0;
    programs.log = log;
    hero.make(file);
    hero.upload(stage, programs);
    crowd.make(file, hero.walk->duration_s, stage, programs);
  }

  // False: the game is over.
  bool events() {
    SDL_Event event;
    while (SDL_PollEvent(&event) || (hidden && SDL_WaitEvent(&event))) {
      const int window = event.type == SDL_WINDOWEVENT ? event.window.event : 0;
      const int key = event.type == SDL_KEYDOWN ? event.key.keysym.sym : 0;
      if (event.type == SDL_QUIT || key == SDLK_ESCAPE) return false;
      if (event.type == SDL_APP_WILLENTERBACKGROUND || window == SDL_WINDOWEVENT_MINIMIZED) hidden = true;
      if (event.type == SDL_APP_DIDENTERFOREGROUND || window == SDL_WINDOWEVENT_RESTORED) {
        hidden = false;
        clock.start();
      }
      if (key == SDLK_SPACE) paused = !paused;
      if (key == SDLK_l || event.type == SDL_RENDER_DEVICE_RESET) restore(event.type == SDL_RENDER_DEVICE_RESET);
    }
    return true;
  }

  // The context is gone, and all that was in it. On Android SDL has made another by the time that it says so.
  void restore(bool there_is_another) {
    on_context_lost(programs);
    for (gles3::Skinner& skinner : hero.skinners) on_context_lost(skinner);
    for (gles3::CrowdMesh& mesh : crowd.meshes) on_context_lost(mesh);
    on_context_lost(crowd.instances);
    stage.reopen(there_is_another);
    must(on_context_restored(stage.gl, stage.caps, programs), "programs of a new context");
    for (gles3::Skinner& skinner : hero.skinners)
      must(on_context_restored(stage.gl, stage.caps, skinner), "the hero in a new context");
    for (gles3::CrowdMesh& mesh : crowd.meshes)
      must(on_context_restored(stage.gl, stage.caps, mesh), "the crowd in a new context");
    must(on_context_restored(stage.gl, stage.caps, crowd.instances), "the crowd's instances in a new context");
  }

  void frame(float dt_s) {
    const Uint64 begun = SDL_GetPerformanceCounter();
    time_s += double(dt_s);
    const float walked = kWalk_mps * float(time_s);
    hero.move(dt_s, walked);
    hero.update(stage, programs);
    crowd.update(stage, programs, time_s);
    marrow.add(SDL_GetPerformanceCounter() - begun);
    stage.begin_shadows();
    hero.draw(stage, programs, kShadow);
    crowd.draw(stage, programs, kShadow);
    stage.begin_picture(walked);
    hero.draw(stage, programs, kColour);
    crowd.draw(stage, programs, kColour);
    until_swap.add(SDL_GetPerformanceCounter() - begun);
  }

  void report() {
    std::printf("%-24s %8s %8s %8s %8s\n", "ms", "p50", "p95", "p99", "worst");
    clock.frames.print("a frame");
    until_swap.print("until it is swapped");
    marrow.print("pose, feet, update");
    std::printf("%.2f s played; standing feet at most %.1f mm off the ground; %ld GL errors\n", time_s,
                double(1000 * hero.off_ground_m), stage.gl_errors + (stage.gl.GetError() != 0));
  }
};

int main(int argc, char** argv) {
  read_options(argc, argv);
  static Game game;
  game.open(open_file(options.file));
  game.clock.start();
  for (long frame = 0; (options.frames == 0 || frame < options.frames) && game.events(); ++frame) {
    if (frame == options.lose || gles3::context_was_reset(game.stage.gl)) game.restore(false);
    const float dt_s = game.clock.tick();
    game.frame(game.paused ? 0 : dt_s);
    if (frame + 1 == options.frames && !options.shot.empty()) game.stage.save(options.shot);
    SDL_GL_SwapWindow(game.stage.window);
  }
  game.report();
  SDL_Quit();
  return 0;
}
