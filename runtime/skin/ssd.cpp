// Skeletal subspace deformation, four vertices at a time.
#include "core/zone.h"
#include "skin/joint_set.h"

namespace marrow {
namespace {

struct Ssd {
  static constexpr bool kFixedDirections = true, kFixedInfluences = true;

  template <class D, class Count>
  [[gnu::always_inline]] static void run(D directions, Count influences, const std::uint16_t* set, std::uint32_t blocks,
                                         const Affine* palette, Cursor& at) {
    JointSet<Row<Count>> joints(set, influences, palette);
    const f32x4 mirror = directions == Directions::blended_tangents ? determinant(joints.last) : splat(1.0f);
    for (; blocks > 0; --blocks) {
      joints.stay(directions, influences);
      // A block: the positions x[4] y[4] z[4], then four weights for each influence but the last.
      const float* const weights = at.stream + 12;
      const Vector<f32x4> v = load_block(at.stream);
      Blend m = joints.last;
      if constexpr (std::is_same_v<Count, std::uint32_t>) {
        add_others(influences, joints, weights, 4, m);
      } else {
        blend_row(influences, joints, 0, weights, m.rows.x, m.origin.x);
        blend_row(influences, joints, 1, weights, m.rows.y, m.origin.y);
        blend_row(influences, joints, 2, weights, m.rows.z, m.origin.z);
      }
      store_xyz(at.out_positions, transform(m, v));
      at.stream += 4 * (influences + 2);
      at.out_positions += 12;
      write_directions(directions, m, mirror, at);
    }
  }

 private:
  template <class Count>
  using Row = std::conditional_t<std::is_same_v<Count, std::uint32_t>, Factors, f32x4>;

  template <class Count>
  [[gnu::always_inline]] static void blend_row(Count influences, const JointSet<f32x4>& joints, int row,
                                               const float* weights, Vector<f32x4>& v, f32x4& origin) {
    for (std::uint32_t j = 0; j + 1 < influences; ++j) {
      const f32x4 w = load_aligned(weights + 4 * j), other = joints.others[j][row];
      v.x = v.x + times<0>(w, other);
      v.y = v.y + times<1>(w, other);
      v.z = v.z + times<2>(w, other);
      origin = origin + times<3>(w, other);
    }
  }
};

}  // namespace

Status skin_ssd(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(deform<Ssd>(mesh, mesh.geometry.skin, palette, out));
  return Status::ok;
}

}  // namespace marrow
