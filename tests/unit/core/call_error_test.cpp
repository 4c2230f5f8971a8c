// The handler of bad calls: what it is told, by whom, and that it may change at any time.
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/marrow.h"
#include "support/call_errors.h"

namespace marrow {
namespace {

Status a_bad_call() {
  JointTransform out;
  return get_joint({}, 3, out);
}

TEST(CallError, FunctionAndCondition) {
  test::CallErrors errors;
  EXPECT_EQ(a_bad_call(), Status::bad_argument);
  const std::vector<test::CallError> heard = errors.take();
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard[0].function, "get_joint");
  EXPECT_GT(heard[0].condition.size(), 3u);
}

TEST(CallError, GoodCallsSayNothing) {
  test::CallErrors errors;
  JointTransform out;
  const std::vector<SoaTransform> pose(1);
  EXPECT_EQ(get_joint(pose, 3, out), Status::ok);
  EXPECT_TRUE(errors.take().empty());
}

TEST(CallError, NobodyIsTold) {
  const CallErrorHandler before = set_call_error_handler(nullptr);
  EXPECT_EQ(a_bad_call(), Status::bad_argument);
  EXPECT_EQ(set_call_error_handler(before), nullptr);
}

TEST(CallError, TheHandlerBeforeIsGivenBack) {
  const CallErrorHandler one = [](const char*, const char*) {};
  const CallErrorHandler before = set_call_error_handler(one);
  EXPECT_EQ(call_error_handler(), one);
  EXPECT_EQ(set_call_error_handler(before), one);
  EXPECT_EQ(call_error_handler(), before);
}

TEST(CallError, DebugBuildsBeginWithALineOnStderr) {
#ifdef NDEBUG
  EXPECT_EQ(test::first_call_error_handler(), nullptr);
#else
  ASSERT_NE(test::first_call_error_handler(), nullptr);
  const CallErrorHandler before = set_call_error_handler(test::first_call_error_handler());
  testing::internal::CaptureStderr();
  EXPECT_EQ(a_bad_call(), Status::bad_argument);
  const std::string line = testing::internal::GetCapturedStderr(), begins = "marrow: bad call of get_joint: ";
  EXPECT_TRUE(line.starts_with(begins) && line.size() > begins.size() + 3 && line.find('\n') == line.size() - 1)
      << line;
  set_call_error_handler(before);
#endif
}

std::atomic<int> told_one{0}, told_other{0};

TEST(CallError, ChangedWhileThreadsCall) {
  const CallErrorHandler one = [](const char*, const char*) { ++told_one; };
  const CallErrorHandler other = [](const char*, const char*) { ++told_other; };
  const CallErrorHandler before = set_call_error_handler(one);
  constexpr int kCalls = 2000, kThreads = 4;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([] {
      for (int i = 0; i < kCalls; ++i) EXPECT_EQ(a_bad_call(), Status::bad_argument);
    });
  }
  for (int i = 0; i < 500; ++i) set_call_error_handler(i % 2 == 0 ? other : one);
  for (std::thread& thread : threads) thread.join();
  set_call_error_handler(before);
  EXPECT_EQ(told_one + told_other, kThreads * kCalls);
}

}  // namespace
}  // namespace marrow
