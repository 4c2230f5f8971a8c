// Clips apart from their character: does a clip pack fit a skeleton, and if not, which joints are in the way.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// Why a joint keeps a clip pack from fitting a skeleton.
enum class Misfit : std::uint8_t {
  missing,       // the skeleton has no joint of this name
  other_parent,  // it has one, below another joint
  other_rest,    // it has one with another rest pose, which coded tracks are relative to
  extra,         // the skeleton has a joint that the clips were made without
  other_place,   // all joints are there, but this one has another number
};

// A joint that is in the way.
struct JointMisfit {
  Misfit how = Misfit::missing;  // what is wrong with it
  std::uint32_t joint = 0;       // index in the pack's reference; for `extra` in the skeleton
};

// A 64-bit hash of a skeleton's joints in their order: names, parents, rest poses bit for bit (docs/format.md, SREF).
// An index without a skeleton gives the hash of no joints. Cost: one pass over the skeleton.
MARROW_API std::uint64_t skeleton_hash(const File& file, std::uint32_t skeleton);

// Whether a pack's clips for one of its references can move a skeleton of another file. After `ok`, sample() treats
// every clip of the pack whose Clip::skeleton is `reference` like the skeleton's own clips. Once a load, not a frame.
// (Sampling a clip that does not fit is safe: joints out of range are refused; otherwise the pose is nonsense.)
//
// misfits: gets as many of the first misfits as it holds. misfit_count, if not null, gets their total number. Both may
// be left out. The transforms above the roots may differ: they do not concern clips. Errors: mismatch if the skeletons
// are not the same; bad_argument if an index is out of range. Cost: one pass over the skeleton if it fits; else a
// search by name a joint. No allocation. Thread-safe.
MARROW_API Status bind_clips(const File& pack, std::uint32_t reference, const File& character, std::uint32_t skeleton,
                             Span<JointMisfit> misfits = {}, std::size_t* misfit_count = nullptr);

}  // namespace marrow
