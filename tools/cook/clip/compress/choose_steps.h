// Chooses the step of every coded track of one stretch of a clip: the fewest bits on disk that keep the promise.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cook/clip/compress/coded_track.h"
#include "cook/clip/compress/strays.h"
#include "cook/scene/cook_options.h"

namespace marrow::cook {

struct TrackId {
  std::size_t joint;
  TrackPath path;
};

// Works on poses in model space through the whole hierarchy, and on the very integers that are stored. First every
// track gets a step by how far its joint reaches, all shrunk together until the promise holds; then one track at a time
// is coarsened, always where most bits are saved for the least rise of Σ (error / promise)⁸. Then every track aims
// again, so that it makes good what the joints above it miss, and the rest of the slack is spent. Last, tracks are
// pushed on: a quarter octave coarser than the promise allows, with neighbours of the nearest integers in those frames
// in which it would be broken.
//
// source: a joint and moment (kMoments a frame but one at the last), parent_from_joint. exact: tracks that are stored
// without loss. still: a joint; what is neither coded nor exact. Nothing where no steps keep the promise.
std::optional<std::vector<CodedTrack>> choose_steps(const Rig& rig, const Promise& promise,
                                                    const std::vector<TrackId>& coded,
                                                    const std::vector<TrackId>& exact,
                                                    const std::vector<Transform>& still,
                                                    std::vector<std::span<const Transform>> source, Effort effort);

}  // namespace marrow::cook
