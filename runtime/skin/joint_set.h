// The matrices of a run's joints, as the kernels of SSD and animation space want them.
#pragma once

#include "skin/deform.h"

namespace marrow {

// All matrices but the last are kept as differences from the last, so that a block needs one weight fewer:
// Σ w_j M_j = M_last + Σ_{j<last} w_j (M_j - M_last). Loaded once a run; stays in memory, as there are not enough
// registers for it. Row: f32x4, which loads fast, or Factors, which multiply faster.
template <class Row>
struct JointSet {
  Blend last;                         // the same in all lanes
  Row others[kMaxInfluences - 1][3];  // rows

  JointSet(const std::uint16_t* set, std::uint32_t influences, const Affine* palette) {
    const Affine& m = palette[set[influences - 1]];
    const f32x4 a = load_aligned(m.rows[0]), b = load_aligned(m.rows[1]), c = load_aligned(m.rows[2]);
    last = four_affines(splat_row(a), splat_row(b), splat_row(c));
    for (std::uint32_t j = 0; j + 1 < influences; ++j) {
      const Affine& other = palette[set[j]];
      keep(load_aligned(other.rows[0]) - a, others[j][0]);
      keep(load_aligned(other.rows[1]) - b, others[j][1]);
      keep(load_aligned(other.rows[2]) - c, others[j][2]);
    }
  }

  // To be called before each block. Without it GCC spreads the lanes of many rows over registers ahead of the blocks
  // and spills those, or copies spread rows from memory to memory. Rows `skin/as/ps/*` take 3 to 5 % less with it.
  template <class D, class Count>
  [[gnu::always_inline]] void stay([[maybe_unused]] D directions, [[maybe_unused]] Count influences) {
    if constexpr (kMultipliesByLane && !std::is_same_v<Count, std::uint32_t>) {
      if (directions == Directions::none || influences == 2) {  // then there are registers for all rows
        for (std::uint32_t j = 0; j + 1 < influences; ++j)
          for (Row& row : others[j]) stay_whole(row);
        return;
      }
    }
#if defined(__GNUC__)
    if (std::is_same_v<Count, std::uint32_t> || (!kMemoryOperands && influences > 2)) asm("" : : "r"(this) : "memory");
#endif
  }

 private:
  static void keep(f32x4 row, f32x4& to) {
    to = row;
  }
  static void keep(f32x4 row, Factors& to) {
    to = factors(row);
  }
};

template <int Lane>
inline f32x4 times(f32x4 v, f32x4 row) {
  return times<Lane>(v, factors(row));
}

inline void add_scaled(Vector<f32x4>& v, f32x4& origin, f32x4 w, const Factors& row) {
  v = {v.x + times<0>(w, row), v.y + times<1>(w, row), v.z + times<2>(w, row)};
  origin = origin + times<3>(w, row);
}

// Adds the other joints, weighted, to four vertices' matrices m, which start as the last joint's. Consecutive joints'
// weights are `stride` floats apart.
[[gnu::always_inline]] inline void add_others(std::uint32_t influences, const JointSet<Factors>& joints,
                                              const float* weights, std::size_t stride, Blend& m) {
  for (std::uint32_t j = 0; j + 1 < influences; ++j, weights += stride) {
    const f32x4 w = load(weights);
    add_scaled(m.rows.x, m.origin.x, w, joints.others[j][0]);
    add_scaled(m.rows.y, m.origin.y, w, joints.others[j][1]);
    add_scaled(m.rows.z, m.origin.z, w, joints.others[j][2]);
  }
}

}  // namespace marrow
