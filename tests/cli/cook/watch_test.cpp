// `marrow watch`: what is saved is cooked at once, and what is wrong is said until it is mended.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/process.h"

namespace marrow::test {
namespace {

using Clock = std::chrono::steady_clock;

class WatchTest : public ::testing::TestWithParam<bool> {
 protected:
  // in/hero.gltf and in/props/box.gltf, triangles of 1 m.
  WatchTest() {
    std::filesystem::create_directories(folder_ / "in/props");
    write_triangle(in("hero.gltf"), in("hero.bin"), 1);
    write_triangle(in("props/box.gltf"), in("props/box.bin"), 1);
  }
  std::string in(const std::string& name) const { return folder_ / ("in/" + name); }
  std::string out(const std::string& name) const { return folder_ / ("out/" + name); }
  std::vector<std::string> arguments(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"watch", folder_ / "in", "-o", folder_ / "out"});
    if (GetParam()) more.emplace_back("--poll");
    return more;
  }
  // What `marrow cook` makes of an input.
  std::string cooked(const std::string& name, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"cook", in(name), "-o", folder_ / "alone.mrw"});
    EXPECT_EQ(run_marrow(options).code, 0);
    return read_text(folder_ / "alone.mrw");
  }
  static bool soon(const std::function<bool()>& is_so) {
    for (const auto end = Clock::now() + std::chrono::seconds(20); Clock::now() < end;) {
      if (is_so()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
  }
  static bool soon_says(const RunningMarrow& marrow, const std::string& text) {
    return soon([&] { return marrow.err().find(text) != std::string::npos; });
  }
  static std::size_t times(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
  }
  // As editors save: a new file takes the name.
  void save_by_renaming(const std::string& name, const std::string& text) const {
    write_text(in(name + "~"), text);
    std::filesystem::rename(in(name + "~"), in(name));
  }

  TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Both, WatchTest, ::testing::Bool(),
                         [](const auto& which) { return which.param ? "Looks" : "IsTold"; });

TEST_P(WatchTest, CooksBreaksAndMends) {
  RunningMarrow marrow(arguments());
  ASSERT_TRUE(soon_says(marrow, "watching 2 files")) << marrow.err();
  EXPECT_EQ(read_text(out("hero.mrw")), cooked("hero.gltf"));
  EXPECT_EQ(read_text(out("props/box.mrw")), cooked("props/box.gltf"));
  const std::string box = read_text(out("props/box.mrw"));

  write_triangle(in("hero.gltf"), in("hero.bin"), 2);
  const std::string larger = cooked("hero.gltf");
  ASSERT_TRUE(soon([&] { return read_text(out("hero.mrw")) == larger; })) << marrow.err();

  const std::string good = read_text(in("hero.gltf"));
  save_by_renaming("hero.gltf", "{ \"asset\": ");
  ASSERT_TRUE(soon_says(marrow, "2 files, 1 wrong")) << marrow.err();
  EXPECT_NE(marrow.err().find(in("hero.gltf") + ": "), std::string::npos) << marrow.err();
  EXPECT_EQ(read_text(out("hero.mrw")), larger) << "the last good one";

  save_by_renaming("hero.gltf", good);
  ASSERT_TRUE(soon_says(marrow, "hero.gltf: good again\n2 files, none wrong")) << marrow.err();

  const std::size_t before = times(marrow.out(), "props/box.mrw:");
  EXPECT_EQ(before, 0u) << "what did not change is not cooked: " << marrow.out();
  EXPECT_EQ(read_text(out("props/box.mrw")), box);

  const Ran ran = marrow.interrupt();
  EXPECT_EQ(ran.code, 130);
  EXPECT_NE(ran.err.find("marrow: interrupted"), std::string::npos);
  EXPECT_EQ(ran.err.find('\r'), std::string::npos) << "a pipe gets lines";
}

TEST_P(WatchTest, FilesAndFoldersComeAndGo) {
  RunningMarrow marrow(arguments());
  ASSERT_TRUE(soon_says(marrow, "watching 2 files")) << marrow.err();
  write_triangle(in("foe.gltf"), in("foe.bin"), 3);
  ASSERT_TRUE(soon([&] { return std::filesystem::exists(out("foe.mrw")); })) << marrow.err();
  std::filesystem::create_directories(in("deep/er"));
  std::this_thread::sleep_for(std::chrono::milliseconds(400));  // empty at first
  write_triangle(in("deep/er/gem.gltf"), in("deep/er/gem.bin"), 4);
  ASSERT_TRUE(soon([&] { return std::filesystem::exists(out("deep/er/gem.mrw")); })) << marrow.err();
  // In the folder that is new, too.
  write_triangle(in("deep/er/gem.gltf"), in("deep/er/gem.bin"), 5);
  const std::string gem = cooked("deep/er/gem.gltf");
  ASSERT_TRUE(soon([&] { return read_text(out("deep/er/gem.mrw")) == gem; })) << marrow.err();

  std::filesystem::remove(in("foe.gltf"));
  ASSERT_TRUE(soon_says(marrow, in("foe.gltf") + ": is gone; " + out("foe.mrw") + " stays")) << marrow.err();
  EXPECT_TRUE(std::filesystem::exists(out("foe.mrw")));
  EXPECT_EQ(marrow.interrupt().code, 130);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "out"))
    EXPECT_FALSE(entry.path().filename().string().ends_with(".tmp")) << entry.path();
}

