// A sub-track that does not move: the numbers that stand for it once a clip.
#pragma once

#include "asset/format.h"
#include "cook/clip/compress/choose_steps.h"

namespace marrow::cook {

struct ConstantTrack {
  TrackId id;
  format::Constant numbers;
};

constexpr int kMostConstant = 32767;

// The numbers up to `most` closest to a rotation among many factors of its quaternion: with kMostConstant off by a few
// 1e-6 rad.
format::Constant code_rotation(const glm::dquat& q, int most);
glm::dquat decode_rotation(const format::Constant& constant);

// The numbers up to `most` closest to a difference from the rest pose: off by half a step of 4/3 of its largest
// component / most, at most.
format::Constant code_offset(const glm::dvec3& offset, int most);
glm::dvec3 decode_offset(const format::Constant& constant);

}  // namespace marrow::cook
