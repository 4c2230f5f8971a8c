// A stroke of the brush, from where the button goes down to where it is let go: what it does to weights.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "commands/view/paint/brush.h"
#include "commands/view/paint/canvas.h"
#include "commands/view/paint/ray.h"

namespace marrow::tools {

// What a place had and has; enough to go back and on.
struct Change {
  std::uint32_t place;
  bool was_touched;
  Influences before, after;
};
using Edit = std::vector<Change>;

class Stroke {
 public:
  // joint: of the skeleton, and its mirror image. mirror: as mirrored_places() has it, or empty. All outlive it.
  Stroke(Canvas& canvas, const Brush& brush, std::uint32_t skeleton, std::uint32_t joint, std::uint32_t mirrored,
         std::span<const std::uint32_t> mirror);

  // Presses the brush onto the surface. Places within its radius, as they are posed, are painted; unless it goes
  // through, only those that edges within it join to the triangle. Passing over a place again adds nothing: a stroke is
  // as strong as its strongest touch. But each touch smooths, all joints together: a place goes so far of the way to
  // the mean of its neighbours. posed: a place.
  void dab(std::span<const glm::vec3> posed, const SurfaceHit& hit);

  // Places of the stroke so far that have kept the joint's weight although it should be less, as no other joint moves
  // them.
  std::size_t kept() const { return kept_.size(); }

  // All that has changed.
  Edit edit() const;

 private:
  struct Touch {
    std::uint32_t place;
    double own, image;  // how much of the brush, and of its mirror image
  };
  std::vector<std::pair<std::uint32_t, double>> reached(std::span<const glm::vec3> posed, const SurfaceHit& hit);
  std::vector<Touch> touches(std::span<const glm::vec3> posed, const SurfaceHit& hit);
  Influences smoothed(std::uint32_t place, double amount) const;
  double target(std::uint32_t joint, double amount, const Influences& before) const;
  Influences painted(const Touch& touch, const Influences& before);
  bool may_paint(std::uint32_t place, std::uint32_t joint) const;

  Canvas& canvas_;
  Brush brush_;
  std::uint32_t skeleton_, joint_, mirrored_;
  std::span<const std::uint32_t> mirror_;
  // A place, so far: the strongest touches, and what it had.
  std::vector<double> own_, image_;
  std::vector<char> changed_;
  std::vector<Change> edit_;
  std::vector<std::uint32_t> where_;  // in edit_
  std::vector<std::uint32_t> kept_;   // ascending
};

// Makes a change, or takes it back.
void redo(Canvas& canvas, const Edit& edit);
void undo(Canvas& canvas, const Edit& edit);

}  // namespace marrow::tools
