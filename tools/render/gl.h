// The tools' OpenGL: a context, its functions, and objects that delete themselves.
#pragma once

#define GL_GLES_PROTOTYPES 0
#include <GLES3/gl3.h>

#include <memory>
#include <string>
#include <utility>

#include "common/failure.h"
#include "marrow/gles3.h"

// What drawing pictures needs beyond marrow::gles3: X(return type, name, parameters).
#define MARROW_TOOL_GL_FUNCTIONS(X)                                                                               \
  X(void, BindRenderbuffer, (GLenum target, GLuint renderbuffer))                                                 \
  X(void, BindSampler, (GLuint unit, GLuint sampler))                                                             \
  X(void, BlendFunc, (GLenum source, GLenum destination))                                                         \
  X(void, BlendFuncSeparate, (GLenum source, GLenum destination, GLenum source_alpha, GLenum destination_alpha))  \
  X(void, BlitFramebuffer,                                                                                        \
    (GLint x0, GLint y0, GLint x1, GLint y1, GLint to_x0, GLint to_y0, GLint to_x1, GLint to_y1, GLbitfield mask, \
     GLenum filter))                                                                                              \
  X(void, Clear, (GLbitfield mask))                                                                               \
  X(void, ClearDepthf, (GLfloat depth))                                                                           \
  X(void, DeleteRenderbuffers, (GLsizei count, const GLuint* renderbuffers))                                      \
  X(void, DeleteSamplers, (GLsizei count, const GLuint* samplers))                                                \
  X(void, DepthMask, (GLboolean on))                                                                              \
  X(void, DrawBuffers, (GLsizei count, const GLenum* buffers))                                                    \
  X(void, FramebufferRenderbuffer, (GLenum target, GLenum attachment, GLenum kind, GLuint renderbuffer))          \
  X(void, FrontFace, (GLenum winding))                                                                            \
  X(void, GenRenderbuffers, (GLsizei count, GLuint * renderbuffers))                                              \
  X(void, GenSamplers, (GLsizei count, GLuint * samplers))                                                        \
  X(void, GenerateMipmap, (GLenum target))                                                                        \
  X(void, GetInternalformativ, (GLenum target, GLenum format, GLenum name, GLsizei size, GLint * values))         \
  X(void, PixelStorei, (GLenum name, GLint value))                                                                \
  X(void, PolygonOffset, (GLfloat factor, GLfloat units))                                                         \
  X(void, RenderbufferStorageMultisample,                                                                         \
    (GLenum target, GLsizei samples, GLenum format, GLsizei width, GLsizei height))                               \
  X(void, SamplerParameteri, (GLuint sampler, GLenum name, GLint value))                                          \
  X(void, TexStorage2D, (GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height))            \
  X(void, Scissor, (GLint x, GLint y, GLsizei width, GLsizei height))                                             \
  X(void, Uniform2fv, (GLint location, GLsizei count, const GLfloat* values))                                     \
  X(void, Uniform3fv, (GLint location, GLsizei count, const GLfloat* values))                                     \
  X(void, UniformMatrix4fv, (GLint location, GLsizei count, GLboolean transpose, const GLfloat* values))

namespace marrow::tools {

struct GlFunctions : gles3::Api {
#define MARROW_MEMBER(Result, Name, Parameters) gles3::Entry<Result Parameters> Name{"gl" #Name};
  MARROW_TOOL_GL_FUNCTIONS(MARROW_MEMBER)
#undef MARROW_MEMBER
};

// gles3::watch_errors() of these functions too.
void watch_all_errors(GlFunctions& gl, gles3::ErrorWatch* watch);

// The graphics processor was reset and has taken the context along.
class ContextLost : public Failure {
 public:
  explicit ContextLost(const std::string& driver)
      : Failure(Exit::internal, "OpenGL ES", "", "the graphics processor was reset",
                "try again; the driver: " + driver) {}
};

// A current OpenGL ES 3.0 context. Throws Failure (unsupported) where there is none. Where NDEBUG is not defined each
// GL error is on stderr, with the call that caused it.
class Gl : public GlFunctions {
 public:
  using LoadProc = void* (*)(const char* name);

  // Without a window.
  Gl();
  // Of a context that is current already, a window's, and outlives this.
  explicit Gl(LoadProc load_proc);
  Gl(const Gl&) = delete;
  Gl& operator=(const Gl&) = delete;

  const gles3::Caps& caps() const { return caps_; }
  // "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL ES 3.2 Mesa 22.3.6"
  const std::string& driver() const { return driver_; }
  // At least once a frame. Throws ContextLost, or Failure (internal) if GL has recorded an error since the last check;
  // `doing` says during what.
  void check(const char* doing) const;

 private:
  Gl(std::shared_ptr<void> context, LoadProc load_proc);

  std::shared_ptr<void> context_;  // none: another's
  gles3::ErrorWatch watch_;
  gles3::Caps caps_;
  std::string driver_;
};

// A GL object's name that is deleted with its owner. The context outlives it.
template <auto Gen, auto Delete>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(const Gl& gl) : gl_(&gl) { (gl.*Gen)(1, &name_); }
  GlObject(GlObject&& other) noexcept : gl_(std::exchange(other.gl_, nullptr)), name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) (gl_->*Delete)(1, &name_);
  }
  operator GLuint() const { return name_; }

 private:
  const Gl* gl_ = nullptr;
  GLuint name_ = 0;
};
using GlBuffer = GlObject<&GlFunctions::GenBuffers, &GlFunctions::DeleteBuffers>;
using GlVertexArray = GlObject<&GlFunctions::GenVertexArrays, &GlFunctions::DeleteVertexArrays>;
using GlTexture = GlObject<&GlFunctions::GenTextures, &GlFunctions::DeleteTextures>;
using GlSampler = GlObject<&GlFunctions::GenSamplers, &GlFunctions::DeleteSamplers>;
using GlFramebuffer = GlObject<&GlFunctions::GenFramebuffers, &GlFunctions::DeleteFramebuffers>;
using GlRenderbuffer = GlObject<&GlFunctions::GenRenderbuffers, &GlFunctions::DeleteRenderbuffers>;

}  // namespace marrow::tools
