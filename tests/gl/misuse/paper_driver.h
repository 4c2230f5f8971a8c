// A driver that draws nothing: it reads all that it is given, so that a sanitizer sees what is not there.
#pragma once

#include <cstddef>

#include "marrow/gles3.h"

namespace marrow::test {

// Of OpenGL ES 3.1. Every call succeeds.
gles3::Api paper_api();
// How many calls all drivers of paper have had.
const std::size_t& paper_calls();
void* paper_proc(const char* name);

}  // namespace marrow::test
