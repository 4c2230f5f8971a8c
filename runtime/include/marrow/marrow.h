// The whole runtime, in the order in which a frame goes through it.
#pragma once

// clang-format off
#include "marrow/version.h"         //    everywhere      which Marrow, which files
#include "marrow/status.h"          //    everywhere      how calls fail
#include "marrow/call_error.h"      //    everywhere      who is told of bad calls
#include "marrow/marks.h"           //    everywhere      begin and end of calls, for profilers
#include "marrow/block.h"          //    everywhere      memory on 16-byte boundaries
#include "marrow/unpack.h"          // 0. unpack          packed file → .mrw in memory
#include "marrow/file.h"            // 1. load            .mrw → Skeleton, Clip, Mesh
#include "marrow/clip_pack.h"       //    beside it       clips of another file
#include "marrow/playback.h"        //    before 2        a playing clip: time, speed, loop
#include "marrow/sample.h"          // 2. sample          Clip, time → local pose
#include "marrow/curve.h"           //    beside it       keys, easings, patches → numbers
#include "marrow/blend.h"           //    between 2 and 3 several poses → one
#include "marrow/transition.h"      //    between 2 and 3 one clip → the next
#include "marrow/local_to_model.h"  // 3. local to model  local pose → scene-space joints
#include "marrow/limits.h"          //    after 3         how far and how fast joints turn
#include "marrow/ik.h"              //    after 3         limbs reach, heads look
#include "marrow/ik_solve.h"        //    after 3         chains and whole bodies reach goals
#include "marrow/feet.h"            //    after 3         soles on the ground
#include "marrow/springs.h"         //    after 3         hair, tails and capes swing
#include "marrow/outfit.h"          //    after 3         hair and clothes of other files follow a body
#include "marrow/example_space.h"   //    before morph    numbers → weights of morph targets
#include "marrow/morph.h"           //    before 5        weights → bind vertices moved
#include "marrow/palette.h"         // 4. palette         joints → skinning matrices
#include "marrow/bounds.h"          //    beside 4        palette → a box and a sphere
#include "marrow/skin.h"            // 5. skin            rigid, SSD, animation space
#include "marrow/debug_lines.h"     //    beside 3 and 4  lines that show joints, limits, goals, springs, bounds
#include "marrow/character.h"       // 2. to 4.           all of a file: animations by name, every skeleton and mesh
// clang-format on
