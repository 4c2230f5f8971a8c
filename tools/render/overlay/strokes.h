// Lines and see-through faces that stand among the figures of a picture, hidden by what is before them.
#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "marrow/gles3.h"
#include "render/camera.h"
#include "render/gl.h"

namespace marrow::tools {

class Strokes {
 public:
  // `gl` outlives it. Throws Failure (internal) if the driver refuses the shader.
  explicit Strokes(const Gl& gl);
  ~Strokes();
  Strokes(const Strokes&) = delete;
  Strokes& operator=(const Strokes&) = delete;

  void clear();
  bool empty() const { return lines_.empty() && faces_.empty(); }
  // Model space; colour: linear RGBA, 0 … 1. Lines are one pixel of the picture wide.
  void line(glm::vec3 from, glm::vec3 to, glm::vec4 colour);
  struct Corner {
    glm::vec3 at{0};
    glm::vec4 colour{1};
  };
  void line(const Corner& from, const Corner& to);
  void face(const Corner& a, const Corner& b, const Corner& c);

  // Into the frame buffer that is bound, whose depth test is on and to which it writes no depth. Faces first.
  void draw(const Camera& camera);

 private:
  void draw_all(GLenum mode, const std::vector<Corner>& corners);

  const Gl& gl_;
  gles3::Program program_;
  GlBuffer buffer_;
  GlVertexArray array_;
  std::vector<Corner> lines_, faces_;
};

}  // namespace marrow::tools
