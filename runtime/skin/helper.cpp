#include "skin/helper.h"

#include "math/at_once.h"
#include "skin/helper_lanes.h"

namespace marrow {
namespace {

// Squares: of the lengths and sines below which there is no direction, of how far helpers may take what is at 0, and of
// the difference to a turn that is none.
constexpr float kLeastSquare = 1e-30f, kLeastSine = 1e-10f, kMostSquare = 1e36f, kNoStretch = 1e-9f;

using Batch = HelperLanes<Number>;
using Vectors = Vector<Number>;
using Linears = Linear<Number>;
using Maps = Batch::Maps;

Number mixed(Number a, Number b, Number share) {
  return a + (b - a) * share;
}

// A matrix as a stretch, 0 below the diagonal, and then a turn: Gram and Schmidt.
struct Parts {
  Linears turn;
  Number xx, xy, yy, xz, yz, zz;  // of the stretch
  Number good;                    // 0 where a column has no direction of its own
};
[[gnu::noinline]] Parts parts_of(const Linears& m) {
  const Number one = number(1.0f), least = number(kLeastSquare);
  Parts out;
  const Number x = dot(m.x, m.x), from_x = one / sqrt(x);
  out.turn.x = m.x * from_x;
  out.xx = x * from_x;
  out.xy = dot(out.turn.x, m.y);
  const Vectors rest = m.y - out.turn.x * out.xy;
  const Number y = dot(rest, rest), from_y = one / sqrt(y);
  out.turn.y = rest * from_y;
  out.yy = y * from_y;
  out.turn.z = cross(out.turn.x, out.turn.y);
  out.xz = dot(out.turn.x, m.z);
  out.yz = dot(out.turn.y, m.z);
  out.zz = dot(out.turn.z, m.z);
  out.good = only_where(least < x, only_where(least + number(kLeastSine) * dot(m.y, m.y) < y, one));
  return out;
}

// From one matrix to another.
struct Way {
  Linears turn;
  Linears stretched;  // the first, with the stretch of both
  Number good;
};
[[gnu::cold, gnu::noinline]] Way stretched_way(const Linears& first, const Linears& second, Number share) {
  const Parts a = parts_of(first), b = parts_of(second);
  const Linears back = Batch::transposed(a.turn);
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

bool all_turns(const Linears& m) {
  const Number one = number(1.0f), x = dot(m.x, m.x) - one, y = dot(m.y, m.y) - one, xy = dot(m.x, m.y);
  const Vectors z = m.z - cross(m.x, m.y);
  return all(x * x + y * y + xy * xy + dot(z, z) < number(kNoStretch));
}
MARROW_CALLED_ONLY_WHERE_SMALL inline Linears product(const Linears& a, const Linears& b) {
  return a * b;
}
// An inverse is `linear` times `over_determinant`.
struct LinearInverse {
  Linears linear;
  Number over_determinant;
};
MARROW_CALLED_ONLY_WHERE_SMALL inline LinearInverse inverse_of(const Linears& m) {
  const Linears rows = cofactors(m);
  return {Batch::transposed(rows), number(1.0f) / dot(m.x, rows.x)};
}
// b a⁻¹
MARROW_CALLED_ONLY_WHERE_SMALL inline Linears product_with_inverse(const Linears& b, const Linears& a) {
  const LinearInverse inverse = inverse_of(a);
  const Linears m = product(b, inverse.linear);
  const Number scale = inverse.over_determinant;
  return {m.x * scale, m.y * scale, m.z * scale};
}
// What maps take to `places`.
Vectors place_before(const Maps& bind, const Vectors& places) {
  const LinearInverse inverse = inverse_of(Batch::columns_of(bind));
  return inverse.linear * (places - Batch::origin_of(bind)) * inverse.over_determinant;
}

// Whether the stretches of any of `count` helpers' ends differ. Helpers that go one at a time are asked four together,
// for that is how those that go four at a time are: so the bits are the same.
[[maybe_unused]] bool any_stretched(const Helper* h, std::size_t count, const Affine* palette) {
  for (const Helper* const end = h + count; h < end; h += Batch::kCount) {
    const Maps a = Batch::maps(palette, h, &Helper::first), b = Batch::maps(palette, h, &Helper::second);
    if (!all_turns(product_with_inverse(Batch::columns_of(b), Batch::columns_of(a)))) return true;
  }
  return false;
}

// As many helpers as go at once, of which `count` are stored; gives those that are good. The turn between two entries
// is the product of one and the other's inverse, unless their stretches differ; then all of four are taken apart.
[[gnu::noinline]] auto blend_some(const Helper* h, const float* centres, const Affine* bind, const Affine* palette,
                                  std::size_t count, bool stretched, Affine* out) {
  const Maps a = Batch::maps(palette, h, &Helper::first), b = Batch::maps(palette, h, &Helper::second);
  const Number one = number(1.0f), share = Batch::shares(h), rest = one - share;
  Way way = {product_with_inverse(Batch::columns_of(b), Batch::columns_of(a)), Batch::columns_of(a), one};
  const bool about_centres = centres != nullptr;
  if constexpr (!kSmall) stretched = !all_turns(way.turn);
  if (stretched) [[unlikely]]
    way = stretched_way(Batch::columns_of(a), Batch::columns_of(b), share);
  const HelperTurn<Number> turn = Batch::shorter_turn(way.turn);
  const Quaternion<Number> q = quaternion(turn.v * share, turn.w * share + turn.length * rest);
  const Linears m = product(Batch::matrix_of(q), way.stretched);

  Vectors from = Batch::origin_of(a), step = Batch::origin_of(b) - from, place{};
  if (about_centres || stretched) {
    if (about_centres) place = Batch::centres(centres);
    place = place_before(Batch::maps(bind, h, &Helper::second), place);
    from = Batch::transformed(a, place);
    step = Batch::transformed(b, place) - from;
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
  Batch::store(m, at, count, out);
  return number(0.0f) < only_where(dot(at, at) < number(kMostSquare), way.good);
}

// Of two matrices, straight.
void blend_straight(const Affine& a, const Affine& b, float share, Affine& out) {
  for (int r = 0; r < 3; ++r)
    store(out.rows[r], load_aligned(a.rows[r]) * splat(1.0f - share) + load_aligned(b.rows[r]) * splat(share));
}

[[gnu::noinline]] void add_some(const Helper* helpers, const float* centres, const Affine* bind, const Affine* palette,
                                std::size_t count, bool stretched, Affine* out) {
  const auto good = blend_some(helpers, centres, bind, palette, count, stretched, out);
  if (all(good)) [[likely]]
    return;
  float ok[4];
  store(ok, Batch::in_lanes(only_where(good, number(1.0f))));
  for (std::size_t i = 0; i < count; ++i)
    if (ok[i] == 0) blend_straight(palette[helpers[i].first], palette[helpers[i].second], helpers[i].share, out[i]);
}

}  // namespace

void add_helpers(Span<const Helper> helpers, const float* centres, Span<const Affine> bind, Affine* palette) {
  Affine* const out = palette + bind.size;
  constexpr std::size_t kCount = Batch::kCount;
  std::size_t i = 0;
  bool stretched = false;
  for (; i + kCount <= helpers.size; i += kCount) {
    if (kSmall && i % 4 == 0)
      stretched = any_stretched(helpers.data + i, helpers.size - i < 4 ? helpers.size - i : 4, palette);
    add_some(helpers.data + i, centres, bind.data, palette, kCount, stretched, out + i);
    if (centres != nullptr) centres += 3 * kCount;
  }
  if (kCount == 1 || i == helpers.size) return;
  // The rest, and the first of it once more for each that is missing.
  Helper last[kCount];
  float last_centres[3 * kCount];
  for (std::size_t k = 0; k < kCount; ++k) {
    const std::size_t from = i + k < helpers.size ? k : 0;
    last[k] = helpers.data[i + from];
    for (std::size_t c = 0; c < 3 && centres != nullptr; ++c) last_centres[3 * k + c] = centres[3 * from + c];
  }
  add_some(last, centres == nullptr ? nullptr : last_centres, bind.data, palette, helpers.size - i, stretched, out + i);
}

}  // namespace marrow
