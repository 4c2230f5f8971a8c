// Transition: from one clip to the next, by cross-fading (both are sampled) or by inertialisation (only the
// new one is).
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// How a weight goes from 0 to 1; u = time / duration. curve.h has more shapes.
enum class Fade : std::uint8_t {
  linear,        // u
  smoothstep,    // 3 u² - 2 u³: no jump of speed
  smootherstep,  // 6 u⁵ - 15 u⁴ + 10 u³: no jump of acceleration
};

// The new clip's weight, `time_s` after the fade began. It is exactly 0 at times ≤ 0 and if time_s is not a number, and
// exactly 1 from duration_s on. If duration_s is not above 0, it is 1 at every time above 0.
MARROW_API float fade_weight(Fade shape, float time_s, float duration_s);

// blend() of two poses: weight 0 gives `from`, weight 1 gives `to`, both bit for bit.
// from, to, out: at least skeleton.soa_size(); out may be either of the poses.
// Errors: bad_argument if a span is too short or the weight not in 0 … 1.
MARROW_API Status cross_fade(const Skeleton& skeleton, Span<const SoaTransform> from, Span<const SoaTransform> to,
                             float weight, Span<SoaTransform> out);

// How far four joints are from the new clip's pose, and how that fades. Each of the nine components of a joint, x y z
// of the translation, of the rotation vector (axis times angle, in the parent's axes) and of the scale, fades by
// itself:
//   offset(t) = (1 - s)⁴ (start + slope s) with s = min(rate t, 1).
struct alignas(16) InertialOffset {
  float start[9][4];  // metres, radians, factors
  float slope[9][4];  // over the whole fade
  float rate[9][4];   // 1 / seconds
};

// A transition under way; the memory is the caller's and can be used again for the next one.
struct Inertia {
  Span<InertialOffset> offsets = {};  // at least skeleton.soa_size()
  float duration_s = 0.0f;            // 0: none, or over
};

// What was shown in the last two frames, and what the new clip would show.
struct InertialStart {
  Span<const SoaTransform> before = {};      // the pose shown one frame before `now`
  Span<const SoaTransform> now = {};         // the pose shown last
  Span<const SoaTransform> target = {};      // the new clip at the time of `now`
  Span<const SoaTransform> target_was = {};  // the new clip one frame earlier; empty: as if it stood still
  float frame_s = 0.0f;                      // time from `before` to `now`, > 0; less than 1e-6 counts as 1e-6
};

// Captures the offset and its velocity; from then on only the new clip is sampled, and apply_inertia() gives what is
// shown.
//
// Inertialisation: D. Bollo, GDC 2018. Each component is a quintic: at the start it has the offset's value and
// velocity; at the end its value, velocity, acceleration and jerk are 0. It is in the factored form above. A component
// whose velocity would take it past zero before duration_s ends sooner, 5 start / -velocity after the beginning; so no
// offset changes its sign. Unlike Bollo's, x, y and z fade separately, not as a length along a fixed axis: the whole
// velocity is carried over, not only its part along the offset. A growing turn is limited to less than a whole turn. A
// turn of more than a quarter in one frame is not carried over faithfully.
// Rotations must be unit quaternions, translations and scales at most 1e15: then all is finite, here and below. To
// begin a new transition in the middle of another, pass the poses that were shown. Errors: bad_argument if a span is
// too short, or frame_s or duration_s is not above 0 and finite, or duration_s is above 1e6. Cost: two logarithms of
// quaternions a joint, four joints at a time; no allocation.
MARROW_API Status begin_inertia(const Skeleton& skeleton, const InertialStart& start, float duration_s,
                                Inertia& inertia);

// pose: in, the new clip's pose `time_s` after the beginning; out, the pose to show. From duration_s on, and without a
// begin_inertia() before, the pose keeps its bits. Times below 0 count as 0.
// Errors: bad_argument if a span is too short or time_s not a number.
// Cost: nine quintics and one exponential a joint, four joints at a time.
MARROW_API Status apply_inertia(const Skeleton& skeleton, const Inertia& inertia, float time_s,
                                Span<SoaTransform> pose);

}  // namespace marrow
