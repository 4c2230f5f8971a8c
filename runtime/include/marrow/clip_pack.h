// Clips apart from their character: does a clip pack fit a skeleton, and if not, which joints are in the way.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// Why a joint keeps a clip pack from fitting a skeleton.
enum class Misfit : std::uint8_t {
  missing,       // the skeleton has no joint of this name
  other_parent,  // it has, below another joint
  other_rest,    // it has, with another rest pose, which coded tracks are relative to
  extra,         // a joint of the skeleton that the clips were made without
  other_place,   // all joints are there, this one at another place in the order
};

// A joint that is in the way.
struct JointMisfit {
  Misfit how = Misfit::missing;  // what is wrong with it
  std::uint32_t joint = 0;       // of the pack's reference; `extra`: of the skeleton
};

// A 64-bit hash of a skeleton's joints in their order: names, parents, rest poses bit for bit (docs/format.md, SREF).
// Of a skeleton that is not there it is the hash of no joints. Cost: one pass over the skeleton.
MARROW_API std::uint64_t skeleton_hash(const File& file, std::uint32_t skeleton);

// Whether the clips that a pack has for one of its references may move a skeleton of another file. After `ok`,
// sample() does for every clip of the pack whose Clip::skeleton is `reference` what it would do for the skeleton's
// own. Once a load, not a frame. (Sampling an unfit clip is safe: joints out of range are refused, and within it the
// pose is nonsense.)
//
// misfits: gets the first ones, as many as it holds; misfit_count, if not null, how many there are. Both may be left
// out. What stands above the roots may differ: it does not concern clips.
// Errors: mismatch if the skeletons are not the same; bad_argument if an index is out of range. Cost: one pass over the
// skeleton if it fits; else a search by name a joint. No allocation. Thread-safe.
MARROW_API Status bind_clips(const File& pack, std::uint32_t reference, const File& character, std::uint32_t skeleton,
                             Span<JointMisfit> misfits = {}, std::size_t* misfit_count = nullptr);

}  // namespace marrow
