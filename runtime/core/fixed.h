// Numbers that a function is made for.
#pragma once

#include <type_traits>

namespace marrow {

// A number that is known when code is compiled, and is used like any other.
template <auto Value>
using Fixed = std::integral_constant<decltype(Value), Value>;

}  // namespace marrow
