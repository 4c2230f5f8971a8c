// The window and the OpenGL ES context, which come and go apart from each other.
#pragma once

#include <EGL/egl.h>

class Window {
 public:
  Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window();

  // Draws to this window from now on; null: to none, as while the app is in the background. The context stays.
  void set(EGLNativeWindowType window);
  bool is_there() const { return window_ != nullptr; }

  // Whether one can draw now. Makes what is missing of display, context and surface. false: error() says why.
  bool make_current();
  // How many contexts were made: in one more than before there is nothing yet.
  int contexts() const { return contexts_; }
  // Shows what was drawn; false: the context is lost, or the surface, and was let go.
  bool show();
  void lose_context();

  int width() const { return width_; }
  int height() const { return height_; }
  EGLint error() const { return error_; }  // of EGL; see eglGetError

 private:
  bool open_display();
  bool fail();
  void close_surface();

  EGLNativeWindowType window_ = {};
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLConfig config_ = nullptr;
  EGLContext context_ = EGL_NO_CONTEXT;
  EGLSurface surface_ = EGL_NO_SURFACE;
  int contexts_ = 0, width_ = 0, height_ = 0;
  EGLint error_ = EGL_SUCCESS;
};
