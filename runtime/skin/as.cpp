// Animation space, four vertices at a time.
#include "skin/joint_set.h"

namespace marrow {
namespace {

// A row of M_j - M_last times four coordinates.
inline f32x4 dot4(const Factors& row, f32x4 x, f32x4 y, f32x4 z, f32x4 w) {
  return (times<0>(x, row) + times<1>(y, row)) + (times<2>(z, row) + times<3>(w, row));
}

inline void add_direction(BlockRow& row, f32x4 w, const Factors& m) {
  row.x = row.x + times<0>(w, m);
  row.y = row.y + times<1>(w, m);
  row.z = row.z + times<2>(w, m);
}

struct AnimationSpace {
  template <Directions D>
  static void run(const std::uint16_t* set, std::uint32_t influences, std::uint32_t blocks, const Affine* palette,
                  Cursor& at) {
    JointSet joints;
    load_joint_set(set, influences, palette, joints);
    if constexpr (kUnrolled &&
                  D == Directions::none) {  // with directions there are too few registers to gain from this
      if (influences == 1) return blend<D, 1>(joints, influences, blocks, at);
      if (influences == 2) return blend<D, 2>(joints, influences, blocks, at);
      if (influences == 3) return blend<D, 3>(joints, influences, blocks, at);
      if (influences == 4) return blend<D, 4>(joints, influences, blocks, at);
    }
    blend<D, 0>(joints, influences, blocks, at);
  }

  // Influences: how many, or 0 for as many as the argument says.
  template <Directions D, std::uint32_t Influences>
  [[gnu::noinline]] static void blend(const JointSet& joints, std::uint32_t influences, std::uint32_t blocks,
                                      Cursor& cursor) {
    const std::uint32_t k = Influences > 0 ? Influences : influences;
    const f32x4 mirror = has_tangents(D) ? determinant(joints.last) : splat(1.0f);
    Cursor at = cursor;
    for (; blocks > 0; --blocks) {
      Blend m = joints.last;
      const f32x4 sx = load(at.stream), sy = load(at.stream + 4), sz = load(at.stream + 8);
      f32x4 px = dot3(m.a.x, m.a.y, m.a.z, sx, sy, sz) + m.a.t;
      f32x4 py = dot3(m.b.x, m.b.y, m.b.z, sx, sy, sz) + m.b.t;
      f32x4 pz = dot3(m.c.x, m.c.y, m.c.z, sx, sy, sz) + m.c.t;
      at.stream += 12;
      for (std::uint32_t j = 0; j + 1 < k; ++j, at.stream += 16) {
        const f32x4 x = load(at.stream), y = load(at.stream + 4), z = load(at.stream + 8), w = load(at.stream + 12);
        const Factors(&other)[3] = joints.others[j];
        px = px + dot4(other[0], x, y, z, w);
        py = py + dot4(other[1], x, y, z, w);
        pz = pz + dot4(other[2], x, y, z, w);
        if constexpr (D != Directions::none) {
          add_direction(m.a, w, other[0]);
          add_direction(m.b, w, other[1]);
          add_direction(m.c, w, other[2]);
        }
      }
      store_xyz(at.out_positions, px, py, pz);
      at.out_positions += 12;
      write_directions<D>(m, mirror, at);
    }
    cursor = at;
  }
};

}  // namespace

Status skin_as(const Mesh& mesh, Span<const float> coordinates, Span<const Affine> palette, const SkinOutput& out) {
  MARROW_REQUIRE(coordinates.size >= as_coordinate_count(mesh.geometry));
  return deform<AnimationSpace>(mesh, coordinates.data, palette, out);
}

}  // namespace marrow
