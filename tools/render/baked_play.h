// A play as crowds have it: clips baked into textures, and a crowd of one that plays them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/aligned_bytes.h"
#include "marrow/gles3_crowd.h"
#include "pose/evaluate.h"
#include "render/gl.h"

namespace marrow::tools {

class BakedPlay {
 public:
  // Bakes at 30 Hz; skeletons that play nothing rest. tangents: of each mesh at this level, from as_tangents(), or
  // empty. path: of `file`, for messages. `gl`, `programs`, `file` and `tangents` outlive it. Throws Failure
  // (unsupported): morph targets that the play moves, an additive clip, more frames than crowds have.
  BakedPlay(const Gl& gl, const gles3::ProgramSet& programs, const std::string& path, const File& file,
            const Play& play, std::uint32_t level, const std::vector<std::vector<float>>& tangents);
  ~BakedPlay();
  BakedPlay(const BakedPlay&) = delete;
  BakedPlay& operator=(const BakedPlay&) = delete;

  // Precondition: `programs` has those of crowds. All palettes as they are at this moment of the play, before its start
  // or after its end as there. Leaves GL as blend_crowd() does, at kPaletteUnit.
  void blend(float time_s);

  // What bind_crowd() wants to draw a mesh: its instance 0.
  const gles3::Crowd& crowd(std::uint32_t mesh) const { return reels_[meshes_[mesh].skeleton].crowd; }
  const gles3::CrowdMesh& mesh(std::uint32_t mesh) const { return meshes_[mesh].gpu; }

 private:
  // Of a skeleton; empty if no mesh hangs on it.
  struct Reel {
    gles3::CrowdClip clip;
    std::vector<Affine> matrices;
    gles3::CrowdFrames frames;
    gles3::Crowd crowd;
    alignas(float) std::byte instance[gles3::kCrowdInstanceBytes];  // its memory
  };
  struct BakedMesh {
    std::uint32_t skeleton = 0;
    gles3::CrowdMesh gpu;
    AlignedBytes memory;
  };

  void bake(const std::string& path, const Skeleton& skeleton, const Clip* clip, Reel& reel);

  const Gl& gl_;
  const gles3::ProgramSet& programs_;
  std::vector<Reel> reels_;
  std::vector<BakedMesh> meshes_;
};

}  // namespace marrow::tools
