// Rigid motions as matrices in double precision, written from the definitions: what root motion is compared with.
#pragma once

#include <cmath>

#include "marrow/root_motion.h"

namespace marrow::test {

using Real = double;

inline Real wide(float x) {
  return static_cast<Real>(x);
}

struct Frame {
  Real turn[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Real place[3] = {0, 0, 0};
};

inline Frame operator*(const Frame& a, const Frame& b) {
  Frame out;
  for (int i = 0; i < 3; ++i) {
    out.place[i] = a.place[i];
    for (int k = 0; k < 3; ++k) out.place[i] += a.turn[i][k] * b.place[k];
    for (int j = 0; j < 3; ++j) {
      out.turn[i][j] = 0;
      for (int k = 0; k < 3; ++k) out.turn[i][j] += a.turn[i][k] * b.turn[k][j];
    }
  }
  return out;
}

inline Frame back(const Frame& a) {
  Frame out;
  for (int i = 0; i < 3; ++i) {
    out.place[i] = 0;
    for (int k = 0; k < 3; ++k) {
      out.turn[i][k] = a.turn[k][i];
      out.place[i] -= a.turn[k][i] * a.place[k];
    }
  }
  return out;
}

// Of a quaternion of any length.
inline Frame frame_of(Real x, Real y, Real z, Real w, Real px, Real py, Real pz) {
  const Real n = std::sqrt(x * x + y * y + z * z + w * w);
  x /= n, y /= n, z /= n, w /= n;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}},
          {px, py, pz}};
}
inline Frame frame_of(const RigidStep& s) {
  const float *q = s.rotation, *t = s.translation;
  return frame_of(wide(q[0]), wide(q[1]), wide(q[2]), wide(q[3]), wide(t[0]), wide(t[1]), wide(t[2]));
}

// The motion of a screw: by Rodrigues' formula, and the way by the integral of the turn, term by term.
inline Frame screw_frame(const Real (&turn)[3], const Real (&way)[3]) {
  const Real cross[3][3] = {{0, -turn[2], turn[1]}, {turn[2], 0, -turn[0]}, {-turn[1], turn[0], 0}};
  Frame out;
  Real power[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, factorial = 1;  // cross^n and n!
  for (int i = 0; i < 3; ++i) out.place[i] = way[i];
  for (int n = 1; n < 60; ++n) {
    Real next[3][3] = {};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) next[i][j] += power[i][k] * cross[k][j];
    factorial *= n;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        power[i][j] = next[i][j];
        out.turn[i][j] += power[i][j] / factorial;
        out.place[i] += power[i][j] / (factorial * (n + 1)) * way[j];
      }
  }
  return out;
}

inline Real distance(const Frame& a, const Frame& b) {
  Real sum = 0;
  for (int i = 0; i < 3; ++i) sum += (a.place[i] - b.place[i]) * (a.place[i] - b.place[i]);
  return std::sqrt(sum);
}
// The greatest difference of the axes' numbers.
inline Real turned_apart(const Frame& a, const Frame& b) {
  Real most = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) most = std::fmax(most, std::fabs(a.turn[i][j] - b.turn[i][j]));
  return most;
}

}  // namespace marrow::test
