// Numbers out of text, the same in every locale.
#pragma once

#include <charconv>

namespace marrow::tools {

// std::from_chars() of a double, also where the standard library lacks it, as libc++ before 20.
std::from_chars_result read_double(const char* first, const char* last, double& value);

}  // namespace marrow::tools
