// Marks of calls for profilers: nested, balanced, and by one handler; in a build without them nobody is told.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/local_to_model.h"
#include "marrow/marks.h"
#include "support/rig.h"

namespace marrow {
namespace {

std::vector<std::string> told;

const MarkHandler kFirst = {[](const char* name) { told.push_back("begin " + std::string(name)); },
                            [](const char* name) { told.push_back("end " + std::string(name)); }};
const MarkHandler kOther = {[](const char*) { told.push_back("other"); }, [](const char*) { told.push_back("other"); }};
// Changes the handler in the midst of a call.
const MarkHandler kLeaves = {[](const char*) { set_mark_handler(&kOther); },
                             [](const char*) { told.push_back("left"); }};

class Marks : public ::testing::Test {
 protected:
  Marks() { told.clear(); }
  ~Marks() override { set_mark_handler(nullptr); }
  void pose() {
    const test::TestSkeleton rig({test::TestJoint{}});
    const Skeleton skeleton = rig.view();
    Affine scene[1];
    ASSERT_EQ(local_to_model(skeleton, {skeleton.rest, 1}, scene), Status::ok);
  }
};

TEST_F(Marks, AreToldInPairs) {
  set_mark_handler(&kFirst);
  pose();
  if (told.empty()) {
    EXPECT_EQ(set_mark_handler(&kFirst), nullptr) << "a build without marks keeps no handler";
    return;
  }
  EXPECT_EQ(told, (std::vector<std::string>{"begin local_to_model", "end local_to_model"}));
  EXPECT_EQ(set_mark_handler(nullptr), &kFirst);
  pose();
  EXPECT_EQ(told.size(), 2u);
}

TEST_F(Marks, ACallEndsWithTheHandlerThatItBeganWith) {
  set_mark_handler(&kLeaves);
  pose();
  if (set_mark_handler(nullptr) == nullptr) GTEST_SKIP() << "a build without marks: MARROW_MARKS is OFF";
  EXPECT_EQ(told, std::vector<std::string>{"left"});
}

}  // namespace
}  // namespace marrow
