#include "cook/options/read_value.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "common/failure.h"
#include "text/number.h"
#include "text/printable.h"

namespace marrow::cook {

void refuse(const Value& value, const std::string& rule, const std::string& advice) {
  throw tools::Failure(tools::Exit::usage, value.origin.file, value.origin.where, tools::printable(rule), advice);
}

bool read_amount(std::string_view text, Amount& out) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = tools::read_double(text.data(), end, out.value);
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  const double scale = unit == "m" ? 1.0 : unit == "cm" ? 1e-2 : unit == "mm" ? 1e-3 : unit == "%" ? 1e-2 : 0.0;
  out.is_share = unit == "%";
  out.value *= scale;
  return error == std::errc() && out.value > 0 && std::isfinite(out.value);
}

double number_between(const Value& given, double least, double most) {
  double value = 0;
  const char* const end = given.text.data() + given.text.size();
  const auto [stop, error] = tools::read_double(given.text.data(), end, value);
  if (error != std::errc() || stop != end || !(value >= least && value <= most))
    refuse(given, "\"" + given.text + "\" is out of range",
           "give a number from " + fmt::format("{}", least) + " to " + fmt::format("{}", most));
  return value;
}

int whole_number(const Value& given, int least, int most) {
  const double value = number_between(given, least, most);
  if (value != std::floor(value)) refuse(given, "\"" + given.text + "\" is no whole number", "give one, as in 4");
  return static_cast<int>(value);
}

}  // namespace marrow::cook
