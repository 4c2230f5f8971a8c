#include "commands/demo/story_movie.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <vector>

#include "commands/demo/scenery.h"
#include "common/failure.h"
#include "common/load_mrw.h"
#include "disk/files.h"
#include "image/apng.h"
#include "image/film.h"
#include "render/figure.h"
#include "story/story.h"
#include "terminal/progress.h"

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

}  // namespace marrow::tools
