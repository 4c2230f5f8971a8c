#include "cook/read_source.h"

#include "common/failure.h"
#include "common/formats.h"
#include "cook/bvh/read_bvh.h"

namespace marrow::cook {

RawScene read_source(const std::string& path, const CookOptions& options) {
  if (!tools::is_named_bvh(path))
    return read_gltf(
        path, {.image_bytes = options.images == Images::embed, .scene = options.scene, .strict = options.strict});
  const SceneChoice& scene = options.scene;
  if (!scene.name.empty() && scene.origin.must_fit)
    throw tools::Failure(tools::Exit::usage, scene.origin.file, scene.origin.where, "motion capture has no scenes",
                         "leave it out for " + path);
  return read_bvh(path);
}

}  // namespace marrow::cook
