#include "commands/demo/story_movie.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "commands/demo/scenery.h"
#include "commands/demo/sheet.h"
#include "common/failure.h"
#include "common/load_mrw.h"
#include "disk/files.h"
#include "image/apng.h"
#include "image/film.h"
#include "marrow/glm.h"
#include "marrow/marrow.h"
#include "render/figure.h"
#include "render/overlay/mark.h"
#include "render/performance.h"
#include "story/adjust.h"
#include "story/story.h"
#include "terminal/progress.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

constexpr int kMovieWidth = 560, kMovieHeight = 336;
constexpr int kMovieFps = 20;
constexpr std::size_t kColourSamples = 16;  // frames of which an animated PNG has the colours

// What light and shadow are for: all of the eight.
const Box kStage = [] {
  Box out;
  out.add({-2.4f, 0, -1.2f});
  out.add({2.4f, 1.6f, 1.2f});
  return out;
}();
constexpr float kStageRadius = 1.25f;

class Stage {
 public:
  Stage(const Gl& gl, const File& file, const Story& story)
      : story_(story),
        studio_(gl, kMovieWidth, kMovieHeight),
        figure_(gl, studio_.programs(), file),
        character_(file),
        scenery_(gl, studio_.programs(), story),
        strokes_(gl) {
    character_.set_change([this](std::uint32_t skeleton, const Pose& pose) {
      if (skeleton == 0) std::ranges::copy(story_.steps[moment_].world_from_joint, pose.model_from_joint.begin());
    });
    follow();
  }

  Image shoot(std::size_t moment) {
    moment_ = moment;
    character_.pose(Play{}, 0);
    Shot shot;
    shot.camera = camera_on(orbits_[moment], static_cast<float>(kMovieWidth) / kMovieHeight, 1.0f);
    shot.box = kStage;
    shot.radius = kStageRadius;
    std::vector<Drawable> drawables = figure_.on_gpu(character_, Deformer::as);
    for (const Drawable& d : scenery_.drawables(moment)) drawables.push_back(d);
    scenery_.draw(moment, shot.camera, strokes_);
    return studio_.shoot(shot, drawables, &strokes_);
  }

 private:
  // The camera goes part of the newt's way, late and softly. It has been round once before, so that the end meets the
  // beginning.
  void follow() {
    glm::vec3 target(0);
    const std::size_t count = story_.steps.size();
    orbits_.resize(count);
    for (std::size_t i = 0; i < 2 * count; ++i) {
      const StoryStep& m = story_.steps[i % count];
      const glm::vec3 wished(0.70f * m.root.x, 0.57f, 0.5f * m.root.z);
      target += (wished - target) * (1 - std::exp(-1.0f / (0.45f * kStoryFps)));
      const float share = static_cast<float>(i % count) / static_cast<float>(count);
      Orbit& orbit = orbits_[i % count];
      orbit.target = target;
      orbit.yaw = 0.26f + 0.16f * std::sin(6.2831853f * share);
      orbit.pitch = 0.25f;
      orbit.distance = 4.7f;
    }
  }

  const Story& story_;
  Studio studio_;
  Figure figure_;
  Character character_;
  Scenery scenery_;
  Strokes strokes_;
  std::vector<Orbit> orbits_;  // a moment
  std::size_t moment_ = 0;
};

using Shoot = std::function<Image(std::size_t frame)>;

std::vector<std::byte> animated_png(std::size_t frames, const Shoot& shoot) {
  std::vector<Image> samples;
  for (std::size_t i = 0; i < frames; i += (frames + kColourSamples - 1) / kColourSamples) samples.push_back(shoot(i));
  Apng apng(static_cast<std::uint32_t>(frames), Palette::of(samples));
  for (std::size_t i = 0; i < frames; ++i) apng.add(shoot(i), Apng::kTicksPerSecond / kMovieFps);
  return apng.finish();
}

constexpr float kSlope = 0.22f;                 // metres up a metre along +X, through the origin
constexpr glm::vec2 kHalfRamp = {0.7f, 0.55f};  // along X and Z
constexpr std::array<float, 3> kTarget = {0.46f, 0.88f, 0.3f};
constexpr float kFrame_s = 1.0f / 60;

