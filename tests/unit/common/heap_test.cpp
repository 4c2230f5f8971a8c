// A heap, and in which order it takes equals.
#include "common/heap.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace marrow::tools {
namespace {

struct Named {
  int worth;
  char name;
  bool operator<(const Named& other) const { return worth < other.worth; }
};

std::string popped(Heap<Named> heap) {
  std::string out;
  while (!heap.empty()) out += heap.pop().name;
  return out;
}

TEST(Heap, GivesTheLargestFirst) {
  Heap<int> heap;
  std::vector<int> all;
  for (unsigned i = 0, x = 1; i < 500; ++i) {
    x = x * 1664525u + 1013904223u;
    all.push_back(static_cast<int>(x >> 24));
    heap.push(all.back());
  }
  std::ranges::sort(all, std::ranges::greater());
  for (const int wanted : all) EXPECT_EQ(heap.pop(), wanted);
  EXPECT_TRUE(heap.empty());
}

// By hand: of two equal children the second goes up.
TEST(Heap, TakesEqualsInOneOrder) {
  Heap<Named> three, four;
  for (const char name : {'a', 'b', 'c'}) three.push({5, name});
  for (const char name : {'a', 'b', 'c', 'd'}) four.push({5, name});
  EXPECT_EQ(popped(three), "abc");
  EXPECT_EQ(popped(four), "acbd");
}

}  // namespace
}  // namespace marrow::tools
