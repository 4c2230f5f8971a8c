// Contexts without a window.
#include "common/failure.h"
#include "marrow/egl.h"
#include "render/gl.h"

namespace marrow::tools {
namespace {

std::shared_ptr<egl::HeadlessContext> make_headless() {
  auto context = std::make_shared<egl::HeadlessContext>();
  if (context->create() != Status::ok) {
    throw Failure(Exit::unsupported, "OpenGL ES", "", context->error(),
                  "install a driver (Debian: libegl1 and libgl1-mesa-dri)");
  }
  return context;
}

}  // namespace

Gl::Gl() : Gl(make_headless(), egl::load_proc) {}

}  // namespace marrow::tools
