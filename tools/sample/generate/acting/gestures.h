// What all of the newt's acting is made of: a spine that bends, a tail and gills that follow, hands at rest, strides.
#pragma once

#include "acting/motion.h"

namespace marrow::sample {

inline constexpr float kTau = 6.2831853f;

float wave(float phase, float lag = 0);

// Spreads a turn over the trunk.
void bend_spine(Pose& pose, float x, float y, float z);
// And one over neck and head.
void bend_head(Pose& pose, float x, float y, float z);

// A wave that runs down the tail, larger towards the tip.
void sway_tail(Pose& pose, float phase, float degrees, float lag);

// Gills trail behind whatever the head does.
void flutter_gills(Pose& pose, float phase, float degrees);

void relax_hand(Pose& pose, int side, float curl);

// How far ahead of its place a foot is that comes down at phase 0, stands for a share of the round, and swings.
float stride(float phase, float stance, float front, float back);

// One foot of the walk; phase 0 is when its heel strikes.
Stand walking_foot(float phase);

}  // namespace marrow::sample
