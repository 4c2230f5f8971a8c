#include "text/safe_name.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "text/printable.h"

namespace marrow::tools {
namespace {

constexpr std::size_t kLongestName = 1024;

bool is_path(std::string_view name) {
  if (name.empty()) return false;
  if (name.front() == '/' || name.front() == '\\') return true;
  for (std::size_t start = 0; start <= name.size();) {
    const std::size_t end = std::min(name.find_first_of("/\\", start), name.size());
    if (name.substr(start, end - start) == "..") return true;
    start = end + 1;
  }
  return false;
}

// Names that some systems take for a device, with or without an extension.
bool is_device(std::string_view name) {
  std::string stem;
  for (const char c : name.substr(0, name.find('.'))) {
    stem += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  constexpr std::array<std::string_view, 4> kDevices = {"con", "prn", "aux", "nul"};
  if (std::ranges::find(kDevices, stem) != kDevices.end()) return true;
  return stem.size() == 4 && (stem.starts_with("com") || stem.starts_with("lpt")) && stem[3] >= '1' && stem[3] <= '9';
}

}  // namespace

std::string safe_name(std::string_view name) {
  const bool path = is_path(name);
  std::string safe;
  safe.reserve(std::min(name.size(), kLongestName));
  for (std::size_t at = 0; at < name.size();) {
    const auto [code, length] = decode_character(name, at);
    if (safe.size() + length > kLongestName) break;
    const bool separator = path && (code == '/' || code == '\\');
    if (is_deceptive(code) || separator) {
      safe += '_';
    } else {
      safe.append(name, at, length);
    }
    at += length;
  }
  if (is_device(safe) || safe == "." || safe == "..") safe += '_';
  return safe;
}

}  // namespace marrow::tools
