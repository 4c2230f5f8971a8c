// A sub-track that does not move: the numbers that stand for it once a clip.
#pragma once

#include "asset/format.h"
#include "cook/clip/compress/choose_steps.h"

namespace marrow::cook {

struct ConstantTrack {
  TrackId id;
  format::Constant numbers;
};

// The numbers closest to a rotation among many factors of its quaternion: off by a few 1e-6 rad.
format::Constant code_rotation(const glm::dquat& q);
glm::dquat decode_rotation(const format::Constant& constant);

// The numbers closest to a difference from the rest pose: off by 1/65534 of its largest component at most.
format::Constant code_offset(const glm::dvec3& offset);
glm::dvec3 decode_offset(const format::Constant& constant);

}  // namespace marrow::cook
