// What a row of `marrow bench --gpu` does in a frame.
#pragma once

#include <cstdint>
#include <memory>

#include "gpu_bench/gpu_rows.h"
#include "marrow/file.h"
#include "render/gl.h"

namespace marrow::tools {

class GpuWork {
 public:
  virtual ~GpuWork() = default;
  virtual void frame() = 0;
  std::uint64_t vertices() const { return vertices_; }

 protected:
  explicit GpuWork(std::uint64_t vertices) : vertices_(vertices) {}

 private:
  std::uint64_t vertices_;  // a frame
};

// Few pixels: what is measured is vertices.
class GpuTarget {
 public:
  // Bound. `gl` outlives it.
  explicit GpuTarget(const Gl& gl);
  void bind() const;

 private:
  static constexpr int kSide = 16;
  const Gl& gl_;
  GlRenderbuffer colour_;
  GlFramebuffer framebuffer_;
};

// What is drawn, in memory that outlives the work; generated meshes have no skeleton and no clip.
struct GpuSubject {
  Mesh mesh;
  Skeleton skeleton;
  Clip clip;
};

// The mesh as the row's characters, by its path. Crowds play the clip, each character at a moment of its own; others
// keep a pose of noise. Throws Failure (internal) where the driver refuses.
std::unique_ptr<GpuWork> make_gpu_work(const Gl& gl, const GpuTarget& target, const GpuRow& row,
                                       const GpuSubject& subject);

}  // namespace marrow::tools
