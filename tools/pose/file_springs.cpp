#include "pose/file_springs.h"

#include <algorithm>

#include "common/check_status.h"

namespace marrow::tools {

FileSprings::FileSprings(const File& file) : file_(&file), skeletons_(file.skeleton_count()) {
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s) {
    std::vector<SpringChain> chains;
    for (std::uint32_t i = 0; i < file.spring_count(s); ++i) chains.push_back(file.spring(s, i));
    if (chains.empty()) continue;
    const Skeleton skeleton = file.skeleton(s);
    const Span<const SpringChain> all(chains.data(), chains.size());
    Swinging& to = skeletons_[s];
    to.memory = AlignedBytes(springs_bytes(skeleton, all));
    check(make_springs(skeleton, all, {to.memory.data(), to.memory.size()}, to.springs));
  }
}

bool FileSprings::has_any() const {
  return std::ranges::any_of(skeletons_, [](const Swinging& s) { return s.springs.group_count > 0; });
}

void FileSprings::swing(std::uint32_t skeleton, SpringFrame frame, const Pose& pose) {
  frame.colliders = file_->spring_colliders(skeleton);
  check(simulate_springs(pose, frame, skeletons_[skeleton].springs));
}

}  // namespace marrow::tools
