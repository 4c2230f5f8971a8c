// How the root moved in a step of a clip, as a screw.
#pragma once

#include "marrow/clip_motion.h"
#include "marrow/playback.h"
#include "marrow/root_motion.h"
#include "math/rigid.h"

namespace marrow {

// Of root_step(), before it is rounded; false if it is not finite, or the playbacks are no step of the clip.
bool root_screw(const ClipMotion& motion, const Playback& before, const Playback& after, Screw& out);

// In floats; false if it is not finite.
bool rounded_step(const RigidMotion& motion, RigidStep& out);

}  // namespace marrow
