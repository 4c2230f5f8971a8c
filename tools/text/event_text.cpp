#include "text/event_text.h"

#include <charconv>
#include <cmath>

#include "text/number.h"

namespace marrow::tools {
namespace {

constexpr double kLargest = 1e9;

bool read_number(std::string_view text, double& out) {
  if (text.starts_with('+')) return false;
  const auto [end, error] = read_double(text.data(), text.data() + text.size(), out);
  return error == std::errc{} && end == text.data() + text.size() && std::abs(out) <= kLargest;
}

}  // namespace

bool read_moment(std::string_view text, ClipMoment& out) {
  out.is_share = text.ends_with('%');
  if (out.is_share || text.ends_with('s')) text.remove_suffix(1);
  if (!read_number(text, out.value) || out.value < 0) return false;
  if (out.is_share) out.value /= 100;
  return !out.is_share || out.value <= 1;
}

bool read_event(std::string_view text, EventText& out) {
  const std::size_t at = text.rfind('@');
  if (at == std::string_view::npos || at == 0) return false;
  out.name = text.substr(0, at);
  text.remove_prefix(at + 1);
  out.number = 0;
  if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
    if (!read_number(text.substr(colon + 1), out.number)) return false;
    text = text.substr(0, colon);
  }
  const std::size_t dots = text.find("..");
  if (!read_moment(text.substr(0, dots), out.from)) return false;
  out.until = out.from;
  return dots == std::string_view::npos || read_moment(text.substr(dots + 2), out.until);
}

}  // namespace marrow::tools
