// A character on the GPU: every mesh of a file, ready to be drawn in any pose by any deformer.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "common/aligned_bytes.h"
#include "marrow/gles3_skinner.h"
#include "pose/evaluate.h"
#include "render/baked_play.h"
#include "render/paths.h"
#include "render/studio.h"

namespace marrow::tools {

class Figure {
 public:
  // programs: of the studio that draws it. `gl`, `programs`, `file` and `textures` (none: drawn without) outlive it.
  // normals: of animation space, by the vertex shader; blended in any case where it has no room for tangents.
  // level: of detail, as in File::mesh. Throws Failure (internal) if the driver refuses.
  Figure(const Gl& gl, gles3::ProgramSet& programs, const File& file, const Textures* textures = nullptr,
         AsNormals normals = AsNormals::blended, std::uint32_t level = 0);
  ~Figure();
  Figure(const Figure&) = delete;
  Figure& operator=(const Figure&) = delete;

  // Index of the first mesh whose palette is too large for a uniform block, if there is one.
  std::optional<std::uint32_t> too_large() const { return too_large_; }

  // What `play` is by the path of crowds, for from_crowd() by the same deformer. path: of the file, for messages.
  // Throws as BakedPlay does.
  std::unique_ptr<BakedPlay> bake(const std::string& path, const Play& play, Deformer deformer) const;

  // By any path but the CPU's and the crowd's; palettes go up now, and what skins once does so. Meshes go up when they
  // are first drawn so. Precondition: !too_large(), unless palettes are in a texture. Throws Failure: unsupported
  // without compute shaders, if they are asked for; internal if the driver refuses.
  std::vector<Drawable> on_gpu(const Character& character, Deformer deformer, SkinPath path = SkinPath::ubo);

  // As `baked`, from bake(), was last blended. character: in the same pose, for where surfaces that blend are.
  std::vector<Drawable> from_crowd(const Character& character, Deformer deformer, const BakedPlay& baked) const;

  // Skinned already, a PosedMesh a mesh; positions and normals go up now. colours: if not empty, 4 floats a slot and
  // mesh, linear, instead of the mesh's own.
  std::vector<Drawable> from_cpu(std::span<const PosedMesh> posed, std::span<const std::vector<float>> colours = {});

 private:
  // Vertices of a mesh that the CPU has skinned.
  struct Streams {
    GlBuffer indices, positions, normals, uvs, colours;
    GlVertexArray array;
  };
  struct Skinned {
    gles3::Skinner skinner;
    AlignedBytes memory;
  };

  Streams make_streams(const Mesh& mesh) const;
  gles3::Skinner& skinner(std::uint32_t mesh, Deformer deformer, SkinPath path);
  Drawable drawable(std::uint32_t mesh, const Character& character) const;
  void set_look(std::uint32_t index, const Mesh& mesh, Drawable& d) const;
  std::uint8_t features(std::uint32_t mesh) const;
  // With what the driver says of a shader's text.
  void check_made(Status status) const;

  const Gl& gl_;
  gles3::ProgramSet& programs_;
  File file_;
  const Textures* textures_;
  std::uint32_t level_;
  std::vector<std::vector<float>> tangents_;
  std::vector<Streams> streams_;
  std::map<std::tuple<std::uint32_t, Deformer, SkinPath>, Skinned> skinned_;
  std::optional<std::uint32_t> too_large_;
};

}  // namespace marrow::tools
