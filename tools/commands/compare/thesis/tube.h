// A tube on a chain of joints, of any size: what frames a second are measured on.
#pragma once

#include "commands/compare/thesis/frame_rates.h"
#include "cook/scene/raw.h"
#include "cook/skin/deform_source.h"
#include "deform/skinned_mesh.h"

namespace marrow::tools {

// Along x, of rings of twenty; a joint at x = 0, 1, 2 …, each below the one before it.
class Tube {
 public:
  explicit Tube(const ThesisSize& size);

  cook::DeformSource source;  // mesh, parents and centres

  // All joints bend and twist alike.
  deform::Pose pose(double bend_rad, double twist_rad) const;
  // As an artist's file has it, with a clip of two seconds that bends and twists it and back.
  cook::RawScene scene() const;
};

}  // namespace marrow::tools
