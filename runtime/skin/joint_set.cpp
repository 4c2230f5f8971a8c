#include "skin/joint_set.h"

namespace marrow {

void load_joint_set(const std::uint16_t* set, std::uint32_t influences, const Affine* palette, JointSet& out) {
  const Affine& last = palette[set[influences - 1]];
  const f32x4 a = load_aligned(last.rows[0]), b = load_aligned(last.rows[1]), c = load_aligned(last.rows[2]);
  out.last = {splat_row(a), splat_row(b), splat_row(c)};
  for (std::uint32_t j = 0; j + 1 < influences; ++j) {
    const Affine& m = palette[set[j]];
    out.others[j][0] = factors(load_aligned(m.rows[0]) - a);
    out.others[j][1] = factors(load_aligned(m.rows[1]) - b);
    out.others[j][2] = factors(load_aligned(m.rows[2]) - c);
  }
}

}  // namespace marrow
