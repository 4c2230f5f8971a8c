// Seconds of a clip as frames, which artists count from 0.
#pragma once

#include <algorithm>
#include <cmath>

namespace marrow::tools {

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
