// The OpenGL ES functions that marrow::gles3 calls, and those for a game's uniforms; and who watches calls for errors.
#pragma once

#include <cstddef>
#include <type_traits>

#include "marrow/api.h"

// X(return type, name without "gl", parameters), in plain C types, which are what the GL types are on every platform.
// OpenGL ES 3.0: all must be there.
#define MARROW_GLES3_FUNCTIONS(X)                                                              \
  X(const unsigned char*, GetString, (unsigned))                                               \
  X(void, GetIntegerv, (unsigned, int*))                                                       \
  X(unsigned, GetError, ())                                                                    \
  X(void, GenBuffers, (int, unsigned*))                                                        \
  X(void, DeleteBuffers, (int, const unsigned*))                                               \
  X(void, BindBuffer, (unsigned, unsigned))                                                    \
  X(void, BufferData, (unsigned, std::ptrdiff_t, const void*, unsigned))                       \
  X(void, BufferSubData, (unsigned, std::ptrdiff_t, std::ptrdiff_t, const void*))              \
  X(void, BindBufferRange, (unsigned, unsigned, unsigned, std::ptrdiff_t, std::ptrdiff_t))     \
  X(void, GenVertexArrays, (int, unsigned*))                                                   \
  X(void, DeleteVertexArrays, (int, const unsigned*))                                          \
  X(void, BindVertexArray, (unsigned))                                                         \
  X(void, EnableVertexAttribArray, (unsigned))                                                 \
  X(void, VertexAttribPointer, (unsigned, int, unsigned, unsigned char, int, const void*))     \
  X(void, VertexAttribIPointer, (unsigned, int, unsigned, int, const void*))                   \
  X(unsigned, CreateShader, (unsigned))                                                        \
  X(void, ShaderSource, (unsigned, int, const char* const*, const int*))                       \
  X(void, CompileShader, (unsigned))                                                           \
  X(void, GetShaderiv, (unsigned, unsigned, int*))                                             \
  X(void, GetShaderInfoLog, (unsigned, int, int*, char*))                                      \
  X(void, DeleteShader, (unsigned))                                                            \
  X(unsigned, CreateProgram, ())                                                               \
  X(void, AttachShader, (unsigned, unsigned))                                                  \
  X(void, TransformFeedbackVaryings, (unsigned, int, const char* const*, unsigned))            \
  X(void, LinkProgram, (unsigned))                                                             \
  X(void, GetProgramiv, (unsigned, unsigned, int*))                                            \
  X(void, GetProgramInfoLog, (unsigned, int, int*, char*))                                     \
  X(void, DeleteProgram, (unsigned))                                                           \
  X(int, GetUniformLocation, (unsigned, const char*))                                          \
  X(void, Uniform1f, (int, float))                                                             \
  X(void, Uniform4f, (int, float, float, float, float))                                        \
  X(void, Uniform1fv, (int, int, const float*))                                                \
  X(void, Uniform2fv, (int, int, const float*))                                                \
  X(void, Uniform3fv, (int, int, const float*))                                                \
  X(void, UniformMatrix3fv, (int, int, unsigned char, const float*))                           \
  X(void, UniformMatrix4fv, (int, int, unsigned char, const float*))                           \
  X(unsigned, GetUniformBlockIndex, (unsigned, const char*))                                   \
  X(void, UniformBlockBinding, (unsigned, unsigned, unsigned))                                 \
  X(void, DrawElements, (unsigned, int, unsigned, const void*))                                \
  X(void, DrawElementsInstanced, (unsigned, int, unsigned, const void*, int))                  \
  X(void, DrawArrays, (unsigned, int, int))                                                    \
  X(void, UseProgram, (unsigned))                                                              \
  X(void, Enable, (unsigned))                                                                  \
  X(void, Disable, (unsigned))                                                                 \
  X(void, BeginTransformFeedback, (unsigned))                                                  \
  X(void, EndTransformFeedback, ())                                                            \
  X(void, BindBufferBase, (unsigned, unsigned, unsigned))                                      \
  X(void, Uniform2i, (int, int, int))                                                          \
  X(void, Uniform1iv, (int, int, const int*))                                                  \
  X(void, ActiveTexture, (unsigned))                                                           \
  X(void, GenTextures, (int, unsigned*))                                                       \
  X(void, DeleteTextures, (int, const unsigned*))                                              \
  X(void, BindTexture, (unsigned, unsigned))                                                   \
  X(void, TexParameteri, (unsigned, unsigned, int))                                            \
  X(void, TexImage2D, (unsigned, int, int, int, int, int, unsigned, unsigned, const void*))    \
  X(void, TexSubImage2D, (unsigned, int, int, int, int, int, unsigned, unsigned, const void*)) \
  X(void, Uniform1i, (int, int))                                                               \
  X(void, Uniform4fv, (int, int, const float*))                                                \
  X(void, GenFramebuffers, (int, unsigned*))                                                   \
  X(void, DeleteFramebuffers, (int, const unsigned*))                                          \
  X(void, BindFramebuffer, (unsigned, unsigned))                                               \
  X(void, FramebufferTexture2D, (unsigned, unsigned, unsigned, unsigned, int))                 \
  X(unsigned, CheckFramebufferStatus, (unsigned))                                              \
  X(void, Viewport, (int, int, int, int))                                                      \
  X(void, ClearBufferuiv, (unsigned, int, const unsigned*))                                    \
  X(void, ReadPixels, (int, int, int, int, unsigned, unsigned, void*))                         \
  X(void, ColorMask, (unsigned char, unsigned char, unsigned char, unsigned char))             \
  X(void, Finish, ())