// A wedge with the slope as its upper side, and flat sides.
cook::RawScene ramp_scene() {
  const float x = kHalfRamp.x, y = kSlope * x, z = kHalfRamp.y;
  const glm::vec3 low_front = {-x, -y, z}, low_back = {-x, -y, -z}, high_front = {x, y, z}, high_back = {x, y, -z};
  const glm::vec3 below_front = {x, -y, z}, below_back = {x, -y, -z};
  cook::RawPrimitive primitive;
  const auto add = [&](std::initializer_list<glm::vec3> corners) {
    const auto first = static_cast<std::uint32_t>(primitive.positions.size());
    const glm::vec3* const c = corners.begin();
    const glm::vec3 normal = glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0]));
    for (const glm::vec3& corner : corners) {
      primitive.positions.push_back(corner);
      primitive.normals.push_back(normal);
    }
    for (std::uint32_t i = 2; i < corners.size(); ++i)
      primitive.indices.insert(primitive.indices.end(), {first, first + i - 1, first + i});
  };
  add({low_front, high_front, high_back, low_back});
  add({high_front, below_front, below_back, high_back});
  add({low_front, below_front, high_front});
  add({low_back, high_back, below_back});
  return prop_scene(std::move(primitive), {0.34f, 0.31f, 0.27f});
}

// What the sheet moves of the sample.
struct Rig {
  std::array<Foot, 2> feet;
  Feet both;
  TwoBoneLimb arm{};
  std::array<std::uint32_t, 2> looking{};  // neck, head
  Aim look;
};

void put(float (&to)[3], glm::vec3 v) {
  for (int c = 0; c < 3; ++c) to[c] = v[c];
}

void make_rig(const File& file, Rig& rig) {
  const Skeleton skeleton = file.skeleton(0);
  const Roles roles = file.roles(0);
  const auto joint = [&](Role role) { return joint_with(roles, role); };
  check(foot_of(roles, Role::left_foot, rig.feet[0]));
  check(foot_of(roles, Role::right_foot, rig.feet[1]));
  rig.both.feet = rig.feet;
  rig.both.pelvis = joint(Role::hips);
  rig.arm = {joint(Role::left_upper_arm), joint(Role::left_lower_arm), joint(Role::left_hand)};
  rig.looking = {joint(Role::neck), joint(Role::head)};
  // Forward and up of the head, as the sample stands at rest.
  std::vector<Affine> rest(skeleton.joint_count);
  check(local_to_model(skeleton, {skeleton.rest, skeleton.soa_size()}, rest));
  const glm::mat4 head = glm::inverse(to_glm(rest[rig.looking[1]]));
  put(rig.look.forward, glm::vec3(head * glm::vec4(0, 0, 1, 0)));
  put(rig.look.up, glm::vec3(head * glm::vec4(0, 1, 0, 0)));
  std::ranges::copy(kTarget, rig.look.target);
  rig.look.pole[1] = 1;
}

struct Motion {
  bool feet = false, hand = false;
  std::array<FootMotion, 2> state = {};
};

void move(const Rig& rig, Motion& motion, const Pose& pose) {
  if (motion.feet) {
    std::array<FootGround, 2> ground;
    FeetFrame frame;
    frame.dt_s = kFrame_s;
    for (std::size_t i = 0; i < 2; ++i) {
      float sole[3];
      check(foot_sole(rig.feet[i], frame.world_from_model, pose.model_from_joint, sole));
      ground[i].hit = true;
      put(ground[i].point, {sole[0], kSlope * sole[0], sole[2]});
      put(ground[i].normal, {-kSlope, 1, 0});
    }
    check(place_feet(pose, rig.both, frame, ground, motion.state));
  }
  if (!motion.hand) return;
  TwoBone hand;
  std::ranges::copy(kTarget, hand.target);
  check(solve_two_bone(pose, rig.arm, hand));
  check(solve_look_at(pose, rig.looking, rig.look, 0.6f));
}

}  // namespace

