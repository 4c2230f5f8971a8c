// Scripts: what lines mean, and where what is wrong with them is.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "behave/script.h"
#include "common/failure.h"
#include "unit/graph/graph_rig.h"

namespace marrow::tools {
namespace {

constexpr const char* kGraph = R"(
output = "walk"
[parameters]
speed = { type = "number", range = [-1, 6] }
armed = { type = "flag" }
jump = { type = "trigger" }
"two words" = { type = "number", range = [0, 1] }
)";

const test::GraphRig& rig() {
  static const test::GraphRig made(kGraph);
  return made;
}

std::vector<ScriptLine> parse(const std::string& text) {
  return parse_script("in.txt", text, rig().file, rig().graph);
}

TEST(Script, SaysWhatIsSetWhen) {
  const std::vector<ScriptLine> lines = parse(
      "# a walk\r\n\r\n2.5 jump # now\n0 speed 1.5\n"
      "1e0\tarmed true\n1 speed -1\n0.5 armed false\n3 \"two words\" 0.25");
  struct Want {
    double time_s;
    std::uint32_t parameter;
    float value;
  };
  // By time; of one time in their order.
  const std::vector<Want> want = {{0, 0, 1.5f}, {0.5, 1, 0}, {1, 1, 1}, {1, 0, -1}, {2.5, 2, 1}, {3, 3, 0.25f}};
  ASSERT_EQ(lines.size(), want.size());
  for (std::size_t i = 0; i < want.size(); ++i) {
    EXPECT_EQ(lines[i].time_s, want[i].time_s) << i;
    EXPECT_EQ(lines[i].parameter, want[i].parameter) << i;
    EXPECT_EQ(lines[i].value, want[i].value) << i;
  }
  EXPECT_TRUE(parse("").empty());
  EXPECT_TRUE(parse("# nothing\n   \n").empty());
}

TEST(Script, SaysWhereItIsWrong) {
  struct Wrong {
    const char *text, *where, *says;
  };
  const Wrong all[] = {
      {"0 speed 1\nnow speed 2", "2:1", "\"now\" is no time"},
      {"0 sped 1", "1:3", "did you mean \"speed\"?"},
      {"0 speed", "1:3", "from -1 to 6"},
      {"0 speed fast", "1:9", "\"fast\" is no number"},
      {"0 speed 1e9", "1:9", "from -1 to 6"},
      {"0 speed nan", "1:9", "from -1 to 6"},
      {"0 speed 1 2", "1:11", "too many words"},
      {"0 armed 1", "1:9", "true or false"},
      {"0 armed", "1:3", "true or false"},
      {"0 jump true", "1:8", "without a value"},
      {"  3", "1:3", "a time alone"},
      {"-1 jump", "1:1", "from 0 on"},
      {"1e300 jump", "1:1", "from 0 on"},
      {"inf jump", "1:1", "is no time"},
      {"1,5 jump", "1:1", "is no time"},
      {"0 \"two words 1", "1:3", "second quote"},
      {"0 Speed 1", "1:3", "did you mean \"speed\"?"},
  };
  for (const Wrong& wrong : all) {
    try {
      parse(wrong.text);
      ADD_FAILURE() << wrong.text;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), Exit::usage) << wrong.text;
      EXPECT_EQ(failure.where(), wrong.where) << wrong.text;
      EXPECT_NE(std::string(failure.what()).find(wrong.says), std::string::npos) << failure.what();
    }
  }
}

TEST(Script, OutlivesHostileText) {
  EXPECT_THROW(parse(std::string(2 << 20, '#')), Failure) << "too large";
  std::string many;
  for (int i = 0; i <= 100000; ++i) many += "0 jump\n";
  EXPECT_THROW(parse(many), Failure) << "too many lines";
  std::uint32_t state = 1;
  int refused = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text = "0 speed 1\n1.5 armed true\n2 jump\n";
    for (int i = 0; i < 4; ++i) {
      state = state * 1664525u + 1013904223u;
      text[(state >> 8) % text.size()] = static_cast<char>(state >> 24);
    }
    try {
      for (const ScriptLine& line : parse(text)) EXPECT_LT(line.parameter, 4u);
    } catch (const Failure& failure) {
      ++refused;
      for (const char c : std::string(failure.what())) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << round;
    }
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace marrow::tools
