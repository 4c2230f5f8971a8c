#include "render/gl.h"

#include "common/failure.h"

namespace marrow::tools {
namespace {

template <class Function>
void load_one(Function& function, const char* name) {
  function = reinterpret_cast<Function>(egl::load_proc(name));
  if (function == nullptr)
    throw Failure(Exit::unsupported, "OpenGL ES", "", std::string(name) + " is missing", "use another driver");
}

std::string text(const gles3::Api& api, GLenum name) {
  const unsigned char* bytes = api.GetString(name);
  return bytes == nullptr ? "unknown" : reinterpret_cast<const char*>(bytes);
}

}  // namespace

Gl::Gl() {
  if (context_.create() != Status::ok) {
    throw Failure(Exit::unsupported, "OpenGL ES", "", context_.error(),
                  "install a driver (Debian: libegl1 and libgl1-mesa-dri)");
  }
  const char* missing = "";
  if (gles3::load_api(*this, egl::load_proc, &missing) != Status::ok) {
    throw Failure(Exit::unsupported, "OpenGL ES", "", std::string(missing) + " is missing", "use another driver");
  }
#define MARROW_LOAD(Result, Name, Parameters) load_one(this->Name, "gl" #Name);
  MARROW_TOOL_GL_FUNCTIONS(MARROW_LOAD)
#undef MARROW_LOAD
  if (gles3::query_caps(*this, caps_) != Status::ok) {
    throw Failure(Exit::unsupported, "OpenGL ES", "", "the driver offers " + text(*this, GL_VERSION),
                  "OpenGL ES 3.0 is needed");
  }
  driver_ = text(*this, GL_RENDERER) + ", " + text(*this, GL_VERSION);
}

void Gl::check(const char* doing) const {
  const GLenum error = GetError();
  if (error == GL_NO_ERROR) return;
  char code[16];
  std::snprintf(code, sizeof(code), "0x%04x", error);
  throw Failure(Exit::internal, "OpenGL ES", "", std::string("error ") + code + " while " + doing,
                "please report this with the driver: " + driver_);
}

}  // namespace marrow::tools
