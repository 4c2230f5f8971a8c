// Animation space, four vertices at a time.
#include "core/zone.h"
#include "skin/joint_set.h"

namespace marrow {
namespace {

// A row of M_j - M_last times four coordinates.
template <class Row>
inline f32x4 dot4(const Row& row, f32x4 x, f32x4 y, f32x4 z, f32x4 w) {
  return (times<0>(x, row) + times<1>(y, row)) + (times<2>(z, row) + times<3>(w, row));
}

// Not aligned: coordinates may lie anywhere.
inline Vector<f32x4> load_anywhere(const float* v) {
  return {load(v), load(v + 4), load(v + 8)};
}
// to += (M_j - M_last) q
inline void add_turned(const Factors (&m)[3], const float* q, Vector<f32x4>& to) {
  const f32x4 x = load(q), y = load(q + 4), z = load(q + 8), w = load(q + 12);
  to = {to.x + dot4(m[0], x, y, z, w), to.y + dot4(m[1], x, y, z, w), to.z + dot4(m[2], x, y, z, w)};
}

// A vector through the last joint's matrix.
[[gnu::always_inline]] inline Vector<f32x4> turned(const Blend& last, const float* q) {
  return turn(last, load_anywhere(q));
}
// Adds the other influences' vectors through their matrices. The vectors are `stride` floats apart.
[[gnu::always_inline]] inline void add_others(std::uint32_t influences, const JointSet<Factors>& joints, const float* q,
                                              std::size_t stride, Vector<f32x4>& to) {
  for (std::uint32_t j = 0; j + 1 < influences; ++j, q += stride) add_turned(joints.others[j], q, to);
}

class AnimationSpace {
 public:
  static constexpr bool kFixedDirections = true, kFixedInfluences = true;

  template <class D, class Count>
  [[gnu::always_inline]] static void run(D directions, Count influences, const std::uint16_t* set, std::uint32_t blocks,
                                         const Affine* palette, Cursor& at) {
    JointSet<Row<D, Count>> joints(set, influences, palette);
    const f32x4 mirror = directions == Directions::blended_tangents ? determinant(joints.last) : splat(1.0f);
    for (; blocks > 0; --blocks) {
      joints.stay(directions, influences);
      Blend m = joints.last;
      const float* const q = at.stream;
      Vector<f32x4> p;
      if constexpr (std::is_same_v<Count, std::uint32_t>) {
        p = turned(m, q) + m.origin;
        add_others(influences, joints, q + 12, 16, p);
        if (directions != Directions::none) add_others(influences, joints, q + 24, 16, m);
      } else {
        p = {add(directions, influences, joints, 0, q, m.rows.x, m.origin.x),
             add(directions, influences, joints, 1, q, m.rows.y, m.origin.y),
             add(directions, influences, joints, 2, q, m.rows.z, m.origin.z)};
      }
      store_xyz(at.out_positions, p);
      at.stream += 16 * influences - 4;
      at.out_positions += 12;
      write_directions(directions, m, mirror, at);
    }
  }

 private:
  template <class D, class Count>
  using Row = std::conditional_t<std::is_same_v<D, Fixed<Directions::none>>, f32x4, Factors>;

  // v, origin: the last joint's row; v becomes the blended row, if directions are wanted. Returns one coordinate of the
  // positions.
  template <class D, class Count, class Joints>
  [[gnu::always_inline]] static f32x4 add(D directions, Count influences, const Joints& joints, int row, const float* q,
                                          Vector<f32x4>& v, f32x4 origin) {
    f32x4 p = dot(v, load_anywhere(q)) + origin;
    q += 12;
    for (std::uint32_t j = 0; j + 1 < influences; ++j, q += 16) {
      const auto& other = joints.others[j][row];
      const f32x4 w = load(q + 12);
      p = p + dot4(other, load(q), load(q + 4), load(q + 8), w);
      if (directions != Directions::none)
        v = {v.x + times<0>(w, other), v.y + times<1>(w, other), v.z + times<2>(w, other)};
    }
    return p;
  }
};

// Normals of the deformed surface: two tangents a vertex are animation-space vectors, as positions are.
class WithTangents {
 public:
  explicit WithTangents(const float* tangents) : tangents_(tangents) {}

  static constexpr bool kFixedDirections = false, kFixedInfluences = false;

  [[gnu::always_inline]] void run(Directions directions, std::uint32_t influences, const std::uint16_t* set,
                                  std::uint32_t blocks, const Affine* palette, Cursor& at) {
    JointSet<Factors> joints(set, influences, palette);
    const f32x4 mirror = determinant(joints.last);
    const float* tau = tangents_;
    for (; blocks > 0; --blocks) {
      joints.stay(directions, influences);
      Vector<f32x4> p = turned(joints.last, at.stream) + joints.last.origin;
      add_others(influences, joints, at.stream + 12, 16, p);
      store_xyz(at.out_positions, p);
      Vector<f32x4> t0 = turned(joints.last, tau), t1 = turned(joints.last, tau + 12);
      add_others(influences, joints, tau + 24, 32, t0);
      add_others(influences, joints, tau + 40, 32, t1);
      at.stream += 16 * influences - 4;
      tau += 32 * influences - 8;
      at.out_positions += 12;
      write(t0, t1, mirror, at);
    }
    tangents_ = tau;
  }

 private:
  static void write(const Vector<f32x4>& t0, const Vector<f32x4>& t1, f32x4 mirror, Cursor& at) {
    store_normals(at.out_normals, cross(t0, t1), mirror);
    at.out_normals += 12;
    if (at.out_tangents != nullptr) {
      store_tangents(at.out_tangents, normalised(t0), at.tangents, mirror);
      at.tangents += 16;
      at.out_tangents += 16;
    }
  }

  const float* tangents_;
};

}  // namespace

Status skin_as(const Mesh& mesh, Span<const float> coordinates, Span<const Affine> palette, const SkinOutput& out,
               Span<const float> tangents) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(coordinates, as_coordinate_count(mesh.geometry)));
  MARROW_REQUIRE(tangents.empty() || holds(tangents, as_tangent_count(mesh.geometry)));
  if (tangents.empty() || out.normals.empty()) {
    MARROW_REQUIRE_GOOD(deform<AnimationSpace>(mesh, coordinates.data, palette, out));
  } else {
    MARROW_REQUIRE_GOOD(deform(mesh, coordinates.data, palette, out, WithTangents(tangents.data)));
  }
  return Status::ok;
}

}  // namespace marrow
