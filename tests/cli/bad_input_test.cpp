// What goes wrong is said in one line that names the file, with the right exit code, and leaves no output behind.
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/process.h"

namespace marrow::test {
namespace {

class BadInput : public ::testing::Test {
 protected:
  BadInput() {
    write_text(in("empty"), "");
    write_text(in("picture"), std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\10\2\0\0\0", 29));
    write_text(in("text"), "once upon a time\n");
    write_text(in("no_meshes.gltf"),
               R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"n"}]})");
    write_text(in("no_triangles.gltf"),
               R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"NORMAL":0}}]}],)"
               R"("accessors":[{"type":"VEC3","componentType":5126,"count":3}]})");
    write_text(in("old.gltf"), R"({"asset":{"version":"1.0"}})");
    write_text(in("needs.gltf"), with_extension());
    write_text(in("cut.glb"), std::string("glTF\2\0\0\0\0\1\0\0\xF0\0\0\0JSON{\"asset\"", 28));
    EXPECT_EQ(run_marrow({"cook", tiny_gltf(), "-o", in("good.mrw")}).code, 0);
    const std::string good = read_text(in("good.mrw"));
    write_text(in("cut.mrw"), good.substr(0, good.size() - 1));
    std::string damaged = good, newer = good;
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
    newer[4] = 99;
    write_text(in("damaged.mrw"), damaged);
    write_text(in("newer.mrw"), newer);
  }
  static std::string with_extension() {
    std::string json = read_text(tiny_gltf());
    return json.replace(json.find('{'), 1,
                        R"({"extensionsUsed":["EXT_no_such"],"extensionsRequired":["EXT_no_such"],)");
  }
  std::string in(const std::string& name) const { return inputs_ / name; }
  std::string out(const std::string& name) const { return outputs_ / name; }

  // One line that names `names`; the exit code; nothing in the outputs' folder.
  void expect_failure(const std::vector<std::string>& arguments, int code, const std::string& names) {
    const Ran ran = run_marrow(arguments);
    std::string line;
    for (const std::string& a : arguments) line += a + " ";
    EXPECT_EQ(ran.code, code) << line << "\n" << ran.err;
    EXPECT_EQ(ran.out, "") << line;
    ASSERT_EQ(ran.complaints().size(), 1u) << line << "\n" << ran.err;
    EXPECT_EQ(ran.err.back(), '\n');
    EXPECT_NE(ran.complaints()[0].find(names), std::string::npos) << line << "\n" << ran.err;
    EXPECT_GT(ran.complaints()[0].size(), names.size() + 8) << "it also says what is wrong: " << ran.err;
    ++cases_;
    if (outputs_.listing().empty()) return;
    ADD_FAILURE() << line << " left " << outputs_.listing()[0];
    std::filesystem::remove(out(outputs_.listing()[0]));
  }

  TemporaryFolder inputs_, outputs_;
  int cases_ = 0;
};

TEST_F(BadInput, Cook) {
  const struct {
    std::string input;
    int code;
  } cases[] = {{in("absent.glb"), kIo},   {in("empty"), kInvalid},          {in("picture"), kInvalid},
               {in("text"), kInvalid},    {in("no_meshes.gltf"), kInvalid}, {in("no_triangles.gltf"), kInvalid},
               {in("cut.glb"), kInvalid}, {in("good.mrw"), kInvalid},       {in("needs.gltf"), kUnsupported},
               {"/dev/null", kIo}};
  for (const auto& c : cases) {
    expect_failure({"cook", c.input, "-o", out("x.mrw")}, c.code, c.input);
    expect_failure({"cook", c.input, "-o", out("x.mrw"), "--report", out("r.json")}, c.code, c.input);
  }
  EXPECT_EQ(cases_, 20);
  const int old = run_marrow({"cook", in("old.gltf"), "-o", out("x.mrw")}).code;
  EXPECT_TRUE(old == kInvalid || old == kUnsupported) << old;
  EXPECT_TRUE(outputs_.listing().empty());
}

TEST_F(BadInput, UnwritableOutputs) {
  const std::string nowhere = out("no/such/folder/x");
  for (const std::string& target : {nowhere, std::string("/dev/null/x"), std::string("/proc/x"), inputs_.path()}) {
    if (target != inputs_.path()) expect_failure({"cook", tiny_gltf(), "-o", target + ".mrw"}, kIo, target);
    expect_failure({"cook", tiny_gltf(), "-o", out("x.mrw"), "--report", target}, kIo, target);
  }
  for (const std::string& target : {nowhere, std::string("/dev/null/x"), std::string("/proc/x")}) {
    expect_failure({"pose", in("good.mrw"), "-o", target + ".bin"}, kIo, target);
    expect_failure({"pose", in("good.mrw"), "-o", target + ".obj"}, kIo, target);
#ifdef MARROW_HAS_GLES
    expect_failure({"render", in("good.mrw"), "--size", "32x32", "-o", target + ".png"}, kIo, target);
    expect_failure({"render", in("good.mrw"), "--size", "8x8", "--movie", "--fps", "1", "-o", target + "%d.png"}, kIo,
                   target);
#endif
  }
  EXPECT_GE(cases_, 13);
}

