// Multi-weight enveloping, four vertices at a time.
#include "skin/joint_set.h"
#include "skin/rotation.h"

namespace marrow {
namespace {

// A row of the blend and one influence more, element by element.
inline BlockRow add_weighted(const BlockRow& row, f32x4 w, const float* residual, const Factors& m) {
  return {row.x + times<0>(w + load_aligned(residual), m), row.y + times<1>(w + load_aligned(residual + 4), m),
          row.z + times<2>(w + load_aligned(residual + 8), m), row.t + times<3>(w + load_aligned(residual + 12), m)};
}

// A row of the root's frame times a column of the blend.
inline f32x4 turned(const f32x4 (&row)[3], f32x4 a, f32x4 b, f32x4 c) {
  return dot3(row[0], row[1], row[2], a, b, c);
}

class MultiWeight {
 public:
  MultiWeight(const float* residual, const Affine& root)
      : residual_(residual), rotation_(rotations_of({&root, &root, &root, &root})) {
    for (int row = 0; row < 3; ++row) origin_[row] = load_aligned(root.rows[row]);
  }

  template <Directions D>
  void run(const std::uint16_t* set, std::uint32_t influences, std::uint32_t blocks, const Affine* palette,
           Cursor& at) {
    Factors inside[kMaxInfluences][3];
    for (std::uint32_t j = 0; j < influences; ++j) load_inside(palette[set[j]], inside[j]);
    for (; blocks > 0; --blocks) {
      const float* const weights = at.stream + 12;
      const f32x4 zero = splat(0.0f);
      const BlockRow nothing = {zero, zero, zero, zero};
      Blend m = {nothing, nothing, nothing};
      f32x4 rest = splat(1.0f);
      for (std::uint32_t j = 0; j < influences; ++j, residual_ += 48) {
        f32x4 w = rest;
        if (j + 1 < influences) {
          w = load_aligned(weights + 4 * j);
          rest = rest - w;
        }
        m = {add_weighted(m.a, w, residual_, inside[j][0]), add_weighted(m.b, w, residual_ + 16, inside[j][1]),
             add_weighted(m.c, w, residual_ + 32, inside[j][2])};
      }
      write_positions(m, at);
      at.stream += 4 * (influences + 2);
      if constexpr (D != Directions::none) {
        const Blend out = {turned_row(m, 0), turned_row(m, 1), turned_row(m, 2)};
        write_directions<D>(out, D == Directions::blended_tangents ? determinant(out) : zero, at);
      }
    }
  }

 private:
  // A joint's matrix as the root sees it.
  void load_inside(const Affine& m, Factors (&out)[3]) const {
    f32x4 rows[3];
    for (int i = 0; i < 3; ++i) rows[i] = load_aligned(m.rows[i]) - only_w(origin_[i]);
    const f32x4(&r)[3][3] = rotation_.m;
    for (int i = 0; i < 3; ++i) out[i] = factors(turned({r[0][i], r[1][i], r[2][i]}, rows[0], rows[1], rows[2]));
  }

  void write_positions(const Blend& m, Cursor& at) const {
    const f32x4 x = dot3(m.a, at.stream) + m.a.t, y = dot3(m.b, at.stream) + m.b.t, z = dot3(m.c, at.stream) + m.c.t;
    const f32x4(&r)[3][3] = rotation_.m;
    store_xyz(at.out_positions, turned(r[0], x, y, z) + splat_lane<3>(origin_[0]),
              turned(r[1], x, y, z) + splat_lane<3>(origin_[1]), turned(r[2], x, y, z) + splat_lane<3>(origin_[2]));
    at.out_positions += 12;
  }

  // The 3×3 part of the blend, in the palette's space.
  BlockRow turned_row(const Blend& m, int row) const {
    const f32x4(&r)[3] = rotation_.m[row];
    return {turned(r, m.a.x, m.b.x, m.c.x), turned(r, m.a.y, m.b.y, m.c.y), turned(r, m.a.z, m.b.z, m.c.z),
            splat(0.0f)};
  }

  const float* residual_;
  FourRotations rotation_;  // the same in all lanes
  f32x4 origin_[3];         // rows of the root's matrix
};

}  // namespace

Status skin_mwe(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out) {
  const Geometry& g = mesh.geometry;
  MARROW_REQUIRE(g.mwe_residual != nullptr && aligned(g.mwe_residual));
  MARROW_REQUIRE(palette.size >= mesh.palette_size() && g.mwe_root < mesh.palette_size());
  return deform(mesh, g.skin, palette, out, MultiWeight(g.mwe_residual, palette[g.mwe_root]));
}

}  // namespace marrow
