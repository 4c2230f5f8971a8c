// Instances of crowds as the GPU reads them, and the arithmetic of their times: whole numbers, so that the CPU's are
// the same to the last bit.
//
// The clock ticks 2¹⁴ times a second, modulo 2³². A clip's place is a 32-bit share of its duration, 2⁻³² each, modulo
// 1; a rate is a signed share a tick, 2⁻⁴⁸ each, modulo 1.
#pragma once

#include "core/check.h"
#include "marrow/gles3_crowd.h"

namespace marrow::gles3 {

// place = phase + rate · clamp(now - start, least, most): of a clip that loops the limits are none.
struct CrowdClockwork {
  std::uint32_t start;
  std::uint32_t phase;
  std::uint32_t rate_high;
  std::uint32_t rate_low_steps;  // the rate's lowest 16 bits, and above them the clip's steps
};
struct CrowdRange {
  std::int32_t least, most;  // ticks
  std::uint32_t first_frame;
};

// Eight texels, RGBA32UI; floats by their bits.
struct CrowdRecord {
  Affine world_from_model;
  float colour[4];
  CrowdClockwork a;
  CrowdRange range_a;
  std::uint32_t blend_start;  // ticks
  CrowdClockwork b;
  CrowdRange range_b;
  float blend_rate;  // share a tick; 0: a alone
};
static_assert(sizeof(CrowdRecord) == kCrowdInstanceBytes);

// Whether the clock goes so far; precondition of ticks_of().
bool has_ticks(double time_s);
std::uint32_t ticks_of(double time_s);

// See crowd_joint().
BadCall check_frames(const CrowdFrames& frames);
BadCall check_instance(const CrowdFrames& frames, const CrowdInstance& instance);
// Precondition: checked.
CrowdRecord record_of(const CrowdFrames& frames, const CrowdInstance& instance);

// Which frames count, and how much. A share of 0 means that the frame is not to be read.
struct CrowdShares {
  std::uint32_t frames[4];  // a, the one behind it, b, the one behind it
  float shares[4];
};
CrowdShares shares_of(const CrowdRecord& record, std::uint32_t now);

}  // namespace marrow::gles3
