#include "cook/bvh/bvh_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "asset/format.h"
#include "text/number.h"

namespace marrow::cook::bvh {
namespace {

bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

bool is_brace(char c) {
  return c == '{' || c == '}';
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string quoted(std::string_view word) {
  return '"' + tools::printable(word) + '"';
}

}  // namespace

std::string line_text(std::size_t line) {
  return "line " + std::to_string(line);
}

Words::Words(std::string_view text, const gltf::Report& report) : text_(text), report_(report) {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  const std::size_t zero = text_.find('\0');
  if (zero != std::string_view::npos) {
    advance(zero);
    fail("a zero byte", "a BVH file is text; export it again");
  }
  skip_blanks();
}

// A line ends with LF, CR or both.
void Words::advance(std::size_t to) {
  for (; at_ < to; ++at_) {
    const bool pair = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
    if (text_[at_] == '\n' || (text_[at_] == '\r' && !pair)) ++line_;
  }
}

void Words::skip_blanks() {
  behind_ = at_;
  line_behind_ = line_;
  std::size_t to = at_;
  while (to < text_.size() && is_blank(text_[to])) ++to;
  advance(to);
}

std::size_t Words::end_of_word() const {
  std::size_t end = at_;
  if (end < text_.size() && is_brace(text_[end])) return end + 1;
  while (end < text_.size() && !is_blank(text_[end]) && !is_brace(text_[end]))
    if (text_[end++] == ':') break;
  return end;
}

std::size_t Words::words_left_on_line() const {
  std::size_t count = 0;
  for (std::size_t i = at_; i < text_.size() && text_[i] != '\n' && text_[i] != '\r'; ++i)
    if (!is_blank(text_[i]) && (i == at_ || is_blank(text_[i - 1]))) ++count;
  return count;
}

bool Words::take(std::string_view word) {
  const std::string_view here = text_.substr(at_, end_of_word() - at_);
  if (!std::ranges::equal(here, word, {}, lower, lower)) return false;
  advance(at_ + here.size());
  skip_blanks();
  return true;
}

void Words::expect(std::string_view word, const std::string& of) {
  if (!take(word)) fail_expected(quoted(word) + " of " + of);
}

std::string_view Words::next(const std::string& what) {
  if (at_end()) fail_expected(what);
  const std::string_view word = text_.substr(at_, end_of_word() - at_);
  advance(at_ + word.size());
  skip_blanks();
  return word;
}

std::string_view Words::rest_of_line() {
  at_ = behind_;
  line_ = line_behind_;
  std::size_t end = at_;
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r' && text_[end] != '{') ++end;
  std::string_view rest = text_.substr(at_, end - at_);
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  advance(end);
  skip_blanks();
  return rest;
}

double Words::number(const std::string& what) {
  const std::size_t line = line_;
  const std::string_view word = next(what);
  const std::string_view digits = word.starts_with('+') && !word.starts_with("+-") ? word.substr(1) : word;
  double value = 0;
  const auto [end, error] = tools::read_double(digits.data(), digits.data() + digits.size(), value);
  const bool whole = end == digits.data() + digits.size();
  if (error == std::errc::invalid_argument || !whole)
    fail(line, quoted(word) + " is not a number", what + " is wanted here, as in -12.5; export again");
  if (error != std::errc() || !(std::abs(value) <= double{format::kFarthest}))
    fail(line, quoted(word) + " is no finite number up to 1e12", "as " + what + " it makes no sense; export again");
  return value;
}

std::uint32_t Words::whole_number(const std::string& what) {
  const std::size_t line = line_;
  const std::string_view word = next(what);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    fail(line, quoted(word) + " is not a whole number", what + " is wanted here; export again");
  return value;
}

void Words::fail(std::size_t line, const std::string& rule, const std::string& advice) const {
  report_.invalid(line_text(line), rule, advice);
}

void Words::fail_expected(const std::string& what) const {
  if (at_end()) fail("the file ends too soon", what + " is missing; export again");
  fail(quoted(text_.substr(at_, end_of_word() - at_)) + " in the wrong place", what + " is wanted here; export again");
}

}  // namespace marrow::cook::bvh
