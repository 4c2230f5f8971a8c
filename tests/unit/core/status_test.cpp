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
  for (int i = 0; i <= static_cast<int>(Status::out_of_memory); ++i, ++cases) {
    const char* const text = to_string(static_cast<Status>(i));
    ASSERT_NE(text, nullptr);
    EXPECT_TRUE(texts.insert(text).second) << text;
    EXPECT_FALSE(std::string(text).empty());
  }
  EXPECT_EQ(cases, 11);
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

float sum(Span<const float> numbers) {
  float all = 0;
  for (const float x : numbers) all += x;
  return all;
}

TEST(Span, TakesArrays) {
  float three[] = {1, 2, 4};
  const float two[2] = {8, 16};
  EXPECT_EQ(sum(three), 7.0f);
  EXPECT_EQ(sum(two), 24.0f);
  const Span<float> writable(three);
  writable[2] = 5;
  EXPECT_EQ(three[2], 5.0f);
  EXPECT_EQ(writable.size, 3u);
}

struct Layer {
  Span<const float> pose = {};
  float weight = 1;
};
float weighed(Span<const Layer> layers) {
  float all = 0;
  for (const Layer& layer : layers) all += layer.weight * sum(layer.pose);
  return all;
}

TEST(Span, TakesListsInBracesForACall) {
  EXPECT_EQ(sum({1, 2, 4, 8}), 15.0f);
  EXPECT_EQ(sum({2.5f}), 2.5f);
  EXPECT_EQ(sum({}), 0.0f);
  const std::vector<float> a = {1, 2}, b = {10};
  EXPECT_EQ(weighed({{a, 2.0f}, {b, 0.5f}}), 11.0f);
  EXPECT_EQ(weighed({{a, 2.0f}}), 6.0f);
  EXPECT_EQ(weighed({{.pose = {3, 4}}}), 7.0f);
}

TEST(Span, APointerAndACountAreNoList) {
  const std::vector<float> a = {1, 2, 4};
  const std::size_t count = 2;
  EXPECT_EQ(sum({a.data(), 3}), 7.0f);
  EXPECT_EQ(sum({a.data(), count}), 3.0f);
  const Layer layers[] = {{a, 1.0f}, {a, 1.0f}};
  EXPECT_EQ(weighed({layers, 1}), 7.0f);
  EXPECT_EQ(weighed({layers, count}), 14.0f);
}

}  // namespace
}  // namespace marrow
