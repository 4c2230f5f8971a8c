#include "gl/support/stage.h"

#include <thread>

#include <gtest/gtest.h>

namespace marrow::test {

Stage::Stage() {
  EXPECT_EQ(context_.create(), Status::ok) << context_.error();
  EXPECT_EQ(gles3::load_api(real_, egl::load_proc), Status::ok);
  EXPECT_EQ(gles3::query_caps(real_, caps_), Status::ok);
  static_cast<gles3::Api&>(gl_) = real_;
#define MARROW_LOAD(Result, Name, Parameters) \
  gl_.Name = reinterpret_cast<Result(*) Parameters>(egl::load_proc("gl" #Name));
  MARROW_TOOL_GL_FUNCTIONS(MARROW_LOAD)
#undef MARROW_LOAD
  GLuint buffers[2] = {};
  gl_.GenRenderbuffers(2, buffers);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  const GLenum formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT24}, places[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (std::size_t i = 0; i < 2; ++i) {
    gl_.BindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, formats[i], kStageSide, kStageSide);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, buffers[i]);
  }
  real_.Enable(GL_DEPTH_TEST);
  clear();
}

void Stage::clear() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(0, 0, kStageSide, kStageSide);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

std::vector<std::uint8_t> Stage::picture() const {
  std::vector<std::uint8_t> out(std::size_t{4} * kStageSide * kStageSide);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.ReadPixels(0, 0, kStageSide, kStageSide, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
  return out;
}

void on_a_thread(const std::function<void()>& test) {
  std::thread(test).join();
}

}  // namespace marrow::test
