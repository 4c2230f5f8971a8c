// The source's clips as the file will have them: split by skeleton, compressed, some of them additive.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// What clips carry along, and must not take far from where the source has it.
struct Carried {
  std::vector<Mesh> meshes;  // every level of detail of each
  std::vector<BuiltNode> nodes;
  std::vector<MorphedMesh> morphed;
};

// Clip by clip of the source, in each skeleton by skeleton. built: its skeletons, and the clips of build_raw_clips()
// with their motions, or no clips. Roots' motion is taken out. Throws tools::Failure (usage) if an option names what
// there is not.
std::vector<BuiltClip> build_clips(const RawScene& scene, const BuiltScene& built, const Carried& carried,
                                   const ClipOptions& options, Notes& notes);
// The same without compression and without notes, for those who look at poses.
std::vector<BuiltClip> build_raw_clips(const RawScene& scene, const BuiltScene& built,
                                       const std::vector<AdditiveRule>& additive);

}  // namespace marrow::cook
