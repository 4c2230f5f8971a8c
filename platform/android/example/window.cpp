#include "window.h"

#include <EGL/eglext.h>
#include <android/native_activity.h>

Window::~Window() {
  set({});
  if (display_ == EGL_NO_DISPLAY) return;
  lose_context();
  eglTerminate(display_);
}

void Window::close_surface() {
  if (surface_ == EGL_NO_SURFACE) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroySurface(display_, surface_);
  surface_ = EGL_NO_SURFACE;
}

void Window::set(EGLNativeWindowType window) {
  close_surface();
  window_ = window;
}

void Window::lose_context() {
  close_surface();
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  context_ = EGL_NO_CONTEXT;
}

bool Window::fail() {
  error_ = eglGetError();
  return false;
}

bool Window::open_display() {
  if (display_ != EGL_NO_DISPLAY) return true;
  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return fail();
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_ES3_BIT_KHR,
                           EGL_SURFACE_TYPE,
                           EGL_WINDOW_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_GREEN_SIZE,
                           8,
                           EGL_BLUE_SIZE,
                           8,
                           EGL_DEPTH_SIZE,
                           16,
                           EGL_NONE};
  EGLint count = 0;
  if (eglChooseConfig(display, wanted, &config_, 1, &count) != EGL_TRUE || count < 1) {
    fail();
    if (error_ == EGL_SUCCESS) error_ = EGL_BAD_CONFIG;  // there is none like it
    eglTerminate(display);
    return false;
  }
  display_ = display;
  return true;
}

bool Window::make_current() {
  if (surface_ != EGL_NO_SURFACE) return true;
  if (!open_display()) return false;
  if (context_ == EGL_NO_CONTEXT) {
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
    context_ = eglCreateContext(display_, config_, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT) return fail();
    ++contexts_;
  }
  EGLint format = 0;
  eglGetConfigAttrib(display_, config_, EGL_NATIVE_VISUAL_ID, &format);
  ANativeWindow_setBuffersGeometry(window_, 0, 0, format);
  surface_ = eglCreateWindowSurface(display_, config_, window_, nullptr);
  if (surface_ == EGL_NO_SURFACE) return fail();
  if (eglMakeCurrent(display_, surface_, surface_, context_) != EGL_TRUE) {
    fail();
    lose_context();  // the next call makes another
    return false;
  }
  eglQuerySurface(display_, surface_, EGL_WIDTH, &width_);
  eglQuerySurface(display_, surface_, EGL_HEIGHT, &height_);
  return true;
}

bool Window::show() {
  if (eglSwapBuffers(display_, surface_) == EGL_TRUE) {
    eglQuerySurface(display_, surface_, EGL_WIDTH, &width_);  // the screen may have been turned
    eglQuerySurface(display_, surface_, EGL_HEIGHT, &height_);
    return true;
  }
  fail();
  if (error_ == EGL_CONTEXT_LOST)
    lose_context();
  else
    close_surface();
  return false;
}
