// What a game asks of a clip beside its poses: how fast it goes, what happens in it, where its steps are, where its
// root moves. A view, from a file or made by hand; events.h, root_motion.h, phase.h and blend_space.h read it.
#pragma once

#include <cstdint>

#include "marrow/api.h"
#include "marrow/span.h"

namespace marrow {

// Something that happens in a clip: a moment, as a blow that lands, or a span, as a foot that stands.
struct ClipEvent {
  float time_s = 0;        // 0 … the clip's duration
  float until_s = 0;       // ≥ time_s; equal: a moment. Beyond the clip's end it goes on at its start
  std::uint32_t name = 0;  // see File::text
  float number = 0;        // whatever the game means by it
};
static_assert(sizeof(ClipEvent) == 16);

// M(t): where the root has moved since the clip's start, in model space. Between keys the translation is linear; the
// rotation is the normalised sum of the two quaternions (nlerp), on the shorter arc, so keys are less than half a turn
// apart. Before the first key and after the last M stays.
struct RootKey {
  float time_s;          // 0 … the clip's duration
  float rotation[4];     // unit quaternion x, y, z, w
  float translation[3];  // metres
};
static_assert(sizeof(RootKey) == 32);

// A clip's motion.
struct ClipMotion {
  float duration_s = 0;               // the clip's; ≥ 0
  float speed_m_s = 0;                // over the ground, ≥ 0, also of a clip that walks on the spot
  float heading[3] = {};              // where to: of unit length, model space; 0: nowhere
  Span<const ClipEvent> events = {};  // by time_s
  // Where the segments of a cycle begin, see phase.h: at most kMaxMarks, 0 … below the duration. Each is later than the
  // one before. A cycle may begin anywhere in the clip, so once at most they go on at the clip's start.
  Span<const float> phase_marks = {};
  Span<const RootKey> root = {};  // by time, strictly; the first is the identity; empty: the root stays
};

// A cycle has as many segments as phase marks, and no group of clips has a cycle of more: see phase.h.
inline constexpr std::uint32_t kMaxMarks = 64;
// Distances and times of a motion are at most this, in metres and seconds.
inline constexpr float kFarthestMotion = 1e12f;

// Whether a motion keeps these rules: numbers finite, spans and marks in order, an event no longer than the clip,
// rotations of unit length within 1e-3. Call it once for a motion that is made by hand; the functions that read motions
// do not. Cost: once over it all.
MARROW_API bool is_valid(const ClipMotion& motion);

}  // namespace marrow
