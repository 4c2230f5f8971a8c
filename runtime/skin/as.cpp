// Animation space, four vertices at a time.
#include "core/mark.h"
#include "skin/joint_set.h"

namespace marrow {
namespace {

// A row of M_j - M_last times four coordinates.
inline f32x4 dot4(const Factors& row, f32x4 x, f32x4 y, f32x4 z, f32x4 w) {
  return (times<0>(x, row) + times<1>(y, row)) + (times<2>(z, row) + times<3>(w, row));
}

inline void add_direction(FourRows& row, f32x4 w, const Factors& m) {
  Vector<f32x4>& v = row.linear;
  v = {v.x + times<0>(w, m), v.y + times<1>(w, m), v.z + times<2>(w, m)};
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

struct AnimationSpace {
  template <class D>
  static void run(D directions, const std::uint16_t* set, std::uint32_t influences, std::uint32_t blocks,
                  const Affine* palette, Cursor& at) {
    JointSet joints;
    load_joint_set(set, influences, palette, joints);
    if constexpr (!kSmall &&
                  D() == Directions::none) {  // with directions there are too few registers to gain from this
      if (influences == 1) return blend(directions, Fixed<1u>(), joints, blocks, at);
      if (influences == 2) return blend(directions, Fixed<2u>(), joints, blocks, at);
      if (influences == 3) return blend(directions, Fixed<3u>(), joints, blocks, at);
      if (influences == 4) return blend(directions, Fixed<4u>(), joints, blocks, at);
    }
    blend(directions, influences, joints, blocks, at);
  }

  template <class D, class Count>
  [[gnu::noinline]] static void blend(D directions, Count influences, const JointSet& joints, std::uint32_t blocks,
                                      Cursor& cursor) {
    const f32x4 mirror = has_tangents(directions) ? determinant(joints.last) : splat(1.0f);
    Cursor at = cursor;
    for (; blocks > 0; --blocks) {
      Blend m = joints.last;
      Vector<f32x4> p = transform(m, load_anywhere(at.stream));
      at.stream += 12;
      for (std::uint32_t j = 0; j + 1 < influences; ++j, at.stream += 16) {
        const Factors(&other)[3] = joints.others[j];
        add_turned(other, at.stream, p);
        if (directions != Directions::none) {
          const f32x4 w = load(at.stream + 12);
          add_direction(m.a, w, other[0]);
          add_direction(m.b, w, other[1]);
          add_direction(m.c, w, other[2]);
        }
      }
      store_xyz(at.out_positions, p);
      at.out_positions += 12;
      write_directions(directions, m, mirror, at);
    }
    cursor = at;
  }
};

// Normals of the deformed surface: two tangents a vertex are animation-space vectors, as positions are.
class WithTangents {
 public:
  explicit WithTangents(const float* tangents) : tangents_(tangents) {}

  template <class D>
  void run(D directions, const std::uint16_t* set, std::uint32_t influences, std::uint32_t blocks,
           const Affine* palette, Cursor& at) {
    JointSet joints;
    load_joint_set(set, influences, palette, joints);
    tangents_ = blend(directions, joints, influences, blocks, tangents_, at);
  }

 private:
  template <class D>
  static void write(D directions, const Vector<f32x4>& t0, const Vector<f32x4>& t1, f32x4 mirror, Cursor& at) {
    const Vector<f32x4> n = cross(t0, t1);
    store_xyz(at.out_normals, n * flip(inverse_length(dot(n, n)), mirror));
    at.out_normals += 12;
    if (has_tangents(directions)) {
      const Vector<f32x4> t = normalised(t0);
      store_xyzw(at.out_tangents, t.x, t.y, t.z, flip(load_aligned(at.tangents + 12), mirror));
      at.tangents += 16;
      at.out_tangents += 16;
    }
  }

  // Returns where the next run's tangents begin.
  template <class D>
  [[gnu::noinline]] static const float* blend(D directions, const JointSet& joints, std::uint32_t influences,
                                              std::uint32_t blocks, const float* tau, Cursor& cursor) {
    const f32x4 mirror = determinant(joints.last);
    Cursor at = cursor;
    for (; blocks > 0; --blocks) {
      Vector<f32x4> p = transform(joints.last, load_anywhere(at.stream));
      Vector<f32x4> t0 = turn(joints.last, load_anywhere(tau)), t1 = turn(joints.last, load_anywhere(tau + 12));
      at.stream += 12;
      tau += 24;
      for (std::uint32_t j = 0; j + 1 < influences; ++j, at.stream += 16, tau += 32) {
        add_turned(joints.others[j], at.stream, p);
        add_turned(joints.others[j], tau, t0);
        add_turned(joints.others[j], tau + 16, t1);
      }
      store_xyz(at.out_positions, p);
      at.out_positions += 12;
      write(directions, t0, t1, mirror, at);
    }
    cursor = at;
    return tau;
  }

  const float* tangents_;
};

}  // namespace

Status skin_as(const Mesh& mesh, Span<const float> coordinates, Span<const Affine> palette, const SkinOutput& out,
               Span<const float> tangents) {
  MARROW_MARK;
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
