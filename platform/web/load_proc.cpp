// Gives the page the function by which marrow.wasm finds OpenGL ES, for mrw_gles3_load_api(): see gl.mjs.
#include "gl_imports.h"
#include "marrow/gles3_functions.h"

MARROW_GLES3_FUNCTIONS(MARROW_WEB_GL_DECLARE)

namespace {

void* load_proc(const char* name) {
  MARROW_GLES3_FUNCTIONS(MARROW_WEB_GL_FIND)
  return nullptr;
}

}  // namespace

extern "C" __attribute__((export_name("marrow_load_proc"))) void* (*marrow_load_proc())(const char*) {
  return &load_proc;
}
