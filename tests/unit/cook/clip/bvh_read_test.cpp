// Reading BVH: what a file may look like, and every way it can be wrong.
#include "cook/bvh/read_bvh.h"

#include <cmath>
#include <locale>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "disk/cook_on_disk.h"

namespace marrow::cook {
namespace {

using tools::Exit;
using tools::Failure;

// 9 numbers a frame; line 17 begins the motion.
const std::string kSmall =
    "HIERARCHY\n"
    "ROOT Hips\n"
    "{\n"
    "  OFFSET 0 1 0\n"
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "  JOINT Spine\n"
    "  {\n"
    "    OFFSET 0 0.5 0\n"
    "    CHANNELS 3 Yrotation Xrotation Zrotation\n"
    "    End Site\n"
    "    {\n"
    "      OFFSET 0 0.25 0\n"
    "    }\n"
    "  }\n"
    "}\n"
    "MOTION\n"
    "Frames: 2\n"
    "Frame Time: 0.5\n"
    "0 1 0 0 0 0 0 0 0\n"
    "1 2 3 90 0 0 0 90 0\n";

RawScene read(const std::string& text) {
  return read_bvh("take/walk.bvh", std::as_bytes(std::span(text)));
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

std::string failure_of(const std::string& text) {
  try {
    read(text);
  } catch (const Failure& failure) {
    EXPECT_TRUE(failure.where().starts_with("line ")) << failure.what();
    EXPECT_FALSE(failure.advice().empty()) << failure.what();
    EXPECT_EQ(std::string(failure.what()).find('\n'), std::string::npos);
    return failure.what();
  }
  ADD_FAILURE() << "is read: " << text;
  return "";
}

void expect_small(const RawScene& scene) {
  ASSERT_EQ(scene.nodes.size(), 3u);
  EXPECT_EQ(scene.nodes[0].name, "Hips");
  EXPECT_EQ(scene.nodes[1].name, "Spine");
  EXPECT_EQ(scene.nodes[2].name, "Spine_end");
  EXPECT_EQ(scene.nodes[1].parent, 0);
  EXPECT_EQ(scene.nodes[2].parent, 1);
  EXPECT_EQ(scene.nodes[2].translation, glm::dvec3(0, 0.25, 0));
  ASSERT_EQ(scene.skins.size(), 1u);
  EXPECT_EQ(scene.skins[0].joints, (std::vector<int>{0, 1})) << "an End Site is no joint";
  EXPECT_TRUE(scene.is_capture);
  ASSERT_EQ(scene.clips.size(), 1u);
  EXPECT_EQ(scene.clips[0].name, "walk");
  ASSERT_EQ(scene.clips[0].channels.size(), 3u);
  for (const RawChannel& channel : scene.clips[0].channels)
    EXPECT_EQ(channel.times_s, (std::vector<float>{0.0F, 0.5F}));
  const float half = std::sqrt(0.5F);
  const RawChannel& turn = scene.clips[0].channels[0];
  EXPECT_EQ(turn.path, RawPath::rotation);
  EXPECT_LE(glm::length(turn.values[1] - glm::vec4(0, 0, half, half)), 1e-6F) << "90 degrees about z";
  const RawChannel& move = scene.clips[0].channels[1];
  EXPECT_EQ(move.path, RawPath::translation);
  EXPECT_EQ(move.values[1], glm::vec4(1, 2, 3, 0)) << "in place of the OFFSET";
  EXPECT_LE(glm::length(scene.clips[0].channels[2].values[1] - glm::vec4(half, 0, 0, half)), 1e-6F);
}

TEST(BvhRead, AnyWhiteSpaceAndCase) {
  expect_small(read(kSmall));
  std::string dos, mac, words, glued = kSmall, lower = kSmall;
  for (const char c : kSmall) {
    dos += c == '\n' ? "\r\n" : std::string(1, c);
    mac += c == '\n' ? '\r' : c;
  }
  for (const char c : kSmall.substr(kSmall.find("OFFSET"))) words += c == ' ' || c == '\n' ? '\t' : c;
  expect_small(read(dos));
  expect_small(read(mac));
  expect_small(read("\xEF\xBB\xBF" + kSmall + "\n\t \r\n"));
  glued =
      replaced(replaced(replaced(glued, "Frames: 2", "Frames:2"), "Hips\n{", "Hips {"), "  }\n}\nMOTION", "}}MOTION");
  expect_small(read(glued));
  lower = replaced(replaced(replaced(lower, "MOTION", "Motion"), "End Site", "END site"), "Zrotation", "ZROTATION");
  expect_small(read(lower));
  // Frames need not be lines.
  expect_small(read(replaced(kSmall, "0 1 0 0 0 0 0 0 0\n1 2", "0 1 0\n0 0 0 0\n0 0 +1.0 2e0")));
}

TEST(BvhRead, NumbersHaveAPointInEveryLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  expect_small(read(kSmall));
  std::locale::global(before);
  EXPECT_NE(failure_of(replaced(kSmall, "0 0.5 0", "0 0,5 0")).find("line 8: \"0,5\" is not a number"),
            std::string::npos);
}

TEST(BvhRead, SeveralRootsAndJointsWithoutChannels) {
  const std::string text =
      replaced(replaced(kSmall, "MOTION", "ROOT Prop { OFFSET 5 0 0 CHANNELS 0 }\nMOTION"),
               "CHANNELS 3 Yrotation Xrotation Zrotation", "CHANNELS 3 Xrotation Yposition Zrotation");
  const RawScene scene = read(text);
  ASSERT_EQ(scene.nodes.size(), 4u);
  EXPECT_EQ(scene.nodes[3].parent, kNone);
  EXPECT_EQ(scene.skins[0].joints, (std::vector<int>{0, 1, 3}));
  ASSERT_EQ(scene.clips[0].channels.size(), 4u);
  EXPECT_EQ(scene.clips[0].channels[3].values[1], glm::vec4(0, 90, 0, 0)) << "other axes as in the OFFSET";
}

TEST(BvhRead, RotationsKeepTheirSign) {
  std::string text = replaced(kSmall, "Frames: 2", "Frames: 40");
  text.resize(text.find("0 1 0 0 0"));
  for (int f = 0; f < 40; ++f) text += "0 1 0 " + std::to_string(50 * f - 720) + " 0 0 0 0 0\n";
  const std::vector<glm::vec4> keys = read(text).clips[0].channels[0].values;
  ASSERT_EQ(keys.size(), 40u);
  for (std::size_t i = 1; i < keys.size(); ++i) EXPECT_GT(glm::dot(keys[i - 1], keys[i]), 0.9F) << i;
}

// What is cut off is missed, wherever the file ends; a last number may be a shorter one.
TEST(BvhRead, TruncatedFilesAreRefused) {
  const std::size_t last_number = kSmall.rfind('0');
  for (std::size_t size = 0; size < last_number; ++size) failure_of(kSmall.substr(0, size));
  expect_small(read(kSmall.substr(0, last_number + 1)));
  EXPECT_NE(failure_of(kSmall.substr(0, last_number)).find("line 20: the file ends too soon"), std::string::npos);
}

TEST(BvhRead, FaultsAreLocated) {
  const std::string zeros(1 << 16, '0');
  const struct {
    const char *what, *with, *says;
  } cases[] = {
      {"HIERARCHY", "HIERARCHIE", "line 1: \"HIERARCHIE\" in the wrong place"},
      {"ROOT Hips", "JOINT Hips", "line 2: \"JOINT\" in the wrong place"},
      {"ROOT Hips", "ROOT", "line 2: a joint without a name"},
      {"JOINT Spine", "JOINT Hips", "line 6: a second joint of one name: \"Hips\" is the joint of line 2 too"},
      {"  {\n    OFFSET 0 0.5 0", "    OFFSET 0 0.5 0", "line 7: \"OFFSET\" in the wrong place: \"{\""},
      {"    OFFSET 0 0.5 0\n", "", "line 6: a joint without OFFSET"},
      {"OFFSET 0 0.5 0", "OFFSET 0 0.5", "line 9: \"CHANNELS\" is not a number"},
      {"OFFSET 0 0.5 0", "OFFSET 0 0.5 0 0", "line 8: \"0\" in the wrong place"},
      {"OFFSET 0 0.5 0", "OFFSET 0 0.5 0 OFFSET 0 0 0", "line 8: a second OFFSET"},
      {"OFFSET 0 0.5 0", "OFFSET 0 nan 0", "line 8: \"nan\" is no finite number"},
      {"OFFSET 0 0.5 0", "OFFSET -inf 0 0", "line 8: \"-inf\" is no finite number"},
      {"OFFSET 0 0.5 0", "OFFSET 0 1e300 0", "line 8: \"1e300\" is no finite number up to 1e12"},
      {"OFFSET 0 0.5 0", "OFFSET 0 1e999 0", "line 8: \"1e999\" is no finite number"},
      {"OFFSET 0 0.5 0", "OFFSET 0 999999995904 0", "line 8: stands beyond 1e12"},
      {"OFFSET 0 0.25 0", "OFFSET 0 0.25 0\n JOINT X", "line 13: \"JOINT\" in the wrong place"},
      {"CHANNELS 3", "CHANNELS 2", "line 9: \"Zrotation\" in the wrong place"},
      {"CHANNELS 3", "CHANNELS 4", "line 10: \"End\" in the wrong place: a channel such as Xrotation"},
      {"CHANNELS 3", "CHANNELS 7", "line 9: 7 channels of one joint"},
      {"CHANNELS 3", "CHANNELS 99999999999", "line 9: \"99999999999\" is not a whole number"},
      {"CHANNELS 3", "CHANNELS -3", "line 9: \"-3\" is not a whole number"},
      {"Yrotation Xrotation Zrotation\n    End", "Yrotation Xrotation Yrotation\n    End", "line 9: Yrotation twice"},
      {"Yrotation Xrotation Zrotation\n    End", "Yrotation Xrotation Wrotation\n    End",
       "line 9: \"Wrotation\" in the wrong place"},
      {"  }\n}\nMOTION", "  }\nMOTION",
       "line 15: \"MOTION\" in the wrong place: a part or the \"}\" of the joint that "
       "begins in line 2"},
      {"}\nMOTION", "}\n}\nMOTION", "line 16: \"}\" in the wrong place: \"MOTION\""},
      {"Frames: 2", "Frames: 0", "line 17: no frames"},
      {"Frames: 2", "Frames: two", "line 17: \"two\" is not a whole number"},
      {"Frames: 2", "Frames: 2000000000", "line 17: 2000000000 frames of 9 numbers: only 54 bytes follow"},
      {"Frames: 2", "Frames: 4294967295", "line 17: 4294967295 frames"},
      {"Frames: 2", "Frames: 3", "line 21: the file ends too soon: a number of frame 3 of 3"},
      {"Frames: 2", "Frames: 1", "line 20: more numbers than 1 frames need"},
      {"Frame Time: 0.5", "Frame Time: 0", "line 18: a frame time that is not above 0"},
      {"Frame Time: 0.5", "Frame Time: -0.5", "line 18: a frame time that is not above 0"},
      {"Frame Time: 0.5", "Frame Time: nan", "line 18: \"nan\" is no finite number"},
      {"Frame Time: 0.5", "Frame Time: 1e-9", "line 18: frames too close"},
      {"Frame Time: 0.5", "Frame Time: 100000", "line 18: a clip of more than a day"},
      {"Frame Time: 0.5", "Time: 0.5", "line 18: \"Time:\" in the wrong place"},
      {"90 0 0 0 90 0\n", "90 0 0 0 90\n", "line 21: the file ends too soon"},
      {"0 1 0 0 0 0 0 0 0\n", "0 1 0 0 0\n",
       "line 21: the file ends too soon: a number of frame 2 of 2 (the first line of numbers has 5, the hierarchy "
       "declares 9 channels)"},
      {"1 2 3 90", "1 2 3 x90", "line 20: \"x90\" is not a number"},
      {"1 2 3 90", "1 2 3 0x90", "line 20: \"0x90\" is not a number"},
      {"1 2 3 90", "1 2 3 +-90", "line 20: \"+-90\" is not a number"},
      {"1 2 3 90", "1 2 3 {90", "line 20: \"{\" is not a number"},
  };
  for (const auto& c : cases) {
    const std::string says = failure_of(replaced(kSmall, c.what, c.with));
    EXPECT_NE(says.find(std::string("take/walk.bvh: ") + c.says), std::string::npos) << c.with << "\n" << says;
  }
  EXPECT_NE(failure_of("").find("line 1: the file ends too soon"), std::string::npos);
  std::string zero = kSmall;
  zero[kSmall.find("Spine")] = '\0';
  EXPECT_NE(failure_of(zero).find("line 6: a zero byte"), std::string::npos);
  EXPECT_LT(failure_of(replaced(kSmall, "1 2 3 90", zeros + "x")).size(), 700u) << "a long word is cut";
  EXPECT_EQ(read(replaced(kSmall, "1 2 3 90", '1' + std::string(".") + zeros + " 2 3 90")).nodes.size(), 3u);
}

TEST(BvhRead, NothingMoves) {
  std::string text =
      replaced(replaced(kSmall, "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation", ""),
               "CHANNELS 3 Yrotation Xrotation Zrotation", "CHANNELS 0");
  EXPECT_NE(failure_of(text).find("no joint has channels"), std::string::npos);
}

TEST(BvhRead, DepthAndNumberAreLimited) {
  const auto chain = [](int depth) {
    std::string text = "HIERARCHY\nROOT r\n{ OFFSET 0 0 0 CHANNELS 1 Xrotation\n";
    for (int i = 1; i < depth; ++i) text += "JOINT j" + std::to_string(i) + "\n{ OFFSET 0 1 0\n";
    return text + std::string(static_cast<std::size_t>(depth), '}') + "\nMOTION\nFrames: 1\nFrame Time: 1\n0\n";
  };
  EXPECT_EQ(read(chain(1024)).nodes.size(), 1024u);
  EXPECT_NE(failure_of(chain(1025)).find("joints nested too deeply"), std::string::npos);
  EXPECT_NE(failure_of(chain(500'000)).find("joints nested too deeply"), std::string::npos);
  const auto fan = [](int joints) {
    std::string text = "HIERARCHY\nROOT r\n{ OFFSET 0 0 0 CHANNELS 1 Xrotation\n";
    for (int i = 1; i < joints; ++i) text += "JOINT j" + std::to_string(i) + "\n{ OFFSET 0 1 0 }\n";
    return text + "}\nMOTION\nFrames: 1\nFrame Time: 1\n0\n";
  };
  EXPECT_EQ(read(fan(32767)).nodes.size(), 32767u);
  EXPECT_NE(failure_of(fan(32768)).find("line 65536: too many joints"), std::string::npos);
}

TEST(BvhRead, AFileThatIsNotThereHasNoLines) {
  try {
    read_bvh("/nowhere/walk.bvh");
    ADD_FAILURE() << "read";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::io);
    EXPECT_STREQ(failure.what(), "/nowhere/walk.bvh: no such file: check the name");
  }
}

TEST(BvhRead, HasNoScenesToChooseFrom) {
  CookOptions options;
  options.source.scene.name = "attic";
  const auto code_of = [&] {
    try {
      read_source("/nowhere/walk.bvh", options);
    } catch (const Failure& failure) {
      return failure.code();
    }
    return Exit::done;
  };
  EXPECT_EQ(code_of(), Exit::usage);
  options.source.scene.origin.must_fit = false;
  EXPECT_EQ(code_of(), Exit::io) << "a rule for many files";
}

TEST(BvhRead, NamesAreMadeFit) {
  const RawScene scene = read(replaced(kSmall, "JOINT Spine", "JOINT Left \x1b Arm.L \t"));
  EXPECT_EQ(scene.nodes[1].name, "Left _ Arm.L");
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0].pointer, "line 6");
  EXPECT_EQ(scene.warnings[0].rule, "name-cleaned");
}

}  // namespace
}  // namespace marrow::cook
