// Instances of crowds as the GPU reads them, and the arithmetic of their times: whole numbers, so that the CPU's are
// the same to the last bit.
//
// The clock ticks 2¹⁴ times a second, modulo 2³². A clip's place is a 32-bit share of its duration, 2⁻³² each, modulo
// 1; a rate is a signed share a tick, 2⁻⁴⁸ each, modulo 1.
#pragma once

#include <type_traits>

#include "core/check.h"
#include "gles3/mesh/prepare.h"
#include "gles3/palettes.h"
#include "marrow/gles3_crowd.h"

namespace marrow::gles3 {

// The most frames of a crowd: as many as fit the smallest textures for meshes with one joint.
inline constexpr std::uint32_t kMaxCrowdFrames = 1u << 20;

// What a CrowdMesh keeps in its state: its palette in every frame (RGBA32F), and the instances' palettes at this moment
// (RGBA32UI, the bits of floats, since GLES 3.0 cannot render to floats). A texel is a row of a matrix, a line 2048
// texels.
struct CrowdMeshState {
  GpuMesh gpu = {};                   // its vertices
  std::uint32_t frames_texture = 0;   // palettes of all frames
  std::uint32_t blended_texture = 0;  // palettes of the instances
  std::uint32_t framebuffer = 0;      // around the blended texture
  // Only with motion: the instances' palettes in the previous frame. begin_frame() swaps the two textures.
  std::uint32_t previous_texture = 0;
  std::uint32_t previous_framebuffer = 0;  // around the previous texture
  std::uint32_t joints = 0;                // matrices of a palette
  Span<Affine> bind = {};                  // what palettes are built with
  Span<std::byte> scratch = {};            // of prepare(), and of palettes on their way up
};
static_assert(sizeof(CrowdMeshState) <= sizeof(CrowdMesh::state) && alignof(CrowdMeshState) <= alignof(void*));
static_assert(std::is_trivially_copyable_v<CrowdMeshState>);

inline CrowdMeshState& state_of(CrowdMesh& mesh) {
  return *reinterpret_cast<CrowdMeshState*>(mesh.state);
}
inline const CrowdMeshState& state_of(const CrowdMesh& mesh) {
  return *reinterpret_cast<const CrowdMeshState*>(mesh.state);
}

// How many palettes of `joints` matrices a texture of the caps' size holds. It limits the frames of a mesh, and the
// instances.
std::uint32_t crowd_palettes_that_fit(const Caps& caps, std::uint32_t joints);

// The program for blend_crowd(). Errors: gl_error, with the driver's words in `log`. Cost: a compile.
Status create_crowd_program(const Api& api, Program& out, Span<char> log = {});

// crowd_joint() of all joints; out: at least frames.joint_count.
Status crowd_pose(const CrowdFrames& frames, const CrowdInstance& instance, double time_s,
                  Span<Affine> model_from_joint);

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
