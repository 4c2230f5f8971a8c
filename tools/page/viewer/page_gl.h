// OpenGL ES 3.0 as a page has it.
#pragma once

namespace marrow::tools {

// A function by its name, as Gl takes it; null where WebGL 2 has none.
void* load_page_gl(const char* name);

}  // namespace marrow::tools
