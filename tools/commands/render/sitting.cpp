#include "commands/render/sitting.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/formats.h"
#include "pose/worn.h"
#include "render/disk/images.h"
#include "render/heat.h"
#include "render/overlay/mark.h"
#include "text/printable.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

std::unique_ptr<Acting> act(const RenderArguments& arguments, const File& file) {
  if (!arguments.by_graph) return nullptr;
  auto acting = std::make_unique<Acting>(arguments.file, file, arguments.behaviour, arguments.acting);
  for (const std::string& warning : acting->behaviour().found().warnings) fmt::print(stderr, "{}\n", warning);
  return acting;
}

std::uint32_t layers_of(const Acting* acting) {
  return std::max(Character::kMostLayers, acting != nullptr ? acting->behaviour().layers() : 0);
}

}  // namespace

namespace {

std::unique_ptr<Images> images_of(const std::string& path, const File& file, const RenderArguments& arguments) {
  return std::make_unique<FoundImages>(path, file, places_of(path, arguments.images_from));
}

}  // namespace

Sitting::Sitting(const RenderArguments& arguments)
    : arguments_(arguments),
      size_(parse_size(arguments.size)),
      manner_{arguments.deformer, arguments.path, parse_pair(arguments.heatmap)},
      normals_(arguments.normals),
      model_(open_model(arguments, arguments.by_graph ? Opens::models_by_graph : Opens::cooked_files)),
      acting_(act(arguments, file())),
      viewpoint_(make_viewpoint(arguments.file, file(), arguments.viewpoint)),
      reach_(file(), arguments.reach),
      springs_(file()),
      character_(file(), normals_, arguments.lod, layers_of(acting_.get())),
      performance_(perform()),
      textures_(gl_, file(), *images_of(arguments.file, file(), arguments)),
      studio_(gl_, size_.first, size_.second),
      figure_(gl_, studio_.programs(), file(), &textures_, normals_, arguments.lod),
      strokes_(gl_) {
  for (const Deformer deformer :
       {manner_.heat ? manner_.heat->first : manner_.deformer, manner_.heat ? manner_.heat->second : manner_.deformer})
    expect_deformer(arguments.file, file(), deformer);
  for (const std::shared_ptr<Worn>& worn : character_.worn())
    worn_.push_back(std::make_unique<WornFigure>(gl_, studio_.programs(), *worn, arguments));
  if (manner_.path != SkinPath::crowd || manner_.heat) return;
  baked_ = figure_.bake(arguments.file, play(), manner_.deformer);
  manner_.baked = baked_.get();
}

Sitting::WornFigure::WornFigure(const Gl& gl, gles3::ProgramSet& programs, const Worn& worn,
                                const RenderArguments& arguments)
    : textures(gl, worn.loaded.file, *images_of(worn.path, worn.loaded.file, arguments)),
      figure(gl, programs, worn.loaded.file, &textures, arguments.normals, arguments.lod) {}

Performance Sitting::perform() {
  Character& character = prepared();
  if (!acting_) return {file(), character, play()};
  Performance out(file(), character,
                  Moments{duration_s(), [this](float time_s) { pose_at(time_s); }, arguments_.camera_follows});
  if (const std::optional<float> ground = acting_->ground_height()) out.set_ground_height(*ground);
  return out;
}

// Dressed, and with its goals.
Character& Sitting::prepared() {
  if (arguments_.between.kind) frames_.emplace(file(), play(), arguments_.between, model_.parameters);
  if (!arguments_.outfits.empty() && manner_.path == SkinPath::crowd)
    throw Failure(Exit::usage, "--path crowd", "", "crowds are baked from one file, without outfits",
                  "use another --path");
  prepare(arguments_, model_, character_, normals_);
  if (arguments_.springs && !springs_.has_any())
    throw Failure(Exit::usage, "--springs", "", "the file has no springs", "draw without; marrow info lists them");
  if (reach_.empty() && !arguments_.springs && !frames_) return character_;
  if (manner_.path == SkinPath::crowd)
    throw Failure(Exit::usage,
                  frames_          ? "--between"
                  : reach_.empty() ? "--springs"
                                   : "--ik",
                  "", "crowds are baked from clips as they are, without inverse kinematics and springs",
                  "use another --path");
  // The camera is to hold what the clip does by itself.
  if (frames_)
    character_.set_weigh([this](auto... to) {
      if (frames_->has_moved()) frames_->weigh(to...);
    });
  character_.set_change([this](std::uint32_t skeleton, const Pose& pose) {
    if (frames_ && frames_->has_moved()) frames_->change(skeleton, pose);
    reach_.apply(skeleton, pose);
    if (swung_s_ < 0 || !springs_.has(skeleton)) return;
    SpringFrame frame;
    frame.dt_s = dt_s_;
    if (acting_) frame.world_from_model = acting_->behaviour().world_from_model();
    springs_.swing(skeleton, frame, pose);
  });
  return character_;
}

void Sitting::act_to(float time_s) {
  if (double{time_s} < acting_->now_s() || acting_->now_s() < 0) springs_ = FileSprings(file());
  if (arguments_.springs) swung_s_ = time_s;
  acting_->play_to(static_cast<double>(time_s), [this](float dt_s) {
    dt_s_ = dt_s;
    acting_->behaviour().pose(character_);
    acting_->leave_prints(character_);
  });
  dt_s_ = 0;
  acting_->behaviour().pose(character_);
}

