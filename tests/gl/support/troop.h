// A crowd on the GPU with all that it needs, and its vertices read back.
#pragma once

#include <vector>

#include "gl/support/feedback.h"
#include "gles3/crowd/crowd.h"
#include "gles3/mesh/gpu_mesh.h"
#include "marrow/gles3_crowd.h"

namespace marrow::test {

// Clips of a skeleton, baked.
struct Reel {
  Reel(const Skeleton& skeleton, std::vector<gles3::CrowdSource> sources, float rate_hz);

  Skeleton skeleton;
  std::vector<gles3::CrowdSource> sources;
  std::vector<gles3::CrowdClip> clips;
  std::vector<Affine> matrices;
  gles3::CrowdFrames frames;
};

// At least so many bytes, 16-byte aligned, for as long as `memory` stays.
inline Span<std::byte> room_for(std::vector<SoaTransform>& memory, std::size_t bytes) {
  memory.resize(bytes / sizeof(SoaTransform) + 1);
  return {reinterpret_cast<std::byte*>(memory.data()), bytes};
}

class Troop {
 public:
  // Fails the current test and leaves ok() false if a step refuses. tangents: from as_tangents(), or empty.
  Troop(const Mesh& mesh, const Reel& reel, std::uint32_t capacity, Span<const float> tangents = {});
  ~Troop();
  Troop(const Troop&) = delete;
  Troop& operator=(const Troop&) = delete;

  bool ok() const { return ok_; }
  const gles3::GpuMesh& gpu() const { return state_of(crowd_mesh_).gpu; }
  const gles3::CrowdMesh& mesh() const { return crowd_mesh_; }
  gles3::Crowd& crowd() { return crowd_; }
  Status set(std::uint32_t first, Span<const gles3::CrowdInstance> instances);
  Status blend(std::uint32_t first, std::uint32_t count, double time_s, const gles3::Api& api = gl());
  // Of each instance its first `vertices` slots, as blended; 0: all.
  std::vector<Skinned> capture(gles3::Deformer deformer, std::uint32_t first, std::uint32_t count,
                               std::uint32_t vertices = 0);

 private:
  const Reel& reel_;
  std::vector<SoaTransform> mesh_memory_, crowd_memory_;
  gles3::CrowdMesh crowd_mesh_;
  gles3::Crowd crowd_;
  tools::GlRenderbuffer colour_;
  tools::GlFramebuffer target_;
  bool ok_ = false;
};

// One of each kind for the whole binary.
const gles3::Program& crowd_program();

}  // namespace marrow::test
