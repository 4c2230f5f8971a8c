// Centres of helpers as packed files hold them: whole numbers times a power of two (runtime/unpack/rest.h).
#pragma once

#include <cstdint>

namespace marrow::cook {

// The least exponent of two, within what a byte of a file holds, by which `longest` is at most `most` steps.
std::int32_t exponent_for(float longest, std::int32_t most);

// The whole number of steps of 2^exponent nearest to a number.
float whole_steps(float number, std::int32_t exponent);

}  // namespace marrow::cook
