// The screen: EGL, where a window is a buffer of Mesa's, and a context is lost when the test says so. See phone.h.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

#include "phone.h"

namespace phone {

Screen screen;

namespace {

EGLint error = EGL_SUCCESS;

// Mesa's function of this name.
template <typename Function>
Function* real(const char* name) {
  static void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
  void* const function = library == nullptr ? nullptr : dlsym(library, name);
  if (function == nullptr) std::exit((std::fprintf(stderr, "phone: there is no %s\n", name), 3));
  return reinterpret_cast<Function*>(function);
}

EGLBoolean fail(EGLint code) {
  error = code;
  return EGL_FALSE;
}

}  // namespace
}  // namespace phone

#define REAL(name) phone::real<decltype(name)>(#name)

extern "C" {

EGLDisplay eglGetDisplay(EGLNativeDisplayType) {
  const auto get =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(REAL(eglGetProcAddress)("eglGetPlatformDisplayEXT"));
  return get(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}
EGLBoolean eglInitialize(EGLDisplay display, EGLint* major, EGLint* minor) {
  return REAL(eglInitialize)(display, major, minor);
}
EGLBoolean eglTerminate(EGLDisplay display) {
  return REAL(eglTerminate)(display);
}
EGLint eglGetError() {
  const EGLint out = phone::error;
  phone::error = EGL_SUCCESS;
  return out;
}
__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* name) {
  return REAL(eglGetProcAddress)(name);
}
EGLBoolean eglChooseConfig(EGLDisplay display, const EGLint* wanted, EGLConfig* configs, EGLint size, EGLint* count) {
  std::vector<EGLint> changed;
  for (; *wanted != EGL_NONE; wanted += 2) {
    changed.push_back(wanted[0]);
    changed.push_back(wanted[0] == EGL_SURFACE_TYPE ? EGL_PBUFFER_BIT : wanted[1]);
  }
  changed.push_back(EGL_NONE);
  return REAL(eglChooseConfig)(display, changed.data(), configs, size, count);
}
EGLBoolean eglGetConfigAttrib(EGLDisplay display, EGLConfig config, EGLint name, EGLint* value) {
  return REAL(eglGetConfigAttrib)(display, config, name, value);
}
EGLContext eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext share, const EGLint* wanted) {
  if (!phone::screen.makes_contexts) return phone::fail(EGL_BAD_ALLOC), EGL_NO_CONTEXT;
  ++phone::screen.contexts;
  ++phone::screen.alive_contexts;
  return REAL(eglCreateContext)(display, config, share, wanted);
}
EGLBoolean eglDestroyContext(EGLDisplay display, EGLContext context) {
  --phone::screen.alive_contexts;
  return REAL(eglDestroyContext)(display, context);
}
EGLSurface eglCreateWindowSurface(EGLDisplay display, EGLConfig config, EGLNativeWindowType window, const EGLint*) {
  if (window == EGLNativeWindowType{}) return phone::fail(EGL_BAD_NATIVE_WINDOW), EGL_NO_SURFACE;
  const EGLint size[] = {EGL_WIDTH, phone::screen.width, EGL_HEIGHT, phone::screen.height, EGL_NONE};
  ++phone::screen.alive_surfaces;
  return REAL(eglCreatePbufferSurface)(display, config, size);
}
EGLBoolean eglDestroySurface(EGLDisplay display, EGLSurface surface) {
  --phone::screen.alive_surfaces;
  return REAL(eglDestroySurface)(display, surface);
}
EGLBoolean eglQuerySurface(EGLDisplay display, EGLSurface surface, EGLint name, EGLint* value) {
  return REAL(eglQuerySurface)(display, surface, name, value);
}
EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
  return REAL(eglMakeCurrent)(display, draw, read, context);
}
EGLBoolean eglSwapBuffers(EGLDisplay, EGLSurface) {
  phone::Screen& screen = phone::screen;
  if (screen.frames++ == screen.lose_at_frame) return phone::fail(EGL_CONTEXT_LOST);
  screen.rgba.resize(4 * static_cast<std::size_t>(screen.width) * static_cast<std::size_t>(screen.height));
  glReadPixels(0, 0, screen.width, screen.height, GL_RGBA, GL_UNSIGNED_BYTE, screen.rgba.data());
  if (const GLenum wrong = glGetError(); wrong != GL_NO_ERROR)
    std::exit((std::fprintf(stderr, "phone: GL error 0x%04x\n", wrong), 1));
  return EGL_TRUE;
}
}
