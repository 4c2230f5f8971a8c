// What the wrappers of marrow::gles3 need beside those of the runtime.
#pragma once

#include "c/twin.h"
#include "marrow/gles3.h"
#if defined(__GNUC__)
#pragma GCC visibility push(default)
#include "marrow/c_gles3.h"
#pragma GCC visibility pop
#else
#include "marrow/c_gles3.h"
#endif

namespace marrow::c {

// Whether load_api() has filled it: it writes all that OpenGL ES 3.0 has, or nothing. Storage full of zeros is not.
inline bool is_ready(const gles3::Api& api) {
  return api.GetError.function != nullptr;
}

}  // namespace marrow::c
