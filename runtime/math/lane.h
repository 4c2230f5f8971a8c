// The number types F that the mathematics is templated on. float: one number. f32x4: four problems at once, one per
// lane. One: a number that fills all four lanes, for one problem whose vectors take a register each. The operations and
// their order are the same, and so are the results, but for the sign of zeros.
#pragma once

#include "core/builtins.h"
#include "math/f32x4.h"

namespace marrow {

inline float sqrt(float a) {
  return square_root(a);
}
inline bool any(bool m) {
  return m;
}
inline bool all(bool m) {
  return m;
}
inline float select(bool m, float yes, float no) {
  return m ? yes : no;
}

inline float lesser(float a, float b) {
  return a < b ? a : b;
}
inline float greater(float a, float b) {
  return b < a ? a : b;
}
inline float absolute(float a) {
  return without_sign(a);
}
inline float flip(float a, float by) {
  return has_sign(by) ? -a : a;
}
// 1 / root; 0 for 0, as of four lanes.
inline float inverse_length(float squared) {
  return 0.0f < squared ? 1.0f / sqrt(squared) : 0.0f;
}
inline f32x4 operator-(f32x4 a) {
  return flip(a, splat(-0.0f));
}

struct One {
  f32x4 v;
};

inline One operator+(One a, One b) {
  return {a.v + b.v};
}
inline One operator-(One a, One b) {
  return {a.v - b.v};
}
inline One operator*(One a, One b) {
  return {a.v * b.v};
}
inline One operator/(One a, One b) {
  return {a.v / b.v};
}
inline bool operator<(One a, One b) {
  return first_lane(a.v) < first_lane(b.v);
}
inline One sqrt(One a) {
  return {sqrt(a.v)};
}
// GCC turns ?: on two lvalues into a pointer select and spills both; if/return avoids that.
[[gnu::always_inline]] inline One select(bool m, One yes, One no) {
  if (m) return yes;
  return no;
}
inline One only_where(bool m, One a) {
  return {m ? a.v : splat(0.0f)};
}
inline One lesser(One a, One b) {
  return {lesser(a.v, b.v)};
}
inline One greater(One a, One b) {
  return {greater(a.v, b.v)};
}
inline One absolute(One a) {
  return {absolute(a.v)};
}
inline One inverse_length(One squared) {
  return {inverse_length(squared.v)};
}
inline One flip(One a, One by) {
  return {flip(a.v, by.v)};
}

template <class F>
F all_lanes(float value);
template <>
inline float all_lanes(float value) {
  return value;
}
template <>
inline f32x4 all_lanes(float value) {
  return splat(value);
}
template <>
inline One all_lanes(float value) {
  return {splat(value)};
}
// Of rigid.h alone.
template <>
inline double all_lanes(float value) {
  return static_cast<double>(value);
}

}  // namespace marrow
