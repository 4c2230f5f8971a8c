#include "render/overlay/strokes.h"

#include <array>
#include <cstddef>

#include <glm/gtc/type_ptr.hpp>

#include "common/failure.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/program.h"

namespace marrow::embedded {
extern const unsigned char shader_strokes_vert[], shader_strokes_frag[];
}

namespace marrow::tools {
namespace {

// Enough that what lies on a surface is not half hidden by it.
constexpr float kNearer = 2e-4f;

}  // namespace

Strokes::Strokes(const Gl& gl) : gl_(gl), buffer_(gl), array_(gl) {
  std::array<char, 1024> log{};
  const auto text = [](const unsigned char* embedded) { return reinterpret_cast<const char*>(embedded); };
  const gles3::ProgramSource source{text(embedded::shader_strokes_vert), text(embedded::shader_strokes_frag), {}};
  if (gles3::create_program(gl, {gles3::Deformer::none, 4, gles3::kColours}, source, 0, program_, log) != Status::ok)
    throw Failure(Exit::internal, "shader", "", log.data(), "please report this with the driver: " + gl.driver());
  gl.BindVertexArray(array_);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  gl.EnableVertexAttribArray(gles3::kPositionLocation);
  gl.VertexAttribPointer(gles3::kPositionLocation, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), nullptr);
  gl.EnableVertexAttribArray(gles3::kColourLocation);
  gl.VertexAttribPointer(gles3::kColourLocation, 4, GL_FLOAT, GL_FALSE, sizeof(Corner),
                         reinterpret_cast<const void*>(offsetof(Corner, colour)));
  gl.BindVertexArray(0);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.check("preparing lines");
}

Strokes::~Strokes() {
  gles3::destroy(gl_, program_);
}

void Strokes::clear() {
  lines_.clear();
  faces_.clear();
}

void Strokes::line(glm::vec3 from, glm::vec3 to, glm::vec4 colour) {
  lines_.push_back({from, colour});
  lines_.push_back({to, colour});
}

void Strokes::line(const Corner& from, const Corner& to) {
  lines_.insert(lines_.end(), {from, to});
}

void Strokes::face(const Corner& a, const Corner& b, const Corner& c) {
  faces_.insert(faces_.end(), {a, b, c});
}

void Strokes::draw_all(GLenum mode, const std::vector<Corner>& corners) {
  if (corners.empty()) return;
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<std::ptrdiff_t>(corners.size() * sizeof(Corner)), corners.data(),
                 GL_STREAM_DRAW);
  gl_.DrawArrays(mode, 0, static_cast<GLsizei>(corners.size()));
}

void Strokes::draw(const Camera& camera) {
  if (empty()) return;
  gl_.UseProgram(program_.id);
  gl_.UniformMatrix4fv(gl_.GetUniformLocation(program_.id, "clip_from_model"), 1, GL_FALSE,
                       glm::value_ptr(camera.clip_from_model));
  gl_.Uniform1f(gl_.GetUniformLocation(program_.id, "nearer"), kNearer);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DepthMask(GL_FALSE);
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  draw_all(GL_TRIANGLES, faces_);
  draw_all(GL_LINES, lines_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl_.BindVertexArray(0);
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_BLEND);
  gl_.UseProgram(0);
}

}  // namespace marrow::tools
