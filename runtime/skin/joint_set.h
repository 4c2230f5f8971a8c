// The matrices of a run's joints, as the kernels of SSD and animation space want them.
#pragma once

#include "skin/deform.h"

namespace marrow {

// All matrices but the last are kept as differences from the last, so that a block needs one weight fewer:
// Σ w_j M_j = M_last + Σ_{j<last} w_j (M_j - M_last). Loaded once a run; stays in memory, where multiplications can
// take it from: there are not enough registers for it.
struct JointSet {
  Blend last;                             // the same in all lanes
  Factors others[kMaxInfluences - 1][3];  // rows
};

void load_joint_set(const std::uint16_t* set, std::uint32_t influences, const Affine* palette, JointSet& out);

inline FourRows add_scaled(const FourRows& row, f32x4 w, const Factors& m) {
  const Vector<f32x4>& v = row.linear;
  return {{v.x + times<0>(w, m), v.y + times<1>(w, m), v.z + times<2>(w, m)}, row.origin + times<3>(w, m)};
}

inline Blend add_scaled(const Blend& blend, f32x4 w, const Factors (&m)[3]) {
  return {add_scaled(blend.a, w, m[0]), add_scaled(blend.b, w, m[1]), add_scaled(blend.c, w, m[2])};
}

}  // namespace marrow
