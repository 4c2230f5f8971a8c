// A clip pack: clips and what they were made for, without the skeletons themselves and without meshes.
#include <algorithm>
#include <vector>

#include "common/failure.h"
#include "cook/build.h"
#include "cook/prepare/match_skeletons.h"

namespace marrow::cook {
namespace {

// Skeletons that no clip moves are of no use.
void drop_unmoved(BuiltScene& scene) {
  std::vector<std::uint32_t> number(scene.skeletons.size(), 0);
  for (const BuiltClip& clip : scene.clips) number[clip.skeleton] = 1;
  std::uint32_t count = 0;
  for (std::size_t s = 0; s < number.size(); ++s) {
    if (number[s] == 0) continue;
    if (count != s) scene.skeletons[count] = std::move(scene.skeletons[s]);
    number[s] = count++;
  }
  scene.skeletons.resize(count);
  for (BuiltClip& clip : scene.clips) clip.skeleton = number[clip.skeleton];
}

}  // namespace

BuiltScene build_pack(RawScene& scene, const CookOptions& options) {
  BuiltScene out;
  out.is_pack = true;
  if (options.onto) {
    match_skeletons(*options.onto, scene, out);
  } else {
    build_skeletons(scene, out);
  }
  if (scene.clips.empty() || out.skeletons.empty())
    throw tools::Failure(tools::Exit::invalid, scene.source, "/animations", "no-clips",
                         "no animation moves a node of the scene; cook without --clips-only");
  build_clips(scene, options, out);
  drop_unmoved(out);
  return out;
}

}  // namespace marrow::cook
