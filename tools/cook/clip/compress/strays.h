// The errors of decoded joints while steps are searched for.
#pragma once

#include <span>
#include <vector>

#include "cook/clip/measure/rig.h"
#include "math/linear.h"

namespace marrow::cook {

// Moments between two frames at which the error is watched: the frame itself, the quarters and the middle.
inline constexpr std::size_t kMoments = 4;

// How far decoded joints stand from where the source has them: four moments at once, in single precision. Holds
// differences of maps in units of the strictest promise, not maps, so that floats lose nothing that counts.
// With s the source's maps and d the decoded ones, below a parent p:
//   d − s = (dₚ − sₚ) · local + (sₚ · local − s)
// where the last bracket hangs on the joint's own tracks alone.
class Strays {
 public:
  // source: a joint and moment (kMoments a frame but one at the last), parent_from_joint.
  Strays(const Rig& rig, const Promise& promise, const std::vector<std::span<const Transform>>& source);

  std::size_t frame_count() const { return frame_count_; }
  // model_from_joint.
  const World& source(std::size_t joint, std::size_t moment) const { return source_[joint][moment]; }
  World decoded(std::size_t joint, std::size_t moment) const;  // as placed and committed

  // decoded: a joint and moment, as source. False: a joint strays beyond its promise, and nothing is changed.
  bool place(const std::vector<std::vector<Transform>>& decoded);
  // Tries decoded moments of one frame: parent_from_joint of `joint`, kMoments of them or, of the last frame, one. Adds
  // to `energy` how much the sum of (error / promise)⁸ changes of it and all that is below it. False: one of them
  // strays beyond its promise.
  bool attempt(std::size_t joint, std::size_t frame, const Transform* decoded, double& energy);
  // The largest (error / promise)² at decoded moments of one frame, or at the frame itself alone. May stop early with
  // any number above `most`.
  float worst(std::size_t joint, std::size_t frame, const Transform* decoded, bool only_first, float most);
  // rig.subtree() of a joint, which is kept.
  const std::vector<std::size_t>& subtree(std::size_t joint);
  // Takes over the joint's last attempts, which must have been of all frames.
  void commit(std::size_t joint);

 private:
  // Maps of four moments, or differences of maps.
  struct FourMaps {
    Linear<f32x4> linear;
    Vector<f32x4> origin;
  };
  struct Placed {
    FourMaps stray;
    f32x4 energy;
  };
  // Each a frame and joint, so that what one attempt reads lies together.
  struct Poses {
    std::vector<FourMaps> local, own;  // own: the bracket above
    std::vector<Placed> placed;
  };

  std::size_t moment_of(std::size_t frame, std::size_t lane) const;
  std::size_t at(std::size_t frame, std::size_t joint) const { return frame * rig_.size() + joint; }
  void take_local(std::size_t joint, std::size_t frame, const Transform* decoded, Poses& out) const;
  f32x4 move(std::size_t joint, std::size_t frame, const Poses& own, const Poses& above);
  f32x4 energy_change(std::size_t joint, std::size_t frame, f32x4 share);
  f32x4 squared_error(std::size_t joint, std::size_t frame, const FourMaps& stray) const;

  const Rig& rig_;
  std::vector<std::vector<std::size_t>> subtrees_;  // a joint; empty: not asked for yet
  std::size_t frame_count_ = 0;
  double unit_ = 0;  // scene units
  std::vector<std::vector<World>> source_;
  std::vector<Vector<f32x4>> per_axis_;         // a frame and joint: the shell's radius over the axes' lengths
  std::vector<std::vector<glm::vec4>> points_;  // a joint: as Promise::points
  std::vector<float> inverse_limit_;            // a joint: one over its promise squared
  Poses now_, trial_;
};

}  // namespace marrow::cook
