// What the CPU deformers share: the walk over a mesh's runs, and what becomes of a block's normals and tangents. A
// deformer (rigid.cpp, ssd.cpp, as.cpp, mwe.cpp, psd.cpp) says how four vertices' positions and blended matrices come
// about.
#pragma once

#include "core/check.h"
#include "core/fixed.h"
#include "marrow/skin.h"
#include "math/affine.h"

namespace marrow {

// Four vertices' blended matrices, one lane a vertex.
using Blend = FourAffines;

// Four vertices' positions, normals or tangents: x[4] y[4] z[4], 16-byte aligned.
inline Vector<f32x4> load_block(const float* v) {
  return {load_aligned(v), load_aligned(v + 4), load_aligned(v + 8)};
}
inline void store_xyz(float* to, const Vector<f32x4>& v) {
  store_xyz(to, v.x, v.y, v.z);
}

// What is written beside positions. exact: normals, and tangents if they are asked for.
enum class Directions { none, blended_normals, blended_tangents, exact };

// Where a kernel reads and writes. The kernel advances these past the run.
struct Cursor {
  const float* stream;  // positions and weights, or animation-space coordinates
  const float* normals;
  const float* tangents;
  float* out_positions;
  float* out_normals;
  float* out_tangents;  // null: there are none
};

// Stores normals at unit length, negated where `mirror` is negative.
inline void store_normals(float* out, const Vector<f32x4>& n, f32x4 mirror) {
  store_xyz(out, n * flip(inverse_length(dot(n, n)), mirror));
}
// Stores tangents with the handedness of the block `tangents`, flipped where `mirror` is negative.
inline void store_tangents(float* out, const Vector<f32x4>& t, const float* tangents, f32x4 mirror) {
  store_xyzw(out, t.x, t.y, t.z, flip(load_aligned(tangents + 12), mirror));
}

// Inverse transpose up to a positive factor: the cofactors, negated where the blend mirrors. Returns the determinant.
inline f32x4 write_exact_normals(const Blend& m, const float* normals, float* out) {
  const Linear<f32x4> cofactor = cofactors(m.rows);
  const f32x4 det = dot(m.rows.x, cofactor.x);
  store_normals(out, transposed_times(cofactor, load_block(normals)), det);
  return det;
}

// mirror: negative where the handedness turns; of blended tangents only.
template <class D>
inline void write_directions(D directions, const Blend& m, f32x4 mirror, Cursor& at) {
  if (directions == Directions::none) return;
  f32x4 det = mirror;
  if (directions == Directions::exact) {
    det = write_exact_normals(m, at.normals, at.out_normals);
  } else {
    store_xyz(at.out_normals, turn(m, load_block(at.normals)));
  }
  at.normals += 12;
  at.out_normals += 12;
  if (directions == Directions::blended_tangents || (directions == Directions::exact && at.out_tangents != nullptr)) {
    const Vector<f32x4> t = turn(m, load_block(at.tangents));
    store_tangents(at.out_tangents, directions == Directions::exact ? normalised(t) : t, at.tangents, det);
    at.tangents += 16;
    at.out_tangents += 16;
  }
}

// Deforms consecutive runs with the same number of influences; returns the run behind them.
template <class D, class Count, class Deformer>
[[gnu::noinline]] const Run* deform_alike(D directions, Count influences, Deformer& deformer, const Run* run,
                                          const Run* end, const std::uint16_t*& set, const Affine* palette,
                                          Cursor& cursor) {
  Cursor at = cursor;
  const std::uint16_t* joints = set;
  do {
    deformer.run(directions, influences, joints, (run->vertex_count + 3) / 4, palette, at);
    joints += influences;
  } while (++run < end && run->influences == influences);
  cursor = at;
  set = joints;
  return run;
}

// deformer.run(directions, influences, set, blocks, palette, cursor) deforms one run; runs come in order. With
// kFixedDirections a deformer has one kernel for each Fixed<…> of directions; with kFixedInfluences, one for each
// Fixed<…> of up to four influences. More influences are seldom: one kernel does for all directions there. Otherwise it
// gets plain values.
template <class D, class Deformer>
void deform_runs(D directions, Deformer deformer, const Geometry& g, const float* stream, const Affine* palette,
                 const SkinOutput& out) {
  float* const out_tangents = out.tangents.empty() ? nullptr : out.tangents.data;
  Cursor at{stream, g.normals, g.tangents, out.positions.data, out.normals.data, out_tangents};
  const std::uint16_t* set = g.sets;
  const Run *run = g.runs.begin(), *const end = g.runs.end();
  const auto alike = [&](auto influences) {
    run = deform_alike(directions, influences, deformer, run, end, set, palette, at);
  };
  while (run < end) {
    if constexpr (!Deformer::kFixedInfluences) {
      alike(run->influences);
    } else {
      switch (run->influences) {
        case 1:
          alike(Fixed<1u>());
          break;
        case 2:
          alike(Fixed<2u>());
          break;
        case 3:
          alike(Fixed<3u>());
          break;
        case 4:
          alike(Fixed<4u>());
          break;
        default:
          run =
              deform_alike(static_cast<Directions>(directions), run->influences, deformer, run, end, set, palette, at);
          break;
      }
    }
  }
}

inline bool aligned(const float* p) {
  return reinterpret_cast<std::uintptr_t>(p) % 16 == 0;
}

// What all deformers ask of their arguments.
BadCall check_deform(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out);
Directions directions_of(const SkinOutput& out);

template <class Deformer>
BadCall deform(const Mesh& mesh, const float* stream, Span<const Affine> palette, const SkinOutput& out,
               const Deformer& deformer = {}) {
  if (const BadCall bad = check_deform(mesh, palette, out)) return bad;
  const auto run = [&](auto directions) {
    deform_runs(directions, deformer, mesh.geometry, stream, palette.data, out);
  };
  using enum Directions;
  const Directions directions = directions_of(out);
  if constexpr (Deformer::kFixedDirections) {
    switch (directions) {
      case none:
        run(Fixed<none>());
        break;
      case blended_normals:
        run(Fixed<blended_normals>());
        break;
      case blended_tangents:
        run(Fixed<blended_tangents>());
        break;
      case exact:
        run(Fixed<exact>());
        break;
    }
  } else {
    run(directions);
  }
  return {};
}

}  // namespace marrow
