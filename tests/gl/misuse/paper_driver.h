// A driver that draws nothing: it reads all that it is given, so that a sanitizer sees what is not there.
#pragma once

#include "marrow/gles3.h"

namespace marrow::test {

// Of OpenGL ES 3.1. Every call succeeds.
gles3::Api paper_api();
void* paper_proc(const char* name);

}  // namespace marrow::test
