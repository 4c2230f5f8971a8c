#include "commands/view/paint/brush.h"

#include <algorithm>

namespace marrow::tools {

double falloff(double distance, double radius) {
  if (!(radius > 0) || !(distance < radius)) return 0;
  const double share = distance / radius, inside = 1 - share * share;
  return inside * inside;
}

double painted_weight(const Brush& brush, double before, double amount) {
  const double strength = static_cast<double>(brush.strength);
  switch (brush.mode) {
    case BrushMode::add:
      return std::min(1.0, before + amount * strength);
    case BrushMode::subtract:
      return std::max(0.0, before - amount * strength);
    case BrushMode::set:
      return before + amount * (strength - before);
    case BrushMode::smooth:
      break;
  }
  return before;
}

}  // namespace marrow::tools
