// How much time is left.
#include "terminal/progress.h"

#include <gtest/gtest.h>

namespace marrow::tools {
namespace {

TEST(Progress, TimeLeft) {
  EXPECT_EQ(time_left(10, 5, 7), ", 14 s left");       // 2 s each
  EXPECT_EQ(time_left(10, 4, 1), ", 3 s left");        // 2.5 s
  EXPECT_EQ(time_left(25, 1, 5), ", 2 min 5 s left");  // 125 s
  EXPECT_EQ(time_left(60, 1, 61), ", 1 h 1 min left");
  EXPECT_EQ(time_left(10, 0, 7), "") << "nothing is done yet";
  EXPECT_EQ(time_left(10, 5, 0), "") << "all is done";
  EXPECT_EQ(time_left(0.5, 5, 7), "") << "too soon";
}

}  // namespace
}  // namespace marrow::tools
