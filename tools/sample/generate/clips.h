// The newt's animation clips as keyed tracks, ready to be written.
#pragma once

#include <string>
#include <vector>

#include "newt_skeleton.h"

namespace marrow::sample {

enum class Interpolation { linear, step, cubic };
enum class Path { translation, rotation, scale };

// What a track moves: a joint by its index, or a face part by kFaceTarget + FacePart.
inline constexpr int kFaceTarget = kJointCount;

struct Track {
  int target = 0;
  Path path = Path::rotation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;
  std::vector<float> values;  // cubic: in-tangent, value, out-tangent per key
};

struct Clip {
  std::string name;
  std::vector<Track> tracks;
  std::vector<std::string> events;  // as Marrow's cooker takes them: NAME@TIME
};

// Of the sample itself.
std::vector<Clip> make_clips();
// What a game needs of it besides: moves.h, with the sample's own walk and idling.
std::vector<Clip> make_moves();

}  // namespace marrow::sample
