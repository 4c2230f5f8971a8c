// Vertices on fewer joints, as close to what they were as those allow.
#pragma once

#include "cook/skin/skin_binding.h"
#include "deform/pose_metric.h"

namespace marrow::cook {

// In animation space.
std::vector<deform::Coordinate> coordinates_of(const BoundVertex& vertex, const glm::dvec3& position);

// On at most so many joints: what animation space makes of it and what linear blend skinning does, each as close to
// what it was as they allow, and both as they were in the bind pose.
BoundVertex with_fewer_joints(const deform::PoseMetric& metric, const BoundVertex& vertex, const glm::dvec3& position,
                              bool has_residual, std::size_t most);

}  // namespace marrow::cook
