// Zones of calls for profilers: nested, balanced, and by one handler; in a build without them nobody is told.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/local_to_model.h"
#include "marrow/zones.h"
#include "support/rig.h"

namespace marrow {
namespace {

std::vector<std::string> told;

const ZoneHandler kFirst = {[](const char* name) { told.push_back("begin " + std::string(name)); },
                            [](const char* name) { told.push_back("end " + std::string(name)); }};
const ZoneHandler kOther = {[](const char*) { told.push_back("other"); }, [](const char*) { told.push_back("other"); }};
// Changes the handler in the midst of a call.
const ZoneHandler kLeaves = {[](const char*) { set_zone_handler(&kOther); },
                             [](const char*) { told.push_back("left"); }};

class Zones : public ::testing::Test {
 protected:
  Zones() { told.clear(); }
  ~Zones() override { set_zone_handler(nullptr); }
  void pose() {
    const test::TestSkeleton rig({test::TestJoint{}});
    const Skeleton skeleton = rig.view();
    Affine scene[1];
    ASSERT_EQ(local_to_model(skeleton, {skeleton.rest, 1}, scene), Status::ok);
  }
};

TEST_F(Zones, AreToldInPairs) {
  set_zone_handler(&kFirst);
  pose();
  if (told.empty()) {
    EXPECT_EQ(set_zone_handler(&kFirst), nullptr) << "a build without zones keeps no handler";
    return;
  }
  EXPECT_EQ(told, (std::vector<std::string>{"begin local_to_model", "end local_to_model"}));
  EXPECT_EQ(set_zone_handler(nullptr), &kFirst);
  pose();
  EXPECT_EQ(told.size(), 2u);
}

TEST_F(Zones, ACallEndsWithTheHandlerThatItBeganWith) {
  set_zone_handler(&kLeaves);
  pose();
  if (set_zone_handler(nullptr) == nullptr) GTEST_SKIP() << "a build without zones: MARROW_ZONES is OFF";
  EXPECT_EQ(told, std::vector<std::string>{"left"});
}

}  // namespace
}  // namespace marrow
