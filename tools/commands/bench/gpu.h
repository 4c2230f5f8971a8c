// `marrow bench --gpu`: what drawing characters costs on this machine's OpenGL ES, by every path.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "marrow/gles3_skinner.h"
#include "render/gl.h"

namespace marrow::tools {

struct GpuBenchArguments {
  bool wanted = false;
  std::string only = "*";
  std::string chart;  // OUT.svg; empty: none
  bool json = false;
};

// Throws Failure: unsupported without OpenGL ES; usage if no row is selected.
void run_gpu_bench(const GpuBenchArguments& arguments);

// The names of all rows, alternatives in braces.
std::string gpu_row_names();

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

// Bars of ns a vertex: a group a case, a pair of SSD and animation space a path.
std::string gpu_chart(const std::vector<GpuRow>& rows, const std::string& driver);

}  // namespace marrow::tools
