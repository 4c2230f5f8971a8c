// A source cooked in memory and posed by the runtime, its vertices put back into the source's order.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "disk/cook_on_disk.h"
#include "support/aligned.h"
#include "support/double_math.h"
#include "support/pose_file.h"

namespace marrow::test {

// As ReferencePose: every mesh of the file one after the other, each in its source's order.
struct CookedPose {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals, tangents;  // zero where absent
  std::vector<double> tangent_signs;    // 0 where absent
  std::vector<bool> used;               // by a triangle; what is not is left out
};

// The first clip behind those that the cooker made of the same animation as `clip`: one a skeleton, ascending.
std::uint32_t next_animation(const File& file, std::uint32_t clip);

class Cooked {
 public:
  // Cooks with the vertex order kept, and clips as they are, whose compression is judged apart, by clip_test.cpp.
  // Throws what the cooker throws.
  explicit Cooked(const std::string& path, cook::MeshCodec codec = cook::MeshCodec::none);
  // As the options have it, with the vertex order kept.
  Cooked(const std::string& path, cook::CookOptions options);

  const File& file() const { return file_; }
  const nlohmann::ordered_json& report() const { return report_; }
  std::size_t bytes() const { return bytes_; }  // as cooked
  // clip ≥ clip_count(): the rest pose. cycle: as pose_mesh().
  CookedPose pose(std::uint32_t clip, float time_s, Deformer deformer, const std::vector<float>& cycle = {}) const;

 private:
  std::unique_ptr<AlignedBlock> block_;
  File file_;
  nlohmann::ordered_json report_;
  std::size_t bytes_ = 0;
};

}  // namespace marrow::test