void Sitting::pose_at(float time_s) {
  if (acting_) return act_to(time_s);
  if (frames_) frames_->move_to(time_s);
  character_.pose(play(), time_s);
}

// Step by step from where springs are, or from the clip's beginning; the next pose shows them.
void Sitting::swing_to(float time_s) {
  if (swung_s_ < 0 || time_s < swung_s_) {
    springs_ = FileSprings(file());
    swung_s_ = dt_s_ = 0;
    pose_at(0);
  }
  while (swung_s_ < time_s) {
    const float next = std::min(swung_s_ + kMaxSpringStep_s, time_s);
    dt_s_ = next - swung_s_;
    swung_s_ = next;
    pose_at(next);
  }
  dt_s_ = 0;
}

void Sitting::agree_on_heat(std::span<const Instant> instants) {
  if (!manner_.heat) return;
  const auto& [a, b] = *manner_.heat;
  float largest = 0;
  for (const Instant& instant : instants) {
    pose_at(instant.time_s);
    largest = std::max(largest, largest_distance(skin_all(file(), character_, a), skin_all(file(), character_, b)));
  }
  manner_.heat_scale = sensible_scale(largest, performance_.diagonal());
  largest_m_ = largest;
  fmt::print("{}: largest distance {} ({} of the diagonal); the hottest colour is {}\n", arguments_.heatmap,
             length_text(static_cast<double>(largest)),
             plain_number(static_cast<double>(largest / performance_.diagonal())),
             length_text(static_cast<double>(manner_.heat_scale)));
}

Shot Sitting::frame(const Instant& instant) const {
  const float aspect = static_cast<float>(width()) / static_cast<float>(height());
  Orbit orbit = viewpoint_.direction;
  if (!viewpoint_.joint && instant.turn_rad) {
    Shot shot = performance_.turned_shot(character_, aspect, kFrameMargin, *instant.turn_rad, orbit);
    shot.light_turn_rad += light_turn_rad(orbit);
    return shot;
  }
  orbit.yaw += instant.turn_rad.value_or(0);
  if (!viewpoint_.joint) {
    Shot shot = performance_.shot_from(orbit, character_, aspect, kFrameMargin);
    shot.light_turn_rad = light_turn_rad(orbit);
    return shot;
  }
  const Affine& joint = character_.model_from_joint(viewpoint_.joint->skeleton)[viewpoint_.joint->joint];
  orbit.target = {joint.rows[0][3], joint.rows[1][3], joint.rows[2][3]};
  orbit.distance = viewpoint_.distance.value_or(performance_.radius());
  Shot shot = performance_.shot_by(camera_on(orbit, aspect, performance_.radius()));
  shot.light_turn_rad = light_turn_rad(orbit);
  return shot;
}

void Sitting::note_misses() {
  misses_.resize(reach_.goals().size());
  ++pictures_;
  for (std::size_t i = 0; i < misses_.size(); ++i) {
    const Reach::Goal& goal = reach_.goals()[i];
    const std::span<const Affine> joints = character_.model_from_joint(goal.skeleton);
    const float miss = reach_.miss_m(goal, {joints.data(), joints.size()});
    misses_[i].largest_m = std::max(misses_[i].largest_m, miss);
    misses_[i].pictures += miss > 0 ? 1 : 0;
  }
}

void Sitting::warn_of_misses() const {
  for (std::size_t i = 0; i < misses_.size(); ++i) {
    if (misses_[i].pictures == 0) continue;
    std::vector<std::string> names = reach_.chain(reach_.goals()[i]);
    for (std::string& name : names) name = fmt::format("\"{}\"", printable(name));
    const std::string when =
        pictures_ == 1 ? "" : fmt::format(" at most, in {} of {} pictures", misses_[i].pictures, pictures_);
    fmt::print(stderr, "--ik: warning: {} misses its goal by {:.3g} m{}\n", fmt::join(names, " > "),
               misses_[i].largest_m, when);
  }
}

void Sitting::add_ground(const Shot& shot) {
  strokes_.clear();
  add_squares(shot, performance_.way(), strokes_);
  for (const Acting::Print& p : acting_->prints()) add_print(p.print, acting_->now_s() - p.at_s, shot, strokes_);
}

Image Sitting::shoot(const Instant& instant) {
  Image image = glimpse(instant);
  note_misses();
  return image;
}

Image Sitting::glimpse(const Instant& instant) {
  if (arguments_.springs && !acting_) swing_to(instant.time_s);
  pose_at(instant.time_s);
  Shot shot = frame(instant);
  if (baked_) baked_->blend(instant.time_s);
  std::vector<Drawable> drawables = drawables_of(arguments_.file, file(), character_, figure_, manner_, shot);
  for (std::size_t i = 0; i < worn_.size(); ++i) {
    const Worn& worn = *character_.worn()[i];
    for (const Drawable& d :
         drawables_of(worn.path, worn.loaded.file, *worn.character, worn_[i]->figure, manner_, shot))
      drawables.push_back(d);
  }
  if (acting_) add_ground(shot);
  Image image = studio_.shoot(shot, drawables, &strokes_);
  if (manner_.heat) draw_legend(image, "distance, " + arguments_.heatmap, largest_m_, manner_.heat_scale);
  for (const Reach::Goal& goal : reach_.goals()) draw_mark(image, shot.camera, goal.position);
  return image;
}

}  // namespace marrow::tools
