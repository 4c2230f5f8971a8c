#include "text/number.h"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

namespace marrow::tools {

#ifdef __cpp_lib_to_chars

std::from_chars_result read_double(const char* first, const char* last, double& value) {
  return std::from_chars(first, last, value);
}

#else

namespace {

const char* skip_digits(const char* at, const char* last) {
  while (at != last && *at >= '0' && *at <= '9') ++at;
  return at;
}

// Behind [-]digits[.digits][e[+-]digits]; `first` where that is no number.
const char* end_of_number(const char* first, const char* last) {
  const char* at = first != last && *first == '-' ? first + 1 : first;
  const char* const whole = at;
  at = skip_digits(at, last);
  std::ptrdiff_t digits = at - whole;
  if (at != last && *at == '.') {
    const char* const point = at++;
    at = skip_digits(at, last);
    digits += at - point - 1;
  }
  if (digits == 0) return first;
  if (at == last || (*at != 'e' && *at != 'E')) return at;
  const char* power = at + 1;
  if (power != last && (*power == '+' || *power == '-')) ++power;
  const char* const end = skip_digits(power, last);
  return end == power ? at : end;
}

}  // namespace

// Infinity and what is no number are none here: no caller takes them.
std::from_chars_result read_double(const char* first, const char* last, double& value) {
  const char* const end = end_of_number(first, last);
  if (end == first) return {first, std::errc::invalid_argument};
  errno = 0;
  const double read = std::strtod(std::string(first, end).c_str(), nullptr);
  if (errno == ERANGE && (std::isinf(read) || read == 0)) return {end, std::errc::result_out_of_range};
  value = read;
  return {end, std::errc()};
}

#endif

}  // namespace marrow::tools
