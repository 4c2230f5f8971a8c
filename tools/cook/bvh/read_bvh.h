// Reads motion capture in BVH files: a skeleton in its rest pose, without rotations, and one clip.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "cook/scene/raw.h"
#include "marrow/cook_host.h"

namespace marrow::cook {

// A scene of nodes, one skin without a mesh that names the joints, and one clip that is called as the file, with a key
// at every frame. Lengths are the file's own, whatever its unit is. End Sites are nodes, but no joints.
//
// The file is hostile until proven otherwise: what it takes in memory is bounded by what it holds.
// Throws tools::Failure (io: cannot be read; invalid: is no whole BVH file; unsupported: a limit), located by the line.
RawScene read_bvh(const std::string& name, Files& files);

// The same for a file in memory. `name` is for failures and for the clip.
RawScene read_bvh(const std::string& name, std::span<const std::byte> bytes);

}  // namespace marrow::cook
