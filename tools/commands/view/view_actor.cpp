#include "commands/view/view_actor.h"

#include <utility>

#include "render/disk/images.h"
#include "render/heat.h"

namespace marrow::tools {
namespace {

std::unique_ptr<Images> images_of(const Source& source) {
  return std::make_unique<FoundImages>(source.path, source.file(), source.images);
}

}  // namespace

ViewActor::ViewActor(const Gl& gl, gles3::ProgramSet& programs, const Choice& choice, Source source, Chosen chosen)
    : Actor(gl, programs, source.path, std::move(source.loaded), *images_of(source)), source_(std::move(source)) {
  if (chosen.play.empty()) return;
  const std::string name = choice.clips.empty() ? choice.clip : choice.clip + " (" + choice.clips + ")";
  chosen_ = add_play(name, std::move(chosen.play), std::move(chosen.pack));
}

Painting& ViewActor::painting(const ViewSettings& settings) {
  if (!painting_)
    painting_.emplace(file(), settings.paint_file.empty() ? paint_file_beside(path()) : settings.paint_file,
                      source_.skins);
  return *painting_;
}

bool ViewActor::paints(const ViewSettings& settings) {
  return settings.painting && !joints().empty() && painting(settings).refusal().empty();
}

std::vector<Drawable> ViewActor::drawables(const ViewSettings& settings, Shot& shot) {
  if (!paints(settings)) return Actor::drawables(settings, shot);
  shot.box = performance().box(character());
  return painted(settings, shot);
}

// By the weights as they are on the canvas, in full detail.
std::vector<Drawable> ViewActor::painted(const ViewSettings& settings, Shot& shot) {
  const NamedJoint& joint = joints()[settings.joint];
  painting_->pose(character());
  const std::uint32_t image = painting_->image_of(settings.brush, joint.skeleton, joint.joint);
  std::vector<std::vector<float>> colours;
  for (std::uint32_t i = 0; i < file().mesh_count(); ++i)
    colours.push_back(ramp_colours(painting_->weights(i, joint.skeleton, joint.joint, image)));
  shot.shading = kHeatShading;
  return figure().from_cpu(painting_->posed(character()), colours);
}

}  // namespace marrow::tools
