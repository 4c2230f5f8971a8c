// What an artist has shown of how a character's surface should be, in poses.
#pragma once

#include <string>
#include <vector>

#include "cook/learn/trainees.h"
#include "cook/skin/deform_source.h"
#include "deform/deformers.h"

namespace marrow::cook {

// A scene of which a mesh, bound to a skin, is to be shown.
struct Shown {
  const RawScene& scene;
  const RawMesh& mesh;
  const RawSkin& skin;
  const BuiltScene& built;
  const DeformSource& source;
};

// A glTF file's examples of the mesh, which must have the same primitives with the same vertices in the same order:
// - of a mesh that is bound to a skin, moments of the file's clips: the file's own joints, found by their names, and
//   its morph targets as the clips drive them, before skinning as glTF 2.0 has it: corrective shapes;
// - meshes without a skin whose nodes have `extras` with "marrow.clip" and "marrow.time", of the character's clips: the
//   surface as it is there, in the scene's space.
// Throws tools::Failure (invalid) at the place in the file: what does not read; no example; other vertices; a joint, a
// clip or a time that there is not; a position that is not finite.
std::vector<ShownPose> read_examples(const RawScene& examples, const Shown& shown);

// Where the examples, and rest, put the vertices; not finite in poses that are none of them.
deform::Deformer as_shown(const deform::SkinnedMesh& mesh, const std::vector<ShownPose>& examples);

}  // namespace marrow::cook
