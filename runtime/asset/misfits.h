// What clip packs and outfits have in common: joints found by name, and a list of those that are in the way.
#pragma once

#include <cstring>

#include "marrow/clip_pack.h"

namespace marrow {

// Joints by name and parent, wherever they come from.
struct Joints {
  const File& file;
  const std::uint32_t* names;
  const std::uint16_t* parents;
  std::uint32_t count;

  const char* name(std::uint32_t joint) const { return file.text(names[joint]); }
  // "": none.
  const char* parent_name(std::uint32_t joint) const { return parents[joint] == kNoJoint ? "" : name(parents[joint]); }
  // The joint called so, `likely` if it is; else the first; `count` if there is none.
  std::uint32_t find(const char* wanted, std::uint32_t likely) const {
    if (likely < count && std::strcmp(name(likely), wanted) == 0) return likely;
    std::uint32_t joint = 0;
    while (joint < count && std::strcmp(name(joint), wanted) != 0) ++joint;
    return joint;
  }
};

class Misfits {
 public:
  explicit Misfits(Span<JointMisfit> out) : out_(out) {}
  void add(Misfit how, std::uint32_t joint) {
    if (count_ < out_.size) out_[count_] = {how, joint};
    ++count_;
  }
  std::size_t count() const { return count_; }

 private:
  Span<JointMisfit> out_;
  std::size_t count_ = 0;
};

}  // namespace marrow
