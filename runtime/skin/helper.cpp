#include "skin/helper.h"

#include "math/rotation.h"

namespace marrow {
namespace {

// All are squares: the length and the sine below which a column has no direction, how far a helper may move the origin,
// and the deviation from a rotation below which a matrix counts as one.
constexpr float kLeastSquare = 1e-30f, kLeastSine = 1e-10f, kMostSquare = 1e36f, kNoStretch = 1e-9f;

// One joint's matrices of four helpers, from the palette or the bind matrices. joint: Helper::first or second.
inline FourAffines maps(const Affine* from, const Helper* h, std::uint16_t Helper::*joint) {
  return load_affines(from[h[0].*joint], from[h[1].*joint], from[h[2].*joint], from[h[3].*joint]);
}
inline Linear<f32x4> transposed(const Linear<f32x4>& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
inline Linear<f32x4> columns_of(const FourAffines& m) {
  return transposed(m.rows);
}

// 1 + the trace of a rotation by 166°. For larger rotations w is small: take_far_turn() handles them.
constexpr float kFarTurn = 0.0625f;

// A turn as a quaternion of some length, w ≥ 0: the shorter way.
struct HelperTurn {
  Vector<f32x4> v;
  f32x4 w, length;
};

[[gnu::cold, gnu::noinline]] void take_far_turn(const Linear<f32x4>& m, HelperTurn& out) {
  const f32x4 zero = splat(0.0f), one = splat(1.0f), xx = m.x.x, yy = m.y.y, zz = m.z.z;
  const f32x4 xy = m.x.y + m.y.x, xz = m.x.z + m.z.x, yz = m.y.z + m.z.y;
  const Vector<f32x4> by_x = {one + xx - yy - zz, xy, xz}, by_y = {xy, one + yy - zz - xx, yz},
                      by_z = {xz, yz, one + zz - xx - yy};
  const mask4 y_is_more = xx < yy, z_is_most = greater(xx, yy) < zz, is_far = out.w < splat(kFarTurn);
  const Vector<f32x4> v = select(z_is_most, by_z, select(y_is_more, by_y, by_x));
  const f32x4 w = select(z_is_most, out.v.z, select(y_is_more, out.v.y, out.v.x));
  out.v = select(is_far, select(w < zero, -v, v), out.v);
  out.w = select(is_far, absolute(w), out.w);
  out.length = select(is_far, sqrt(dot(v, v) + w * w), out.length);
}

inline HelperTurn shorter_turn(const Linear<f32x4>& m) {
  HelperTurn out;
  out.v = {m.y.z - m.z.y, m.z.x - m.x.z, m.x.y - m.y.x};
  out.w = splat(1.0f) + (m.x.x + m.y.y + m.z.z);
  out.length = sqrt(splat(4.0f) * out.w);
  if (any(out.w < splat(kFarTurn))) [[unlikely]]
    take_far_turn(m, out);
  return out;
}

[[gnu::always_inline]] inline void store_row(Vector<f32x4> v, f32x4 origin, int row, std::size_t count, Affine* out) {
  transpose(v.x, v.y, v.z, origin);
  store(out[0].rows[row], v.x);
  if (count > 1) store(out[1].rows[row], v.y);
  if (count > 2) store(out[2].rows[row], v.z);
  if (count > 3) store(out[3].rows[row], origin);
}
inline void store_maps(const Linear<f32x4>& m, const Vector<f32x4>& origin, std::size_t count, Affine* out) {
  store_row({m.x.x, m.y.x, m.z.x}, origin.x, 0, count, out);
  store_row({m.x.y, m.y.y, m.z.y}, origin.y, 1, count, out);
  store_row({m.x.z, m.y.z, m.z.z}, origin.z, 2, count, out);
}

f32x4 mixed(f32x4 a, f32x4 b, f32x4 share) {
  return a + (b - a) * share;
}

// QR by Gram–Schmidt: a matrix = turn · stretch. The stretch is upper triangular.
struct Parts {
  Linear<f32x4> turn;
  f32x4 xx, xy, yy, xz, yz, zz;  // of the stretch
  f32x4 good;                    // 0 where a column has no direction of its own
};
[[gnu::noinline]] Parts parts_of(const Linear<f32x4>& m) {
  const f32x4 one = splat(1.0f), least = splat(kLeastSquare);
  Parts out;
  const f32x4 x = dot(m.x, m.x), from_x = one / sqrt(x);
  out.turn.x = m.x * from_x;
  out.xx = x * from_x;
  out.xy = dot(out.turn.x, m.y);
  const Vector<f32x4> rest = m.y - out.turn.x * out.xy;
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

// The way from a first matrix to a second.
struct Way {
  Linear<f32x4> turn;
  Linear<f32x4> stretched;  // the first's turn, with a mix of both stretches
  f32x4 good;
};
[[gnu::cold, gnu::noinline]] Way stretched_way(const Linear<f32x4>& first, const Linear<f32x4>& second, f32x4 share) {
  const Parts a = parts_of(first), b = parts_of(second);
  const Linear<f32x4> back = transposed(a.turn);
  Way out;
  out.turn.x = b.turn * back.x;
  out.turn.y = b.turn * back.y;
  out.turn.z = cross(out.turn.x, out.turn.y);
  out.stretched.x = a.turn.x * mixed(a.xx, b.xx, share);
  out.stretched.y = a.turn.x * mixed(a.xy, b.xy, share) + a.turn.y * mixed(a.yy, b.yy, share);
  out.stretched.z =
      a.turn.x * mixed(a.xz, b.xz, share) + a.turn.y * mixed(a.yz, b.yz, share) + a.turn.z * mixed(a.zz, b.zz, share);
  out.good = a.good * b.good;
  return out;
}

bool all_turns(const Linear<f32x4>& m) {
  const f32x4 one = splat(1.0f), x = dot(m.x, m.x) - one, y = dot(m.y, m.y) - one, xy = dot(m.x, m.y);
  const Vector<f32x4> z = m.z - cross(m.x, m.y);
  return all(x * x + y * y + xy * xy + dot(z, z) < splat(kNoStretch));
}
// An inverse is `linear` times `over_determinant`.
struct LinearInverse {
  Linear<f32x4> linear;
  f32x4 over_determinant;
};
[[gnu::always_inline]] inline LinearInverse inverse_of(const Linear<f32x4>& m) {
  const Linear<f32x4> rows = cofactors(m);
  return {transposed(rows), splat(1.0f) / dot(m.x, rows.x)};
}
// b a⁻¹
[[gnu::always_inline]] inline Linear<f32x4> product_with_inverse(const Linear<f32x4>& b, const Linear<f32x4>& a) {
  const LinearInverse inverse = inverse_of(a);
  const Linear<f32x4> m = b * inverse.linear;
  const f32x4 scale = inverse.over_determinant;
  return {m.x * scale, m.y * scale, m.z * scale};
}
// The points that `bind` takes to `places`.
Vector<f32x4> place_before(const FourAffines& bind, const Vector<f32x4>& places) {
  const LinearInverse inverse = inverse_of(columns_of(bind));
  return inverse.linear * (places - origin(bind)) * inverse.over_determinant;
}

// Blends four helpers and stores `count` of them; returns which are good. The turn from entry a to b is b a⁻¹, if that
// is a rotation for all four. Otherwise all four are split into turn and stretch.
[[gnu::noinline]] mask4 blend_some(const Helper* h, const float* centres, const Affine* bind, const Affine* palette,
                                   std::size_t count, Affine* out) {
  const FourAffines a = maps(palette, h, &Helper::first), b = maps(palette, h, &Helper::second);
  const f32x4 one = splat(1.0f), share = lanes(h[0].share, h[1].share, h[2].share, h[3].share), rest = one - share;
  Way way = {product_with_inverse(columns_of(b), columns_of(a)), columns_of(a), one};
  const bool about_centres = centres != nullptr;
  const bool stretched = !all_turns(way.turn);
  if (stretched) [[unlikely]]
    way = stretched_way(columns_of(a), columns_of(b), share);
  const HelperTurn turn = shorter_turn(way.turn);
  const Quaternion<f32x4> q = quaternion(turn.v * share, turn.w * share + turn.length * rest);
  const Linear<f32x4> m = matrix_of(q) * way.stretched;

  Vector<f32x4> from = origin(a), step = origin(b) - from, place{};
  if (about_centres || stretched) {
    if (about_centres) load_xyz(centres, place.x, place.y, place.z);
    place = place_before(maps(bind, h, &Helper::second), place);
    from = transform(a, place);
    step = transform(b, place) - from;
  }
  Vector<f32x4> at;
  if (about_centres) {
    at = from + step * share - m * place;
  } else {  // the dual part
    const Vector<f32x4> sum = step * (turn.w * rest + turn.length * share) + cross(step, turn.v) * rest;
    at = from + sum * (share * turn.length / dot(q, q));
    if (stretched) [[unlikely]]
      at = at - m * place;
  }
  store_maps(m, at, count, out);
  return splat(0.0f) < only_where(dot(at, at) < splat(kMostSquare), way.good);
}

// The linear blend of two matrices.
void blend_straight(const Affine& a, const Affine& b, float share, Affine& out) {
  for (int r = 0; r < 3; ++r)
    store(out.rows[r], load_aligned(a.rows[r]) * splat(1.0f - share) + load_aligned(b.rows[r]) * splat(share));
}

[[gnu::noinline]] void add_some(const Helper* helpers, const float* centres, const Affine* bind, const Affine* palette,
                                std::size_t count, Affine* out) {
  const mask4 good = blend_some(helpers, centres, bind, palette, count, out);
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
    add_some(helpers.data + i, centres, bind.data, palette, 4, out + i);
    if (centres != nullptr) centres += 12;
  }
  if (i == helpers.size) return;
  // The remaining helpers. Lanes without one repeat the first of them.
  Helper last[4];
  float last_centres[12];
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t from = i + k < helpers.size ? k : 0;
    last[k] = helpers.data[i + from];
    for (std::size_t c = 0; c < 3 && centres != nullptr; ++c) last_centres[3 * k + c] = centres[3 * from + c];
  }
  add_some(last, centres == nullptr ? nullptr : last_centres, bind.data, palette, helpers.size - i, out + i);
}

}  // namespace marrow
