// What the CPU deformers share: the walk over a mesh's runs, and what becomes of a block's normals and tangents. A
// deformer (rigid.cpp, ssd.cpp, as.cpp, mwe.cpp, psd.cpp) says how four vertices' positions and blended matrices come
// about.
#pragma once

#include "core/check.h"
#include "marrow/skin.h"
#include "math/f32x4.h"

namespace marrow {

// One row of four vertices' matrices, one lane a vertex.
struct BlockRow {
  f32x4 x, y, z, t;
};

// Four vertices' blended matrices.
struct Blend {
  BlockRow a, b, c;
};

// Four vertices' positions, normals or tangents: x[4] y[4] z[4], 16-byte aligned, through the 3×3 part of a row.
inline f32x4 dot3(const BlockRow& row, const float* v) {
  return row.x * load_aligned(v) + row.y * load_aligned(v + 4) + row.z * load_aligned(v + 8);
}

// Whether kernels are also made for fixed numbers of influences, whose loops unroll: not where code is to be small.
#ifdef __OPTIMIZE_SIZE__
inline constexpr bool kUnrolled = false;
#else
inline constexpr bool kUnrolled = true;
#endif

// What a kernel writes beside positions.
enum class Directions { none, blended_normals, blended_tangents, exact_normals, exact_tangents };

constexpr bool has_tangents(Directions d) {
  return d == Directions::blended_tangents || d == Directions::exact_tangents;
}
constexpr bool is_exact(Directions d) {
  return d == Directions::exact_normals || d == Directions::exact_tangents;
}

// Where a kernel reads and writes; it leaves them behind the run.
struct Cursor {
  const float* stream;  // positions and weights, or animation-space coordinates
  const float* normals;
  const float* tangents;
  float* out_positions;
  float* out_normals;
  float* out_tangents;
};

inline f32x4 determinant(const Blend& m) {
  return dot3(m.a.x, m.a.y, m.a.z, m.b.y * m.c.z - m.b.z * m.c.y, m.b.z * m.c.x - m.b.x * m.c.z,
              m.b.x * m.c.y - m.b.y * m.c.x);
}

// Inverse transpose up to a positive factor: the cofactors, turned round where the blend mirrors. Normalised. Returns
// the determinant.
inline f32x4 write_exact_normals(const Blend& m, const float* normals, float* out) {
  const f32x4 x = load_aligned(normals), y = load_aligned(normals + 4), z = load_aligned(normals + 8);
  const BlockRow &a = m.a, &b = m.b, &c = m.c;
  const f32x4 ax = b.y * c.z - b.z * c.y, ay = b.z * c.x - b.x * c.z, az = b.x * c.y - b.y * c.x;
  const f32x4 nx = dot3(ax, ay, az, x, y, z), det = dot3(a.x, a.y, a.z, ax, ay, az);
  const f32x4 bx = c.y * a.z - c.z * a.y, by = c.z * a.x - c.x * a.z, bz = c.x * a.y - c.y * a.x;
  const f32x4 ny = dot3(bx, by, bz, x, y, z);
  const f32x4 cx = a.y * b.z - a.z * b.y, cy = a.z * b.x - a.x * b.z, cz = a.x * b.y - a.y * b.x;
  const f32x4 nz = dot3(cx, cy, cz, x, y, z);
  const f32x4 scale = flip(inverse_length(dot3(nx, ny, nz, nx, ny, nz)), det);
  store_xyz(out, nx * scale, ny * scale, nz * scale);
  return det;
}

inline void write_exact_tangents(const Blend& m, f32x4 det, const float* tangents, float* out) {
  const f32x4 x = dot3(m.a, tangents), y = dot3(m.b, tangents), z = dot3(m.c, tangents);
  const f32x4 scale = inverse_length(dot3(x, y, z, x, y, z));
  store_xyzw(out, x * scale, y * scale, z * scale, flip(load_aligned(tangents + 12), det));
}

// mirror: negative where the handedness turns; of blended tangents only.
template <Directions D>
inline void write_directions(const Blend& m, f32x4 mirror, Cursor& at) {
  if constexpr (D == Directions::none) return;
  f32x4 det = mirror;
  if constexpr (is_exact(D)) {
    det = write_exact_normals(m, at.normals, at.out_normals);
  } else {
    store_xyz(at.out_normals, dot3(m.a, at.normals), dot3(m.b, at.normals), dot3(m.c, at.normals));
  }
  at.normals += 12;
  at.out_normals += 12;
  if constexpr (has_tangents(D)) {
    if constexpr (is_exact(D)) {
      write_exact_tangents(m, det, at.tangents, at.out_tangents);
    } else {
      store_xyzw(at.out_tangents, dot3(m.a, at.tangents), dot3(m.b, at.tangents), dot3(m.c, at.tangents),
                 flip(load_aligned(at.tangents + 12), det));
    }
    at.tangents += 16;
    at.out_tangents += 16;
  }
}

// deformer.run<D>(set, influences, blocks, palette, cursor) deforms one run; runs come in order.
template <Directions D, class Deformer>
void deform_runs(Deformer deformer, const Geometry& g, const float* stream, const Affine* palette,
                 const SkinOutput& out) {
  Cursor at{stream, g.normals, g.tangents, out.positions.data, out.normals.data, out.tangents.data};
  const std::uint16_t* set = g.sets;
  for (const Run& run : g.runs) {
    deformer.template run<D>(set, run.influences, (run.vertex_count + 3) / 4, palette, at);
    set += run.influences;
  }
}

inline bool aligned(const float* p) {
  return reinterpret_cast<std::uintptr_t>(p) % 16 == 0;
}

template <class Deformer>
Status deform(const Mesh& mesh, const float* stream, Span<const Affine> palette, const SkinOutput& out,
              const Deformer& deformer = {}) {
  const Geometry& g = mesh.geometry;
  const std::size_t slots = g.slot_count;
  const bool normals = !out.normals.empty(), tangents = !out.tangents.empty();
  const bool exact = out.normal_transform == NormalTransform::inverse_transpose;
  MARROW_REQUIRE(palette.size >= mesh.palette_size());
  MARROW_REQUIRE(aligned(g.skin) && aligned(g.normals) && aligned(g.tangents));
  MARROW_REQUIRE(out.positions.size >= slots * 3);
  MARROW_REQUIRE(!normals || (g.normals != nullptr && out.normals.size >= slots * 3));
  MARROW_REQUIRE(!tangents || (normals && g.tangents != nullptr && out.tangents.size >= slots * 4));
  if (!normals) {
    deform_runs<Directions::none>(deformer, g, stream, palette.data, out);
  } else if (!tangents) {
    exact ? deform_runs<Directions::exact_normals>(deformer, g, stream, palette.data, out)
          : deform_runs<Directions::blended_normals>(deformer, g, stream, palette.data, out);
  } else {
    exact ? deform_runs<Directions::exact_tangents>(deformer, g, stream, palette.data, out)
          : deform_runs<Directions::blended_tangents>(deformer, g, stream, palette.data, out);
  }
  return Status::ok;
}

}  // namespace marrow
