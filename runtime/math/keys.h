// Where a time falls among key times, and the weights of glTF's cubic splines there.
#pragma once

#include <cstddef>

namespace marrow {

// Binary search in ascending numbers: i with values[i] ≤ x < values[i + 1], if values[0] ≤ x < values[last]. Whatever
// the numbers are, 0 ≤ i < last, if last ≥ 1.
inline std::size_t find_interval(const float* values, std::size_t last, float x) {
  std::size_t low = 0, high = last;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    if (x < values[middle]) {
      high = middle;
    } else {
      low = middle;
    }
  }
  return low;
}

// Where a time falls among key times.
struct Moment {
  std::size_t key;  // the last at or before the time, and never the last of all unless it is the only one
  float u;          // 0 … 1 on the way to the next key
  float span_s;     // to the next key; 0 outside the list
};

inline Moment find_moment(const float* times_s, std::size_t count, float time_s) {
  if (count == 1 || !(times_s[0] < time_s)) return {0, 0.0f, 0.0f};
  if (!(time_s < times_s[count - 1])) return {count - 2, 1.0f, 0.0f};
  const std::size_t key = find_interval(times_s, count - 1, time_s);
  const float span_s = times_s[key + 1] - times_s[key];
  return {key, (time_s - times_s[key]) / span_s, span_s};
}

// glTF 2.0, "Interpolation Cubic": the weights at u of two keys' values and of the tangents between them. Tangents are
// per key interval: a tangent per second must be multiplied by the interval.
struct HermiteWeights {
  float from, leave, to, arrive;
};
inline HermiteWeights hermite_weights(float u) {
  const float u2 = u * u, u3 = u2 * u;
  return {2.0f * u3 - 3.0f * u2 + 1.0f, u3 - 2.0f * u2 + u, 3.0f * u2 - 2.0f * u3, u3 - u2};
}

}  // namespace marrow
