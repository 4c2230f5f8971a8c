/* The functions of OpenGL ES 3.0 that the render event calls itself, and how the driver is asked for any. No header of
 * GL or EGL is needed. */
#ifndef MARROW_UNITY_GL_H
#define MARROW_UNITY_GL_H

#include <dlfcn.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum {
  GL_BACK_ = 0x0405,
  GL_LEQUAL_ = 0x0203,
  GL_CW_ = 0x0900,
  GL_CCW_ = 0x0901,
  GL_CULL_FACE_ = 0x0B44,
  GL_CULL_FACE_MODE_ = 0x0B45,
  GL_FRONT_FACE_ = 0x0B46,
  GL_DEPTH_TEST_ = 0x0B71,
  GL_DEPTH_WRITEMASK_ = 0x0B72,
  GL_DEPTH_FUNC_ = 0x0B74,
  GL_BLEND_ = 0x0BE2,
  GL_ACTIVE_TEXTURE_ = 0x84E0,
  GL_VERTEX_ARRAY_BINDING_ = 0x85B5,
  GL_ARRAY_BUFFER_ = 0x8892,
  GL_ARRAY_BUFFER_BINDING_ = 0x8894,
  GL_UNIFORM_BUFFER_ = 0x8A11,
  GL_UNIFORM_BUFFER_BINDING_ = 0x8A28,
  GL_CURRENT_PROGRAM_ = 0x8B8D
};

#define GL_FUNCTIONS(X)                                                      \
  X(void, UseProgram, (uint32_t))                                            \
  X(int32_t, GetUniformLocation, (uint32_t, const char*))                    \
  X(void, UniformMatrix4fv, (int32_t, int32_t, unsigned char, const float*)) \
  X(void, Uniform4fv, (int32_t, int32_t, const float*))                      \
  X(void, Enable, (uint32_t))                                                \
  X(void, Disable, (uint32_t))                                               \
  X(unsigned char, IsEnabled, (uint32_t))                                    \
  X(void, GetIntegerv, (uint32_t, int32_t*))                                 \
  X(void, DepthFunc, (uint32_t))                                             \
  X(void, DepthMask, (unsigned char))                                        \
  X(void, CullFace, (uint32_t))                                              \
  X(void, FrontFace, (uint32_t))                                             \
  X(void, ActiveTexture, (uint32_t))                                         \
  X(void, BindBuffer, (uint32_t, uint32_t))                                  \
  X(void, BindVertexArray, (uint32_t))

static struct {
#define MEMBER(Result, Name, Parameters) Result(*Name) Parameters;
  GL_FUNCTIONS(MEMBER)
#undef MEMBER
} gl;

static void* load_proc(const char* name) {
  static void *egl, *gles;
  static void* (*get_proc)(const char* name);
  void* found = NULL;
  if (egl == NULL) {
    egl = dlopen("libEGL.so.1", RTLD_LAZY);
    if (egl == NULL) egl = dlopen("libEGL.so", RTLD_LAZY); /* Android's */
    if (egl == NULL) return NULL;
    found = dlsym(egl, "eglGetProcAddress");
    memcpy(&get_proc, &found, sizeof found); /* ISO C has no cast from objects to functions */
    gles = dlopen("libGLESv2.so.2", RTLD_LAZY);
    if (gles == NULL) gles = dlopen("libGLESv3.so", RTLD_LAZY);
  }
  found = get_proc != NULL ? get_proc(name) : NULL;
  return found == NULL && gles != NULL ? dlsym(gles, name) : found;
}

static int load_gl(void) {
  void* function;
#define LOAD(Result, Name, Parameters) \
  function = load_proc("gl" #Name);    \
  if (function == NULL) return 0;      \
  memcpy(&gl.Name, &function, sizeof function);
  GL_FUNCTIONS(LOAD)
#undef LOAD
  return 1;
}

/* What the engine has set and is to find again. Bindings of textures and of uniform blocks are left as drawing leaves
 * them: texture units 12 and 13 and binding 20, which engines hardly know. */
typedef struct gl_state {
  int32_t program, vertex_array, array_buffer, uniform_buffer, texture, depth_mask, depth_function, cull_mode, front;
  unsigned char depth, cull, blend;
} gl_state;

static gl_state save_state(void) {
  gl_state out;
  gl.GetIntegerv(GL_CURRENT_PROGRAM_, &out.program);
  gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING_, &out.vertex_array);
  gl.GetIntegerv(GL_ARRAY_BUFFER_BINDING_, &out.array_buffer);
  gl.GetIntegerv(GL_UNIFORM_BUFFER_BINDING_, &out.uniform_buffer);
  gl.GetIntegerv(GL_ACTIVE_TEXTURE_, &out.texture);
  gl.GetIntegerv(GL_DEPTH_WRITEMASK_, &out.depth_mask);
  gl.GetIntegerv(GL_DEPTH_FUNC_, &out.depth_function);
  gl.GetIntegerv(GL_CULL_FACE_MODE_, &out.cull_mode);
  gl.GetIntegerv(GL_FRONT_FACE_, &out.front);
  out.depth = gl.IsEnabled(GL_DEPTH_TEST_);
  out.cull = gl.IsEnabled(GL_CULL_FACE_);
  out.blend = gl.IsEnabled(GL_BLEND_);
  return out;
}

static void set_enabled(uint32_t what, unsigned char enabled) {
  if (enabled)
    gl.Enable(what);
  else
    gl.Disable(what);
}

static void restore_state(const gl_state* state) {
  gl.UseProgram((uint32_t)state->program);
  gl.BindVertexArray((uint32_t)state->vertex_array);
  gl.BindBuffer(GL_ARRAY_BUFFER_, (uint32_t)state->array_buffer);
  gl.BindBuffer(GL_UNIFORM_BUFFER_, (uint32_t)state->uniform_buffer);
  gl.ActiveTexture((uint32_t)state->texture);
  gl.DepthMask(state->depth_mask != 0);
  gl.DepthFunc((uint32_t)state->depth_function);
  gl.CullFace((uint32_t)state->cull_mode);
  gl.FrontFace((uint32_t)state->front);
  set_enabled(GL_DEPTH_TEST_, state->depth);
  set_enabled(GL_CULL_FACE_, state->cull);
  set_enabled(GL_BLEND_, state->blend);
}

#endif
