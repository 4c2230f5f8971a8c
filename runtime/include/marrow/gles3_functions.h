// The OpenGL ES functions that marrow::gles3 calls, and those for a game's uniforms: X(return type, name without "gl",
// parameters). Those of 3.0 must be there, those of 3.1 and of extensions may be missing.
//
// Spelt in plain C types, which are what the GL types are on every platform, so that neither Khronos' headers nor a
// particular loader are needed to include this.
#pragma once

#include <cstddef>

// OpenGL ES 3.0: all must be there.
#define MARROW_GLES3_FUNCTIONS(X)                                                                              \
  X(const unsigned char*, GetString, (unsigned name))                                                          \
  X(void, GetIntegerv, (unsigned name, int* values))                                                           \
  X(unsigned, GetError, ())                                                                                    \
  X(void, GenBuffers, (int count, unsigned* buffers))                                                          \
  X(void, DeleteBuffers, (int count, const unsigned* buffers))                                                 \
  X(void, BindBuffer, (unsigned target, unsigned buffer))                                                      \
  X(void, BufferData, (unsigned target, std::ptrdiff_t bytes, const void* data, unsigned usage))               \
  X(void, BufferSubData, (unsigned target, std::ptrdiff_t offset, std::ptrdiff_t bytes, const void* data))     \
  X(void, BindBufferRange,                                                                                     \
    (unsigned target, unsigned index, unsigned buffer, std::ptrdiff_t offset, std::ptrdiff_t bytes))           \
  X(void, GenVertexArrays, (int count, unsigned* arrays))                                                      \
  X(void, DeleteVertexArrays, (int count, const unsigned* arrays))                                             \
  X(void, BindVertexArray, (unsigned array))                                                                   \
  X(void, EnableVertexAttribArray, (unsigned location))                                                        \
  X(void, VertexAttribPointer,                                                                                 \
    (unsigned location, int size, unsigned type, unsigned char normalized, int stride, const void* offset))    \
  X(void, VertexAttribIPointer, (unsigned location, int size, unsigned type, int stride, const void* offset))  \
  X(unsigned, CreateShader, (unsigned type))                                                                   \
  X(void, ShaderSource, (unsigned shader, int count, const char* const* texts, const int* lengths))            \
  X(void, CompileShader, (unsigned shader))                                                                    \
  X(void, GetShaderiv, (unsigned shader, unsigned name, int* value))                                           \
  X(void, GetShaderInfoLog, (unsigned shader, int size, int* length, char* text))                              \
  X(void, DeleteShader, (unsigned shader))                                                                     \
  X(unsigned, CreateProgram, ())                                                                               \
  X(void, AttachShader, (unsigned program, unsigned shader))                                                   \
  X(void, TransformFeedbackVaryings, (unsigned program, int count, const char* const* names, unsigned mode))   \
  X(void, LinkProgram, (unsigned program))                                                                     \
  X(void, GetProgramiv, (unsigned program, unsigned name, int* value))                                         \
  X(void, GetProgramInfoLog, (unsigned program, int size, int* length, char* text))                            \
  X(void, DeleteProgram, (unsigned program))                                                                   \
  X(int, GetUniformLocation, (unsigned program, const char* name))                                             \
  X(void, Uniform1f, (int location, float value))                                                              \
  X(void, Uniform2f, (int location, float x, float y))                                                         \
  X(void, Uniform3f, (int location, float x, float y, float z))                                                \
  X(void, Uniform4f, (int location, float x, float y, float z, float w))                                       \
  X(void, Uniform1fv, (int location, int count, const float* values))                                          \
  X(void, Uniform2fv, (int location, int count, const float* values))                                          \
  X(void, Uniform3fv, (int location, int count, const float* values))                                          \
  X(void, UniformMatrix3fv, (int location, int count, unsigned char transpose, const float* values))           \
  X(void, UniformMatrix4fv, (int location, int count, unsigned char transpose, const float* values))           \
  X(unsigned, GetUniformBlockIndex, (unsigned program, const char* name))                                      \
  X(void, UniformBlockBinding, (unsigned program, unsigned index, unsigned binding))                           \
  X(void, DrawElements, (unsigned mode, int count, unsigned type, const void* offset))                         \
  X(void, DrawElementsInstanced, (unsigned mode, int count, unsigned type, const void* offset, int instances)) \
  X(void, DrawArrays, (unsigned mode, int first, int count))                                                   \
  X(void, UseProgram, (unsigned program))                                                                      \
  X(void, Enable, (unsigned capability))                                                                       \
  X(void, Disable, (unsigned capability))                                                                      \
  X(void, BeginTransformFeedback, (unsigned mode))                                                             \
  X(void, EndTransformFeedback, ())                                                                            \
  X(void, BindBufferBase, (unsigned target, unsigned index, unsigned buffer))                                  \
  X(void, Uniform2i, (int location, int x, int y))                                                             \
  X(void, Uniform1iv, (int location, int count, const int* values))                                            \
  X(void, ActiveTexture, (unsigned unit))                                                                      \
  X(void, GenTextures, (int count, unsigned* textures))                                                        \
  X(void, DeleteTextures, (int count, const unsigned* textures))                                               \
  X(void, BindTexture, (unsigned target, unsigned texture))                                                    \
  X(void, TexParameteri, (unsigned target, unsigned name, int value))                                          \
  X(void, TexImage2D,                                                                                          \
    (unsigned target, int level, int internal_format, int width, int height, int border, unsigned format,      \
     unsigned type, const void* texels))                                                                       \
  X(void, TexSubImage2D,                                                                                       \
    (unsigned target, int level, int x, int y, int width, int height, unsigned format, unsigned type,          \
     const void* texels))                                                                                      \
  X(void, Uniform1i, (int location, int value))                                                                \
  X(void, Uniform4fv, (int location, int count, const float* values))                                          \
  X(void, GenFramebuffers, (int count, unsigned* framebuffers))                                                \
  X(void, DeleteFramebuffers, (int count, const unsigned* framebuffers))                                       \
  X(void, BindFramebuffer, (unsigned target, unsigned framebuffer))                                            \
  X(void, FramebufferTexture2D, (unsigned target, unsigned point, unsigned kind, unsigned texture, int level)) \
  X(unsigned, CheckFramebufferStatus, (unsigned target))                                                       \
  X(void, Viewport, (int x, int y, int width, int height))                                                     \
  X(void, ClearBufferuiv, (unsigned buffer, int index, const unsigned* value))                                 \
  X(void, ReadPixels, (int x, int y, int width, int height, unsigned format, unsigned type, void* out))        \
  X(void, ColorMask, (unsigned char red, unsigned char green, unsigned char blue, unsigned char alpha))        \
  X(void, Finish, ())

// OpenGL ES 3.1: compute shaders.
#define MARROW_GLES31_FUNCTIONS(X)                               \
  X(void, DispatchCompute, (unsigned x, unsigned y, unsigned z)) \
  X(void, MemoryBarrier, (unsigned barriers))

// GL_KHR_debug or OpenGL ES 3.2.
#define MARROW_KHR_DEBUG_FUNCTIONS(X) X(void, ObjectLabel, (unsigned kind, unsigned name, int size, const char* text))

// GL_EXT_robustness, GL_KHR_robustness or OpenGL ES 3.2.
#define MARROW_ROBUSTNESS_FUNCTIONS(X) X(unsigned, GetGraphicsResetStatus, ())
