// Which words say what a joint is: those of English, and of other languages that artists name joints in.
#pragma once

#include <optional>
#include <string_view>

#include "cook/roles/name_words.h"

namespace marrow::cook {

// Of small letters from a to z; nothing: no word that is known.
std::optional<Word> known_word(std::string_view text);

}  // namespace marrow::cook
