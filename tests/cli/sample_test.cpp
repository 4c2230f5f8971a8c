// `marrow sample`: the character, clips for a game and a graph, which fit one another as they come.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/process.h"

namespace marrow::test {
namespace {

class SampleTest : public ::testing::Test {
 protected:
  std::string in(const std::string& name) const { return folder_ / name; }
  std::string run(const std::vector<std::string>& arguments) const {
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << arguments[0] << "\n" << ran.err;
    return ran.out + ran.err;
  }
  void write_all() const {
    run({"sample", "-o", in("newt.glb")});
    run({"sample", "--moves", "-o", in("moves.glb")});
    run({"sample", "--graph", "-o", in("newt.anim.toml")});
    run({"cook", in("newt.glb"), "-o", in("newt.mrw"), "--mesh-codec", "none"});
  }
  // Cooks the clips for the character.
  std::string cook(const std::string& to, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"cook", in("moves.glb"), "--clips-only", "--skeleton", in("newt.mrw"), "-o", to});
    return run(options);
  }
  // The mean place of a pose's vertices along z.
  double mean_z(const std::string& pack, const std::string& time) const {
    run({"pose", in("newt.mrw"), "--clips", pack, "--clip", "run", "--time", time, "-o", in("p.obj")});
    double sum = 0, count = 0, x = 0, y = 0, z = 0;
    std::istringstream lines(read_text(in("p.obj")));
    for (std::string line; std::getline(lines, line);) {
      if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) != 3) continue;
      sum += z;
      ++count;
    }
    EXPECT_GT(count, 8000);
    return sum / count;
  }
  TemporaryFolder folder_;
};

TEST_F(SampleTest, ItsGraphFindsItsClips) {
  write_all();
  const std::string said =
      cook(in("pack.mrw"), {"--root", "*=ground", "--mirror", "turn_right=turn_left", "--graph", in("newt.anim.toml")});
  EXPECT_EQ(said.find("warning"), std::string::npos) << said;
  const std::string motion = run({"info", in("pack.mrw"), "--motion"});
  // As they are made: game_moves.h has the run's round, and a turn is a quarter.
  for (const char* const expected :
       {"\"run\": 0.560 s, moves at 1.55 m/s", "ends at 0.000 0.000 0.868 m, turned by 0.0", "turned by 90.0",
        "turned by -90.0", "passing     0.300 s", "passing     0.140 s"})
    EXPECT_NE(motion.find(expected), std::string::npos) << expected << "\n" << motion;
}

// Half of the run's round: a root that is taken out leaves the newt where it was.
TEST_F(SampleTest, RootsAreTakenOutOfPacksForACharacter) {
  write_all();
  cook(in("with.mrw"));
  cook(in("without.mrw"), {"--root", "run=ground"});
  EXPECT_NEAR(mean_z(in("with.mrw"), "0.28") - mean_z(in("with.mrw"), "0"), 0.434, 0.06);
  EXPECT_NEAR(mean_z(in("without.mrw"), "0.28") - mean_z(in("without.mrw"), "0"), 0, 0.06);
  EXPECT_NEAR(mean_z(in("with.mrw"), "0"), mean_z(in("without.mrw"), "0"), 1e-3);
}

TEST_F(SampleTest, WrongNamesAndBothAtOnceAreRefused) {
  EXPECT_EQ(run_marrow({"sample", "--graph", "-o", in("newt.glb")}).code, kUsage);
  EXPECT_EQ(run_marrow({"sample", "--moves", "-o", in("newt.toml")}).code, kUsage);
  EXPECT_EQ(run_marrow({"sample", "--moves", "--graph", "-o", in("newt.toml")}).code, kUsage);
  EXPECT_TRUE(folder_.listing().empty());
}

}  // namespace
}  // namespace marrow::test
