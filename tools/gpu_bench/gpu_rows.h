// What drawing characters costs on this machine's OpenGL ES, a row a path.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "marrow/gles3_skinner.h"
#include "render/gl.h"

namespace marrow::tools {

struct GpuCase {
  const char* name;  // "1000x3"
  std::uint32_t vertices, joints, characters;
  const char* model;             // null: generated
  bool motion;                   // is also drawn with motion vectors
  std::uint32_t influences = 4;  // of a generated one
};

struct GpuRow {
  std::string name;
  const GpuCase* of = nullptr;
  std::optional<gles3::SkinningPath> path;  // none: a crowd
  gles3::Deformer deformer = gles3::Deformer::ssd;
  std::uint8_t features = 0;  // gles3::kNormals, gles3::kMotion
  double frames_per_s = 0;
  double ns_per_vertex = 0;                 // of a frame from its first call to its last pixel
  std::optional<double> gpu_ns_per_vertex;  // by the driver's own timer, where it has one
};

// Fills in what rows measure, one after the other; rows of one case stand together. Throws Failure (internal) where the
// driver refuses one.
void measure_gpu(const Gl& gl, std::vector<GpuRow>& rows);

// "ubo", … or "crowd".
const char* path_name(std::optional<gles3::SkinningPath> path);

}  // namespace marrow::tools
