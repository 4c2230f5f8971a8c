// The same character cooked without a better deformer, in the other's pose: what any engine would draw.
#pragma once

#include <vector>

#include "render/figure.h"
#include "stage/actor.h"

namespace marrow::tools {

class Plain {
 public:
  // `gl` and `programs` outlive it, `images` need not.
  Plain(const Gl& gl, gles3::ProgramSet& programs, LoadedFile loaded, Images& images)
      : loaded_(std::move(loaded)),
        textures_(gl, loaded_.file, images),
        figure_(gl, programs, loaded_.file, &textures_) {}

  // Whether a file's meshes hang on the same joints as the actor's, one by one.
  static bool fits(const File& file, const File& other) {
    bool same = file.mesh_count() == other.mesh_count() && file.skeleton_count() == other.skeleton_count();
    for (std::uint32_t s = 0; same && s < file.skeleton_count(); ++s)
      same = file.skeleton(s).joint_count == other.skeleton(s).joint_count;
    for (std::uint32_t m = 0; same && m < file.mesh_count(); ++m)
      same = file.mesh(m).skeleton == other.mesh(m).skeleton && file.mesh(m).targets.size == other.mesh(m).targets.size;
    return same;
  }

  // By linear blend skinning.
  std::vector<Drawable> drawables(const Character& posed) {
    return figure_.on_gpu(posed, Deformer::ssd, figure_.too_large() ? SkinPath::texture : SkinPath::ubo);
  }

 private:
  LoadedFile loaded_;
  Textures textures_;
  Figure figure_;
};

}  // namespace marrow::tools
