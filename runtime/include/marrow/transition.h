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

// The new clip's weight, `time_s` after the fade began: exactly 0 at or before 0 and for what is not a number, exactly
// 1 from duration_s on (at once if that is not above 0).
MARROW_API float fade_weight(Fade shape, float time_s, float duration_s);

// blend() of two poses: from at weight 0, to at weight 1, both bit for bit.
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
  Span<const SoaTransform> before = {};      // shown one frame earlier
  Span<const SoaTransform> now = {};         // shown last
  Span<const SoaTransform> target = {};      // the new clip at the time of `now`
  Span<const SoaTransform> target_was = {};  // the new clip one frame earlier; empty: taken to stand still
  float frame_s = 0.0f;                      // between the two, > 0; less than 1e-6 counts as that
};

// Captures the offset and its velocity; from then on only the new clip is sampled, and apply_inertia() gives what is
// shown.
//
// Inertialisation: D. Bollo, GDC 2018. Each component is the quintic with the offset's value and velocity at the start,
// and value, velocity, acceleration and jerk 0 at the end, in the factored form above. A component on its way to zero
// that would pass it before duration_s ends sooner, 5 start / -velocity after the beginning, so no offset
// changes its sign. Other than there, x, y and z are not reduced to a length on a fixed axis, so the whole velocity
// is carried over and not only its part along the offset. The growth of a turn is limited so that it stays below a
// whole one; a turn of more than a quarter in one frame is not carried over faithfully.
// Rotations must be unit quaternions, translations and scales at most 1e15: then all is finite, here and below. To
// begin anew in the middle of a transition, pass the poses that were shown. Errors: bad_argument if a span is too
// short, or frame_s or duration_s is not above 0 and finite, or duration_s is above 1e6. Cost: two logarithms of
// quaternions a joint, four joints at a time; no allocation.
MARROW_API Status begin_inertia(const Skeleton& skeleton, const InertialStart& start, float duration_s,
                                Inertia& inertia);

// pose: in, the new clip's pose `time_s` after the beginning; out, what is to be shown. From duration_s on, and before
// any begin_inertia(), the pose keeps its bits. Times below 0 count as 0.
// Errors: bad_argument if a span is too short or time_s not a number.
// Cost: nine quintics and one exponential a joint, four joints at a time.
MARROW_API Status apply_inertia(const Skeleton& skeleton, const Inertia& inertia, float time_s,
                                Span<SoaTransform> pose);

}  // namespace marrow
