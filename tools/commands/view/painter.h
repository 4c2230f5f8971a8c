// Draws what Dear ImGui leaves, by the tools' own OpenGL functions: its backend as packaged is built for desktop
// OpenGL.
#pragma once

#include "render/gl.h"

struct ImDrawData;
struct ImDrawCmd;

namespace marrow::tools {

class Painter {
 public:
  // After the fonts are chosen: they go up now. Throws Failure (internal) if the driver refuses. `gl` outlives it.
  explicit Painter(const Gl& gl);
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  // Into the window.
  void paint(const ImDrawData& data);

 private:
  void upload_fonts();
  void draw(const ImDrawData& data, const ImDrawCmd& command, int height);

  const Gl& gl_;
  gles3::Program program_;
  GlTexture font_;
  GlBuffer vertices_, indices_;
  GlVertexArray array_;
};

}  // namespace marrow::tools
