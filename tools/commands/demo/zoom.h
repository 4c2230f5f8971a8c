// The worst place of a contact sheet from near by: the joint about which two deformers differ most.
#pragma once

#include <string>
#include <vector>

#include "pose/evaluate.h"
#include "render/figure.h"
#include "render/heat.h"
#include "render/performance.h"

namespace marrow::tools {

struct WorstMoment {
  float time_s = 0;
  Farthest place;
};

// The joint that a vertex belongs to: of those that it follows by a twentieth or more the one that is nearest in this
// pose, for that is where the skin bends. By its name, or without one its number; empty if the file has no such vertex.
std::string joint_about(const File& file, const Character& character, const Farthest& place);

inline constexpr int kZoomColumns = 3;

struct Zoom {
  std::string joint;
  std::vector<Image> cells;  // SSD, AS, difference; of the studio's size
};

// From the side on which the difference is seen best, the usual one if that is nearly as good. Leaves `character` in
// the moment's pose. full_scale_m: what the hottest colour stands for.
Zoom shoot_zoom(Studio& studio, Figure& figure, const Performance& performance, const File& file, Character& character,
                const Play& play, const WorstMoment& worst, float aspect, float full_scale_m);

}  // namespace marrow::tools
