// advance_phase() and follow_phase() of motions, weights and places that were checked before, as those of graphs are.
#pragma once

#include "marrow/phase.h"

namespace marrow {

void advance_checked_phase(Span<const PhaseClip> clips, float dt_s, Phase& phase);
void follow_checked_phase(const ClipMotion& motion, const Phase& before, const Phase& after, Playback& was,
                          Playback& now);

}  // namespace marrow
