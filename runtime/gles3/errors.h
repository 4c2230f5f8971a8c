// Tells the caller's old GL errors from those of a call that checks its own.
#pragma once

#include "gles3/gl_constants.h"
#include "marrow/gles3.h"

namespace marrow::gles3 {

// A lost context may report its loss for ever, so this gives up after as many errors as GL has kinds.
inline void forget_errors(const Api& api) {
  for (int i = 0; i < 8 && api.GetError() != kGlNoError; ++i) {
  }
}

}  // namespace marrow::gles3
