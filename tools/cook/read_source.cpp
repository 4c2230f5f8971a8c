#include "common/failure.h"
#include "common/formats.h"
#include "cook/bvh/read_bvh.h"
#include "cook/read_inputs.h"

namespace marrow::cook {

RawScene read_source(const std::string& name, Files& files, const SourceOptions& options) {
  if (!tools::is_named_bvh(name))
    return read_gltf(
        name, files,
        {.image_bytes = options.images == Images::embed, .scene = options.scene, .strict = options.strict});
  const SceneChoice& scene = options.scene;
  if (!scene.name.empty() && scene.origin.must_fit)
    throw tools::Failure(tools::Exit::usage, scene.origin.file, scene.origin.where, "motion capture has no scenes",
                         "leave it out for " + name);
  return read_bvh(name, files);
}

}  // namespace marrow::cook
