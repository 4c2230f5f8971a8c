// A source cooked in memory and posed by the runtime, its vertices put back into the source's order.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "support/aligned.h"
#include "support/double_math.h"
#include "support/pose_file.h"

namespace marrow::test {

// As ReferencePose: every mesh of the file one after the other, each in its source's order.
struct CookedPose {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals, tangents;  // zero where absent
  std::vector<double> tangent_signs;    // 0 where absent
};

// The first clip behind those that the cooker made of the same animation as `clip`: one a skeleton, ascending.
std::uint32_t next_animation(const File& file, std::uint32_t clip);

class Cooked {
 public:
  // Cooks with the vertex order kept; throws what the cooker throws.
  explicit Cooked(const std::string& path);

  const File& file() const { return file_; }
  std::size_t bytes() const { return block_->size(); }
  // clip ≥ clip_count(): the rest pose.
  CookedPose pose(std::uint32_t clip, float time_s, Deformer deformer) const;

 private:
  std::unique_ptr<AlignedBlock> block_;
  File file_;
};

}  // namespace marrow::test
