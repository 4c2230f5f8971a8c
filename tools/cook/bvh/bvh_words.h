// The text of a BVH file, word by word, with the line on which each stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "cook/gltf/document/findings.h"

namespace marrow::cook::bvh {

// Words are separated by white space. A brace is a word by itself, and a colon ends one. Everything that fails throws
// tools::Failure (invalid), located by the line.
class Words {
 public:
  // `text` and `report` live as long as this. Skips a byte-order mark; refuses a zero byte.
  Words(std::string_view text, const gltf::Report& report);

  // Of the next word; at the end of the file, of the end.
  std::size_t line() const { return line_; }
  // Of the word that was read last.
  std::size_t line_of_last() const { return line_behind_; }
  bool at_end() const { return at_ == text_.size(); }
  // How many bytes are left, from the next word on.
  std::size_t bytes_left() const { return text_.size() - at_; }
  // How many words stand on the line of the next one, from that on.
  std::size_t words_left_on_line() const;

  // Whether the next word is this one, in upper or lower case; if so, it is read.
  bool take(std::string_view word);
  // Fails if the next word is another. `of`: what it is a part of: "the joint of line 12".
  void expect(std::string_view word, const std::string& of);
  // The next word; `what` is missing if there is none.
  std::string_view next(const std::string& what);
  // What is left of the last word's line, up to an opening brace, without white space around it. May be empty.
  std::string_view rest_of_line();
  // Of finite size, at most 1e12 from zero; in any locale with a point.
  double number(const std::string& what);
  // Up to 2^32 - 1.
  std::uint32_t whole_number(const std::string& what);

  [[noreturn]] void fail(std::size_t line, const std::string& rule, const std::string& advice) const;
  // At the next word.
  [[noreturn]] void fail(const std::string& rule, const std::string& advice) const { fail(line_, rule, advice); }
  // The next word is not what belongs here.
  [[noreturn]] void fail_expected(const std::string& what) const;

 private:
  std::size_t end_of_word() const;
  void skip_blanks();
  void advance(std::size_t to);

  std::string_view text_;
  const gltf::Report& report_;
  std::size_t at_ = 0;  // of the next word
  std::size_t line_ = 1;
  std::size_t behind_ = 0, line_behind_ = 1;  // of the last word's end
};

// "line 12", as a failure or a warning is located.
std::string line_text(std::size_t line);

}  // namespace marrow::cook::bvh
