// Runs the tests of a binary; a filter that matches nothing is a failure, not a pass.
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "support/call_errors.h"

namespace {
marrow::CallErrorHandler first_handler;
}

marrow::CallErrorHandler marrow::test::first_call_error_handler() {
  return first_handler;
}

int main(int argc, char** argv) {
  // Tests make bad calls on purpose; those that ask what is said of them listen themselves.
  first_handler = marrow::set_call_error_handler(nullptr);
  ::testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  if (::testing::GTEST_FLAG(list_tests)) return result;
  const auto& unit = *::testing::UnitTest::GetInstance();
  // Of the shards that share a filter's tests, the first has the first.
  const char* const shard = std::getenv("GTEST_SHARD_INDEX");
  if (shard != nullptr && std::atoi(shard) > 0) return result;
  if (result == 0 && unit.successful_test_count() == 0 && unit.skipped_test_count() == 0) {
    std::fputs("no test ran\n", stderr);
    return 1;
  }
  return result;
}
