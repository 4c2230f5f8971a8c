// For builds without an EGL library to link with: the functions that egl.cpp calls, from the one that is there when the
// program runs. Without one they all fail.
#include <EGL/egl.h>
#include <dlfcn.h>

namespace {

template <class Function>
Function* find(const char* name) {
  static void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  return library == nullptr ? nullptr : reinterpret_cast<Function*>(dlsym(library, name));
}

template <class Result>
Result failed() {
  return Result();
}

}  // namespace

#define MARROW_LATE(Result, Name, Parameters, Arguments)                \
  Result EGLAPIENTRY Name Parameters {                                  \
    static auto* const function = find<decltype(Name)>(#Name);          \
    return function != nullptr ? function Arguments : failed<Result>(); \
  }

MARROW_LATE(EGLBoolean, eglBindAPI, (EGLenum api), (api))
MARROW_LATE(EGLBoolean, eglChooseConfig,
            (EGLDisplay display, const EGLint* attributes, EGLConfig* configs, EGLint size, EGLint* count),
            (display, attributes, configs, size, count))
MARROW_LATE(EGLContext, eglCreateContext,
            (EGLDisplay display, EGLConfig config, EGLContext share, const EGLint* attributes),
            (display, config, share, attributes))
MARROW_LATE(EGLSurface, eglCreatePbufferSurface, (EGLDisplay display, EGLConfig config, const EGLint* attributes),
            (display, config, attributes))
MARROW_LATE(EGLBoolean, eglDestroyContext, (EGLDisplay display, EGLContext context), (display, context))
MARROW_LATE(EGLBoolean, eglDestroySurface, (EGLDisplay display, EGLSurface surface), (display, surface))
MARROW_LATE(EGLDisplay, eglGetDisplay, (EGLNativeDisplayType native), (native))
MARROW_LATE(EGLint, eglGetError, (), ())
MARROW_LATE(__eglMustCastToProperFunctionPointerType, eglGetProcAddress, (const char* name), (name))
MARROW_LATE(EGLBoolean, eglInitialize, (EGLDisplay display, EGLint* major, EGLint* minor), (display, major, minor))
MARROW_LATE(EGLBoolean, eglMakeCurrent, (EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context),
            (display, draw, read, context))
MARROW_LATE(const char*, eglQueryString, (EGLDisplay display, EGLint name), (display, name))
MARROW_LATE(EGLBoolean, eglTerminate, (EGLDisplay display), (display))
