// Clips and poses of other rigs, and mirrors: what a scene gets beside its own clips.
#pragma once

#include <string>
#include <vector>

#include "cook/prepare/match_skeletons.h"
#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Of a scene that is prepared: options.clips, then options.mirror. A clip with a name that there is already gets
// "FILE." in front. Notes what retarget_clips() does, at the file. Throws tools::Failure as retarget_clips() and
// with_mirrored_clips().
RawScene with_added_clips(RawScene scene, const RetargetOptions& options, const std::vector<RoleRule>& roles,
                          Notes& notes);

// The clips of options.clips alone, and their mirrors, of the skeletons of `onto`. `scene`: whose pack it is.
Matched only_added_clips(const Character& onto, RawScene scene, const RetargetOptions& options, Notes& notes);

// A prepared scene's skeletons, with roles, and its meshes as they are without options of theirs. Points into what it
// holds, and not into the scene.
Character character_of(const RawScene& scene, const std::vector<RoleRule>& roles);

// Maps by which a game puts poses of other rigs onto a character: of the rules, in their order, each called as its
// rig's file. Notes what make_pose_map() does, at the file. Throws tools::Failure as make_pose_map(); usage where two
// are called alike.
std::vector<BuiltPoseMap> make_pose_maps(const Character& character, const std::vector<RetargetRule>& rules,
                                         Notes& notes);

// The map of what --retarget would pair with the joints of `character`. Throws tools::Failure as pair_with().
std::string map_of(const Character& character, const RawScene& rig);

}  // namespace marrow::cook
