// Words in a page or a drawing.
#pragma once

#include <string>
#include <string_view>

namespace marrow::tools {

// Text of a page's body, with nothing in it that HTML or SVG would take for markup.
std::string html_text(std::string_view text);

}  // namespace marrow::tools
