// `marrow view` in a window of a screen that nobody sees.
#ifdef MARROW_HAS_VIEW
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/window.h"

namespace marrow::test {
namespace {

TEST_F(ViewTest, ShowsThePictureBesideThePanel) {
  const std::vector<png_byte> window = shot({"--clip", "point"});
  std::set<std::vector<png_byte>> panel, beside;
  for (std::size_t i = 0; i < window.size(); i += 3) {
    const bool is_panel = static_cast<int>(i / 3) % kWindowWidth < kPanelPixels;
    (is_panel ? panel : beside).insert({window[i], window[i + 1], window[i + 2]});
  }
  EXPECT_GT(panel.size(), 10u) << "text and widgets";
  EXPECT_GT(beside.size(), 100u) << "light and shadow";
  EXPECT_EQ(panel.contains({20, 25, 31}), true) << "the panel's ground";

  // What `marrow render` draws of the size and in the place of the picture.
  ASSERT_EQ(run_marrow({"render", mrw(), "--clip", "point", "--size", "164x360", "-o", folder_ / "r.png"}).code, 0);
  const std::vector<png_byte> render = picture(folder_ / "r.png", kWindowWidth - kPanelPixels, kWindowHeight);
  std::vector<png_byte> placed(window.size());
  for (std::size_t i = 0; i < render.size(); ++i) {
    const std::size_t row = i / (3 * (kWindowWidth - kPanelPixels)), column = i % (3 * (kWindowWidth - kPanelPixels));
    placed[3 * (row * kWindowWidth + kPanelPixels) + column] = render[i];
  }
  EXPECT_GT(difference(window, placed, 0, kPanelPixels), 0.99);
  EXPECT_LT(difference(window, placed, kPanelPixels, kWindowWidth), 0.01);
}

TEST_F(ViewTest, OptionsAreWhereThePanelBegins) {
  const std::vector<std::string> at = {"--clip", "wave", "--time", "0.5"};
  const std::vector<png_byte> plain = shot(at);
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--bones"},
                                                 {"--heatmap", "rigid:ssd"},
                                                 {"--weights", "elbow"},
                                                 {"--time", "1"},
                                                 {"--show", "names"},
                                                 {"--show", "axes"},
                                                 {"--show", "grid"},
                                                 {"--show", "wireframe"},
                                                 {"--show", "normals"},
                                                 {"--show", "uv"},
                                                 {"--ghosts", "2"},
                                                 {"--joint", "elbow", "--show", "trail"},
                                                 {"--ik", "wrist=-1,1.5,1"}}) {
    std::vector<std::string> options = at;
    if (option[0] == "--time") options.resize(2);
    options.insert(options.end(), option.begin(), option.end());
    // Lines are thin: thirty pixels.
    EXPECT_GT(difference(plain, shot(options), kPanelPixels, kWindowWidth), 0.0005)
        << option[0] << ' ' << option.back();
  }
  // On the processor and in the vertex shader, it looks alike.
  std::vector<std::string> cpu = at;
  cpu.insert(cpu.end(), {"--path", "cpu"});
  EXPECT_LT(difference(plain, shot(cpu), kPanelPixels, kWindowWidth), 0.01);
}

// With a driver that is reset as a frame ends, `at` of them in the process: the window comes back with what it showed.
TEST_F(ViewTest, OutlivesAResetOfTheDriver) {
  const std::vector<std::string> options = {"--clip", "wave", "--time", "0.5"};
  const std::vector<png_byte> plain = shot(options);
  const auto spoilt = [&](const char* at) {
    std::vector<std::string> all = {"--size", "480x360", "--screenshot", folder_ / "s.png", "--frames", "3"};
    all.insert(all.end(), options.begin(), options.end());
    return view(all, {"LD_PRELOAD=" + reset_shim(), std::string("MARROW_RESET_AT=") + at});
  };
  const std::string message = "OpenGL ES: the graphics processor was reset: ";
  const Ran twice = spoilt("9 18");
  EXPECT_EQ(twice.code, 0) << twice.err;
  const std::size_t first = twice.err.find(message + "the window is opened anew");
  ASSERT_NE(first, std::string::npos) << twice.err;
  EXPECT_NE(twice.err.find(message, first + 1), std::string::npos) << twice.err;
  EXPECT_LT(difference(plain, picture(folder_ / "s.png", kWindowWidth, kWindowHeight), kPanelPixels, kWindowWidth),
            0.001);
  // Before there is a frame there is no use in another try.
  const Ran always = spoilt("1");
  EXPECT_EQ(always.code, 5) << always.err;
  EXPECT_NE(always.err.find(message + "try again"), std::string::npos) << always.err;
}

