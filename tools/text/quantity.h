// Numbers as people read them: so many digits, no exponent, a unit that fits.
#pragma once

#include <cstdint>
#include <string>

namespace marrow::tools {

// Rounded to so many significant digits, but never before the point, without zeros at the end: "1.1", "1235", "0".
std::string plain_number(double value, int digits = 3);

// Of millimetres; what is less than a nanometre is zero: "12.5 mm", "0.0031 mm", "0 mm".
std::string length_text(double length_m);

// "812 bytes", "4.1 MB": of a thousand and a million.
std::string bytes_text(std::uint64_t bytes);

}  // namespace marrow::tools
