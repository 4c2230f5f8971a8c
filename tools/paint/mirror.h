// What is the mirror image of what: places of a canvas, joints of a skeleton.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "paint/canvas.h"
#include "paint/stroke.h"

namespace marrow::tools {

// Of each place the one that it is the mirror image of, in the bind pose: the nearest on the same skeleton, no farther
// off than `within`, else kNoPlace. plane: there is one. Cost: n log n.
std::vector<std::uint32_t> mirrored_places(const Canvas& canvas, const MirrorPlane& plane, double within);

// "LeftArm" and "RightArm", "arm.L" and "arm.R", "l_arm" and "r_arm": of one the other. Of other names the same.
std::string mirrored_name(const std::string& name);

// The joint on the other side: by its name if the skeleton has that, else the nearest to the mirrored place, no farther
// off than `within`; else, and where that is none other, itself. names, places: a joint, at rest in the scene.
std::uint32_t mirrored_joint(std::span<const std::string> names, std::span<const glm::vec3> places, std::uint32_t joint,
                             const MirrorPlane& plane, double within);

}  // namespace marrow::tools
