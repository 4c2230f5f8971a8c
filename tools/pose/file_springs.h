// Spring bones that a file came with, swinging.
#pragma once

#include <vector>

#include "common/aligned_bytes.h"
#include "marrow/file.h"
#include "marrow/springs.h"

namespace marrow::tools {

class FileSprings {
 public:
  // At rest in whatever pose comes first. `file` outlives it.
  explicit FileSprings(const File& file);

  bool has(std::uint32_t skeleton) const { return skeletons_[skeleton].springs.group_count > 0; }
  bool has_any() const;
  // frame: its colliders are the file's. pose: of that skeleton, as simulate_springs() has it.
  void swing(std::uint32_t skeleton, SpringFrame frame, const Pose& pose);

 private:
  struct Swinging {
    AlignedBytes memory;
    Springs springs;
  };
  const File* file_;
  std::vector<Swinging> skeletons_;
};

}  // namespace marrow::tools
