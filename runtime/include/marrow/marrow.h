// The whole runtime, in the order in which a frame goes through it.
#pragma once

// clang-format off
#include "marrow/version.h"        // which Marrow, which files
#include "marrow/status.h"         // how calls fail
#include "marrow/call_error.h"     // who is told of bad calls
#include "marrow/zones.h"          // begin and end of calls, for profilers
#include "marrow/math.h"           // maps one after another, back, on points
#include "marrow/block.h"          // memory on 16-byte boundaries
#include "marrow/unpack.h"         // packed file → .mrw in memory
#include "marrow/file.h"           // .mrw → Skeleton, Clip, Mesh
#include "marrow/roles.h"          // which joint is the left foot
#include "marrow/clip_pack.h"      // clips of another file
#include "marrow/playback.h"       // a playing clip: time, speed, loop
#include "marrow/clip_motion.h"    // what a clip does: speed, events, steps, root
#include "marrow/events.h"         // which events a step met
#include "marrow/root_motion.h"    // how far a step moves the character
#include "marrow/phase.h"          // clips in step
#include "marrow/blend_space.h"    // numbers of a game → weights of clips
#include "marrow/sample.h"         // Clip, time → local pose
#include "marrow/curve.h"          // keys, easings, patches → numbers
#include "marrow/blend.h"          // several poses → one
#include "marrow/transition.h"     // one clip → the next
#include "marrow/local_to_model.h" // local pose → model-space joints
#include "marrow/pose_map.h"       // a pose of another rig → local pose
#include "marrow/limits.h"         // how far and how fast joints turn
#include "marrow/ik.h"             // limbs reach, heads look
#include "marrow/ik_solve.h"       // chains and whole bodies reach goals
#include "marrow/feet.h"           // soles on the ground
#include "marrow/springs.h"        // hair, tails and capes swing
#include "marrow/outfit.h"         // hair and clothes of other files follow a body
#include "marrow/example_space.h"  // numbers → weights of morph targets
#include "marrow/morph.h"          // weights → bind vertices moved
#include "marrow/palette.h"        // joints → skinning matrices
#include "marrow/bounds.h"         // palette → a box and a sphere
#include "marrow/skin.h"           // vertices by rigid skinning, SSD, animation space
#include "marrow/debug_lines.h"    // lines that show joints, limits, goals, springs, bounds
#include "marrow/character.h"      // all of a file in two calls a frame: animations by name, every skeleton and mesh
#include "marrow/graph.h"          // a behaviour as data
#include "marrow/animator.h"       // a behaviour in two calls a frame
// clang-format on