TEST_F(BadInput, CookedFiles) {
  const struct {
    const char* input;
    int code;
  } cases[] = {{"absent.mrw", kIo},       {"", kIo},
               {"empty", kInvalid},       {"picture", kInvalid},
               {"text", kInvalid},        {"cut.mrw", kInvalid},
               {"damaged.mrw", kInvalid}, {"newer.mrw", kUnsupported}};
  for (const auto& c : cases) {
    expect_failure({"info", in(c.input)}, c.code, in(c.input));
    expect_failure({"info", in(c.input), "--json"}, c.code, in(c.input));
    expect_failure({"pose", in(c.input), "-o", out("p.bin")}, c.code, in(c.input));
    expect_failure({"export", in(c.input), "-o", out("x.glb")}, c.code, in(c.input));
    expect_failure({"diff", in("good.mrw"), in(c.input)}, c.code, in(c.input));
#ifdef MARROW_HAS_GLES
    expect_failure({"render", in(c.input), "-o", out("p.png")}, c.code, in(c.input));
#endif
#ifdef MARROW_HAS_VIEW
    expect_failure({"view", in(c.input), "--screenshot", out("p.png")}, c.code, in(c.input));
#endif
  }
  EXPECT_GE(cases_, 24);
}

TEST_F(BadInput, Clips) {
  for (const char* clip : {"wawe", "2", "-1", "99999999999999999999", "Wave", "1x"}) {
    expect_failure({"pose", in("good.mrw"), "--clip", clip, "-o", out("p.bin")}, kUsage, clip);
#ifdef MARROW_HAS_GLES
    expect_failure({"render", in("good.mrw"), "--clip", clip, "-o", out("p.png")}, kUsage, clip);
#endif
#ifdef MARROW_HAS_VIEW
    expect_failure({"view", in("good.mrw"), "--clip", clip, "--screenshot", out("p.png")}, kUsage, clip);
#endif
  }
  EXPECT_GE(cases_, 6);
}

TEST_F(BadInput, Usage) {
  const std::string good = in("good.mrw"), bin = out("p.bin");
  expect_failure({}, kUsage, "marrow");
  expect_failure({"frobnicate"}, kUsage, "marrow");
  expect_failure({"cook"}, kUsage, "marrow");
  expect_failure({"cook", tiny_gltf()}, kUsage, "marrow");
  expect_failure({"cook", tiny_gltf(), "-o", out("x.mrw"), "--wat"}, kUsage, "--wat");
  for (const char* error : {"0mm", "-1mm", "0.1", "nanm", "infm", "1e999m", "0.1 mm", "", "0.1mmm"})
    expect_failure({"cook", tiny_gltf(), "-o", out("x.mrw"), "--clip-error", error}, kUsage, error);
  expect_failure({"cook", tiny_gltf(), "-o", out("x.mrw"), "--clip-codec", "magic"}, kUsage, "magic");
  expect_failure({"info"}, kUsage, "marrow");
  expect_failure({"pose", good}, kUsage, "marrow");
  expect_failure({"pose", good, "-o", bin, "--deformer", "magic"}, kUsage, "magic");
  expect_failure({"pose", good, "-o", bin, "--time", "soon"}, kUsage, "soon");
  expect_failure({"pose", good, "-o", bin, "--time", "nan"}, kUsage, "nan");
  expect_failure({"pose", good, "-o", out("p.xyz")}, kUsage, "p.xyz");
#ifdef MARROW_HAS_GLES
  const std::string png = out("p.png");
  for (const char* size : {"0x0", "x", "100", "-3x5", "1000000x1000000", "10x10x10"})
    expect_failure({"render", good, "--size", size, "-o", png}, kUsage, size);
  expect_failure({"render", good, "--heatmap", "ssd:magic", "-o", png}, kUsage, "magic");
  expect_failure({"render", good, "--path", "magic", "-o", png}, kUsage, "magic");
  expect_failure({"render", good, "--normals", "magic", "-o", png}, kUsage, "magic");
  expect_failure({"render", good}, kUsage, "marrow");
  for (const char* option : {"--fps", "--turn"})
    expect_failure({"render", good, "-o", png, option, "20"}, kUsage, "--movie");
  for (const char* fps : {"0", "61", "1.5", "x"})
    expect_failure({"render", good, "-o", png, "--movie", "--fps", fps}, kUsage, "--fps");
  for (const char* turn : {"nan", "inf", "3601", "x"})
    expect_failure({"render", good, "-o", png, "--movie", "--turn", turn}, kUsage, "--turn");
  expect_failure({"render", good, "-o", png, "--movie", "--turn", "0"}, kUsage, "nothing would move");
  expect_failure({"render", good, "-o", out("%d%04d.png"), "--movie"}, kUsage, "%d%04d.png");
  expect_failure({"render", good, "-o", png, "--movie", "--turn", "3600", "--fps", "60", "--size", "4000x4000"}, kUsage,
                 png);
#endif
  EXPECT_GE(cases_, 11);
}

TEST_F(BadInput, AFailedCookLeavesTheOldFile) {
  write_text(out("x.mrw"), "precious");
  EXPECT_EQ(run_marrow({"cook", in("picture"), "-o", out("x.mrw")}).code, kInvalid);
  EXPECT_EQ(read_text(out("x.mrw")), "precious");
  EXPECT_EQ(outputs_.listing().size(), 1u);
}

TEST_F(BadInput, HelpIsNoFailure) {
  std::vector<std::string> commands = {"", "cook", "info", "pose", "export", "diff"};
#ifdef MARROW_HAS_GLES
  commands.push_back("render");
#endif
#ifdef MARROW_HAS_VIEW
  commands.push_back("view");
#endif
  for (const std::string& command : commands) {
    std::vector<std::string> arguments = {"--help"};
    if (!command.empty()) arguments.insert(arguments.begin(), command);
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << command;
    EXPECT_EQ(ran.err, "") << command;
    EXPECT_NE(ran.out.find("-h,--help"), std::string::npos) << command;
    EXPECT_NE(ran.out.find(command), std::string::npos) << command;
  }
  EXPECT_NE(run_marrow({"pose", "--help"}).out.find("--deformer"), std::string::npos);
}

}  // namespace
}  // namespace marrow::test
