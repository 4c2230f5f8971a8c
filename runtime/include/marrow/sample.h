// Sample: a clip at a time → local transforms of every joint.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// Which joints are sampled.
struct SampleOptions {
  // A level of detail, or any set of joints: joint j is bit j % 32 of word j / 32; at least ⌈joint_count / 32⌉ words.
  // Joints whose bit is 0 keep what `out` holds. Empty: all joints. Every group of four without a joint of the set
  // costs a few operations only.
  Span<const std::uint32_t> joints = {};
};

// What an instance that plays a clip keeps between two calls of sample_cached(). A new cache is empty.
struct SampleCache {
  // The caller's, 16-byte aligned. It holds the two unpacked frames of the clip that the time lies between, so that
  // times between them need no unpacking. If it is empty, or smaller than sample_cache_bytes() of the clip, each call
  // unpacks both frames; only what does not move in the clip is still skipped.
  Span<std::byte> memory = {};
  alignas(8) std::byte state[24] = {};  // sample_cached()'s own
};

// Evaluates `clip` at `time_s`, clamped to each track's first and last key, as glTF 2.0 defines its interpolations:
// STEP, LINEAR (spherical along the shortest arc for rotations) and CUBICSPLINE (Hermite, rotations normalised). Coded
// (compressed) tracks are blended between their two nearest frames, rotations by spherical interpolation; their error
// stays within the cooker's --clip-error.
//
// out: at least skeleton.soa_size() elements, caller's memory; joints that the clip leaves alone get their rest pose.
// Errors: bad_argument if `out` or the set of joints is too short, the clip belongs to a skeleton with other joints or
// is additive, or time_s is not a number. Rotations differ from exact spherical interpolation by at most 1e-6 rad plus
// float rounding. Cost: one binary search for each distinct list of key times and a few dozen operations for each
// track, whatever time_s is. Stateless; thread-safe on different outputs.
MARROW_API Status sample(const Skeleton& skeleton, const Clip& clip, float time_s, Span<SoaTransform> out,
                         const SampleOptions& options = {});

// Bytes of SampleCache::memory for this clip: 160 for each group of four joints in which some rotation changes, and the
// same again for translations and for scales.
MARROW_API std::size_t sample_cache_bytes(const Clip& clip);

// sample() of all joints for an instance that plays on: writes the same bits, but skips what the last call with this
// cache has already done. The cache notices a changed clip, skeleton or `out` and starts anew. It knows a File's clip
// by Clip::id, a clip made by hand by the addresses of its tracks.
//
// out: as in sample(). Nobody else may write to it while the cache is in use, not even to joints that move: a joint
// whose two frames are alike is written once and then skipped until the frames change. To change the pose afterwards,
// copy it or let blend() read it. cache: one for each `out`. If others wrote to `out`, replace the cache by a new one
// with the same memory. Errors: as sample(), and bad_argument if the cache's memory is not on a boundary of 16 bytes;
// the cache then stays as it is. Cost: at most that of sample() and a copy of the frames; about half of sample() for
// keys at 30 Hz that are played at 60 Hz.
MARROW_API Status sample_cached(const Skeleton& skeleton, const Clip& clip, float time_s, Span<SoaTransform> out,
                                SampleCache& cache);

// Evaluates a clip cooked as additive (`marrow cook --additive`). out: the change for add(), from the clip's reference
// pose to the pose that sample() would give of an ordinary clip. Added to the reference with weight 1 it gives that
// pose, within the cooker's --clip-error. A joint that the clip leaves alone is sampled in its rest pose: it does not
// change if the reference has it in its rest pose, too.
//
// out: at least skeleton.soa_size() elements, caller's memory. Errors: as sample(), and bad_argument if the clip is not
// additive. Cost: sample() and make_additive(). Stateless; thread-safe on different outputs.
MARROW_API Status sample_additive(const Skeleton& skeleton, const Clip& clip, float time_s,
                                  Span<AdditiveTransform> out);

// Evaluates the clip's channels at `time_s` as above: out[i] is the value of clip.channels[i].
//
// out: at least clip.channels.size floats. File::find_channel says which channel is which. A number that the clip does
// not drive has no channel and keeps the value that the game gives it. Channels of an additive clip are values, too,
// not changes. Errors: bad_argument if `out` is too short or time_s is not a number. Cost: one binary search for each
// distinct list of key times and a few operations for each channel.
MARROW_API Status sample_channels(const Clip& clip, float time_s, Span<float> out);

}  // namespace marrow
