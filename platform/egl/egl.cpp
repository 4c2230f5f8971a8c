// An OpenGL ES 3.0 context without a window or a screen.
#include "marrow/egl.h"

#include <EGL/egl.h>

#include <cstdint>
#include <cstdio>
#include <cstring>

namespace marrow::egl {
namespace {

// From the specifications of EGL_MESA_platform_surfaceless and of ANGLE's platform extensions.
constexpr EGLenum kPlatformSurfacelessMesa = 0x31DD;
constexpr EGLenum kPlatformAngle = 0x3202;
constexpr EGLint kPlatformAngleType = 0x3203;
constexpr EGLint kPlatformAngleTypeVulkan = 0x3450;
constexpr EGLint kPlatformAngleDeviceType = 0x3209;
constexpr EGLint kPlatformAngleDeviceTypeSwiftShader = 0x3487;
constexpr EGLint kOpenGlEs3Bit = 0x0040;
constexpr EGLint kContextMinorVersion = 0x30FB;
// EGL_EXT_create_context_robustness, and EGL 1.5 with a number of its own for the same attribute.
constexpr EGLint kResetNotificationExt = 0x3138;
constexpr EGLint kResetNotification = 0x31BD;
constexpr EGLint kLoseContextOnReset = 0x31BF;

using GetPlatformDisplay = EGLDisplay (*)(EGLenum platform, void* native, const EGLint* attributes);

// Whether `name` is one of the words of `list`.
bool has_extension(const char* list, const char* name) {
  if (list == nullptr) return false;
  const std::size_t length = std::strlen(name);
  for (const char* at = std::strstr(list, name); at != nullptr; at = std::strstr(at + length, name)) {
    const bool starts = at == list || at[-1] == ' ';
    const bool ends = at[length] == ' ' || at[length] == '\0';
    if (starts && ends) return true;
  }
  return false;
}

// The attribute by which this display is asked for contexts that tell of resets; EGL_NONE: none.
EGLint reset_attribute(EGLDisplay display) {
  if (has_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_EXT_create_context_robustness"))
    return kResetNotificationExt;
  const char* const version = eglQueryString(display, EGL_VERSION);
  const bool is_old = version == nullptr || std::strncmp(version, "1.", 2) != 0 || version[2] < '5';
  return is_old ? EGL_NONE : kResetNotification;
}

bool initialise(EGLDisplay display) {
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
}

}  // namespace

HeadlessContext::~HeadlessContext() {
  release();
}

void HeadlessContext::release() {
  if (initialised_) {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface_ != nullptr) eglDestroySurface(display_, surface_);
    if (context_ != nullptr) eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }
  display_ = context_ = surface_ = nullptr;
  initialised_ = tells_of_resets_ = false;
}

bool HeadlessContext::fail(const char* step) {
  std::snprintf(error_, sizeof(error_), "%s failed (EGL error 0x%04x)", step, static_cast<unsigned>(eglGetError()));
  return false;
}

bool HeadlessContext::open_display() {
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto get_display = reinterpret_cast<GetPlatformDisplay>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_display != nullptr && has_extension(client, "EGL_ANGLE_platform_angle")) {
    const EGLint attributes[] = {kPlatformAngleType, kPlatformAngleTypeVulkan, kPlatformAngleDeviceType,
                                 kPlatformAngleDeviceTypeSwiftShader, EGL_NONE};
    display_ = get_display(kPlatformAngle, nullptr, attributes);
    platform_ = "ANGLE";
    if (initialise(display_)) return true;
  }
  if (get_display != nullptr && has_extension(client, "EGL_MESA_platform_surfaceless")) {
    display_ = get_display(kPlatformSurfacelessMesa, nullptr, nullptr);
    platform_ = "surfaceless";
    if (initialise(display_)) return true;
  }
  display_ = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  platform_ = "default display";
  return initialise(display_) || fail("opening an EGL display");
}

bool HeadlessContext::create_context(int major, int minor) {
  if (eglBindAPI(EGL_OPENGL_ES_API) != EGL_TRUE) return fail("eglBindAPI");
  const char* extensions = eglQueryString(display_, EGL_EXTENSIONS);
  const bool surfaceless = has_extension(extensions, "EGL_KHR_surfaceless_context");
  const EGLint wanted[] = {EGL_SURFACE_TYPE, surfaceless ? 0 : EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, kOpenGlEs3Bit,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display_, wanted, &config, 1, &count) != EGL_TRUE || count == 0) {
    return fail("finding a configuration for OpenGL ES 3");
  }
  const EGLint reset = reset_attribute(display_);
  const EGLint robust[] = {EGL_CONTEXT_CLIENT_VERSION, major,   kContextMinorVersion, minor, reset,
                           kLoseContextOnReset,        EGL_NONE};
  const EGLint plain[] = {EGL_CONTEXT_CLIENT_VERSION, major, kContextMinorVersion, minor, EGL_NONE};
  if (reset != EGL_NONE) context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, robust);
  tells_of_resets_ = context_ != EGL_NO_CONTEXT;
  if (!tells_of_resets_) context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, plain);
  if (context_ == EGL_NO_CONTEXT) return fail("creating an OpenGL ES context");
  if (!surfaceless) {
    const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display_, config, size);
    if (surface_ == EGL_NO_SURFACE) return fail("creating a one-pixel surface");
  }
  return eglMakeCurrent(display_, surface_, surface_, context_) == EGL_TRUE || fail("eglMakeCurrent");
}

Status HeadlessContext::create(int major, int minor) {
  if (initialised_) return Status::bad_argument;
  error_[0] = '\0';
  initialised_ = open_display();
  if (initialised_ && create_context(major, minor)) return Status::ok;
  release();
  return Status::unsupported;
}

void* load_proc(const char* name) {
  return reinterpret_cast<void*>(eglGetProcAddress(name));
}

}  // namespace marrow::egl
