// Makes names of an untrusted scene fit to print and to become file names.
#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "cook/gltf/import/import.h"
#include "text/printable.h"

namespace marrow::cook::gltf {
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

std::string clean_name(const std::string& name, const std::string& where, Report& report) {
  const bool path = is_path(name);
  std::string clean;
  clean.reserve(name.size());
  for (std::size_t at = 0; at < name.size();) {
    const auto [code, length] = tools::decode_character(name, at);
    if (clean.size() + length > kLongestName) break;
    const bool separator = path && (code == '/' || code == '\\');
    if (tools::is_deceptive(code) || separator) {
      clean += '_';
    } else {
      clean.append(name, at, length);
    }
    at += length;
  }
  if (is_device(clean) || clean == "." || clean == "..") clean += '_';
  if (clean != name)
    report.warn(under(where, "name"), "name-cleaned", "unfit to print or to name a file; now \"" + clean + '"');
  return clean;
}

}  // namespace marrow::cook::gltf
