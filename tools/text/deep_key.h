// Guards toml++ against keys that nest too deep for it and for the stack.
#pragma once

#include <cstddef>
#include <string_view>

namespace marrow::tools {

// The line, from 1, on which keys are dotted more than kMostDots times, or 0. Each dot nests a table, and neither
// toml++ 3.3 nor the stack is prepared for thousands; lists and inline tables end at 256.
std::size_t line_of_deep_key(std::string_view text);

}  // namespace marrow::tools
