// Clips of one rig onto another: joints of a character turn as those of another body that are for the same, or as a
// map says.
#pragma once

#include <string>
#include <vector>

#include "cook/prepare/match_skeletons.h"
#include "cook/retarget/plan/pair_rigs.h"
#include "cook/scene/built.h"
#include "cook/scene/raw.h"
#include "marrow/cook_host.h"

namespace marrow::cook {

// Which skeletons are paired, and as what the joints turn: counterparts are joints of the rig.
struct RigPairing {
  std::size_t skeleton = 0, rig = 0;  // of the character, and of the source
  std::vector<Counterpart> pairs;     // a joint
  BuiltSkeleton rig_skeleton = {};
};

// Those that have most in common, see pair_rigs(), or as a map says. Throws tools::Failure: invalid where nothing is
// paired, else as map_rigs().
RigPairing pair_with(const Character& character, const RawScene& source, const RetargetMap* map);

// The same, with warnings of joints that nothing turns as, and of a body of another plan.
RigPairing pair_with(const Character& character, const RawScene& source, const RetargetMap* map, Notes& notes);

// The pairs, their counterparts as nodes of the source.
std::vector<Counterpart> nodes_of_pairs(const RigPairing& pairing);

// Where the character faces another way at rest than the source does; 0: it does not.
void warn_of_facing(const Character& character, const RawScene& source, int facing_deg, Notes& notes);

// Clips of a skeleton of the character: channels' nodes are its joints.
struct RetargetedClips {
  std::size_t skeleton = 0;
  std::vector<RawClip> clips;
};

// All clips of `source`, which is motion capture or of any other scene. map: null: as pair_rigs() has it. What has no
// counterpart keeps its rest pose below what it hangs on.
//
// With G the rotation in the scene that a source's joint has made since its rest pose, and R its counterpart's at rest,
// the counterpart's rotation in the scene is G · A · R. A takes the character from its rest pose to one in which it
// looks as the source does at rest: the direction of its bone goes to that of the source's bone, by the shortest arc,
// so that both bones point the same way in every frame, whether one of them rests in a T-pose and the other in an
// A-pose. A bone goes to the next paired joint below, of several to their mean if they lie about one way (a hand's
// fingers), else A is the identity (hips, a chest). Of a trunk, a neck, a head and shoulders, known by roles, A is the
// identity as well, unless the bones are more than 40 degrees apart: where in the body these joints are differs from
// rig to rig, and says nothing of how it stands. What the fingers are rolled about their mean belongs to A, and half of
// it to the A of the forearm. A foot's A only turns it about y, as its sole is level in both. A joint with none below
// takes the A of the paired joint above if the source's bone to it slopes by less than 60 degrees, or if that A is more
// than 30 (a hand, toes), else the identity (a head).
//
// The topmost joint that the source carries moves from its place, and hips do below it (of motion capture only the
// topmost). The middle of the legs' tops goes along x and z as the source's, scaled by the legs' length, from where
// both are at rest; motion capture is where it says. Along y, feet stand on the ground as the source's do
// (find_ground(), stand()): soles are vertices of the character, where it has meshes. Ankles go along x and z as the
// source's go from the hips. Where a foot of motion capture is lowest it is level: A makes good up to 24 degrees.
// Without legs the joint goes to the source's place, scaled by the length of the way down to its lowest joint, or by
// that of all bones. If the two skeletons face otherwise at rest, clips are turned about y by the quarter turns between
// them, with a warning.
//
// Throws tools::Failure: as pair_with(); invalid where a place comes out beyond 1e12; unsupported for clips of very
// many poses for their bytes.
RetargetedClips retarget_clips(const Character& character, const RawScene& source, const RetargetMap* map,
                               Notes& notes);

// The character's joints as a scene that the clips move, in place of what `scene` has.
Matched scene_of(const Character& character, std::vector<RetargetedClips> all, RawScene scene);

// Of motion capture, as such a scene.
Matched retarget(const Character& character, RawScene capture, Notes& notes);

// A table [joints]: JOINT = "SOURCE", or JOINT = ["SOURCE", "OTHER", SHARE] for one between two. Throws tools::Failure
// (usage), located by line and column, for what is no such file.
RetargetMap parse_retarget_map(const std::string& path, std::string_view text);

// A map that says what pair_with() has found, joint by joint of the character; those without a counterpart and the
// source's that are none are comments.
std::string retarget_map_text(const Character& character, const RawScene& source, const RigPairing& pairing);

// A scene of the file's joints, which its clips move, but for additive ones: keys every 1/60 s, or farther apart where
// they would be too many. Throws tools::Failure as load_mrw(), and (invalid) for a clip pack, which does not say how
// its joints rest.
RawScene read_cooked_motion(const std::string& name, Files& files);

}  // namespace marrow::cook