// Of OpenGL ES 3.1, GL_KHR_debug and GL_EXT_robustness: these may be missing.
#define MARROW_GLES3_OPTIONAL_FUNCTIONS(X)                     \
  X(void, DispatchCompute, (unsigned, unsigned, unsigned))     \
  X(void, MemoryBarrier, (unsigned))                           \
  X(void, ObjectLabel, (unsigned, unsigned, int, const char*)) \
  X(unsigned, GetGraphicsResetStatus, ())

namespace marrow::gles3 {

// Is told of every GL error and of the call that caused it, as "glBindBuffer": see watch_errors(). One an Api and
// thread.
struct ErrorWatch {
  // May be null. call: a static string.
  void (*report)(void* user, const char* call, unsigned error) = nullptr;
  void* user = nullptr;               // what `report` gets
  unsigned pending = 0;               // what the Api's GetError has yet to tell, as it would without a watch
  unsigned (*get_error)() = nullptr;  // the driver's glGetError
};

// What the Api's GetError returns under a watch.
MARROW_API unsigned take_error(ErrorWatch& watch);

// Before a call under a watch: keeps errors from before it pending. Gives an error that GL does not clear, or none.
MARROW_API unsigned begin_watched(ErrorWatch& watch);
// After it: reports the errors that it has left behind, but for `stuck`, which begin_watched() gave.
MARROW_API void end_watched(ErrorWatch& watch, const char* call, unsigned stuck);

// A function of the driver, called and assigned like a function pointer.
template <class Function>
struct Entry;
template <class Result, class... Arguments>
// A function of this result and these arguments.
struct Entry<Result(Arguments...)> {
  // What the driver gives.
  using Pointer = Result (*)(Arguments...);

  Pointer function = nullptr;   // null: the driver has it not
  const char* name;             // "glBindBuffer"; a static string
  ErrorWatch* watch = nullptr;  // null: nobody watches

  // A function that is not there yet.
  explicit constexpr Entry(const char* of) : name(of) {}
  // Another function in its place.
  Entry& operator=(Pointer to) {
    function = to;
    return *this;
  }
  // Whether the driver has it not.
  bool operator==(std::nullptr_t) const { return function == nullptr; }

  // Calls it. Precondition: it is there.
  Result operator()(Arguments... arguments) const {
    if (watch == nullptr) [[likely]]
      return function(arguments...);
    if constexpr (std::is_same_v<Pointer, unsigned (*)()>) {
      if (function == watch->get_error) return take_error(*watch);
    }
    const unsigned stuck = begin_watched(*watch);
    if constexpr (std::is_void_v<Result>) {
      function(arguments...);
      end_watched(*watch, name, stuck);
    } else {
      const Result result = function(arguments...);
      end_watched(*watch, name, stuck);
      return result;
    }
  }
};

}  // namespace marrow::gles3
