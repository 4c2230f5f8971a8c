#include "cook/build_pack.h"

#include <utility>
#include <vector>

#include "common/failure.h"
#include "cook/clip/build_clips.h"
#include "cook/motion/build_motions.h"
#include "cook/options/exclusions.h"
#include "cook/prepare/idle_motion.h"
#include "cook/prepare/match_skeletons.h"
#include "cook/prepare/prepare_scene.h"
#include "cook/retarget/add_clips.h"
#include "cook/retarget/mirror_clips.h"
#include "cook/retarget/retarget.h"
#include "cook/roles/build_roles.h"
#include "cook/skeleton/build_skeletons.h"

namespace marrow::cook {
namespace {

// Skeletons that no clip moves are of no use.
BuiltScene without_unmoved(BuiltScene scene) {
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
  return scene;
}

// Clips of other rigs, for the character or for what the scene is.
Matched clips_of_rigs(RawScene scene, const CookOptions& options, Notes& notes) {
  if (options.onto) return only_added_clips(*options.onto, std::move(scene), options.retarget, notes);
  scene = prepare_scene(std::move(scene), options.prepare, notes);
  const Character own = character_of(scene, options.roles);
  return only_added_clips(own, std::move(scene), options.retarget, notes);
}

// The scene's clips, for the skeletons that they are to move.
Matched clips_and_skeletons(RawScene scene, const CookOptions& options, Notes& notes) {
  if (!options.retarget.clips.empty()) return clips_of_rigs(std::move(scene), options, notes);
  if (options.onto && scene.is_capture) return retarget(*options.onto, std::move(scene), notes);
  if (options.onto) return match_skeletons(*options.onto, std::move(scene), options.prepare.keep, notes);
  scene = without_idle_motion(std::move(scene), options.prepare.keep, notes);
  BuiltScene skeletons = build_skeletons(scene);
  return {std::move(scene), std::move(skeletons)};
}

}  // namespace

BuiltScene build_pack(RawScene given, const CookOptions& options, Notes& notes) {
  notes.begin(Stage::prepare);
  check_for(Product::pack, options);
  auto [scene, out] = clips_and_skeletons(std::move(given), options, notes);
  if (scene.clips.empty() || out.skeletons.empty())
    throw tools::Failure(tools::Exit::invalid, scene.source, "/animations", "no-clips",
                         "no animation moves a node of the scene; cook without --clips-only");
  if (options.retarget.clips.empty()) {
    if (!options.onto) find_roles(scene, {}, options.roles, out, notes);
    scene = with_mirrored_clips(std::move(scene), out, options.retarget.mirror);
  }
  out.is_pack = true;
  out.packs_clips = options.mesh.codec != MeshCodec::none;
  notes.begin(Stage::clip);
  Carried carried;
  if (options.onto) {
    carried.meshes = options.onto->meshes;
    carried.morphed = options.onto->morphed;
  }
  out.clips = build_raw_clips(scene, out, options.clips.additive);
  measure_motions(scene, carried.meshes, options.motion, out, notes);
  out.clips = build_clips(scene, out, carried, options.clips, notes);
  return without_unmoved(std::move(out));
}

}  // namespace marrow::cook