TEST_F(ViewTest, CooksGltfFirst) {
  const std::vector<std::string> at = {"--clip", "wave", "--time", "0.5"};
  const std::vector<png_byte> cooked = shot(at), source = shot_of(tiny_gltf(), at);
  EXPECT_LT(difference(cooked, source, kPanelPixels, kWindowWidth), 0.001);
  EXPECT_GT(difference(cooked, source, 0, kPanelPixels), 0.001) << "the panel says that it was cooked";
  // By the settings beside it.
  std::filesystem::copy_file(tiny_gltf(), folder_ / "t.gltf");
  write_text(folder_ / "marrow.toml", "no-such-option = true\n");
  const Ran ran = run_marrow({"view", folder_ / "t.gltf"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("marrow.toml: 1:1: unknown setting \"no-such-option\""), std::string::npos) << ran.err;
  write_text(folder_ / "marrow.toml", "clips-only = true\nskeleton = \"t.mrw\"\n");
  EXPECT_NE(run_marrow({"view", folder_ / "t.gltf"}).err.find("it makes a clip pack"), std::string::npos);
}

// The colour of skin is another; clip, moment and camera stay.
TEST_F(ViewTest, LoadsAgainWhatChangesOnTheDisk) {
  const std::vector<std::string> at = {"--clip", "wave", "--time", "0.5"};
  std::string text = read_text(tiny_gltf());
  const std::size_t skin = text.find("0.75, 0.5, 0.25, 1]");
  ASSERT_NE(skin, std::string::npos);
  const std::string file = folder_ / "c.gltf", other = folder_ / "other.gltf", broken = folder_ / "broken.gltf";
  write_text(file, text);
  write_text(broken, text.substr(0, text.size() / 2));
  text.replace(skin, 18, "0.1, 0.2, 0.9, 1");
  write_text(other, text);
  std::vector<std::string> options = at;
  options.insert(options.begin(), file);
  const std::vector<png_byte> before = shot_of(file, at), after = shot_of(other, at);
  ASSERT_GT(difference(before, after, kPanelPixels, kWindowWidth), 0.01);
  const auto is = [](const std::vector<png_byte>& a, const std::vector<png_byte>& b) {
    return difference(a, b, kPanelPixels, kWindowWidth) < 0.001;
  };
  EXPECT_TRUE(is(by_hand("3 copy " + other + " " + file, options), after));
  // An error is shown over the old picture, until the next good save.
  write_text(file, read_text(tiny_gltf()));
  const std::vector<png_byte> error = by_hand("3 copy " + broken + " " + file, options);
  EXPECT_TRUE(middle_of(error, 107, 28, 23).has_value()) << "a red note";
  EXPECT_FALSE(is(error, before));
  write_text(file, read_text(tiny_gltf()));
  EXPECT_TRUE(is(by_hand("3 copy " + broken + " " + file + "|8 copy " + other + " " + file, options), after));
}

TEST_F(ViewTest, OpensWhatIsDroppedOnIt) {
  ASSERT_EQ(run_marrow({"cook", in_golden("looks.gltf"), "-o", folder_ / "l.mrw"}).code, 0);
  const std::vector<png_byte> fresh = shot_of(folder_ / "l.mrw", {"--time", "0"});
  const std::vector<png_byte> dropped = by_hand("3 drop " + (folder_ / "l.mrw"), {mrw(), "--time", "0"});
  EXPECT_LT(difference(fresh, dropped, kPanelPixels, kWindowWidth), 0.001);
  // What cannot be opened leaves what is there.
  const std::vector<png_byte> nothing = by_hand("3 drop " + (folder_ / "none.glb"), {mrw(), "--time", "0"});
  EXPECT_TRUE(middle_of(nothing, 107, 28, 23).has_value());
}

TEST_F(ViewTest, AClickChoosesAJoint) {
  const std::vector<std::string> at = {mrw(), "--clip", "wave", "--time", "0.5"};
  std::vector<std::string> chosen = at;
  chosen.insert(chosen.end(), {"--joint", "elbow"});
  const std::vector<png_byte> wanted = by_hand("", chosen);
  const auto middle = middle_of(wanted, 255, 176, 64);
  ASSERT_TRUE(middle.has_value());
  const std::string where = "3 at " + coordinates(middle->first, middle->second);
  const std::vector<png_byte> clicked = by_hand(where + "|4 down|6 up", at);
  EXPECT_LT(difference(wanted, clicked, kPanelPixels, kWindowWidth), 0.001);
  // A click beside all of them chooses none.
  const std::vector<png_byte> none = by_hand("3 at 470 10|4 down|6 up", chosen);
  EXPECT_FALSE(middle_of(none, 255, 176, 64).has_value());
}

TEST_F(ViewTest, KeysStepByFrames) {
  const std::vector<std::string> at = {mrw(), "--clip", "wave", "--time", "0.5"};
  const auto is_at = [&](const std::string& acts, const char* time_s) {
    const std::vector<png_byte> there = shot_of(mrw(), {"--clip", "wave", "--time", time_s});
    return difference(by_hand(acts, at), there, kPanelPixels, kWindowWidth);
  };
  // A clip that is kept as it is has no rate of its own: 30 frames a second.
  EXPECT_LT(is_at("3 key 262|5 key 262|7 key 262", "0.6"), 0.001);
  EXPECT_LT(is_at("3 key 263", "0.4666667"), 0.001);
  EXPECT_LT(is_at("3 key 268", "0"), 0.001);
  EXPECT_GT(is_at("", "0"), 0.002);
}

TEST_F(ViewTest, AGoalIsDragged) {
  const std::vector<std::string> at = {mrw(), "--time", "0", "--ik", "wrist=-1,1.5,1"};
  const std::vector<png_byte> before = by_hand("", at);
  const auto from = middle_of(before, 90, 220, 210);
  ASSERT_TRUE(from.has_value());
  const std::string acts = "3 at " + coordinates(from->first, from->second) + "|4 down|5 at " +
                           coordinates(from->first + 15, from->second + 25) + "|7 up";
  const std::vector<png_byte> after = by_hand(acts, at);
  const auto to = middle_of(after, 90, 220, 210);
  ASSERT_TRUE(to.has_value());
  EXPECT_NEAR(to->first - from->first, 15, 1.5);
  EXPECT_NEAR(to->second - from->second, 25, 1.5);
  EXPECT_GT(difference(before, after, kPanelPixels, kWindowWidth), 0.01);
}

// The elbow's mark lies over the arm: a stroke down from there, taken back, made again, saved and cooked.
TEST_F(ViewTest, AStrokeIsPaintedAndSaved) {
  const std::string saved = folder_ / "t.paint.json";
  const std::vector<std::string> at = {tiny_gltf(), "--clip", "wave",      "--time", "0.5",
                                       "--paint",   saved,    "--weights", "wrist"};
  std::vector<std::string> elbow = at;
  elbow.back() = "elbow";
  const auto middle = middle_of(by_hand("", elbow), 255, 176, 64);
  ASSERT_TRUE(middle.has_value());
  const auto [x, y] = *middle;
  const std::string larger = "1 key 93|2 key 93|3 key 93|4 key 93|";
  const std::string stroke =
      larger + "5 at " + coordinates(x, y) + "|6 down|7 at " + coordinates(x + 8, y + 12) + "|8 up|9 at 470 10";
  const std::vector<png_byte> before = by_hand("1 at 470 10", at), painted = by_hand(stroke, at);
  EXPECT_GT(difference(before, painted, kPanelPixels, kWindowWidth), 0.005) << "the colours of the wrist's weights";
  EXPECT_FALSE(std::filesystem::exists(saved)) << "it was not asked for";
  constexpr const char* kUndo = "|10 key 90 2";
  constexpr const char* kRedo = "|12 key 89 2";
  constexpr const char* kSave = "|14 key 83 2";
  EXPECT_LT(difference(before, by_hand(stroke + kUndo, at), kPanelPixels, kWindowWidth), 0.001);
  EXPECT_LT(difference(painted, by_hand(stroke + kUndo + kRedo, at), kPanelPixels, kWindowWidth), 0.001);
  by_hand(stroke + kSave, at);
  ASSERT_TRUE(std::filesystem::exists(saved));
  // What is cooked of it is coloured as it was painted; so is what is opened again.
  ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "-o", folder_ / "p.mrw", "--paint", saved}).code, 0);
  std::vector<std::string> cooked = {folder_ / "p.mrw", "--clip", "wave", "--time", "0.5", "--weights", "wrist"};
  EXPECT_LT(difference(painted, by_hand("1 at 470 10", cooked), kPanelPixels, kWindowWidth), 0.002);
  EXPECT_LT(difference(painted, by_hand("1 at 470 10", at), kPanelPixels, kWindowWidth), 0.001);
}

