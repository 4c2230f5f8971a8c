// The CPU deformers: one kernel, four vertices at a time, run by run; what differs between deformers is how a block's
// position and its blended matrix come about.
#include "marrow/skin.h"

#include "core/check.h"
#include "math/affine.h"

namespace marrow {
namespace {

enum class Deformer { rigid, ssd, as };

// Twelve elements of a joint's matrix, each in all four lanes.
struct SplatMatrix {
  f32x4 e[12];
};

// Four vertices' matrices, one lane a vertex; row r, column c at 4 r + c.
struct BlockMatrix {
  f32x4 e[12];
};

struct Block {
  f32x4 x, y, z;      // deformed positions
  BlockMatrix blend;  // its 3×3 part carries normals and tangents
};

SplatMatrix splat_matrix(const Affine& a) {
  SplatMatrix m;
  for (int row = 0; row < 3; ++row) {
    const f32x4 r = load(a.rows[row]);
    m.e[4 * row] = splat_lane<0>(r);
    m.e[4 * row + 1] = splat_lane<1>(r);
    m.e[4 * row + 2] = splat_lane<2>(r);
    m.e[4 * row + 3] = splat_lane<3>(r);
  }
  return m;
}

// The matrices of a run's joint set. For SSD all but the last are kept as differences from the last, so that a block
// needs one weight fewer: Σ w_j M_j = M_last + Σ_{j<last} w_j (M_j - M_last).
template <Deformer D>
void load_set(const std::uint16_t* set, std::uint32_t k, const Affine* palette, SplatMatrix* out) {
  const SplatMatrix last = splat_matrix(palette[set[k - 1]]);
  for (std::uint32_t j = 0; j + 1 < k; ++j) {
    out[j] = splat_matrix(palette[set[j]]);
    if constexpr (D == Deformer::ssd)
      for (int i = 0; i < 12; ++i) out[j].e[i] = out[j].e[i] - last.e[i];
  }
  out[k - 1] = last;
}

// skin: x y z and k-1 weights of four vertices. Leaves it behind the block.
inline Block deform_ssd(const SplatMatrix* set, std::uint32_t k, const float*& skin) {
  const float* const position = skin;
  skin += 12;
  Block b;
  for (int i = 0; i < 12; ++i) b.blend.e[i] = set[k - 1].e[i];
  for (std::uint32_t j = 0; j + 1 < k; ++j, skin += 4) {
    const f32x4 w = load(skin);
    for (int i = 0; i < 12; ++i) b.blend.e[i] = b.blend.e[i] + w * set[j].e[i];
  }
  const f32x4 x = load(position), y = load(position + 4), z = load(position + 8);
  const f32x4* const e = b.blend.e;
  b.x = dot3(e[0], e[1], e[2], x, y, z) + e[3];
  b.y = dot3(e[4], e[5], e[6], x, y, z) + e[7];
  b.z = dot3(e[8], e[9], e[10], x, y, z) + e[11];
  return b;
}

inline Block deform_rigid(const SplatMatrix* set, std::uint32_t k, const float*& skin) {
  const float* const position = skin;
  skin += 12;
  Block b;
  for (int i = 0; i < 12; ++i) b.blend.e[i] = set[0].e[i];
  if (k > 1) {
    f32x4 largest = load(skin), last_weight = splat(1.0f) - largest;
    for (std::uint32_t j = 1; j < k; ++j) {
      f32x4 w = last_weight;
      if (j + 1 < k) {
        w = load(skin + 4 * j);
        last_weight = last_weight - w;
      }
      const mask4 larger = largest < w;
      largest = select(larger, w, largest);
      for (int i = 0; i < 12; ++i) b.blend.e[i] = select(larger, set[j].e[i], b.blend.e[i]);
    }
    skin += 4 * (k - 1);
  }
  const f32x4 x = load(position), y = load(position + 4), z = load(position + 8);
  const f32x4* const e = b.blend.e;
  b.x = dot3(e[0], e[1], e[2], x, y, z) + e[3];
  b.y = dot3(e[4], e[5], e[6], x, y, z) + e[7];
  b.z = dot3(e[8], e[9], e[10], x, y, z) + e[11];
  return b;
}

// q: k coordinates (x y z w) of four vertices. Leaves it behind the block. The blend is formed only if asked for.
template <bool Blend>
inline Block deform_as(const SplatMatrix* set, std::uint32_t k, const float*& q) {
  Block b;
  for (std::uint32_t j = 0; j < k; ++j, q += 16) {
    const f32x4 x = load(q), y = load(q + 4), z = load(q + 8), w = load(q + 12);
    const f32x4* const e = set[j].e;
    const f32x4 px = (e[0] * x + e[1] * y) + (e[2] * z + e[3] * w);
    const f32x4 py = (e[4] * x + e[5] * y) + (e[6] * z + e[7] * w);
    const f32x4 pz = (e[8] * x + e[9] * y) + (e[10] * z + e[11] * w);
    b.x = j == 0 ? px : b.x + px;
    b.y = j == 0 ? py : b.y + py;
    b.z = j == 0 ? pz : b.z + pz;
    if constexpr (Blend)
      for (int i = 0; i < 12; ++i)
        if (i % 4 != 3) b.blend.e[i] = j == 0 ? w * e[i] : b.blend.e[i] + w * e[i];
  }
  return b;
}

// Inverse transpose up to a positive factor: the cofactors, turned round where the blend mirrors. Normalised.
// Returns the sign of the determinant.
inline f32x4 write_normals(const f32x4* e, const float* normals, float* out) {
  const f32x4 x = load(normals), y = load(normals + 4), z = load(normals + 8);
  const f32x4 c00 = e[5] * e[10] - e[6] * e[9], c01 = e[6] * e[8] - e[4] * e[10], c02 = e[4] * e[9] - e[5] * e[8];
  const f32x4 c10 = e[9] * e[2] - e[10] * e[1], c11 = e[10] * e[0] - e[8] * e[2], c12 = e[8] * e[1] - e[9] * e[0];
  const f32x4 c20 = e[1] * e[6] - e[2] * e[5], c21 = e[2] * e[4] - e[0] * e[6], c22 = e[0] * e[5] - e[1] * e[4];
  const f32x4 determinant = dot3(e[0], e[1], e[2], c00, c01, c02);
  const f32x4 sign = select(determinant < splat(0.0f), splat(-1.0f), splat(1.0f));
  const f32x4 nx = dot3(c00, c01, c02, x, y, z), ny = dot3(c10, c11, c12, x, y, z), nz = dot3(c20, c21, c22, x, y, z);
  const f32x4 scale = inverse_length(dot3(nx, ny, nz, nx, ny, nz)) * sign;
  store_xyz(out, nx * scale, ny * scale, nz * scale);
  return sign;
}

inline void write_tangents(const f32x4* e, f32x4 sign, const float* tangents, float* out) {
  const f32x4 x = load(tangents), y = load(tangents + 4), z = load(tangents + 8);
  const f32x4 tx = dot3(e[0], e[1], e[2], x, y, z);
  const f32x4 ty = dot3(e[4], e[5], e[6], x, y, z);
  const f32x4 tz = dot3(e[8], e[9], e[10], x, y, z);
  const f32x4 scale = inverse_length(dot3(tx, ty, tz, tx, ty, tz));
  f32x4 v0 = tx * scale, v1 = ty * scale, v2 = tz * scale, v3 = load(tangents + 12) * sign;
  transpose(v0, v1, v2, v3);
  store(out, v0);
  store(out + 4, v1);
  store(out + 8, v2);
  store(out + 12, v3);
}

template <Deformer D, bool Normals, bool Tangents>
void skin_runs(const Geometry& g, const float* stream, const Affine* palette, const SkinOutput& out) {
  SplatMatrix set[kMaxInfluences];
  const std::uint16_t* joints = g.sets;
  const float* normals = g.normals;
  const float* tangents = g.tangents;
  float* p = out.positions.data;
  float* n = out.normals.data;
  float* t = out.tangents.data;
  for (const Run& run : g.runs) {
    const std::uint32_t k = run.influences;
    load_set<D>(joints, k, palette, set);
    joints += k;
    const std::uint32_t blocks = (run.vertex_count + 3) / 4;
    for (std::uint32_t i = 0; i < blocks; ++i, p += 12) {
      Block b;
      if constexpr (D == Deformer::ssd) b = deform_ssd(set, k, stream);
      if constexpr (D == Deformer::rigid) b = deform_rigid(set, k, stream);
      if constexpr (D == Deformer::as) b = deform_as < Normals || Tangents > (set, k, stream);
      store_xyz(p, b.x, b.y, b.z);
      f32x4 sign = splat(1.0f);
      if constexpr (Normals) {
        sign = write_normals(b.blend.e, normals, n);
        normals += 12;
        n += 12;
      }
      if constexpr (Tangents) {
        write_tangents(b.blend.e, sign, tangents, t);
        tangents += 16;
        t += 16;
      }
    }
  }
}

template <Deformer D>
Status skin(const Mesh& mesh, const float* stream, Span<const Affine> palette, const SkinOutput& out) {
  const Geometry& g = mesh.geometry;
  const std::size_t slots = g.slot_count;
  const bool normals = !out.normals.empty(), tangents = !out.tangents.empty();
  MARROW_REQUIRE(palette.size >= mesh.joint_count);
  MARROW_REQUIRE(out.positions.size >= slots * 3);
  MARROW_REQUIRE(!normals || (g.normals != nullptr && out.normals.size >= slots * 3));
  MARROW_REQUIRE(!tangents || (normals && g.tangents != nullptr && out.tangents.size >= slots * 4));
  if (tangents) {
    skin_runs<D, true, true>(g, stream, palette.data, out);
  } else if (normals) {
    skin_runs<D, true, false>(g, stream, palette.data, out);
  } else {
    skin_runs<D, false, false>(g, stream, palette.data, out);
  }
  return Status::ok;
}

}  // namespace

Status skin_rigid(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out) {
  return skin<Deformer::rigid>(mesh, mesh.geometry.skin, palette, out);
}

Status skin_ssd(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out) {
  return skin<Deformer::ssd>(mesh, mesh.geometry.skin, palette, out);
}

Status skin_as(const Mesh& mesh, Span<const float> coordinates, Span<const Affine> palette, const SkinOutput& out) {
  MARROW_REQUIRE(coordinates.size >= as_coordinate_count(mesh.geometry));
  return skin<Deformer::as>(mesh, coordinates.data, palette, out);
}

}  // namespace marrow
