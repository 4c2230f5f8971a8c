#include "render/manner.h"

#include "common/failure.h"
#include "gles3/palettes.h"
#include "render/heat.h"
#include "render/performance.h"

namespace marrow::tools {

std::vector<Drawable> drawables_of(const std::string& path, const File& file, const Character& character,
                                   Figure& figure, const Manner& manner, Shot& shot) {
  std::vector<PosedMesh> posed;
  if (manner.heat || manner.path == SkinPath::cpu || shot.box.empty())
    posed = skin_all(file, character, manner.heat ? manner.heat->first : manner.deformer);
  if (shot.box.empty()) shot.box = box_of(posed);
  if (manner.heat) {
    const std::vector<PosedMesh> other = skin_all(file, character, manner.heat->second);
    shot.shading = kHeatShading;
    return figure.from_cpu(posed, compare(posed, other, manner.heat_scale).colours);
  }
  if (manner.path == SkinPath::cpu) return figure.from_cpu(posed);
  if (manner.path == SkinPath::crowd) return figure.from_crowd(character, manner.deformer, *manner.baked);
  if (const std::optional<std::uint32_t> mesh = figure.too_large(); mesh && manner.path != SkinPath::texture) {
    throw Failure(Exit::unsupported, path, "mesh " + std::to_string(*mesh),
                  "more joints than one uniform block holds (" + std::to_string(gles3::kPaletteJoints) + ")",
                  "use --path cpu or texture, or cook it without --palette");
  }
  return figure.on_gpu(character, manner.deformer, manner.path);
}

}  // namespace marrow::tools