TEST_F(ViewTest, WhatCannotBeSavedIsSaid) {
  const Ran ran = view({"--paint", folder_ / "no/folder/t.json", "--screenshot", folder_ / "w.png"});
  EXPECT_EQ(ran.code, 2) << ran.err;
  EXPECT_NE(ran.err.find("no/folder"), std::string::npos) << ran.err;
  EXPECT_EQ(view({"--paint", folder_ / "t.txt", "--screenshot", folder_ / "w.png"}).code, 1);
  // What is not ours is not written over; a red note says so.
  write_text(folder_ / "other.json", "{}");
  const std::vector<png_byte> note =
      by_hand("3 key 83 2", {tiny_gltf(), "--paint", folder_ / "other.json", "--time", "0"});
  EXPECT_TRUE(middle_of(note, 107, 28, 23).has_value());
  EXPECT_EQ(read_text(folder_ / "other.json"), "{}");
}

TEST_F(ViewTest, SaysWhatIsWrong) {
  const Ran joint = view({"--weights", "nose", "--screenshot", folder_ / "w.png"});
  EXPECT_EQ(joint.code, 1);
  EXPECT_NE(joint.err.find("no joint \"nose\""), std::string::npos) << joint.err;
  EXPECT_EQ(run_marrow({"view", mrw(), "--frames", "3"}).code, 1);
  EXPECT_EQ(run_marrow({"view", mrw(), "--weights", "a", "--heatmap", "ssd:as"}).code, 1);
  const Ran blind = run_program({"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", program(), "view", mrw()});
  EXPECT_EQ(blind.code, 4);
  ASSERT_EQ(blind.complaints().size(), 1u) << blind.err;
  EXPECT_EQ(blind.err.find("window: "), 0u) << blind.err;
}

}  // namespace
}  // namespace marrow::test
#endif
