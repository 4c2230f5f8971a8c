// An OpenGL ES context without a window, for programs in C.
#pragma once

#include <stdlib.h>
#include <string.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

static EGLDisplay display = EGL_NO_DISPLAY;
static EGLContext context = EGL_NO_CONTEXT;

// ISO C has no cast from functions to objects.
static void* load_proc(const char* name) {
  const __eglMustCastToProperFunctionPointerType function = eglGetProcAddress(name);
  void* out = NULL;
  memcpy(&out, &function, sizeof out);
  return out;
}

static void open_context(void) {
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
  const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_display = NULL;
  void* const function = load_proc("eglGetPlatformDisplayEXT");
  EGLConfig config = NULL;
  EGLint count = 0;
  memcpy(&get_display, &function, sizeof get_display);
  if (get_display == NULL) exit(77);
  display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_ES_API) ||
      !eglChooseConfig(display, wanted, &config, 1, &count) || count < 1)
    exit(77);
  context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) exit(77);
}

static void close_context(void) {
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, context);
  eglTerminate(display);
}
