// The self-test's meshes and poses: made of numbers that look like noise and are the same everywhere.
#pragma once

#include "core/memory.h"
#include "marrow/file.h"

namespace marrow::gles3 {

inline constexpr std::uint32_t kProbeCharacters = 2;
inline constexpr std::uint32_t kProbeFrames = 2;

struct ProbeShape {
  Span<const Run> runs;
  std::uint32_t joints;
};
// Runs of 1 to 4 influences, joints in a byte each; and runs of 1 to 8 over the largest palette that a uniform block
// holds, joints in 16 bits each. Slots: 36, 48.
inline constexpr std::size_t kProbeShapes = 2;
ProbeShape probe_shape(std::size_t which);

// The first with more vertices, to be timed: `runs`, filled in, are to stay.
ProbeShape timed_shape(std::uint32_t vertices, Run (&runs)[4]);

// Positions within half a metre of an axis 2 m long, unit normals and tangents, positive weights, small residuals of
// animation space; indices are the slots in order. The arrays are taken from `memory`; where that only counts, those
// of the mesh are not to be read.
Mesh make_probe_mesh(const ProbeShape& shape, Memory& memory);

// Where a character's joints are: turned by up to 33°, scaled unevenly by 0.8 to 1.25, some 100 m from the origin. Each
// frame and character has a pose of its own.
void pose_probe(std::uint32_t frame, std::uint32_t character, Span<Affine> model_from_joint);

}  // namespace marrow::gles3
