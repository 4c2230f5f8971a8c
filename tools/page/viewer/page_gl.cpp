#include "page/viewer/page_gl.h"

#include "gl_imports.h"
#include "render/gl.h"

MARROW_GLES3_FUNCTIONS(MARROW_WEB_GL_DECLARE)
MARROW_TOOL_GL_FUNCTIONS(MARROW_WEB_GL_DECLARE)

namespace marrow::tools {

void* load_page_gl(const char* name) {
  MARROW_GLES3_FUNCTIONS(MARROW_WEB_GL_FIND)
  MARROW_TOOL_GL_FUNCTIONS(MARROW_WEB_GL_FIND)
  return nullptr;
}

}  // namespace marrow::tools
