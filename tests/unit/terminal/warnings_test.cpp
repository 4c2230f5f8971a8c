// Warnings as a terminal shows them.
#include "terminal/warnings.h"

#include <gtest/gtest.h>

namespace marrow::tools {
namespace {

using Lines = std::vector<std::string>;

TEST(Warnings, OneLineARule) {
  std::vector<Warning> warnings = {{"/a", "odd", "it is odd"}, {"/b", "bad", "it is bad"}};
  EXPECT_EQ(warning_lines("f", warnings), (Lines{"f: /a: warning: odd: it is odd", "f: /b: warning: bad: it is bad"}));
  for (int i = 0; i < 49; ++i) warnings.push_back({"/c", "odd", "it is another"});
  EXPECT_EQ(warning_lines("f", warnings, "; see there"),
            (Lines{"f: /a: warning: odd: it is odd (1 of 50; see there)", "f: /b: warning: bad: it is bad"}));
}

TEST(Warnings, WithoutARuleTheTextIsOne) {
  EXPECT_EQ(
      warning_lines("f", std::vector<Warning>{{"mesh 0", "", "no"}, {"mesh 1", "", "no"}, {"mesh 1", "", "never"}}),
      (Lines{"f: mesh 0: warning: no (1 of 2)", "f: mesh 1: warning: never"}));
}

TEST(Warnings, NamesOfASourceAreMadePrintable) {
  EXPECT_EQ(warning_lines("f", std::vector<Warning>{{"/a\x1b[2J", "odd", "b\nc"}}).front().find_first_of("\x1b\n"),
            std::string::npos);
}

}  // namespace
}  // namespace marrow::tools
