// Text of an untrusted scene, on its way to a terminal or a file name.
#include "text/printable.h"

namespace marrow::tools {
namespace {

constexpr std::size_t kLongestText = 400;

}  // namespace

DecodedCharacter decode_character(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[at + i])); };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (lead < 0xC2 || lead > 0xF4 || length > text.size() - at) return {0, 1};
  std::uint32_t code = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {0, 1};
    code = code << 6 | (byte(i) & 0x3F);
  }
  return {code, length};
}

bool is_deceptive(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x200B && code <= 0x200F) ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF ||
         (code >= 0xFFF9 && code <= 0xFFFF);
}

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    if (result.size() > kLongestText) return result + "...";
    const DecodedCharacter character = decode_character(text, at);
    if (is_deceptive(character.code)) {
      result += '?';
    } else {
      result.append(text, at, character.length);
    }
    at += character.length;
  }
  return result;
}

}  // namespace marrow::tools
