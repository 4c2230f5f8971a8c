// Events as options and files write them, and rules that do not fit.
#include <string>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "disk/cook_on_disk.h"
#include "support/places.h"
#include "text/event_text.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {
namespace {

TEST(EventText, IsRead) {
  tools::EventText e;
  ASSERT_TRUE(tools::read_event("hit@0.35", e));
  EXPECT_EQ(e.name, "hit");
  EXPECT_EQ(e.from.value, 0.35);
  EXPECT_EQ(e.until.value, 0.35);
  EXPECT_FALSE(e.from.is_share);
  EXPECT_EQ(e.number, 0);
  ASSERT_TRUE(tools::read_event("a name@b@25%..0.5s:-2.5", e));
  EXPECT_EQ(e.name, "a name@b");
  EXPECT_EQ(e.from.value, 0.25);
  EXPECT_TRUE(e.from.is_share);
  EXPECT_EQ(e.until.value, 0.5);
  EXPECT_FALSE(e.until.is_share);
  EXPECT_EQ(e.number, -2.5);
  for (const char* bad : {"", "hit", "@1", "hit@", "hit@-1", "hit@nan", "hit@inf", "hit@1e300", "hit@101%", "hit@1..",
                          "hit@..1", "hit@1:", "hit@1:x", "hit@+1", "hit@1 ", "hit@0x1"})
    EXPECT_FALSE(tools::read_event(bad, e)) << bad;
}

void refuse(const char* option, const char* value, const char* rule) {
  try {
    cook_file(test::in_golden("roles.gltf"), options_of("--mesh-codec none --" + std::string(option) + " " + value));
    ADD_FAILURE() << option << " " << value;
  } catch (const tools::Failure& failure) {
    EXPECT_EQ(failure.code(), tools::Exit::usage) << value;
    EXPECT_NE(std::string(failure.what()).find(rule), std::string::npos) << failure.what();
    EXPECT_NE(std::string(failure.what()).find("--" + std::string(option)), std::string::npos) << failure.what();
  }
}

TEST(MotionOptions, ThatFitNothingAreRefused) {
  refuse("event", "walk", "names no clip");
  refuse("event", "walk=hit", "is no event");
  refuse("event", "wolk=hit@0.5", "did you mean \"walk\"?");
  refuse("event", "walk=hit@1.5", "is outside of \"walk\", which takes 1.0");
  refuse("event", "walk=hit@0.5..0.25", "ends before it begins");
  refuse("event", "walk=hit@0.5..2", "is outside of");
  refuse("root", "walk=fast", "there is no root motion \"fast\"");
  refuse("root", "run=ground", "no clip is called \"run\"");
  refuse("phase", "walk=0.5,x", "is no list of times");
  refuse("phase", "walk=0.5,", "is no list of times");
  refuse("phase", "walk=0.5,0.5", "do not go once round");
  refuse("phase", "walk=100%", "do not go once round");
}

}  // namespace
}  // namespace marrow::cook
