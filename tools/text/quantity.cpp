#include "text/quantity.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace marrow::tools {
namespace {

constexpr int kMostDecimals = 9;

}  // namespace

std::string plain_number(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return fmt::format("{:g}", std::fabs(value));
  // Scientific notation knows where the first digit stands, and log10() differs between libraries.
  const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  std::string out = fmt::format("{:.{}f}", value, std::clamp(digits - 1 - exponent, 0, kMostDecimals));
  if (out.find('.') != std::string::npos) {
    out.erase(out.find_last_not_of('0') + 1);
    if (out.back() == '.') out.pop_back();
  }
  return out == "-0" ? "0" : out;
}

std::string length_text(double length_m) {
  return plain_number(std::fabs(length_m) < 1e-9 ? 0 : 1e3 * length_m) + " mm";
}

std::string bytes_text(std::uint64_t bytes) {
  const auto n = static_cast<double>(bytes);
  if (bytes < 1000) return fmt::format("{} byte{}", bytes, bytes == 1 ? "" : "s");
  if (n < 999'500) return plain_number(n / 1e3, 2) + " kB";
  return plain_number(n / 1e6, 2) + " MB";
}

}  // namespace marrow::tools
