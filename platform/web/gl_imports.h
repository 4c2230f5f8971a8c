// OpenGL ES 3.0 as gl.mjs gives it to WebAssembly: declares functions of module "gl", and finds them by name.
#pragma once

#include <cstring>

// Both are for lists as MARROW_GLES3_FUNCTIONS. A load_proc is
//
//   MARROW_GLES3_FUNCTIONS(MARROW_WEB_GL_DECLARE)
//   void* load_proc(const char* name) {
//     MARROW_GLES3_FUNCTIONS(MARROW_WEB_GL_FIND)
//     return nullptr;
//   }
#define MARROW_WEB_GL_DECLARE(Result, Name, Parameters) \
  extern "C" __attribute__((import_module("gl"), import_name("gl" #Name))) Result gl##Name Parameters;
#define MARROW_WEB_GL_FIND(Result, Name, Parameters) \
  if (std::strcmp(name, "gl" #Name) == 0) return reinterpret_cast<void*>(&gl##Name);
