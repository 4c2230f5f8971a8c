// Whether an outfit was bound in the pose that its body rests in.
#pragma once

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Warns for each skin that is drawn if the body's rest pose puts a vertex more than 1 mm from where it was bound, seen
// from the joint that most follow, and also from where it stands in the outfit's own file; names the joint of the
// worst. A file whose rest pose is not its bind pose is so no reason to warn, as long as it rests like its body. built:
// skeletons, and which joint a node is. body: its file, for messages.
void check_bind_pose(const RawScene& scene, const BuiltScene& built, const std::string& body, Notes& notes);

}  // namespace marrow::cook
