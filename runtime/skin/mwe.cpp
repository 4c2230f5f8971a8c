// Multi-weight enveloping, four vertices at a time.
#include "core/zone.h"
#include "math/rotation.h"
#include "skin/joint_set.h"

namespace marrow {
namespace {

// A row of the blend plus one more influence, whose weight is per element.
inline FourRows add_weighted(const Vector<f32x4>& v, f32x4 origin, f32x4 w, const float* residual, const Factors& m) {
  return {{v.x + times<0>(w + load_aligned(residual), m), v.y + times<1>(w + load_aligned(residual + 4), m),
           v.z + times<2>(w + load_aligned(residual + 8), m)},
          origin + times<3>(w + load_aligned(residual + 12), m)};
}

class MultiWeight {
 public:
  MultiWeight(const float* residual, const Affine& root)
      : residual_(residual), rotation_(rotations_of(root, root, root, root)) {
    for (int row = 0; row < 3; ++row) origin_[row] = load_aligned(root.rows[row]);
  }

  static constexpr bool kFixedDirections = false, kFixedInfluences = false;

  [[gnu::always_inline]] void run(Directions directions, std::uint32_t influences, const std::uint16_t* set,
                                  std::uint32_t blocks, const Affine* palette, Cursor& at) {
    Factors inside[kMaxInfluences][3];
    for (std::uint32_t j = 0; j < influences; ++j) load_inside(palette[set[j]], inside[j]);
    for (; blocks > 0; --blocks) {
      const float* const weights = at.stream + 12;
      const f32x4 zero = splat(0.0f);
      const Vector<f32x4> nothing = {zero, zero, zero};
      Blend m = {{nothing, nothing, nothing}, nothing};
      f32x4 rest = splat(1.0f);
      for (std::uint32_t j = 0; j < influences; ++j, residual_ += 48) {
        f32x4 w = rest;
        if (j + 1 < influences) {
          w = load_aligned(weights + 4 * j);
          rest = rest - w;
        }
        m = four_affines(add_weighted(m.rows.x, m.origin.x, w, residual_, inside[j][0]),
                         add_weighted(m.rows.y, m.origin.y, w, residual_ + 16, inside[j][1]),
                         add_weighted(m.rows.z, m.origin.z, w, residual_ + 32, inside[j][2]));
      }
      write_positions(m, at);
      at.stream += 4 * (influences + 2);
      if (directions != Directions::none) {
        const Blend out = in_palette(m);
        write_directions(directions, out, directions == Directions::blended_tangents ? determinant(out) : zero, at);
      }
    }
  }

 private:
  // A joint's matrix as the root sees it.
  void load_inside(const Affine& m, Factors (&out)[3]) const {
    const auto row = [&](int i) { return load_aligned(m.rows[i]) - only_w(origin_[i]); };
    const Vector<f32x4> seen = transposed_times(rotation_, Vector<f32x4>{row(0), row(1), row(2)});
    out[0] = factors(seen.x);
    out[1] = factors(seen.y);
    out[2] = factors(seen.z);
  }

  void write_positions(const Blend& m, Cursor& at) const {
    const Vector<f32x4> origin = {splat_lane<3>(origin_[0]), splat_lane<3>(origin_[1]), splat_lane<3>(origin_[2])};
    store_xyz(at.out_positions, rotation_ * transform(m, load_block(at.stream)) + origin);
    at.out_positions += 12;
  }

  // The 3×3 part of the blend, in the palette's space.
  Blend in_palette(const Blend& m) const {
    const Linear<f32x4>& rows = m.rows;
    const Vector<f32x4> x = rotation_ * Vector<f32x4>{rows.x.x, rows.y.x, rows.z.x},
                        y = rotation_ * Vector<f32x4>{rows.x.y, rows.y.y, rows.z.y},
                        z = rotation_ * Vector<f32x4>{rows.x.z, rows.y.z, rows.z.z};
    const f32x4 zero = splat(0.0f);
    return {{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}, {zero, zero, zero}};
  }

  const float* residual_;
  Linear<f32x4> rotation_;  // the same in all lanes
  f32x4 origin_[3];         // rows of the root's matrix
};

}  // namespace

Status skin_mwe(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out) {
  MARROW_ZONE;
  const Geometry& g = mesh.geometry;
  MARROW_REQUIRE(g.mwe_residual != nullptr && aligned(g.mwe_residual));
  MARROW_REQUIRE(holds(palette, mesh.palette_size()) && g.mwe_root < mesh.palette_size());
  MARROW_REQUIRE_GOOD(deform(mesh, g.skin, palette, out, MultiWeight(g.mwe_residual, palette[g.mwe_root])));
  return Status::ok;
}

}  // namespace marrow
