// Makes names of an untrusted scene fit to print and to become file names.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <string_view>

#include "cook/gltf_import.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::size_t kLongestName = 1024;

// Decodes one character of valid UTF-8 (the JSON parser has seen to that) and its length in bytes.
std::pair<std::uint32_t, std::size_t> decode(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[at + i])); };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  std::uint32_t code = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) code = code << 6 | (byte(i) & 0x3F);
  return {code, length};
}

// Control characters, line separators, byte-order marks and what reorders or hides text.
bool is_deceptive(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x200B && code <= 0x200F) ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF ||
         (code >= 0xFFF9 && code <= 0xFFFF);
}

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
    const auto [code, length] = decode(name, at);
    if (clean.size() + length > kLongestName) break;
    const bool separator = path && (code == '/' || code == '\\');
    if (is_deceptive(code) || separator) {
      clean += '_';
    } else {
      clean.append(name, at, length);
    }
    at += length;
  }
  if (is_device(clean) || clean == "." || clean == "..") clean += '_';
  if (clean != name) report.warn(under(where, "name"), "name-cleaned", "unfit to print or to name a file; now \"" + clean + '"');
  return clean;
}

}  // namespace marrow::cook::gltf
