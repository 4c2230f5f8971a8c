// Motion capture onto a character: joints of its own proportions and rest pose turn as those of the same names.
#pragma once

#include "cook/prepare/match_skeletons.h"
#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// `capture`: as read_bvh() gives it, with nodes that do not turn at rest, a skin of all joints, and one clip, all of
// whose channels have the same keys. Joints are paired by pair_joints() with those of the skeleton that has most of
// them; the rest keep their rest pose.
//
// With G a captured joint's rotation in the scene and R its counterpart's at rest, the counterpart's rotation in the
// scene is G · A · R. A takes the direction of its bone at rest to the direction of the captured bone at rest, by the
// shortest arc, so that both bones point the same way in every frame, whether one of them rests in a T-pose and the
// other in an A-pose. A bone goes to the next paired joint below, of several to their mean if they lie about one way
// (a hand's fingers), else A is the identity (hips, a chest). What the fingers are rolled about that mean belongs to A,
// and half of it to the A of the forearm. A foot's A only turns it about y, as its sole is level in both. A joint with
// none below takes the A of the paired joint above if the captured bone to it slopes by less than 60 degrees, or if
// that A is more than 30 (a hand, toes), else the identity (a head).
//
// Only the topmost joint that the capture carries moves from its place. Legs are the chains below it that part at one
// joint (find_legs()). The middle of their tops goes along x and z as the captured one, scaled by the legs' length.
// Along y, feet stand on the ground as the captured ones do (find_ground(), stand()): soles are vertices of the
// character, where it has meshes. Where a captured foot is lowest it is level: A makes good up to 24 degrees.
// Without legs the joint goes to the captured place, scaled by the length of the way down to its lowest joint, or by
// that of all bones. If the two skeletons face otherwise at rest, the capture is turned about y by the quarter turns
// between them, with a warning.
//
// Throws tools::Failure: invalid where no name fits, or a place comes out beyond 1e12; unsupported for clips of very
// many poses for their bytes.
Matched retarget(const Character& character, RawScene capture, Notes& notes);

}  // namespace marrow::cook
