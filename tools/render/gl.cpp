#include "render/gl.h"

#include <cstdio>

#include "common/failure.h"

namespace marrow::tools {
namespace {

template <class Function>
void load_one(Gl::LoadProc load_proc, gles3::Entry<Function>& entry) {
  entry = reinterpret_cast<Function*>(load_proc(entry.name));
  if (entry == nullptr)
    throw Failure(Exit::unsupported, "OpenGL ES", "", std::string(entry.name) + " is missing", "use another driver");
}

[[maybe_unused]] void print_error(void*, const char* call, unsigned error) {
  std::fprintf(stderr, "OpenGL ES: %s: error 0x%04x\n", call, error);
}

std::string text(const gles3::Api& api, GLenum name) {
  const unsigned char* bytes = api.GetString(name);
  return bytes == nullptr ? "unknown" : reinterpret_cast<const char*>(bytes);
}

}  // namespace

void watch_all_errors(GlFunctions& gl, gles3::ErrorWatch* watch) {
  gles3::watch_errors(gl, watch);
#define MARROW_WATCH(Result, Name, Parameters) gl.Name.watch = watch;
  MARROW_TOOL_GL_FUNCTIONS(MARROW_WATCH)
#undef MARROW_WATCH
}

Gl::Gl(LoadProc load_proc) : Gl(nullptr, load_proc) {}

Gl::Gl(std::shared_ptr<void> context, LoadProc load_proc) : context_(std::move(context)) {
  const char* missing = "";
  if (gles3::load_api(*this, load_proc, &missing) != Status::ok) {
    throw Failure(Exit::unsupported, "OpenGL ES", "", std::string(missing) + " is missing", "use another driver");
  }
#define MARROW_LOAD(Result, Name, Parameters) load_one(load_proc, this->Name);
  MARROW_TOOL_GL_FUNCTIONS(MARROW_LOAD)
#undef MARROW_LOAD
#ifndef NDEBUG
  watch_.report = print_error;
  watch_all_errors(*this, &watch_);
#endif
  if (gles3::query_caps(*this, caps_) != Status::ok) {
    throw Failure(Exit::unsupported, "OpenGL ES", "", "the driver offers " + text(*this, GL_VERSION),
                  "OpenGL ES 3.0 is needed");
  }
  driver_ = text(*this, GL_RENDERER) + ", " + text(*this, GL_VERSION);
}

void Gl::check(const char* doing) const {
  if (gles3::context_was_reset(*this)) throw ContextLost(driver_);
  const GLenum error = GetError();
  if (error == GL_NO_ERROR) return;
  char code[16];
  std::snprintf(code, sizeof(code), "0x%04x", error);
  throw Failure(Exit::internal, "OpenGL ES", "", std::string("error ") + code + " while " + doing,
                "please report this with the driver: " + driver_);
}

}  // namespace marrow::tools
