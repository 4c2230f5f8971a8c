// What a terminal shows of commands that take a while, and Ctrl-C in the middle of them.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/process.h"

namespace marrow::test {
namespace {

constexpr int kInterrupted = 130;

// The sample, and a cook of it that takes seconds.
class ProgressTest : public ::testing::Test {
 protected:
  ProgressTest() { EXPECT_EQ(run_marrow({"sample", "-o", newt()}).code, 0); }
  std::string newt() const { return folder_ / "newt.glb"; }
  std::vector<std::string> slow_cook() const {
    return {"cook", newt(), "-o", folder_ / "newt.mrw", "--report", folder_ / "r.json", "--as", "fit"};
  }

  TemporaryFolder folder_;
};

TEST_F(ProgressTest, ATerminalShowsItAndAPipeDoesNot) {
  const Ran shown = run_marrow_on_terminal({"cook", newt(), "-o", folder_ / "newt.mrw"});
  EXPECT_EQ(shown.code, 0);
  EXPECT_NE(shown.err.find("newt.glb"), std::string::npos) << shown.err;
  EXPECT_NE(shown.err.find("[4/4] clips"), std::string::npos) << shown.err;
  EXPECT_TRUE(shown.err.ends_with("\r\x1b[K")) << "the line is gone at the end: " << shown.err;
  EXPECT_EQ(run_marrow({"cook", newt(), "-o", folder_ / "newt.mrw", "--clip-codec", "raw"}).err, "");
#ifdef MARROW_HAS_GLES
  const Ran movie = run_marrow_on_terminal({"render", folder_ / "newt.mrw", "--clip", "walk", "--movie", "--fps", "5",
                                            "--size", "8x8", "-o", folder_ / "walk.png"});
  EXPECT_NE(movie.err.find("[1/6] drawing"), std::string::npos) << movie.err;
#endif
}

TEST_F(ProgressTest, AnInterruptedCookLeavesNothing) {
  const Ran ran = run_marrow_on_terminal(slow_cook(), "] fitting");
  EXPECT_EQ(ran.code, kInterrupted) << ran.err;
  EXPECT_NE(ran.err.find("marrow: interrupted"), std::string::npos) << ran.err;
  EXPECT_EQ(folder_.listing(), std::vector<std::string>{"newt.glb"});
}

TEST_F(ProgressTest, AnInterruptedCookLeavesTheOldFiles) {
  write_text(folder_ / "newt.mrw", "precious");
  write_text(folder_ / "r.json", "too");
  EXPECT_EQ(run_marrow_on_terminal(slow_cook(), "] fitting").code, kInterrupted);
  EXPECT_EQ(read_text(folder_ / "newt.mrw"), "precious");
  EXPECT_EQ(read_text(folder_ / "r.json"), "too");
  EXPECT_EQ(folder_.listing().size(), 3u);
}

TEST_F(ProgressTest, ComparisonsAreInterruptedToo) {
  const Ran ran = run_marrow_on_terminal({"compare", newt(), "-o", folder_ / "page.html"}, "] learning");
  EXPECT_EQ(ran.code, kInterrupted) << ran.err;
  EXPECT_EQ(folder_.listing(), std::vector<std::string>{"newt.glb"});
}

}  // namespace
}  // namespace marrow::test
