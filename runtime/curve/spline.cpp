// Keys → Hermite tangents that make the second derivative continuous.
#include <cstring>

#include "core/check.h"
#include "curve/segment.h"

namespace marrow {
namespace {

// One row of the system, a key's: before · m[i-1] + 2 m[i] + after · m[i+1] = 3 (before · slope[i-1] + after ·
// slope[i]), slope being the straight line's to the next key. In words: both parabolas of velocity have the same slope
// at the key.
struct Row {
  float before, after;
};

Row row_of(Span<const float> times_s, std::size_t key) {
  if (key == 0) return {0.0f, 1.0f};
  if (key + 1 == times_s.size) return {1.0f, 0.0f};
  const float left = times_s[key] - times_s[key - 1], right = times_s[key + 1] - times_s[key];
  const float before = right / (left + right);
  return {before, 1.0f - before};
}

// Works in `out`, glTF's layout: in-tangent, value, out-tangent. The out-tangents hold the eliminated right sides, the
// first in-tangent of a key its eliminated upper diagonal, until the way back overwrites both with the solution.
class Solver {
 public:
  Solver(const Curve& keys, float* out) : times_s_(keys.times_s), n_(keys.components), out_(out) {
    for (std::size_t k = 0; k < count(); ++k) {
      std::memcpy(value(k), keys.values.data + k * n_, sizeof(float) * n_);
      if (keys.rotation && k > 0) chain_sign(value(k - 1), value(k));
    }
  }

  // first, last: the tangents there, or null for a natural end.
  void solve(const float* first, const float* last) {
    if (count() == 1) {
      for (std::uint32_t c = 0; c < n_; ++c) {
        leave(0)[c] = last ? last[c] : 0.0f;
        arrive(0)[c] = first ? first[c] : 0.0f;
      }
      return;
    }
    for (std::size_t k = 0; k < count(); ++k) {
      if (k == 0 && first) {
        fix(k, first);
      } else if (k + 1 == count() && last) {
        fix(k, last);
      } else {
        eliminate(k);
      }
    }
    for (std::size_t k = count(); k-- > 0;) {
      const float upper = arrive(k)[0];
      for (std::uint32_t c = 0; c < n_; ++c) {
        if (k + 1 < count()) leave(k)[c] -= upper * leave(k + 1)[c];
        arrive(k)[c] = leave(k)[c];
      }
    }
  }

 private:
  std::size_t count() const { return times_s_.size; }
  float* arrive(std::size_t key) const { return out_ + 3 * n_ * key; }
  float* value(std::size_t key) const { return arrive(key) + n_; }
  float* leave(std::size_t key) const { return value(key) + n_; }

  void fix(std::size_t key, const float* tangent) {
    arrive(key)[0] = 0.0f;
    std::memcpy(leave(key), tangent, sizeof(float) * n_);
  }

  void eliminate(std::size_t key) {
    const Row row = row_of(times_s_, key);
    const float upper_before = key > 0 ? arrive(key - 1)[0] : 0.0f;
    const float pivot = 2.0f - row.before * upper_before;  // at least 1
    for (std::uint32_t c = 0; c < n_; ++c) {
      float right = 0.0f;
      if (key > 0) right += row.before * (3.0f * slope(key - 1, c) - leave(key - 1)[c]);
      if (key + 1 < count()) right += row.after * (3.0f * slope(key, c));
      leave(key)[c] = right / pivot;
    }
    arrive(key)[0] = row.after / pivot;
  }

  float slope(std::size_t key, std::uint32_t c) const {
    return (value(key + 1)[c] - value(key)[c]) / (times_s_[key + 1] - times_s_[key]);
  }

  Span<const float> times_s_;
  std::size_t n_;
  float* out_;
};

BadCall check_keys(const Curve& keys, Span<float> out) {
  MARROW_CHECK(keys.kind == CurveKind::linear);
  MARROW_CHECK(holds(out, curve_value_count(CurveKind::hermite, keys.components, keys.times_s.size)));
  return {};
}

Status solve(const Curve& keys, const float* first, const float* last, float* out) {
  Solver(keys, out).solve(first, last);
  const std::size_t count = curve_value_count(CurveKind::hermite, keys.components, keys.times_s.size);
  return all_finite(out, count) ? Status::ok : Status::bad_data;
}

}  // namespace

Status natural_spline(const Curve& keys, Span<float> out) {
  MARROW_REQUIRE_GOOD(check_counts(keys));
  if (const Status status = check_curve(keys); status != Status::ok) return status;
  MARROW_REQUIRE_GOOD(check_keys(keys, out));
  return solve(keys, nullptr, nullptr, out.data);
}

Status clamped_spline(const Curve& keys, Span<const float> first_velocity, Span<const float> last_velocity,
                      Span<float> out) {
  MARROW_REQUIRE_GOOD(check_counts(keys));
  if (const Status status = check_curve(keys); status != Status::ok) return status;
  MARROW_REQUIRE_GOOD(check_keys(keys, out));
  MARROW_REQUIRE(holds(first_velocity, keys.components) && holds(last_velocity, keys.components));
  return solve(keys, first_velocity.data, last_velocity.data, out.data);
}

}  // namespace marrow
