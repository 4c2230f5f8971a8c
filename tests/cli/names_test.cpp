// Names and files that are not what a command takes: what it says, and how soon.
#include <chrono>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/process.h"
#include "marrow/version.h"

namespace marrow::test {
namespace {

TEST(Version, IsThatOfTheHeader) {
  const Ran ran = run_marrow({"--version"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, std::to_string(MARROW_VERSION_MAJOR) + '.' + std::to_string(MARROW_VERSION_MINOR) + '.' +
                         std::to_string(MARROW_VERSION_PATCH) + '\n');
}

// The sample, with one coarser level.
class Names : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    ASSERT_EQ(run_marrow({"sample", "-o", newt()}).code, 0);
    ASSERT_EQ(run_marrow({"cook", newt(), "-o", cooked(), "--lod", "0.5", "--clip-codec", "raw"}).code, 0);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static std::string at(const std::string& name) { return *folder_ / name; }
  static std::string newt() { return at("newt.glb"); }
  static std::string cooked() { return at("newt.mrw"); }

  // One line, with all of these texts in it.
  static void expect_failure(const std::vector<std::string>& arguments, int code,
                             const std::vector<std::string>& texts) {
    const Ran ran = run_marrow(arguments);
    const std::string command = ::testing::PrintToString(arguments);
    EXPECT_EQ(ran.code, code) << command << '\n' << ran.err;
    EXPECT_EQ(ran.err.find('\n'), ran.err.size() - 1) << command << '\n' << ran.err;
    for (const std::string& text : texts)
      EXPECT_NE(ran.err.find(text), std::string::npos) << command << '\n' << ran.err;
  }

 private:
  static TemporaryFolder* folder_;
};

TemporaryFolder* Names::folder_ = nullptr;

TEST_F(Names, FoldersThatAreNotThere) {
  const std::string folder = at("no/such/dir"), rule = "there is no folder " + folder;
  std::vector<std::vector<std::string>> commands = {{"cook", newt(), "-o", folder + "/x.mrw"},
                                                    {"cook", newt(), "-o", at("x.mrw"), "--report", folder + "/x.json"},
                                                    {"cook", newt(), "-o", at("x.mrw"), "--depfile", folder + "/x.d"},
                                                    {"pose", cooked(), "-o", folder + "/x.obj"},
                                                    {"export", cooked(), "-o", folder + "/x.glb"},
                                                    {"compare", newt(), "-o", folder + "/x.html"}};
#ifdef MARROW_HAS_GLES
  commands.push_back({"render", cooked(), "-o", folder + "/x.png"});
  commands.push_back({"render", cooked(), "--movie", "-o", folder + "/x%d.png"});
  commands.push_back({"bench", "--gpu", "-o", folder + "/x.svg"});
#endif
  const auto start = std::chrono::steady_clock::now();
  for (const std::vector<std::string>& command : commands) expect_failure(command, kIo, {rule, folder + "/x"});
  // To compare alone takes a minute, and the GPU's rows take more.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST_F(Names, FormatsThatAreNotWritten) {
  expect_failure({"pose", cooked(), "-o", at("x.fbx")}, kUsage, {"x.fbx: unknown format", ".obj or .bin"});
  expect_failure({"export", cooked(), "-o", at("x.gltf")}, kUsage, {"x.gltf: unknown format", ".glb"});
  expect_failure({"sample", "-o", at("x.mrw")}, kUsage, {"x.mrw: unknown format", ".glb"});
  expect_failure({"compare", newt(), "-o", at("x.pdf")}, kUsage, {"x.pdf: unknown format", ".html"});
  expect_failure({"cook", newt(), "-o", at("x.glb")}, kUsage, {"x.glb: unknown format", ".mrw"});
#ifdef MARROW_HAS_GLES
  expect_failure({"render", cooked(), "-o", at("x.jpg")}, kUsage, {"x.jpg: unknown format", ".png"});
  expect_failure({"render", cooked(), "--movie", "-o", at("x%d.jpg")}, kUsage, {"unknown format", ".png"});
  expect_failure({"bench", "--gpu", "-o", at("x.png")}, kUsage, {"x.png: unknown format", ".svg"});
  EXPECT_EQ(run_marrow({"render", cooked(), "--size", "8x8", "-o", at("X.PNG")}).code, 0) << "in any case";
#endif
}

TEST_F(Names, CommandsAndOptions) {
  expect_failure({"cok", newt()}, kUsage, {"no command \"cok\": did you mean \"cook\"?", "\"info\""});
  expect_failure({"cook", newt(), "-o", at("x.mrw"), "--clip-eror=1mm"}, kUsage,
                 {"unknown option --clip-eror: did you mean \"--clip-error\"? (see marrow cook --help)"});
  expect_failure({"pose", cooked(), "--otput", at("x.obj")}, kUsage,
                 {"unknown option --otput: did you mean \"--output\"?"});
  expect_failure({"--vesion"}, kUsage, {"unknown option --vesion: did you mean \"--version\"?"});
}

TEST_F(Names, Clips) {
  const std::string all = "there are 0 \"idle\", 1 \"walk\", 2 \"twist\", 3 \"reach\"";
  expect_failure({"pose", cooked(), "--clip", "wlak", "-o", at("x.obj")}, kUsage,
                 {"no clip \"wlak\": did you mean \"walk\"? " + all});
  expect_failure({"pose", cooked(), "--clip", "somersault", "-o", at("x.obj")}, kUsage,
                 {"no clip \"somersault\": " + all});
  expect_failure({"cook", newt(), "-o", at("x.mrw"), "--additive", "twst"}, kUsage, {"did you mean \"twist\"?"});
}

TEST_F(Names, Joints) {
  expect_failure({"cook", newt(), "-o", at("x.mrw"), "--clip-error", "hnd.L=1mm"}, kUsage,
                 {"\"hnd.L\": did you mean \"hand.L\"? there are ", " more"});
#ifdef MARROW_HAS_GLES
  expect_failure({"render", cooked(), "--ik", "hnd.L=0,1,0", "-o", at("x.png")}, kUsage,
                 {"--ik: no joint \"hnd.L\": did you mean \"hand.L\"? there are ", " more"});
#endif
}

TEST_F(Names, FilesOfTheOtherKind) {
  const std::string cook_it = "cook it first: marrow cook " + newt() + " -o " + cooked();
  expect_failure({"info", newt()}, kInvalid, {cook_it});
  expect_failure({"pose", newt(), "-o", at("x.obj")}, kInvalid, {cook_it});
  expect_failure({"export", newt(), "-o", at("x.glb")}, kInvalid, {cook_it});
  expect_failure({"diff", cooked(), newt()}, kInvalid, {cook_it});
#ifdef MARROW_HAS_GLES
  expect_failure({"render", newt(), "-o", at("x.png")}, kInvalid, {cook_it});
#endif
  const std::string export_it = "marrow export " + cooked() + " -o " + newt();
  expect_failure({"cook", cooked(), "-o", at("x.mrw")}, kInvalid, {export_it});
  expect_failure({"compare", cooked()}, kInvalid, {export_it});
}

TEST_F(Names, FilesOfOtherPrograms) {
  const struct {
    const char *name, *rule;
  } cases[] = {{"x.fbx", "Autodesk FBX"},
               {"x.FBX", "Autodesk FBX"},
               {"x.obj", "Wavefront OBJ"},
               {"x.usdz", "Universal Scene Description"},
               {"x.blend", "Blender"},
               {"x.dae", "COLLADA"},
               {"x.what", "the format .what is unknown"}};
  for (const auto& c : cases) {
    write_text(at(c.name), "no glTF");
    expect_failure({"cook", at(c.name), "-o", at("x.mrw")}, kUnsupported,
                   {c.rule, "export glTF (.glb) from the program"});
  }
  expect_failure({"info", at("x.fbx")}, kUnsupported, {"Autodesk FBX", "tools/fbx_to_glb.sh, and cook that"});
  // A name is no reason to refuse what is glTF inside.
  write_text(at("x.vrm"), read_text(newt()));
  EXPECT_EQ(run_marrow({"cook", at("x.vrm"), "-o", at("x.mrw"), "--clip-codec", "raw"}).code, 0);
}

#ifdef MARROW_HAS_GLES
TEST_F(Names, LevelsOfDetail) {
  expect_failure({"render", cooked(), "--lod", "5", "-o", at("x.png")}, kUsage,
                 {"no level of detail 5: there are 2 levels, 0 to 1"});
  EXPECT_EQ(run_marrow({"render", cooked(), "--lod", "1", "--size", "8x8", "-o", at("x.png")}).code, 0);
}

TEST_F(Names, GoalsOutOfReach) {
  std::vector<std::string> command = {"render", cooked(), "--size", "8x8", "-o", at("x.png"), "--ik", "hand.L=0,1,0.3"};
  EXPECT_EQ(run_marrow(command).err.find("warning"), std::string::npos);
  command.back() = "hand.L=0,101,0";
  const Ran ran = run_marrow(command);
  EXPECT_EQ(ran.code, 0);
  // The shoulder is between one and two metres high, and the arm shorter than one.
  const std::string rule = "--ik: warning: \"upper_arm.L\" > \"forearm.L\" > \"hand.L\" misses its goal by ";
  const std::size_t found = ran.err.find(rule);
  ASSERT_NE(found, std::string::npos) << ran.err;
  EXPECT_NEAR(std::stod(ran.err.substr(found + rule.size())), 99.5, 1) << ran.err;
}
#endif

}  // namespace
}  // namespace marrow::test
