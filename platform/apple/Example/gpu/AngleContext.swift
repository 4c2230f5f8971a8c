// OpenGL ES 3.0 over Metal, by ANGLE, for marrow/c_gles3.h. The app's bridging header includes ANGLE's EGL/egl.h,
// EGL/eglext.h and EGL/eglext_angle.h.
import Foundation
import MarrowKit

typealias FindGL = @convention(c) (UnsafePointer<CChar>?) -> UnsafeMutableRawPointer?

/// GL's functions by name.
func loadGL(_ find: @escaping FindGL) throws -> mrw_gles3_api {
  var api = mrw_gles3_api()
  var missing: UnsafePointer<CChar>?
  let status = mrw_gles3_load_api(&api, find, &missing)
  try check(status, "OpenGL ES 3.0" + (missing.map { ": there is no \(String(cString: $0))" } ?? ""))
  return api
}

struct AngleContext {
  let display: EGLDisplay
  let surface: EGLSurface
  let context: EGLContext
  var api: mrw_gles3_api

  /// layer: a CAMetalLayer, whose drawableSize is set. Makes the context current on this thread.
  init?(layer: AnyObject) throws {
    let metal = [EGL_PLATFORM_ANGLE_TYPE_ANGLE, EGL_PLATFORM_ANGLE_TYPE_METAL_ANGLE, EGL_NONE].map { EGLAttrib($0) }
    guard let display = eglGetPlatformDisplay(EGLenum(EGL_PLATFORM_ANGLE_ANGLE), nil, metal),
      eglInitialize(display, nil, nil) == EGL_TRUE
    else { return nil }
    let wanted: [EGLint] = [EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_DEPTH_SIZE, 24, EGL_NONE]
    let version: [EGLint] = [EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE]
    var config: EGLConfig?
    var count: EGLint = 0
    guard eglChooseConfig(display, wanted, &config, 1, &count) == EGL_TRUE, count == 1,
      let surface = eglCreateWindowSurface(display, config, Unmanaged.passUnretained(layer).toOpaque(), nil),
      let context = eglCreateContext(display, config, nil, version),
      eglMakeCurrent(display, surface, surface, context) == EGL_TRUE
    else { return nil }
    self.display = display
    self.surface = surface
    self.context = context
    api = try loadGL { unsafeBitCast(eglGetProcAddress($0), to: UnsafeMutableRawPointer?.self) }
  }

  func present() { _ = eglSwapBuffers(display, surface) }
}
