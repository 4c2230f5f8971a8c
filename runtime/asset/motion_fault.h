// The rules of clip_motion.h: what load() and is_valid() ask.
#pragma once

#include "marrow/clip_motion.h"

namespace marrow {

// A broken rule, and the event, mark or key that breaks it; null: it is about the motion as a whole.
struct MotionFault {
  const void* where = nullptr;
  const char* rule = nullptr;  // null: all is well
};

// The first broken rule. The spans hold what they say.
MotionFault find_fault(const ClipMotion& motion);
// Of the phase marks alone; the duration is finite and not below 0.
MotionFault find_fault_of_marks(const ClipMotion& motion);

}  // namespace marrow
