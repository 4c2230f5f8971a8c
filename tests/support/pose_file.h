// A loaded file taken through every stage after load, for tests that ask whether anything goes wrong.
#pragma once

#include <cstdint>
#include <vector>

#include "marrow/marrow.h"

namespace marrow::test {

// The documented checksum, written into the header: what a forger would do, so that the rules behind it are tested too.
// Does nothing to blocks shorter than a header.
void forge_checksum(std::byte* block, std::size_t size);

struct PosedMesh {
  std::vector<float> positions, normals, tangents;  // by slot; the last two empty if the mesh has none
};

// FNV-1a over every number that came out, so that nothing is optimised away and results can be compared.
std::uint64_t hash(std::uint64_t state, const void* data, std::size_t bytes);
inline constexpr std::uint64_t kHashStart = 14695981039346656037u;

enum class Deformer { rigid, ssd, as };

// Clip, time → vertices of one mesh, which plays the clip of that name for its skeleton. clip ≥ clip_count(): the rest
// pose. cycle: if not empty, the weights of the mesh's morph targets in turn, instead of the clip's. Expects every
// stage to succeed.
PosedMesh pose_mesh(const File& file, std::uint32_t clip, float time_s, std::uint32_t mesh, Deformer deformer,
                    const std::vector<float>& cycle = {});

// Whether every mesh's palette is of finite numbers, in every clip.
bool has_finite_palettes(const File& file);

// Every clip at a few moments, every mesh, every deformer; reads every name and index. Returns a hash of all of it.
std::uint64_t exercise(const File& file);

}  // namespace marrow::test
