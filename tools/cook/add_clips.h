// Clips that a scene gets beside its own: those of other rigs, and mirrors of what it has.
#pragma once

#include <string>
#include <vector>

#include "cook/prepare/match_skeletons.h"
#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// A file with another rig: glTF, motion capture or cooked. Throws tools::Failure as these are read.
RawScene read_rig(const std::string& file);

// Of a scene that is prepared: options.retarget, then options.mirror. A clip with a name that there is already gets
// "FILE." in front. Notes what retarget_clips() does, at the file. Throws tools::Failure as reading those files,
// retarget_clips() and with_mirrored_clips().
RawScene with_added_clips(RawScene scene, const CookOptions& options, Notes& notes);

// The clips of options.retarget alone, and their mirrors, of the skeletons of `onto`. `scene`: whose pack it is.
Matched only_added_clips(const Character& onto, RawScene scene, const CookOptions& options, Notes& notes);

// A prepared scene's skeletons, with roles, and its meshes as they are without options of theirs. Points into what it
// holds, and not into the scene.
Character character_of(const RawScene& scene, const std::vector<RoleRule>& roles);

// The map of what `--retarget source` would pair with the joints of `character`, each a file. Throws tools::Failure as
// these are read, and as pair_with().
std::string map_of(const std::string& character, const std::string& source);

}  // namespace marrow::cook
