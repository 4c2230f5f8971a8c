// What the newt does in a game: it runs, sets off and stops, turns, hops over something, is hit.
//
// Clips that are played once begin and end where hips neither turn nor lead: standing, or at a moment of the walk or
// the run in which a leg passes the other. So a root that follows the hips goes as the newt goes.
#pragma once

#include "acting/motion.h"

namespace marrow::sample {

// Metres of a round of the run, and seconds that it takes. In the air the newt goes on as fast.
inline constexpr float kRunStride = .868f, kRunRound_s = .56f;
inline constexpr float kRunSpeed = kRunStride / kRunRound_s;

// Phase of its loop: 0 is when the left foot comes down, as of the walk. The way is not in it.
Pose run_pose(float phase);
// In the air, on the way up and on the way down: loops, without the way.
Pose rise_pose(float phase);
Pose fall_pose(float phase);

// Once, over 0 … 1 of so many seconds, way included.
inline constexpr float kStart_s = .72f, kStop_s = 1.15f, kTurn_s = 1.2f, kJump_s = .38f, kLand_s = .42f, kHit_s = 1;
// From standing into the walk, at a quarter of it; back from there.
Pose start_pose(float share);
Pose stop_pose(float share);
// A quarter of a turn to the left, on the spot.
Pose turn_pose(float share);
// From a quarter of the run to leaving the ground with the right foot; from coming down with the left foot to three
// quarters of the run.
Pose jump_pose(float share);
Pose land_pose(float share);
// By something that falls on its head.
Pose hit_pose(float share);

}  // namespace marrow::sample
