// Start of the GPU road: the driver's entry points and what the context can do.
#include "gles3/gl_constants.h"
#include "marrow/gles3.h"

namespace marrow::gles3 {
namespace {

template <class Function>
bool load_one(Function& function, void* (*load_proc)(const char*), const char* name) {
  function = reinterpret_cast<Function>(load_proc(name));
  return function != nullptr;
}

// Reads "OpenGL ES 3.1 …" → 3; 0 for anything else. GL_MAJOR_VERSION is no use here: GLES 2 does not know it.
int es_major_version(const unsigned char* text) {
  const char* prefix = "OpenGL ES ";
  if (text == nullptr) return 0;
  for (; *prefix != '\0'; ++prefix, ++text) {
    if (*text != static_cast<unsigned char>(*prefix)) return 0;
  }
  return *text >= '0' && *text <= '9' ? *text - '0' : 0;
}

}  // namespace

Status load_api(Api& api, void* (*load_proc)(const char* name), const char** missing) {
  if (load_proc == nullptr) return Status::bad_argument;
  Api loaded;
#define MARROW_LOAD(Result, Name, Parameters)          \
  if (!load_one(loaded.Name, load_proc, "gl" #Name)) { \
    if (missing != nullptr) *missing = "gl" #Name;     \
    return Status::unsupported;                        \
  }
  MARROW_GLES3_FUNCTIONS(MARROW_LOAD)
#undef MARROW_LOAD
  api = loaded;
  return Status::ok;
}

Status query_caps(const Api& api, Caps& caps) {
  if (es_major_version(api.GetString(kGlVersion)) < 3) return Status::unsupported;
  int block = 0;
  int alignment = 0;
  int attributes = 0;
  api.GetIntegerv(kGlMaxUniformBlockSize, &block);
  api.GetIntegerv(kGlUniformBufferOffsetAlignment, &alignment);
  api.GetIntegerv(kGlMaxVertexAttribs, &attributes);
  if (block <= 0 || alignment <= 0 || attributes <= 0) return Status::gl_error;
  caps = {static_cast<std::uint32_t>(block), static_cast<std::uint32_t>(alignment),
          static_cast<std::uint32_t>(attributes)};
  return Status::ok;
}

}  // namespace marrow::gles3
