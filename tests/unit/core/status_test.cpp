// Status texts and Span.
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/marrow.h"

namespace marrow {
namespace {

TEST(Status, EveryOneHasItsOwnText) {
  std::set<std::string> texts;
  int cases = 0;
  for (int i = 0; i <= static_cast<int>(Status::mismatch); ++i, ++cases) {
    const char* const text = to_string(static_cast<Status>(i));
    ASSERT_NE(text, nullptr);
    EXPECT_TRUE(texts.insert(text).second) << text;
    EXPECT_FALSE(std::string(text).empty());
  }
  EXPECT_EQ(cases, 10);
}

TEST(Status, AnUnknownOneHasATextToo) {
  ASSERT_NE(to_string(static_cast<Status>(200)), nullptr);
  EXPECT_NE(std::string(to_string(static_cast<Status>(200))), to_string(Status::ok));
}

TEST(Span, ViewsContainersAndAddsConst) {
  std::vector<int> numbers = {1, 2, 3};
  const Span<int> writable(numbers);
  writable[1] = 5;
  const Span<const int> readable = writable;
  int sum = 0;
  for (const int n : readable) sum += n;
  EXPECT_EQ(sum, 9);
  EXPECT_EQ(readable.size, 3u);
  EXPECT_EQ(readable.data, numbers.data());
  EXPECT_TRUE(Span<const int>{}.empty());
  EXPECT_EQ(Span<const int>{}.data, nullptr);
}

}  // namespace
}  // namespace marrow