TEST_P(WatchTest, WhatAnInputDependsOn) {
  RunningMarrow marrow(arguments());
  ASSERT_TRUE(soon_says(marrow, "watching 2 files")) << marrow.err();
  // Its numbers alone.
  const std::string numbers = read_text(in("hero.bin"));
  write_triangle(folder_ / "other.gltf", folder_ / "other.bin", 1.5f);
  std::filesystem::copy_file(folder_ / "other.bin", in("hero.bin"), std::filesystem::copy_options::overwrite_existing);
  const std::string moved = cooked("hero.gltf");
  ASSERT_TRUE(soon([&] { return read_text(out("hero.mrw")) == moved; })) << marrow.err();
  std::filesystem::remove(in("hero.bin"));
  ASSERT_TRUE(soon_says(marrow, "1 wrong")) << marrow.err();
  write_text(in("hero.bin"), numbers);
  ASSERT_TRUE(soon_says(marrow, "none wrong")) << marrow.err();

  // Settings that come, are wrong, are right, and go.
  const std::string plain = cooked("props/box.gltf");
  const std::string raw = cooked("props/box.gltf", {"--mesh-codec", "none"});
  ASSERT_NE(plain, raw);
  write_text(in("marrow.toml"), "mesh-codec = \"none\"\n");
  ASSERT_TRUE(soon([&] { return read_text(out("props/box.mrw")) == raw; })) << marrow.err();
  write_text(in("marrow.toml"), "mesh-codek = \"none\"\n");
  ASSERT_TRUE(soon_says(marrow, "mesh-codek")) << marrow.err();
  EXPECT_EQ(read_text(out("props/box.mrw")), raw);
  std::filesystem::remove(in("marrow.toml"));
  ASSERT_TRUE(soon_says(marrow, "the settings are good again")) << marrow.err();
  ASSERT_TRUE(soon([&] { return read_text(out("props/box.mrw")) == plain; })) << marrow.err();
  EXPECT_EQ(marrow.interrupt().code, 130);
}

TEST_P(WatchTest, BehindLinks) {
  std::filesystem::create_directory_symlink(in(""), folder_ / "link");
  std::filesystem::create_directory(folder_ / "links");
  std::filesystem::create_symlink(in("props/box.gltf"), folder_ / "links/box.gltf");
  std::vector<std::string> watch = {"watch", folder_ / "link/hero.gltf", folder_ / "links", "-o", out("")};
  if (GetParam()) watch.emplace_back("--poll");
  RunningMarrow marrow(watch);
  ASSERT_TRUE(soon_says(marrow, "watching 2 files")) << marrow.err();
  const std::string before = read_text(out("hero.mrw"));
  write_triangle(folder_ / "other.gltf", folder_ / "other.bin", 1.5f);
  std::filesystem::copy_file(folder_ / "other.bin", in("hero.bin"), std::filesystem::copy_options::overwrite_existing);
  ASSERT_TRUE(soon([&] { return read_text(out("hero.mrw")) != before; })) << marrow.err();
  // What a link in a folder leads to; broken from the start on.
  const std::string text = read_text(in("props/box.gltf"));
  std::filesystem::copy_file(in("props/box.bin"), folder_ / "links/box.bin");
  ASSERT_TRUE(soon_says(marrow, "2 files, none wrong")) << marrow.err();
  const std::string box = read_text(out("box.mrw")), name = R"("name":"m")";
  save_by_renaming("props/box.gltf", std::string(text).replace(text.find(name), name.size(), R"("name":"k")"));
  ASSERT_TRUE(soon([&] { return read_text(out("box.mrw")) != box; })) << marrow.err();
  EXPECT_EQ(marrow.interrupt().code, 130);
}

