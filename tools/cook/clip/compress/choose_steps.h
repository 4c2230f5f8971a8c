// Chooses the step of every coded track of one stretch of a clip: the fewest bits on disk that keep the promise.
#pragma once

#include <cstdint>
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
class StepSearch {
 public:
  // source: a joint and moment (kMoments a frame but one at the last), parent_from_joint; must outlive it. exact:
  // tracks that are stored without loss. still: a joint; what is neither coded nor exact.
  StepSearch(const Rig& rig, const Promise& promise, const std::vector<TrackId>& coded,
             const std::vector<TrackId>& exact, const std::vector<Transform>& still,
             std::vector<std::span<const Transform>> source);

  // False if no steps keep the promise.
  bool search(Effort effort);
  const std::vector<CodedTrack>& tracks() const { return coded_; }

 private:
  struct Trial {
    bool kept = false;  // the promise
    double energy = 0;  // change
  };

  std::size_t moment_count() const { return source_.empty() ? 0 : source_[0].size(); }
  void find_targets();
  void find_reach();
  bool start(double share);
  Trial attempt(std::size_t track, const CodedTrack& candidate);
  void commit(std::size_t track, CodedTrack candidate);
  void decode_frame(std::size_t track, const CodedTrack& candidate, std::size_t frame,
                    std::vector<Transform>& out) const;
  bool coarser(std::size_t track, CodedTrack& candidate);
  void coarsen();
  void price(std::size_t track, CodedTrack& candidate);
  std::uint64_t cost() const;
  std::vector<glm::dvec3> compensated(std::size_t track) const;
  void compensate();
  float error_at(std::size_t track, const CodedTrack& candidate, std::size_t frame, float most);
  bool mend(std::size_t track, CodedTrack& candidate);
  bool push(std::size_t track);

  const Rig& rig_;
  Promise promise_;
  const std::vector<TrackId>& ids_;
  std::vector<std::span<const Transform>> source_;
  std::vector<std::vector<glm::dvec3>> targets_;  // a track and frame: what is rounded
  std::vector<double> reach_;                     // a joint: metres to the farthest of what it carries
  std::vector<double> scale_above_;               // a joint: scene units a unit of its translation
  std::vector<double> least_;                     // a joint: the strictest promise for it and those below it

  std::vector<CodedTrack> coded_;
  PackedCost packed_cost_;
  std::vector<std::array<ClipCurve, 3>> curves_;  // a track
  std::vector<std::vector<Transform>> local_;     // as decoded, a joint and moment
  Strays strays_;

  std::size_t tried_ = SIZE_MAX;         // the track of the last attempt, if it is not committed and was kept
  std::vector<Transform> trial_local_;   // of the last attempt
  std::vector<std::size_t> hard_frame_;  // a track: where it last broke the promise
};

}  // namespace marrow::cook
