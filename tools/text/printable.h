// Text of an untrusted scene, on its way to a terminal or a file name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace marrow::tools {

struct DecodedCharacter {
  std::uint32_t code;
  std::size_t length;  // bytes
};

// The character at `at`; a byte that is no part of valid UTF-8 counts as a control character of its own.
DecodedCharacter decode_character(std::string_view text, std::size_t at);

// Control characters, line separators, byte-order marks and what reorders or hides text.
bool is_deceptive(std::uint32_t code);

// `text` without deceptive characters and of a length that a person may read.
std::string printable(std::string_view text);

}  // namespace marrow::tools
