// A brush for a joint's weights, its strokes, from where the button goes down to where it is let go, and the history of
// them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "paint/canvas.h"
#include "text/choices.h"

namespace marrow::tools {

enum class BrushMode : std::uint8_t { add, subtract, set, smooth };

inline constexpr Named<BrushMode> kBrushModes[] = {
    {"add", BrushMode::add}, {"subtract", BrushMode::subtract}, {"set", BrushMode::set}, {"smooth", BrushMode::smooth}};

// A plane of symmetry, of the model at rest.
struct MirrorPlane {
  int axis = -1;  // 0, 1, 2: across x, y, z; below 0: there is none
  float at = 0;   // scene units along the axis
  bool operator==(const MirrorPlane&) const = default;
};

struct Brush {
  BrushMode mode = BrushMode::add;
  float radius = 0;  // scene units
  float strength = 0.5f;
  MirrorPlane mirror;
  bool through = false;  // what is not joined to the surface under it, too
};

// 1 in the middle, 0 at the radius and beyond, flat at both: (1 - (d / r)²)². A radius that is not above 0 has no
// inside.
double falloff(double distance, double radius);

// The weight that the whole of a stroke makes of `before`. amount: 0 … 1, how much of the brush the vertex has felt.
// Not for smoothing, which depends on neighbours.
double painted_weight(const Brush& brush, double before, double amount);

// What a place had and has; enough to go back and on.
struct Change {
  std::uint32_t place;
  bool was_touched;
  Influences before, after;
};
using Edit = std::vector<Change>;

// What the brush does to weights.
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

// Strokes that can be taken back, and made again.
class History {
 public:
  static constexpr std::size_t kMost = 200;  // strokes; older ones stay

  // One that has been made. What was taken back is forgotten.
  void add(Edit edit) {
    if (edit.empty()) return;
    edits_.resize(done_);
    if (saved_ > static_cast<std::ptrdiff_t>(done_)) saved_ = kGone;
    edits_.push_back(std::move(edit));
    ++done_;
    if (edits_.size() <= kMost) return;
    edits_.erase(edits_.begin());
    --done_;
    saved_ = saved_ <= 0 ? kGone : saved_ - 1;
  }
  std::size_t done() const { return done_; }
  std::size_t undone() const { return edits_.size() - done_; }
  void undo(Canvas& canvas) {
    if (done_ > 0) tools::undo(canvas, edits_[--done_]);
  }
  void redo(Canvas& canvas) {
    if (done_ < edits_.size()) tools::redo(canvas, edits_[done_++]);
  }
  // Whether it is as it was when it was saved last, or at first.
  bool saved() const { return saved_ == static_cast<std::ptrdiff_t>(done_); }
  void set_saved() { saved_ = static_cast<std::ptrdiff_t>(done_); }
  void set_unsaved() { saved_ = kGone; }

 private:
  static constexpr std::ptrdiff_t kGone = -1;
  std::vector<Edit> edits_;
  std::size_t done_ = 0;
  std::ptrdiff_t saved_ = 0;
};

}  // namespace marrow::tools