// What it writes lies where it looks: that must not set it off again.
TEST_P(WatchTest, OutputsAndCacheBesideTheInputs) {
  write_text(in("broken.gltf"), "{");
  RunningMarrow marrow(
      {"watch", folder_ / "in", "-o", in("build"), "--cache", in("cache"), GetParam() ? "--poll" : "--jobs=2"});
  ASSERT_TRUE(soon_says(marrow, "watching 3 files")) << marrow.err();
  for (int i = 0; i < 3; ++i) {
    const std::string old = read_text(in("build/hero.mrw"));
    write_triangle(in("hero.gltf"), in("hero.bin"), 3.0f + float(i));
    ASSERT_TRUE(soon([&] { return read_text(in("build/hero.mrw")) != old; })) << marrow.err();
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  const std::string out = marrow.out(), err = marrow.err();
  const double used_s = marrow.processor_s();
  std::this_thread::sleep_for(std::chrono::milliseconds(800));
  const double idle_s = marrow.processor_s() - used_s;
  const Ran ran = marrow.interrupt();
  EXPECT_EQ(ran.out, out);
  EXPECT_EQ(ran.err, err + "marrow: interrupted\n") << "it goes on by itself";
  EXPECT_LE(times(ran.out, "hero.mrw: "), 6u) << ran.out;
  EXPECT_LT(idle_s, 0.1) << "it is busy";
}

// From the save to the whole file, of a scene that takes a few milliseconds; the best of some, as others work here,
// too.
TEST_P(WatchTest, BeginsAtOnce) {
  if (GetParam()) return;  // who looks every 250 ms does not
  RunningMarrow marrow(arguments());
  ASSERT_TRUE(soon_says(marrow, "watching 2 files")) << marrow.err();
  double best_s = 1e9;
  for (int i = 0; i < 8; ++i) {
    const std::string old = read_text(out("hero.mrw"));
    const auto start = Clock::now();
    write_triangle(in("hero.gltf"), in("hero.bin"), 2.0f + float(i));
    ASSERT_TRUE(soon([&] { return read_text(out("hero.mrw")) != old; })) << marrow.err();
    best_s = std::min(best_s, std::chrono::duration<double>(Clock::now() - start).count());
    std::this_thread::sleep_for(std::chrono::milliseconds(150));  // all of it is done
  }
  RecordProperty("best_ms", std::to_string(1e3 * best_s));
  EXPECT_LT(best_s, 0.1);
}

TEST_P(WatchTest, OneFileAndABrokenStart) {
  write_text(in("hero.gltf"), "{");
  {
    RunningMarrow marrow({"watch", in("hero.gltf"), "-o", folder_ / "one.mrw"});
    ASSERT_TRUE(soon_says(marrow, "watching 1 file;")) << marrow.err();
    EXPECT_NE(marrow.err().find("1 file, 1 wrong"), std::string::npos) << marrow.err();
    write_triangle(in("hero.gltf"), in("hero.bin"), 1);
    ASSERT_TRUE(soon_says(marrow, "1 file, none wrong")) << marrow.err();
    EXPECT_EQ(read_text(folder_ / "one.mrw"), cooked("hero.gltf"));
    EXPECT_EQ(marrow.interrupt().code, 130);
  }
  EXPECT_EQ(run_marrow({"watch", folder_ / "nowhere", "-o", out("")}).code, 2);
  EXPECT_EQ(run_marrow({"watch", in("hero.gltf"), "-o", in("hero.glb")}).code, 1);
  write_text(in("marrow.toml"), "nonsense = 1\n");
  EXPECT_EQ(run_marrow(arguments()).code, 1) << "settings that are wrong at the start";
}

}  // namespace
}  // namespace marrow::test
