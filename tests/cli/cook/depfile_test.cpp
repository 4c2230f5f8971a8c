// --depfile as ninja reads it: built again when an input changes, and only then.
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

namespace fs = std::filesystem;

TEST(Depfile, NamesWhatWasRead) {
  const TemporaryFolder folder;
  write_triangle(folder / "a.gltf", folder / "a.bin", 1);
  write_text(folder / "marrow.toml", "");
  const std::string in_folder = "cd '" + folder.path() + "' && exec '" + program() + "' cook ";
  ASSERT_EQ(run_program({"sh", "-c", in_folder + "a.gltf -o a.mrw --depfile a.d"}).code, 0);
  EXPECT_EQ(read_text(folder / "a.d"), "a.mrw: a.gltf a.bin marrow.toml\n");
  // From a cache too, and a rule an output.
  fs::create_directory(folder / "more");
  write_triangle(folder / "more/b.gltf", folder / "more/b.bin", 1);
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(run_program({"sh", "-c", in_folder + "a.gltf more -o out/ --depfile all.d --cache c"}).code, 0);
    EXPECT_EQ(read_text(folder / "all.d"),
              "out/a.mrw: a.gltf a.bin marrow.toml\nout/b.mrw: more/b.gltf more/b.bin marrow.toml\n");
  }
}

class Ninja : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      if (run_program({"ninja", "--version"}).code != 0) GTEST_SKIP() << "no ninja";
    } catch (const std::runtime_error&) {
      GTEST_SKIP() << "no ninja";
    }
  }
  // Whether ninja had something to do.
  bool build() {
    const Ran ran = run_program({"ninja", "-C", folder_.path()});
    EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
    return ran.out.find("no work to do") == std::string::npos;
  }
  // Later than everything before: file times go by the kernel's ticks.
  void change(const std::string& name, const std::string& text) {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    write_text(folder_ / name, text);
  }
  TemporaryFolder folder_;
};

// With every character that the syntax needs escaped.
TEST_F(Ninja, BuildsAgainWhenAnInputChanges) {
  const std::string odd = "a b#c$d(e)";
  write_triangle(folder_ / (odd + ".gltf"), folder_ / (odd + ".bin"), 1);
  change("marrow.toml", "");
  write_text(folder_ / "build.ninja", "rule cook\n  command = '" + program() +
                                          "' cook $in -o $out --depfile $out.d\n  depfile = $out.d\n  deps = gcc\n"
                                          "build out.mrw: cook a$ b#c$$d(e).gltf\n");
  EXPECT_TRUE(build());
  EXPECT_FALSE(build());
  const std::string first = read_text(folder_ / "out.mrw");
  std::string numbers = read_text(folder_ / (odd + ".bin"));
  numbers[12] = 0x01;
  change(odd + ".bin", numbers);
  EXPECT_TRUE(build());
  EXPECT_NE(read_text(folder_ / "out.mrw"), first);
  change("other.bin", "nobody reads this");
  EXPECT_FALSE(build());
}

TEST_F(Ninja, BuildsAgainWhenTheSettingsChange) {
  write_triangle(folder_ / "a.gltf", folder_ / "a.bin", 1);
  change("marrow.toml", "");
  write_text(folder_ / "build.ninja", "rule cook\n  command = '" + program() +
                                          "' cook $in -o $out --depfile $out.d\n  depfile = $out.d\n"
                                          "build out.mrw: cook a.gltf\n");
  EXPECT_TRUE(build());
  EXPECT_FALSE(build());
  change("marrow.toml", "keep-vertex-order = true\n");
  EXPECT_TRUE(build());
}

// With a cache outputs that stay the same keep their time; `restat` tells ninja.
TEST_F(Ninja, StopsWhereTheOutputStaysTheSame) {
  write_triangle(folder_ / "a.gltf", folder_ / "a.bin", 1);
  write_text(folder_ / "build.ninja",
             "rule cook\n  command = '" + program() +
                 "' cook $in -o $out --depfile $out.d --cache cache\n  depfile = $out.d\n  deps = gcc\n  restat = 1\n"
                 "rule copy\n  command = echo packed >> log && cp $in $out\n"
                 "build out.mrw: cook a.gltf\nbuild game.pak: copy out.mrw\n");
  EXPECT_TRUE(build());
  EXPECT_EQ(read_text(folder_ / "log"), "packed\n");
  change("a.bin", read_text(folder_ / "a.bin"));
  EXPECT_TRUE(build());
  EXPECT_EQ(read_text(folder_ / "log"), "packed\n") << "nothing that depends on the output ran";
  EXPECT_FALSE(build());
}

}  // namespace
}  // namespace marrow::test
