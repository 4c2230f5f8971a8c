// A whole clip at even moments: what curves, trails and ghosts are drawn from.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/vec3.hpp>

#include "pose/evaluate.h"

namespace marrow::tools {

// Of one joint over a clip, a row a moment.
struct JointCurves {
  std::vector<float> translation[3];   // metres, from the parent
  std::vector<float> rotation_deg[3];  // about x, then y, then z of the parent's axes; without jumps of whole turns
  std::vector<float> scale[3];
  std::vector<glm::vec3> places;  // model space
};

// Poses `play` at `moments` even moments, its first and its end among them, as the clip alone has it. moments: ≥ 2.
// Cost: as many poses.
JointCurves record_joint(const File& file, const Play& play, std::uint32_t skeleton, std::uint32_t joint, int moments);

// A unit quaternion x y z w as angles about the parent's x, y and z axes, in this order, degrees: rotation =
// rotate(z) · rotate(y) · rotate(x). The angle about y is within ±90°.
glm::vec3 angles_deg(const float (&rotation)[4]);

// Seconds of a clip as frames, which artists count from 0.

// Frames that begin within a clip after its first: 30 for a second at 30 Hz.
inline int last_frame(float duration_s, float rate_hz) {
  return static_cast<int>(std::floor(static_cast<double>(duration_s) * static_cast<double>(rate_hz) + 1e-3));
}

// The nearest frame.
inline int frame_at(double time_s, float rate_hz) {
  return static_cast<int>(std::lround(time_s * static_cast<double>(rate_hz)));
}

// Where `frame` begins, within the clip.
inline double time_of_frame(int frame, float duration_s, float rate_hz) {
  return std::clamp(static_cast<double>(frame) / static_cast<double>(rate_hz), 0.0, static_cast<double>(duration_s));
}

// The frame `by` whole frames from a moment, before the first the last and after the last the first.
inline double stepped(double time_s, int by, float duration_s, float rate_hz) {
  const int count = last_frame(duration_s, rate_hz) + 1;
  return time_of_frame(((frame_at(time_s, rate_hz) + by) % count + count) % count, duration_s, rate_hz);
}

}  // namespace marrow::tools
