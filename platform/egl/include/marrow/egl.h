// An OpenGL ES 3.0 context without a window or a screen: what tools and tests render in.
#pragma once

#include "marrow/api.h"
#include "marrow/status.h"

namespace marrow::egl {

// Owns an EGL context that is current on the thread that created it. Neither copied nor moved.
class HeadlessContext {
 public:
  HeadlessContext() = default;
  MARROW_API ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  // Makes an OpenGL ES context of at least this version current. What it draws in is up to framebuffer objects: where
  // EGL insists on a surface it gets one pixel.
  // Tried in this order: ANGLE on Vulkan in software, if the EGL library in the process is ANGLE's; Mesa's surfaceless
  // platform; the default display.
  // Where the display offers it, the context is one that is lost when the graphics processor is reset and tells so, see
  // marrow::gles3::context_was_reset(); where that is refused, an ordinary one.
  // Errors: bad_argument if there is a context already; unsupported, with error() saying which step refused and EGL's
  // error code.
  MARROW_API Status create(int major = 3, int minor = 0);

  // One line in English about the last create(); empty after success.
  const char* error() const { return error_; }
  // Which of the three it came to: "ANGLE", "surfaceless" or "default display".
  const char* platform() const { return platform_; }
  // Whether the context tells of resets.
  bool tells_of_resets() const { return tells_of_resets_; }

 private:
  bool open_display();
  bool create_context(int major, int minor);
  bool fail(const char* step);
  void release();

  void* display_ = nullptr;
  void* context_ = nullptr;
  void* surface_ = nullptr;
  bool initialised_ = false;
  bool tells_of_resets_ = false;
  const char* platform_ = "";
  char error_[128] = {};
};

// Address of a GL function for marrow::gles3::load_api(); null if there is none.
MARROW_API void* load_proc(const char* name);

}  // namespace marrow::egl
