// What clips are for, by the words of their names and by what they do.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "marrow/character.h"

namespace marrow::tools {

enum class ClipKind {
  idle,
  gait,        // goes ahead over the ground
  sideways,    // or back
  jump_start,  // or all of a jump
  air,
  landing,
  death,
  arms,   // once, with the upper body
  whole,  // once, with all of the body
  pose,   // of rest, for no one to see
  added,  // additive
  other,
};

struct KnownClip {
  std::string name;
  std::vector<std::string> words;  // of the name, in small letters; without those that all clips have
  ClipKind kind = ClipKind::other;
  float duration_s = 0, speed_m_s = 0;
  std::size_t marks = 0;  // of its phase
  std::size_t odd = 0;    // words that say more than its kind, as "crouched": the fewer, the plainer
  int rank = 0;           // of a gait: 1 a walk, 4 a sprint; of what is done once: 0 attacks, 1 hits, 2 all else
  std::string action;     // of what is done once: the word that says what, as "punch"
};

// "Armature|Jump_Start2" → jump, start, 2.
std::vector<std::string> words_of_clip(const std::string& name);

// One a name, in their order. Clips without a name cannot be named in a graph, and are left out.
std::vector<KnownClip> know_clips(Span<const Animation> animations);

}  // namespace marrow::tools
