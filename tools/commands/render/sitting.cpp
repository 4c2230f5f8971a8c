#include "commands/render/sitting.h"

#include <algorithm>
#include <cstdio>

#include "common/failure.h"
#include "common/load_mrw.h"
#include "render/heat.h"
#include "render/mark.h"

namespace marrow::tools {
namespace {

constexpr float kFrameMargin = 0.09f;

}  // namespace

Sitting::Sitting(const LookArguments& arguments)
    : arguments_(arguments),
      size_(parse_size(arguments.size)),
      manner_{arguments.deformer, arguments.path, parse_pair(arguments.heatmap)},
      normals_(arguments.normals),
      loaded_(load_mrw(arguments.file)),
      chosen_(choose(arguments.file, loaded_.file, arguments.choice)),
      reach_(loaded_.file, arguments.reach),
      character_(loaded_.file, normals_, arguments.lod),
      performance_(loaded_.file, reaching(), chosen_.play),
      textures_(gl_, arguments.file, loaded_.file, places_of_cooked(arguments.file, arguments.images_from)),
      studio_(gl_, size_.first, size_.second),
      figure_(gl_, studio_.programs(), loaded_.file, &textures_, normals_, arguments.lod) {
  if (manner_.path != SkinPath::crowd || manner_.heat) return;
  baked_ = figure_.bake(arguments.file, chosen_.play, manner_.deformer);
  manner_.baked = baked_.get();
}

Character& Sitting::reaching() {
  if (reach_.empty()) return character_;
  if (manner_.path == SkinPath::crowd)
    throw Failure(Exit::usage, "--ik", "", "crowds are baked, without inverse kinematics", "use another --path");
  character_.set_change([this](std::uint32_t skeleton, Span<SoaTransform> local, Span<Affine> scene_from_joint) {
    reach_.apply(skeleton, local, scene_from_joint);
  });
  return character_;
}

void Sitting::agree_on_heat(std::span<const Instant> instants) {
  if (!manner_.heat) return;
  const auto& [a, b] = *manner_.heat;
  float largest = 0;
  for (const Instant& instant : instants) {
    character_.pose(chosen_.play, instant.time_s);
    largest = std::max(largest,
                       largest_distance(skin_all(loaded_.file, character_, a), skin_all(loaded_.file, character_, b)));
  }
  manner_.heat_scale = sensible_scale(largest, performance_.diagonal());
  std::printf("%s: largest distance %.6g mm (%.3g of the diagonal); the hottest colour is %.6g mm\n",
              arguments_.heatmap.c_str(), 1e3 * static_cast<double>(largest),
              static_cast<double>(largest / performance_.diagonal()), 1e3 * static_cast<double>(manner_.heat_scale));
}

Image Sitting::shoot(const Instant& instant) {
  character_.pose(chosen_.play, instant.time_s);
  const float aspect = static_cast<float>(width()) / static_cast<float>(height());
  Shot shot = instant.turn_rad ? performance_.turned_shot(character_, aspect, kFrameMargin, *instant.turn_rad)
                               : performance_.shot(character_, aspect, kFrameMargin);
  if (baked_) baked_->blend(instant.time_s);
  const std::vector<Drawable> drawables =
      drawables_of(arguments_.file, loaded_.file, character_, figure_, manner_, shot);
  Image image = studio_.shoot(shot, drawables);
  for (const Reach::Goal& goal : reach_.goals()) draw_mark(image, shot.camera, goal.position);
  return image;
}

}  // namespace marrow::tools
