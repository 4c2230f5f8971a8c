// Outfits on the command line: cooked for a body, posed and drawn with it, refused where they do not fit.
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

class CliOutfit : public ::testing::Test {
 protected:
  CliOutfit() {
    run({"sample", "-o", in("newt.glb")});
    run({"cook", in("newt.glb"), "-o", in("newt.mrw"), "--clip-codec", "raw"});  // quick, and enough here
    run({"cook", in("newt.glb"), "-o", in("skin.mrw"), "--clip-codec", "raw", "--skeleton", in("newt.mrw")});
  }
  std::string in(const std::string& name) const { return folder_ / name; }
  std::string run(const std::vector<std::string>& arguments, int code = 0) const {
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, code) << arguments[0] << " " << arguments[1] << "\n" << ran.err;
    return ran.err;
  }
  std::vector<float> positions(const std::string& name) const {
    const std::string bytes = read_text(in(name));
    std::vector<float> out(bytes.size() / sizeof(float));
    std::memcpy(out.data(), bytes.data(), out.size() * sizeof(float));
    return out;
  }
  TemporaryFolder folder_;
};

// The sample in a skin of its own, which is where the sample is.
TEST_F(CliOutfit, IsPosedWithItsBody) {
  const std::vector<std::string> at = {"--clip", "walk", "--time", "0.4"};
  std::vector<std::string> alone = {"pose", in("newt.mrw"), "-o", in("alone.bin")},
                           both = {"pose", in("newt.mrw"), in("skin.mrw"), "-o", in("both.bin")};
  alone.insert(alone.end(), at.begin(), at.end());
  both.insert(both.end(), at.begin(), at.end());
  run(alone);
  run(both);
  const std::vector<float> one = positions("alone.bin"), two = positions("both.bin");
  ASSERT_EQ(two.size(), 2 * one.size());
  float worst = 0;
  for (std::size_t i = 0; i < two.size(); ++i) worst = std::max(worst, std::abs(two[i] - one[i % one.size()]));
  EXPECT_LT(worst, 2e-4f) << "metres, of a newt of 1.4 m; each file is quantised for itself";
  run({"pose", in("newt.mrw"), in("skin.mrw"), in("skin.mrw"), "-o", in("three.bin")});
  EXPECT_EQ(positions("three.bin").size(), 3 * one.size());
}

TEST_F(CliOutfit, OfAnotherBodyIsRefused) {
  run({"cook", in_golden("tiny.gltf"), "-o", in("arm.mrw")});
  const std::string line = run({"pose", in("arm.mrw"), in("skin.mrw"), "-o", in("p.bin")}, 3);
  for (const char* word : {"skin.mrw", "does not fit", "arm.mrw", "--skeleton"})
    EXPECT_NE(line.find(word), std::string::npos) << line;
  const std::string unmatched =
      run({"cook", in_golden("dance.gltf"), "-o", in("dance.mrw"), "--skeleton", in("arm.mrw")}, 3);
  EXPECT_NE(unmatched.find("no such joint in "), std::string::npos) << unmatched;
  run({"cook", in("newt.glb"), "-o", in("pack.mrw"), "--clip-codec", "raw", "--clips-only"});
  EXPECT_NE(run({"pose", in("newt.mrw"), in("pack.mrw"), "-o", in("p.bin")}, 3).find("no skeleton"), std::string::npos);
}

#ifdef MARROW_HAS_GLES
TEST_F(CliOutfit, IsDrawnWithItsBody) {
  run({"render", in("newt.mrw"), in("skin.mrw"), "--size", "120x90", "-o", in("both.png")});
  run({"render", in("newt.mrw"), in("skin.mrw"), "--heatmap", "rigid:ssd", "--size", "120x90", "-o", in("heat.png")});
  run({"render", in("newt.mrw"), in("skin.mrw"), "--clip", "walk", "--path", "crowd", "-o", in("no.png")}, 1);
}
#endif

}  // namespace
}  // namespace marrow::test
