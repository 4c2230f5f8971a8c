// `marrow view --graph`: a graph is set, taken back and read again in a window of a screen that nobody sees.
#ifdef MARROW_HAS_VIEW
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/window.h"

namespace marrow::test {
namespace {

class ViewGraphTest : public ViewTest {};

// What the panel of this graph looks like in the window: a slider, a box, a button.
constexpr const char* kGraph = R"(output = "all"
[parameters]
bend = { type = "number", range = [0, 1] }
up = { type = "flag" }
go = { type = "trigger", hold = 0.1 }
[node.body]
type = "machine"
start = "waves"
state.waves = { pose = "wave" }
state.points = { pose = "point" }
transition = [
  { from = "waves", to = "points", when = "go", fade = 0.3, kind = "inertial" },
  { from = "waves", to = "points", when = "up", fade = 0.3 },
  { from = "points", to = "waves", when = "not up", after = 1.5, fade = 0.2 },
]
[node.all]
type = "layer"
base = "body"
pose = "point"
weight = "bend"
)";
constexpr int kFrames = 14;
constexpr const char *kBendSlider = "89 105", *kBendMost = "300 105", *kUpBox = "91 130", *kGoButton = "184 154";

std::string clicked(int frame, const char* at) {
  return std::to_string(frame) + " at " + at + "|" + std::to_string(frame + 1) + " down|" + std::to_string(frame + 2) +
         " up|" + std::to_string(frame + 3) + " at 470 10";
}

// Whether the picture beside the panel is the same, to the bit.
bool same_picture(const std::vector<png_byte>& a, const std::vector<png_byte>& b) {
  return difference(a, b, kPanelPixels, kWindowWidth, 0) == 0;
}

TEST_F(ViewGraphTest, AGraphIsSetByMouseAndByKeys) {
  write_text(folder_ / "g.anim.toml", kGraph);
  const std::vector<std::string> at = {mrw(), "--graph", folder_ / "g.anim.toml"};
  std::string report;
  const std::vector<png_byte> plain = by_hand("1 at 470 10", at, kFrames, &report);
  EXPECT_EQ(report, "g at 0.217 s: body waves 0.217 s") << "13 steps of a sixtieth";
  // A slider at its end: the pose is all of the layer.
  const auto begun = [&](const char* bend) {
    std::string text = kGraph;
    text.insert(text.find(" }", text.find("bend")), std::string(", initial = ") + bend);
    const std::string file = folder_ / (std::string(bend) + ".anim.toml");
    write_text(file, text);
    return std::vector<std::string>{mrw(), "--graph", file};
  };
  const std::vector<png_byte> whole = by_hand("1 at 470 10", begun("1"), kFrames);
  EXPECT_FALSE(same_picture(plain, whole));
  const std::string drag = std::string("3 at ") + kBendSlider + "|4 down|5 at " + kBendMost + "|7 up|8 at 470 10";
  EXPECT_TRUE(same_picture(whole, by_hand(drag, at, kFrames)));
  // A key is a twentieth.
  EXPECT_TRUE(same_picture(whole, by_hand("2 key 265", begun("0.95"), kFrames)));
  // A flag, and a trigger: the machine goes, and says so.
  const std::vector<png_byte> up = by_hand("5 key 50", at, kFrames, &report);
  EXPECT_EQ(report, "g at 0.217 s: body points 0.150 s") << "it is set before the fifth step of 13";
  EXPECT_FALSE(same_picture(plain, up));
  by_hand("5 key 51", at, kFrames, &report);
  EXPECT_EQ(report, "g at 0.217 s: body points 0.150 s");
  for (const char* const where : {kUpBox, kGoButton}) {
    by_hand(clicked(3, where), at, kFrames, &report);
    EXPECT_EQ(report.substr(0, 24), "g at 0.217 s: body point") << where;
  }
}

// In the middle of an inertial fade, a hundred frames ago.
TEST_F(ViewGraphTest, AGraphGoesBackToTheSamePicture) {
  write_text(folder_ / "g.anim.toml", kGraph);
  const std::vector<std::string> at = {mrw(), "--graph", folder_ / "g.anim.toml"};
  const std::string fired = "15 key 51", paused = "|21 key 32";
  std::string back;
  for (int i = 0; i < 10; ++i) back += "|" + std::to_string(121 + i) + " key 263 2";
  std::string then, now;
  const std::vector<png_byte> was = by_hand(fired + paused, at, 0, &then), is = by_hand(fired + back, at, 0, &now);
  EXPECT_EQ(then, "g at 0.333 s: body points 0.100 s");
  EXPECT_EQ(now, then);
  EXPECT_TRUE(same_picture(was, is));
  // From there it goes on as it went: at frame 141 by ten steps, as after 30 of them.
  const std::vector<png_byte> on = by_hand(fired + back + "|132 key 32", at, 142, &now),
                              straight = by_hand(fired, at, 31, &then);
  EXPECT_EQ(now, then);
  EXPECT_TRUE(same_picture(on, straight));
  // Step by step, and to the ends of what was played.
  by_hand("20 key 263|21 key 263|22 key 268|23 key 262|24 key 262 2|25 key 263", at, 0, &now);
  EXPECT_EQ(now.substr(0, 12), "g at 0.167 s") << "0 + 1 + 10 - 1 sixtieths";
  by_hand("20 key 268|21 key 269|22 key 262", at, 0, &now);
  EXPECT_EQ(now.substr(0, 12), "g at 0.333 s") << "19 + 1: beyond the end it moves on by a frame";
}

TEST_F(ViewGraphTest, AGraphIsReadAgain) {
  const std::string file = folder_ / "g.anim.toml", broken = folder_ / "broken.toml", other = folder_ / "other.toml",
                    unknown = folder_ / "unknown.toml";
  std::string text = kGraph;
  write_text(broken, text.substr(0, text.size() - 10));
  const auto replace = [&](const std::string& what, const std::string& by) {
    std::string out = text;
    for (std::size_t found = out.find(what); found != std::string::npos; found = out.find(what, found + by.size()))
      out.replace(found, what.size(), by);
    return out;
  };
  write_text(other, replace("waves", "greets"));
  write_text(unknown, replace("\"wave\"", "\"swims\""));
  const std::vector<std::string> at = {mrw(), "--graph", file};
  const auto with = [&](const std::string& acts, std::string* report) {
    write_text(file, kGraph);
    return by_hand(acts, at, 0, report);
  };
  std::string report;
  for (const std::string& wrong : {broken, unknown}) {
    const std::vector<png_byte> error = with("3 copy " + wrong + " " + file, &report);
    EXPECT_TRUE(middle_of(error, 107, 28, 23).has_value()) << "a red note";
    EXPECT_EQ(report, "g at 0.183 s: body waves 0.183 s") << "it plays on";
  }
  // What is set stays: the layer's weight is 1.
  const std::vector<png_byte> mended = with("1 at 89 105|2 down|3 at 300 105|4 up|5 at 470 10|6 copy " + broken + " " +
                                                file + "|10 copy " + other + " " + file,
                                            &report);
  EXPECT_FALSE(middle_of(mended, 107, 28, 23).has_value());
  EXPECT_NE(report.find("body greets"), std::string::npos) << report;
  const std::vector<png_byte> unset = with("10 copy " + other + " " + file, &report);
  EXPECT_NE(report.find("body greets"), std::string::npos) << report;
  EXPECT_FALSE(same_picture(mended, unset));
}

TEST_F(ViewGraphTest, SaysWhatGoesWithNoGraph) {
  write_text(folder_ / "g.anim.toml", kGraph);
  for (const char* const other : {"--clip=wave", "--time=0", "--ik=wrist=0,1,0", "--ghosts=1", "--paint"}) {
    const Ran ran = run_marrow({"view", mrw(), "--graph", folder_ / "g.anim.toml", other});
    EXPECT_EQ(ran.code, 1) << other;
    EXPECT_NE(ran.err.find("goes by a graph"), std::string::npos) << ran.err;
  }
  EXPECT_NE(run_marrow({"view", mrw(), "--graph"}).err.find("no graph"), std::string::npos);
  EXPECT_NE(run_marrow({"view", mrw(), "--clip", "wave", "--clips", "a.mrw", "--clips", "b.mrw"}).err.find("several"),
            std::string::npos);
  std::string text = kGraph;
  text.replace(text.find("\"wave\""), 6, "\"wafe\"");
  write_text(folder_ / "w.anim.toml", text);
  const Ran ran = run_marrow({"view", mrw(), "--graph", folder_ / "w.anim.toml"});
  EXPECT_NE(ran.err.find("w.anim.toml: 9:24: "), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("did you mean \"wave\"?"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace marrow::test
#endif
