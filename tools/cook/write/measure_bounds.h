// What every mesh reaches in every clip: boxes and spheres about all that the written file can show.
#pragma once

#include <cstdint>
#include <vector>

#include "asset/format.h"
#include "common/aligned_bytes.h"

namespace marrow::cook {

// What one BNDS section holds.
struct MeasuredBounds {
  format::BoundsHeader header{};
  std::vector<format::BoundsCodes> codes;
};

// One for each skeleton that has clips and meshes, in their order. file: not packed, accepted by load().
//
// Poses are taken at every key, just before it where a value jumps, and between two keys in the middle and as often as
// gaps are 1/60 s; vertices are skinned by all deformers that a mesh was cooked for, at all levels of detail. What a
// curve between two poses may add is added. Codes are rounded outwards. Cost: of the order of a CPU-skinned playback;
// of clips of more than 60 million vertices keys are left out evenly.
// None of a skeleton whose meshes, times the moments of a clip, are more than a million: as of a thousand meshes in a
// clip of 16 s.
std::vector<MeasuredBounds> measure_bounds(const tools::AlignedBytes& file);

// The moments of a clip whose poses measure_bounds() takes, ascending; `is_key` says which are keys.
struct Moments {
  std::vector<float> times_s;
  std::vector<char> is_key;
};
Moments moments_of(const Clip& clip, std::size_t most);

// The finest codes of a box and a radius about the decoded box's centre, not smaller than them. What is not finite, or
// beyond 10³², becomes the largest there is.
format::BoundsCodes encode_box(const double (&least)[3], const double (&most)[3]);
std::uint8_t encode_radius(const format::BoundsCodes& box, double radius);

}  // namespace marrow::cook
