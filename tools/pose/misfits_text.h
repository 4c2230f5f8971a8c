// Which joints keep a clip pack or an outfit from a skeleton, in words.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

#include "marrow/clip_pack.h"

namespace marrow::tools {

inline constexpr std::size_t kMostMisfits = 12;  // that are listed

// `"hand_l" is missing, "head" has another parent, and 3 more`. count: of misfits in all; own, there: names of joints
// of what was made for a skeleton, and of the skeleton; made: what that is.
template <class Own, class There>
std::string misfits_text(std::span<const JointMisfit> misfits, std::size_t count, const Own& own, const There& there,
                         const std::string& made) {
  std::string text;
  for (std::size_t i = 0; i < std::min(count, misfits.size()); ++i) {
    const JointMisfit& m = misfits[i];
    text.append(i > 0 ? ", " : "").append("\"");
    text.append(m.how == Misfit::extra ? there(m.joint) : own(m.joint)).append("\"");
    text.append(m.how == Misfit::missing        ? " is missing"
                : m.how == Misfit::other_parent ? " has another parent"
                : m.how == Misfit::other_rest   ? " has another rest pose"
                : m.how == Misfit::extra        ? " is not in " + made
                                                : " stands elsewhere");
  }
  if (count > misfits.size()) text.append(", and ").append(std::to_string(count - misfits.size())).append(" more");
  return text;
}

}  // namespace marrow::tools
