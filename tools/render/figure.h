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

#include "marrow/gles3_skinned.h"
#include "pose/evaluate.h"
#include "render/baked_play.h"
#include "render/paths.h"
#include "render/studio.h"

namespace marrow::tools {

class Figure {
 public:
  // Throws Failure (internal) if the driver refuses. `gl`, `file` and `textures` (none: drawn without) outlive it.
  // normals: of animation space, by the vertex shader; blended in any case where it has no room for tangents.
  // level: of detail, as in File::mesh.
  Figure(const Gl& gl, const File& file, const Textures* textures = nullptr, AsNormals normals = AsNormals::blended,
         std::uint32_t level = 0);
  ~Figure();
  Figure(const Figure&) = delete;
  Figure& operator=(const Figure&) = delete;

  // Index of the first mesh whose palette is too large for a uniform block, if there is one.
  std::optional<std::uint32_t> too_large() const { return too_large_; }

  // What `play` is by the path of crowds. path: of the file, for messages. Throws as BakedPlay does.
  std::unique_ptr<BakedPlay> bake(const std::string& path, const Play& play) const;

  // By any path but the CPU's and the crowd's; palettes go up now, and what skins once does so. Precondition:
  // !too_large(), unless palettes are in a texture. Throws Failure (unsupported) without compute shaders, if they are
  // asked for.
  std::vector<Drawable> on_gpu(const Character& character, Deformer deformer, SkinPath path = SkinPath::ubo);

  // As `baked`, from bake(), was last blended. character: in the same pose, for where surfaces that blend are.
  std::vector<Drawable> from_crowd(const Character& character, Deformer deformer, const BakedPlay& baked) const;

  // Skinned already, a PosedMesh a mesh; positions and normals go up now. colours: if not empty, 4 floats a slot and
  // mesh, linear, instead of the mesh's own.
  std::vector<Drawable> from_cpu(std::span<const PosedMesh> posed, std::span<const std::vector<float>> colours = {});

  const gles3::PaletteRing& palettes() const { return ring_; }
  std::uint64_t gpu_vertex_bytes() const;

 private:
  struct Part {
    gles3::GpuMesh gpu;
    std::vector<Affine> bind;    // what palettes are built with
    gles3::SkinnedMesh skinned;  // by paths that skin once; empty before
    GlBuffer indices, positions, normals, uvs, colours;
    GlVertexArray array;
  };

  void make_streams(const Mesh& mesh, Part& part);
  Drawable unposed(std::uint32_t index, const gles3::GpuMesh& gpu, const Character& character, Deformer deformer) const;
  Drawable posed(std::uint32_t index, const Character& character, Deformer deformer, std::vector<Affine>& palettes);
  void preskin(Part& part, gles3::Preskin method, Drawable& d);
  void set_look(std::uint32_t index, const Mesh& mesh, Drawable& d) const;

  const Gl& gl_;
  File file_;
  const Textures* textures_;
  std::uint32_t level_;
  std::vector<std::vector<float>> tangents_;
  std::vector<Part> parts_;
  gles3::PaletteRing ring_;
  gles3::PaletteTexture texture_;
  std::map<std::tuple<gles3::Preskin, gles3::Deformer, int, int>, gles3::Program> preskins_;
  std::optional<std::uint32_t> too_large_;
};

}  // namespace marrow::tools
