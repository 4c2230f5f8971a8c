#include "skin/helper.h"

#include "math/affine.h"
#include "math/quaternion.h"
#include "math/rotation.h"

namespace marrow {
namespace {

using Vectors = Vector<f32x4>;
using Linears = Linear<f32x4>;

// Squares: of the lengths and sines below which there is no direction, of how far helpers may take what is at 0, and of
// the difference to a turn that is none.
constexpr float kLeastSquare = 1e-30f, kLeastSine = 1e-10f, kMostSquare = 1e36f, kNoStretch = 1e-9f;
// 1 + the trace of a turn by 166°; of what turns farther w is small.
constexpr float kFarTurn = 0.0625f;

f32x4 mixed(f32x4 a, f32x4 b, f32x4 share) {
  return a + (b - a) * share;
}
Linears columns_of(const FourAffines& m) {
  return {{m.a.linear.x, m.b.linear.x, m.c.linear.x},
          {m.a.linear.y, m.b.linear.y, m.c.linear.y},
          {m.a.linear.z, m.b.linear.z, m.c.linear.z}};
}

// A matrix as a stretch, 0 below the diagonal, and then a turn: Gram and Schmidt.
struct Parts {
  Linears turn;
  f32x4 xx, xy, yy, xz, yz, zz;  // of the stretch
  f32x4 good;                    // 0 where a column has no direction of its own
};
[[gnu::noinline]] Parts parts_of(const Linears& m) {
  const f32x4 one = splat(1.0f), least = splat(kLeastSquare);
  Parts out;
  const f32x4 x = dot(m.x, m.x), from_x = one / sqrt(x);
  out.turn.x = m.x * from_x;
  out.xx = x * from_x;
  out.xy = dot(out.turn.x, m.y);
  const Vectors rest = m.y - out.turn.x * out.xy;
  const f32x4 y = dot(rest, rest), from_y = one / sqrt(y);
  out.turn.y = rest * from_y;
  out.yy = y * from_y;
  out.turn.z = cross(out.turn.x, out.turn.y);
  out.xz = dot(out.turn.x, m.z);
  out.yz = dot(out.turn.y, m.z);
  out.zz = dot(out.turn.z, m.z);
  out.good = only_where(least < x, only_where(least + splat(kLeastSine) * dot(m.y, m.y) < y, one));
  return out;
}

// From one matrix to another.
struct Way {
  Linears turn;
  Linears stretched;  // the first, with the stretch of both
  f32x4 good;
};
[[gnu::cold, gnu::noinline]] Way stretched_way(const Linears& first, const Linears& second, f32x4 share) {
  const Parts a = parts_of(first), b = parts_of(second);
  Way out;
  out.turn.x = b.turn * Vectors{a.turn.x.x, a.turn.y.x, a.turn.z.x};
  out.turn.y = b.turn * Vectors{a.turn.x.y, a.turn.y.y, a.turn.z.y};
  out.turn.z = cross(out.turn.x, out.turn.y);
  out.stretched.x = a.turn.x * mixed(a.xx, b.xx, share);
  out.stretched.y = a.turn.x * mixed(a.xy, b.xy, share) + a.turn.y * mixed(a.yy, b.yy, share);
  out.stretched.z =
      a.turn.x * mixed(a.xz, b.xz, share) + a.turn.y * mixed(a.yz, b.yz, share) + a.turn.z * mixed(a.zz, b.zz, share);
  out.good = a.good * b.good;
  return out;
}

bool all_turns(const Linears& m) {
  const f32x4 one = splat(1.0f), x = dot(m.x, m.x) - one, y = dot(m.y, m.y) - one, xy = dot(m.x, m.y);
  const Vectors z = m.z - cross(m.x, m.y);
  return all(x * x + y * y + xy * xy + dot(z, z) < splat(kNoStretch));
}
// b a⁻¹
Linears product_with_inverse(const Linears& b, const Linears& a) {
  const Linears inverse = cofactors(a);
  const f32x4 scale = splat(1.0f) / dot(a.x, inverse.x);
  return {b * Vectors{inverse.x.x, inverse.y.x, inverse.z.x} * scale,
          b * Vectors{inverse.x.y, inverse.y.y, inverse.z.y} * scale,
          b * Vectors{inverse.x.z, inverse.y.z, inverse.z.z} * scale};
}

// A turn as a quaternion of some length, w ≥ 0: the shorter way.
struct Turn {
  Vectors v;
  f32x4 w, length;
};
[[gnu::cold, gnu::noinline]] void take_far_turn(const Linears& m, Turn& out) {
  const f32x4 zero = splat(0.0f), one = splat(1.0f), xx = m.x.x, yy = m.y.y, zz = m.z.z;
  const f32x4 xy = m.x.y + m.y.x, xz = m.x.z + m.z.x, yz = m.y.z + m.z.y;
  const Vectors by_x = {one + xx - yy - zz, xy, xz}, by_y = {xy, one + yy - zz - xx, yz},
                by_z = {xz, yz, one + zz - xx - yy};
  const mask4 y_is_more = xx < yy, z_is_most = greater(xx, yy) < zz, is_far = out.w < splat(kFarTurn);
  const Vectors v = select(z_is_most, by_z, select(y_is_more, by_y, by_x));
  const f32x4 w = select(z_is_most, out.v.z, select(y_is_more, out.v.y, out.v.x));
  out.v = select(is_far, select(w < zero, -v, v), out.v);
  out.w = select(is_far, absolute(w), out.w);
  out.length = select(is_far, sqrt(dot(v, v) + w * w), out.length);
}
Turn shorter_turn(const Linears& m) {
  Turn out;
  out.v = {m.y.z - m.z.y, m.z.x - m.x.z, m.x.y - m.y.x};
  out.w = splat(1.0f) + (m.x.x + m.y.y + m.z.z);
  out.length = sqrt(splat(4.0f) * out.w);
  if (any(out.w < splat(kFarTurn))) [[unlikely]]
    take_far_turn(m, out);
  return out;
}

// What four matrices take to `places`.
Vectors place_before(const FourAffines& bind, const Vectors& places) {
  const Linears m = columns_of(bind), cofactor = cofactors(m);
  return transposed_times(cofactor, places - origin(bind)) * (splat(1.0f) / dot(m.x, cofactor.x));
}

[[gnu::always_inline]] inline FourAffines load_four(const Affine* from, const std::size_t (&at)[4]) {
  return load_affines(from[at[0]], from[at[1]], from[at[2]], from[at[3]]);
}
Vectors load_centres(const float* c) {
  if (c == nullptr) return splat(0.0f, 0.0f, 0.0f);
  Vectors out;
  load_xyz(c, out.x, out.y, out.z);
  return out;
}

[[gnu::always_inline]] inline void store_one_row(FourRows rows, int row, std::size_t count, Affine* out) {
  transpose(rows.linear.x, rows.linear.y, rows.linear.z, rows.origin);
  store(out[0].rows[row], rows.linear.x);
  if (count > 1) store(out[1].rows[row], rows.linear.y);
  if (count > 2) store(out[2].rows[row], rows.linear.z);
  if (count > 3) store(out[3].rows[row], rows.origin);
}

// Four helpers, of which `count` are stored; gives those that are good. The turn between two entries is the product of
// one and the other's inverse, unless their stretches differ; then all four are taken apart.
[[gnu::noinline]] mask4 blend_four(const Helper* h, const float* centres, const Affine* bind, const Affine* palette,
                                   std::size_t count, Affine* out) {
  const std::size_t first[4] = {h[0].first, h[1].first, h[2].first, h[3].first};
  const std::size_t second[4] = {h[0].second, h[1].second, h[2].second, h[3].second};
  const FourAffines a = load_four(palette, first), b = load_four(palette, second);
  const f32x4 one = splat(1.0f), share = lanes(h[0].share, h[1].share, h[2].share, h[3].share), rest = one - share;
  Way way = {product_with_inverse(columns_of(b), columns_of(a)), columns_of(a), one};
  const bool stretched = !all_turns(way.turn), about_centres = centres != nullptr;
  if (stretched) [[unlikely]]
    way = stretched_way(columns_of(a), columns_of(b), share);
  const Turn turn = shorter_turn(way.turn);
  const Quaternion<f32x4> q = quaternion(turn.v * share, turn.w * share + turn.length * rest);
  const Linears m = matrix_of(q) * way.stretched;

  Vectors from = origin(a), step = origin(b) - from, place;
  if (about_centres || stretched) {
    place = place_before(load_four(bind, second), load_centres(centres));
    from = transform(a, place);
    step = transform(b, place) - from;
  }
  Vectors at;
  if (about_centres) {
    at = from + step * share - m * place;
  } else {  // the dual part
    const Vectors sum = step * (turn.w * rest + turn.length * share) + cross(step, turn.v) * rest;
    at = from + sum * (share * turn.length / dot(q, q));
    if (stretched) [[unlikely]]
      at = at - m * place;
  }
  store_one_row({{m.x.x, m.y.x, m.z.x}, at.x}, 0, count, out);
  store_one_row({{m.x.y, m.y.y, m.z.y}, at.y}, 1, count, out);
  store_one_row({{m.x.z, m.y.z, m.z.z}, at.z}, 2, count, out);
  return splat(0.0f) < only_where(dot(at, at) < splat(kMostSquare), way.good);
}

// Of two matrices, straight.
void blend_straight(const Affine& a, const Affine& b, float share, Affine& out) {
  for (int r = 0; r < 3; ++r)
    store(out.rows[r], load_aligned(a.rows[r]) * splat(1.0f - share) + load_aligned(b.rows[r]) * splat(share));
}

[[gnu::noinline]] void add_four(const Helper* helpers, const float* centres, const Affine* bind, const Affine* palette,
                                std::size_t count, Affine* out) {
  const mask4 good = blend_four(helpers, centres, bind, palette, count, out);
  if (all(good)) [[likely]]
    return;
  float ok[4];
  store(ok, only_where(good, splat(1.0f)));
  for (std::size_t i = 0; i < count; ++i)
    if (ok[i] == 0) blend_straight(palette[helpers[i].first], palette[helpers[i].second], helpers[i].share, out[i]);
}

}  // namespace

void add_helpers(Span<const Helper> helpers, const float* centres, Span<const Affine> bind, Affine* palette) {
  Affine* const out = palette + bind.size;
  std::size_t i = 0;
  for (; i + 4 <= helpers.size; i += 4) {
    add_four(helpers.data + i, centres, bind.data, palette, 4, out + i);
    if (centres != nullptr) centres += 12;
  }
  if (i == helpers.size) return;
  // The rest, and the first of it once more for each that is missing.
  Helper last[4];
  float last_centres[12];
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t from = i + k < helpers.size ? k : 0;
    last[k] = helpers.data[i + from];
    for (std::size_t c = 0; c < 3 && centres != nullptr; ++c) last_centres[3 * k + c] = centres[3 * from + c];
  }
  add_four(last, centres == nullptr ? nullptr : last_centres, bind.data, palette, helpers.size - i, out + i);
}

}  // namespace marrow
