// Hair, clothes and what a hand holds, exported apart from their body: their nodes become the body's joints of the same
// names, and what only they have hangs on these.
#pragma once

#include "cook/prepare/match_skeletons.h"

namespace marrow::cook {

// The scene's skeletons are the body's, those that something here follows, each whole and with its rest pose. Among
// their joints are the outfit's own: nodes that a skin names or a clip moves, and what lies between them and a joint of
// the body; of each parent they come behind its children of the body, so that joints are breadth-first (outfit.h).
// Joints of a skin that no vertex follows and that hang on no joint of the body, such as an exporter's own root, are
// left out.
//
// Clips lose what they do to joints of the body, and are dropped where nothing is left; warnings say so, and where
// skins were bound in another pose than the body's rest (check_bind_pose.h). Throws tools::Failure (invalid):
// two nodes of one name, a joint below another one than in the body, vertices or meshes that follow no joint of the
// body, a skin across two skeletons, nothing to draw; (unsupported) too many joints.
Matched match_outfit(const Character& body, RawScene scene, Notes& notes);

}  // namespace marrow::cook
