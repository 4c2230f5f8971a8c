// Example shapes through the program: a clip's channels or --set decide where in the space, by hand.
#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

using Vertices = std::vector<std::array<double, 3>>;

// face.gltf with a space in which the smile is at (1, 0) and the blink, half a metre to the front, at (1, 1).
class Parameters : public ::testing::Test {
 protected:
  Parameters() {
    write_text(folder_ / "marrow.toml", R"([[shapes]]
name = "face"
parameters = ["mood", "head.glow"]
examples = [
  { at = [0, 0] },
  { target = "smile", at = [1, 0] },
  { target = "blink", at = [1, 1] },
]
)");
    const Ran ran = run_marrow({"cook", in_golden("face.gltf"), "-o", file_, "--settings", folder_ / "marrow.toml",
                                "--mesh-codec", "none", "--keep-vertex-order"});
    EXPECT_EQ(ran.code, 0) << ran.err;
  }
  // The face's four vertices.
  Vertices posed(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"pose", file_, "-o", folder_ / "p.obj"});
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    std::ifstream in(folder_ / "p.obj");
    Vertices out;
    for (std::string line; std::getline(in, line) && out.size() < 4;) {
      if (line.rfind("v ", 0) != 0) continue;
      std::istringstream words(line.substr(2));
      auto& v = out.emplace_back();
      words >> v[0] >> v[1] >> v[2];
    }
    return out;
  }
  void expect_near(const Vertices& got, const Vertices& wanted, double error) const {
    ASSERT_EQ(got.size(), wanted.size());
    for (std::size_t i = 0; i < got.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(got[i][c], wanted[i][c], error) << i << c;
  }
  TemporaryFolder folder_;
  std::string file_ = folder_ / "face.mrw";
};

// The smile's targets (0.1 0 0, 0 0.1 0, 0 0 0.1, 0 0 0) on the square, turned by (0, 0, 0.6, 0.8): (x, y) goes to
// (0.28 x - 0.96 y, 0.96 x + 0.28 y).
const Vertices kSmile = {{0.028, 0.096, 0}, {0.184, 0.988, 0}, {-0.96, 0.28, 0.1}, {-0.68, 1.24, 0.25}};

TEST_F(Parameters, AreSetByHand) {
  expect_near(posed({"--set", "mood=1", "--set", "head.glow=0"}), kSmile, 1e-5);
  Vertices none = kSmile;  // the defaults, (0, 0): the mesh as it is
  none[0] = {0, 0, 0};
  none[1] = {0.28, 0.96, 0};
  none[2] = {-0.96, 0.28, 0};
  expect_near(posed({}), none, 1e-5);
}

// A quarter of a second in, both channels are 1 and the head is not turned.
TEST_F(Parameters, AreAClips) {
  const Vertices blink = {{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}, {1, 1, 0.75}};
  expect_near(posed({"--clip", "speak", "--time", "0.25"}), blink, 2e-4);
  const Vertices smile = {{0.1, 0, 0}, {1, 0.1, 0}, {0, 1, 0.1}, {1, 1, 0.25}};
  expect_near(posed({"--clip", "speak", "--time", "0.25", "--set", "head.glow=0"}), smile, 2e-4);
}

TEST_F(Parameters, ThatThereAreNotAreRefused) {
  const struct {
    const char *given, *says;
  } cases[] = {{"mod=1", "no parameter \"mod\": did you mean \"mood\"?"},
               {"mood", "gives no number"},
               {"mood=", "gives no number"},
               {"mood=nan", "gives no number"},
               {"mood=1x", "gives no number"}};
  for (const auto& c : cases) {
    const Ran ran = run_marrow({"pose", file_, "-o", folder_ / "p.obj", "--set", c.given});
    EXPECT_EQ(ran.code, 1) << c.given;
    EXPECT_NE(ran.err.find(c.says), std::string::npos) << ran.err;
  }
}

TEST_F(Parameters, AreListed) {
  const auto info = nlohmann::json::parse(run_marrow({"info", file_, "--json"}).out);
  const auto& shape = info.at("shapes").at(0);
  EXPECT_EQ(shape.at("name"), "face");
  EXPECT_EQ(shape.at("examples"), 3);
  EXPECT_EQ(shape.at("parameters").at(1).at("name"), "head.glow");
  EXPECT_EQ(shape.at("targets"), nlohmann::json::parse(R"(["smile", "blink"])"));
  EXPECT_EQ(shape.at("meshes"), nlohmann::json::parse("[0]"));
  EXPECT_NE(run_marrow({"info", file_}).out.find("3 examples of 2 morph targets by \"mood\", \"head.glow\", of mesh 0"),
            std::string::npos);
  const Ran exported = run_marrow({"export", file_, "-o", folder_ / "face.glb"});
  EXPECT_NE(exported.err.find("glTF has no spaces of example shapes"), std::string::npos) << exported.err;
}

}  // namespace
}  // namespace marrow::test
