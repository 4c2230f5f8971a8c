// A clip as a file has it: what moves, and numbers beside it.
#pragma once

#include "marrow/api.h"
#include "marrow/pose.h"
#include "marrow/span.h"

namespace marrow {

// No clip: a skeleton rests.
inline constexpr std::uint32_t kNoClip = 0xFFFFFFFF;

// Which part of a local transform a Track drives.
enum class TrackPath : std::uint8_t { translation, rotation, scale };
// What lies between two keys, as glTF 2.0 defines it.
enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

// One channel of a clip stored without loss: the source's own keys at the source's own times.
struct Track {
  std::uint16_t joint = 0;                            // of the skeleton
  TrackPath path = TrackPath::translation;            // what of the joint it drives
  Interpolation interpolation = Interpolation::step;  // between its keys
  std::uint32_t key_count = 0;                        // ≥ 1
  std::uint32_t first_time = 0;                       // into Clip::times_s; tracks with the same keys share them
  // Into Clip::values; 3 or 4 floats a key, thrice that for cubic_spline (in, value, out).
  std::uint32_t first_value = 0;
};
static_assert(sizeof(Track) == 16);

// For a group of four joints: which sub-tracks (a joint's rotation, translation or scale) move in a clip, and which
// hold one value that is not the rest pose's. Bits 0-3 are rotations, 4-7 translations, 8-11 scales; the lowest bit is
// the first joint.
struct GroupMasks {
  std::uint16_t moving = 0;    // sub-tracks that change over the clip
  std::uint16_t constant = 0;  // sub-tracks that hold one value, not the rest pose's
};
static_assert(sizeof(GroupMasks) == 4);

// A number over time, such as a morph target's weight or a property of the game; it moves no joint. Stored without
// loss, except that keys on a straight line between others may have been left out (docs/cooking/clips.md).
struct Channel {
  std::uint32_t name = 0;         // see File::text
  float rest = 0;                 // the number where no clip drives it
  std::uint32_t key_count = 0;    // ≥ 1
  std::uint32_t first_time = 0;   // as in Track
  std::uint32_t first_value = 0;  // into Clip::values; one float a key, three for cubic_spline (in, value, out)
  Interpolation interpolation = Interpolation::step;  // between its keys
  std::uint8_t reserved[3] = {};
};
static_assert(sizeof(Channel) == 24);
// No channel.
inline constexpr std::uint32_t kNoChannel = 0xFFFFFFFF;

// Tracks compressed within a stated error (docs/format.md): poses at even steps of time, or at times of their own. They
// are divided into segments of packed integers, relative to the rest pose. What does not move is stored once.
struct CodedTracks {
  std::uint32_t frame_count = 0;                   // 0: the clip has no coded tracks; else ≥ 2
  std::uint32_t track_count = 0;                   // sub-tracks that move
  std::uint32_t constant_count = 0;                // sub-tracks that hold one value, not the rest pose's
  std::uint32_t segment_intervals = 0;             // time steps in a segment; the last may have fewer
  float start_s = 0;                               // of frame 0
  float frames_per_s = 0;                          // the mean rate where steps are uneven
  const float* times_s = nullptr;                  // frame_count, ascending; null: even steps
  const GroupMasks* masks = nullptr;               // one a group of four joints
  const std::uint32_t* segment_offsets = nullptr;  // bytes into payload
  const std::byte* constants = nullptr;            // their values
  const std::byte* payload = nullptr;              // segments of packed integers

  // Seconds of a frame.
  float time_of(std::uint32_t frame) const {
    return times_s != nullptr ? times_s[frame] : start_s + static_cast<float>(frame) / frames_per_s;
  }
};

// An animation of one skeleton, and of numbers. Joints without a track keep their rest pose.
struct Clip {
  const char* name = "";                    // as the source calls it; never null
  std::uint32_t skeleton = 0;               // which skeleton of the file; in a clip pack, which reference
  std::uint32_t joint_count = 0;            // of that skeleton
  float duration_s = 0;                     // time of the last key; ≥ 0
  bool additive = false;                    // for sample_additive(), not for sample()
  const SoaTransform* reference = nullptr;  // additive: the pose that changes are relative to; null: the rest pose
  CodedTracks coded = {};                   // what is compressed
  Span<const Track> tracks = {};            // what is stored without loss
  Span<const Channel> channels = {};        // numbers that it drives
  const float* times_s = nullptr;           // key times of tracks and channels, seconds
  const float* values = nullptr;            // keys of tracks and channels
  std::uint64_t id = 0;  // of its bytes and its place in the file, from File::clip(); 0: made by hand
};

}  // namespace marrow
