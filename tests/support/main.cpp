// Runs the tests of a binary; a filter that matches nothing is a failure, not a pass.
#include <cstdio>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  if (::testing::GTEST_FLAG(list_tests)) return result;
  const auto& unit = *::testing::UnitTest::GetInstance();
  if (result == 0 && unit.successful_test_count() == 0 && unit.skipped_test_count() == 0) {
    std::fputs("no test ran\n", stderr);
    return 1;
  }
  return result;
}
