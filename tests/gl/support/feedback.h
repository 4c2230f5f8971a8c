// What the vertex shader computed, read back: positions, normals and tangents by transform feedback.
#pragma once

#include <string>
#include <vector>

#include "gles3/mesh/gpu_mesh.h"
#include "gles3/palettes.h"
#include "marrow/gles3_skinner.h"
#include "render/gl.h"

namespace marrow::test {

// The context of the whole test binary, made on first use. Aborts the binary with a message where there is none, or
// where it is not the driver named in MARROW_EXPECT_DRIVER: a driver's tests must not pass on another one. Where it is
// not the one named in MARROW_ONLY_ON, ends with 77, which ctest counts as skipped.
const tools::Gl& gl();

struct Skinned {
  std::vector<float> positions;  // 3 a slot
  std::vector<float> normals;    // 3 a slot; zero if the mesh has none
  std::vector<float> tangents;   // 4 a slot; zero if the mesh has none

  // A slot more, as feedback_source() captures it.
  void add(const float* v) {
    positions.insert(positions.end(), v, v + 3);
    normals.insert(normals.end(), v + 3, v + 6);
    tangents.insert(tangents.end(), v + 6, v + 10);
  }
};

// A role that has everything captured, interleaved: kFeedbackFloats a vertex, position, normal and tangent.
inline constexpr std::size_t kFeedbackFloats = 10;
gles3::ProgramSource feedback_source();
// What is in a transform feedback buffer.
std::vector<float> read_feedback(GLuint buffer, std::size_t floats);

// Ways of the GPU to a skinned vertex: palettes in a uniform block or a texture, or pre-skinning by two methods.
enum class Way : std::uint8_t { block, texture, feedback, compute };
inline constexpr Way kWays[] = {Way::block, Way::texture, Way::feedback, Way::compute};
const char* name_of(Way way);
// Compute shaders are not everywhere.
bool can(Way way);

// A mesh on the GPU with all that drawing it needs, to be skinned in any pose.
class Feedback {
 public:
  // Fails the current test and leaves ok() false if a step refuses.
  // tangents: from as_tangents(), or empty.
  explicit Feedback(const Mesh& mesh, Span<const float> tangents = {});
  ~Feedback();
  Feedback(const Feedback&) = delete;
  Feedback& operator=(const Feedback&) = delete;

  bool ok() const { return prepared_ == Status::ok; }
  Status prepared() const { return prepared_; }
  const gles3::GpuMesh& gpu() const { return gpu_; }
  // weights: one a morph target of the mesh.
  Skinned skin(gles3::Deformer deformer, Span<const Affine> model_from_joint, Span<const float> weights = {},
               Way way = Way::block);

 private:
  void bind(const gles3::Program& with, Span<const Affine> palette, Way way);
  void capture(gles3::Deformer deformer);

  Mesh mesh_;
  gles3::GpuMesh gpu_;
  gles3::PaletteRing ring_;
  gles3::PaletteTexture texture_, distances_;
  gles3::SkinnedMesh skinned_;
  std::vector<Affine> bind_, two_palettes_;
  tools::GlBuffer capture_;
  tools::GlRenderbuffer colour_;
  tools::GlFramebuffer target_;
  Status prepared_ = Status::bad_argument;
};

}  // namespace marrow::test
