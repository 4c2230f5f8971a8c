// A context of a test's own with a small picture to draw in, to be lost and made anew.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "marrow/egl.h"
#include "render/gl.h"

namespace marrow::test {

inline constexpr int kStageSide = 128;

// Current on the thread that made it.
class Stage {
 public:
  Stage();
  const gles3::Api& real() const { return real_; }
  const gles3::Caps& caps() const { return caps_; }
  // Draws into the picture from now on, and empties it.
  void clear() const;
  std::vector<std::uint8_t> picture() const;
  unsigned error() const { return real_.GetError(); }

 private:
  egl::HeadlessContext context_;
  tools::GlFunctions gl_;
  gles3::Api real_;
  gles3::Caps caps_;
  GLuint framebuffer_ = 0;
};

// Contexts are current on one thread: such tests do not disturb that of the others.
void on_a_thread(const std::function<void()>& test);

}  // namespace marrow::test