StoryMovie shoot_story(const Gl& gl, const std::string& character) {
  const StoryFiles files = cook_story(character);
  const Story story = tell_story(files);
  const LoadedFile loaded = load_mrw(files.character);
  Stage stage(gl, loaded.file, story);
  StoryMovie out;
  constexpr std::size_t kEvery = kStoryFps / kMovieFps;
  out.frames = story.steps.size() / kEvery;
  out.duration_s = static_cast<double>(out.frames) / kMovieFps;
  Progress progress;
  const Shoot shoot = [&](std::size_t frame) {
    progress.show(frame, out.frames, "drawing");
    return stage.shoot(frame * kEvery);
  };
  const auto in_folder = [&](const char* name) {
    return std::filesystem::path(character).replace_filename(name).string();
  };
  try {
    out.path = in_folder("newt-moves.webp");
    Film film(out.path, {kMovieWidth, kMovieHeight, out.frames, out.duration_s});
    for (std::size_t i = 0; i < out.frames; ++i) film.add(shoot(i));
    film.finish();
  } catch (const Failure&) {  // no ffmpeg, or one without this codec
    out.path = in_folder("newt-moves.png");
    write_file_atomically(out.path, animated_png(out.frames, shoot));
  }
  return out;
}

Image make_moves_sheet(const Gl& gl, const File& file) {
  const std::uint32_t clip = file.find_clip("walk", 0);
  if (clip == file.clip_count()) throw Failure(Exit::internal, "the sample", "", "no walk", "please report this");
  const Play play = play_together(file, clip);
  Character character(file);
  const Performance performance(file, character, play);
  Studio studio(gl, kCellWidth, kCellHeight);
  Figure figure(gl, studio.programs(), file);
  Prop ramp(gl, studio.programs(), ramp_scene());
  Rig rig;
  make_rig(file, rig);
  const auto frames = static_cast<int>(std::lround(play.duration_s / kFrame_s));

  SheetPage page;
  page.title = "Inverse kinematics";
  page.scene =
      fmt::format("clip \"walk\", {} s, made for level ground", plain_number(static_cast<double>(play.duration_s)));
  page.rows = {
      {"As animated", "feet go through a slope, or hang above it", {}, {}, {}, 0},
      {"place_feet", "soles follow the ground, the pelvis gives way", {}, {}, {}, 0},
      {"place_feet, solve_two_bone, solve_look_at", "and a hand stays on a point, and the eyes", {}, {}, {}, 0}};
  for (std::size_t row = 0; row < page.rows.size(); ++row) {
    Motion motion;
    motion.feet = row > 0;
    motion.hand = row > 1;
    character.set_change([&](std::uint32_t, const Pose& pose) { move(rig, motion, pose); });
    // A round to settle, and one to be photographed.
    for (int frame = 0; frame < 2 * frames; ++frame) {
      const int at = frame % frames;
      const float time_s = static_cast<float>(at) * kFrame_s;
      character.pose(play, time_s);
      if (frame < frames || at % (frames / kSheetColumns) != 0) continue;
      if (page.rows[row].cells.size() == kSheetColumns) break;
      Shot shot = performance.shot(character, static_cast<float>(kCellWidth) / kCellHeight, 0.1f);
      shot.box = box_of(skin_all(file, character, Deformer::as));
      shot.box.add(ramp.box().min);
      shot.box.add(ramp.box().max);
      shot.ground_height = ramp.box().min.y;
      std::vector<Drawable> drawables = figure.on_gpu(character, Deformer::as);
      for (const Drawable& d : ramp.drawables()) drawables.push_back(d);
      page.rows[row].cells.push_back(studio.shoot(shot, drawables));
      if (motion.hand) draw_mark(page.rows[row].cells.back(), shot.camera, kTarget);
      if (row + 1 == page.rows.size())
        page.rows[row].captions.push_back(fmt::format("{:.2f} s", static_cast<double>(time_s)));
    }
  }
  return lay_out(page);
}

}  // namespace marrow::tools
