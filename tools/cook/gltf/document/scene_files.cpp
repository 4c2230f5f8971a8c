// What an untrusted scene names by URIs: bytes in the URI itself, or files.
#include "cook/gltf/document/scene_files.h"

#include <algorithm>
#include <cctype>

#include "common/failure.h"
#include "common/hash.h"
#include "common/retold.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::size_t kLongestPath = 4096;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percent_decode(std::string_view text, const std::string& where, const Report& report) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0) report.invalid(where, "malformed URI", "'%' must be followed by two hexadecimal digits");
    decoded += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return decoded;
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  if (c == '/') return 63;
  return -1;
}

std::vector<std::byte> decode_base64(std::string_view text, const std::string& where, const Report& report) {
  const auto refuse = [&](const char* why) { report.invalid(where, "malformed base64", why); };
  if (text.size() % 4 != 0) refuse("the length must be a multiple of four");
  std::size_t padding = 0;
  while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') ++padding;
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3);
  unsigned bits = 0;
  unsigned bit_count = 0;
  for (const char c : text.substr(0, text.size() - padding)) {
    const int digit = base64_digit(c);
    if (digit < 0) refuse("a character is outside the alphabet");
    bits = (bits << 6 | static_cast<unsigned>(digit)) & 0xFFFF;
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    bytes.push_back(static_cast<std::byte>(bits >> bit_count));
  }
  if ((bits & ((1U << bit_count) - 1)) != 0) refuse("the bits after the last byte are not zero");
  return bytes;
}

// "data:" [ type "/" subtype ] *( ";" attribute "=" value ) [ ";base64" ]; returns whether it is base64.
bool check_data_header(std::string_view header, const std::string& where, const Report& report) {
  bool base64 = false;
  for (std::size_t start = header.find(';'); start != std::string_view::npos;) {
    const std::size_t end = header.find(';', start + 1);
    const std::string_view part = header.substr(start + 1, end == std::string_view::npos ? end : end - start - 1);
    if (base64) report.invalid(where, "malformed data URI", "\";base64\" must come last before the comma");
    if (part == "base64") {
      base64 = true;
    } else if (const std::size_t equals = part.find('='); equals == 0 || equals == std::string_view::npos) {
      report.invalid(where, "malformed data URI", "a parameter must be like \";name=value\"");
    }
    start = end;
  }
  return base64;
}

bool has_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string_view::npos && colon < uri.find_first_of("/?#");
}

}  // namespace

bool is_data_uri(std::string_view uri) {
  constexpr std::string_view kScheme = "data:";
  return uri.size() >= kScheme.size() && std::equal(kScheme.begin(), kScheme.end(), uri.begin(), [](char a, char b) {
           return a == std::tolower(static_cast<unsigned char>(b));
         });
}

DataUri decode_data_uri(std::string_view uri, const std::string& where, const Report& report) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) report.invalid(where, "malformed data URI", "there is no comma before the data");
  const std::string_view header = uri.substr(5, comma - 5);
  const bool base64 = check_data_header(header, where, report);
  DataUri result;
  for (const char c : header.substr(0, header.find(';'))) {
    result.mime_type += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  const std::string_view data = uri.substr(comma + 1);
  if (base64) {
    result.bytes = decode_base64(data, where, report);
  } else {
    const std::string text = percent_decode(data, where, report);
    for (const char c : text) result.bytes.push_back(static_cast<std::byte>(c));
  }
  return result;
}

std::string decode_relative_uri(std::string_view uri, const std::string& where, const Report& report) {
  const auto refuse = [&](const char* why) {
    report.invalid(where, "URI not allowed", std::string(why) + "; put the file beside the scene");
  };
  if (uri.empty()) refuse("it is empty");
  if (has_scheme(uri)) refuse("it has a scheme or a drive");
  const std::string path = percent_decode(uri, where, report);
  if (path.size() > kLongestPath) refuse("it is too long");
  if (path.front() == '/' || path.front() == '~') refuse("it is absolute");
  if (path.find('\\') != std::string::npos) refuse("it has a backslash");
  if (has_scheme(path)) refuse("it has a scheme or a drive");
  if (std::ranges::any_of(path, [](unsigned char c) { return c < 0x20 || c == 0x7F; })) {
    refuse("it has a control character");
  }
  for (std::size_t start = 0; start <= path.size();) {
    const std::size_t end = std::min(path.find('/', start), path.size());
    if (path.compare(start, end - start, "..") == 0) refuse("it leads out of the scene's folder");
    start = end + 1;
  }
  return path;
}

namespace {

// What the caller's files say, at the place in the scene.
template <class Ask>
auto located(const std::string& where, const Report& report, const Ask& ask) {
  return tools::retold<tools::Failure>(ask, [&](const tools::Failure& failure) -> tools::Failure {
    report.fail(failure.code(), where, failure.rule(), failure.advice());
  });
}

}  // namespace

std::vector<std::byte> read_scene_file(Files& files, const std::string& name, std::uint64_t at_most,
                                       const std::string& where, Report& report) {
  std::vector<std::byte> bytes = located(where, report, [&] {
    std::vector<std::byte> read = files.read(name, at_most);
    if (read.size() > kMostBytes) throw too_large(name);
    return read;
  });
  report.note_read({name, bytes.size(), tools::hash_of(bytes)});
  return bytes;
}

std::string name_beside(Files* files, const std::string& scene, const std::string& uri, const char* what,
                        const std::string& where, const Report& report) {
  const std::string relative = decode_relative_uri(uri, where, report);
  if (files == nullptr)
    report.unreadable(where, "cannot read", std::string("a scene in memory has no folder; embed the ") + what);
  return located(where, report, [&] { return files->beside(scene, relative); });
}

}  // namespace marrow::cook::gltf
