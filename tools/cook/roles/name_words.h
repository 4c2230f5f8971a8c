// What the words of a joint's name say: "mixamorig:LeftUpLeg" has a side, "up" and "leg".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace marrow::cook {

enum class Side : std::uint8_t { none, left, right };

// "fl", "hr": which of four legs, if a skeleton has such names of all.
enum class Corner : std::uint8_t { none, front_left, front_right, back_left, back_right };

enum class Word : std::uint8_t {
  neutral,  // "bone", "joint", "mixamorig"
  upper,
  lower,
  front,
  back,
  mid,
  leg,
  thigh,
  shin,
  knee,
  ankle,
  foot,
  toe,
  hip,
  pelvis,
  spine,
  chest,
  neck,
  head,
  jaw,
  mouth,
  eye,
  collar,
  shoulder,
  arm,
  humerus,
  forearm,
  elbow,
  wrist,
  hand,
  finger,
  thumb,
  index,
  middle,
  ring,
  little,
  palm,
  tail,
  root,
  deform,     // Rigify's DEF-: the joints that vertices follow
  mechanism,  // its ORG-, which those are made of
  twist,      // turns along with another joint
  control,    // moves others, and carries nothing
  end,        // a point behind the last joint, where nothing hangs on it
  other,      // a part of a body, or something on it, that has no role
  unknown,
};

struct NameWords {
  Side side = Side::none;
  Corner corner = Corner::none;
  std::uint64_t words = 0;           // a bit each
  std::vector<std::string> numbers;  // behind the first word that is not neutral
  std::vector<std::string> unknown;  // in small letters

  void add(Word word) { words |= std::uint64_t{1} << static_cast<unsigned>(word); }
  bool has(Word word) const { return (words >> static_cast<unsigned>(word) & 1) != 0; }
  template <class... More>
  bool has(Word word, More... more) const {
    return has(word) || has(more...);
  }
};

inline bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}
inline char small_letter(char c) {
  return is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c;
}

// Of any name; costs as much as it is long.
NameWords words_of(std::string_view name);

}  // namespace marrow::cook
