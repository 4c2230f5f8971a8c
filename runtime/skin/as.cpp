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

// Normals of the deformed surface: two tangents a vertex are animation-space vectors, as positions are.
class WithTangents {
 public:
  explicit WithTangents(const float* tangents) : tangents_(tangents) {}

  template <Directions D>
  void run(const std::uint16_t* set, std::uint32_t influences, std::uint32_t blocks, const Affine* palette,
           Cursor& at) {
    JointSet joints;
    load_joint_set(set, influences, palette, joints);
    tangents_ = blend<has_tangents(D)>(joints, influences, blocks, tangents_, at);
  }

 private:
  struct Vectors {
    f32x4 x, y, z;
  };

  static Vectors first(const Blend& m, const float* v) {
    const f32x4 x = load(v), y = load(v + 4), z = load(v + 8);
    return {dot3(m.a.x, m.a.y, m.a.z, x, y, z), dot3(m.b.x, m.b.y, m.b.z, x, y, z), dot3(m.c.x, m.c.y, m.c.z, x, y, z)};
  }

  static void add(const Factors (&m)[3], const float* v, Vectors& to) {
    const f32x4 x = load(v), y = load(v + 4), z = load(v + 8), w = load(v + 12);
    to = {to.x + dot4(m[0], x, y, z, w), to.y + dot4(m[1], x, y, z, w), to.z + dot4(m[2], x, y, z, w)};
  }

  template <bool Tangents>
  static void write(const Vectors& t0, const Vectors& t1, f32x4 mirror, Cursor& at) {
    const f32x4 x = t0.y * t1.z - t0.z * t1.y, y = t0.z * t1.x - t0.x * t1.z, z = t0.x * t1.y - t0.y * t1.x;
    const f32x4 scale = flip(inverse_length(dot3(x, y, z, x, y, z)), mirror);
    store_xyz(at.out_normals, x * scale, y * scale, z * scale);
    at.out_normals += 12;
    if constexpr (Tangents) {
      const f32x4 shorten = inverse_length(dot3(t0.x, t0.y, t0.z, t0.x, t0.y, t0.z));
      store_xyzw(at.out_tangents, t0.x * shorten, t0.y * shorten, t0.z * shorten,
                 flip(load_aligned(at.tangents + 12), mirror));
      at.tangents += 16;
      at.out_tangents += 16;
    }
  }

  // Returns where the next run's tangents begin.
  template <bool Tangents>
  [[gnu::noinline]] static const float* blend(const JointSet& joints, std::uint32_t influences, std::uint32_t blocks,
                                              const float* tau, Cursor& cursor) {
    const f32x4 mirror = determinant(joints.last);
    Cursor at = cursor;
    for (; blocks > 0; --blocks) {
      Vectors p = first(joints.last, at.stream), t0 = first(joints.last, tau), t1 = first(joints.last, tau + 12);
      p = {p.x + joints.last.a.t, p.y + joints.last.b.t, p.z + joints.last.c.t};
      at.stream += 12;
      tau += 24;
      for (std::uint32_t j = 0; j + 1 < influences; ++j, at.stream += 16, tau += 32) {
        add(joints.others[j], at.stream, p);
        add(joints.others[j], tau, t0);
        add(joints.others[j], tau + 16, t1);
      }
      store_xyz(at.out_positions, p.x, p.y, p.z);
      at.out_positions += 12;
      write<Tangents>(t0, t1, mirror, at);
    }
    cursor = at;
    return tau;
  }

  const float* tangents_;
};

}  // namespace

Status skin_as(const Mesh& mesh, Span<const float> coordinates, Span<const Affine> palette, const SkinOutput& out,
               Span<const float> tangents) {
  MARROW_REQUIRE(coordinates.size >= as_coordinate_count(mesh.geometry));
  MARROW_REQUIRE(tangents.empty() || tangents.size >= as_tangent_count(mesh.geometry));
  if (tangents.empty() || out.normals.empty()) return deform<AnimationSpace>(mesh, coordinates.data, palette, out);
  return deform(mesh, coordinates.data, palette, out, WithTangents(tangents.data));
}

}  // namespace marrow
