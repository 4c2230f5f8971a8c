// Every command on every kind of cooked file does what it says, or says why not: the table of
// docs/reference/command_line.md.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

constexpr int kDiffer = 6;

class Kinds : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    write_text(in("character.mrw"), read_text(in_golden("tiny_v1.mrw")));
    write_text(in("face.mrw"), read_text(in_golden("face_v1.mrw")));
    write_text(in("others.mrw"), read_text(in_golden("pack_v1.mrw")));  // for another character
    write_triangle(in("triangle.gltf"), in("triangle.bin"), 1);
    write_text(in("rig.gltf"), R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
      "nodes":[{"name":"hips","children":[1]},{"name":"spine"}],"skins":[{"joints":[0,1]}]})");
    expect({"cook", tiny_gltf(), "-o", in("packed.mrw")}, 0);
    expect({"cook", tiny_gltf(), "-o", in("outfit.mrw"), "--skeleton", in("character.mrw")}, 0);
    expect({"cook", tiny_gltf(), "-o", in("moves.mrw"), "--clips-only", "--skeleton", in("character.mrw")}, 0);
    expect({"cook", tiny_gltf(), "-o", in("rough.mrw"), "--clips-only", "--skeleton", in("character.mrw"),
            "--clip-error", "5cm"},
           0);
    expect({"cook", in("triangle.gltf"), "-o", in("scenery.mrw")}, 0);
    expect({"cook", in("rig.gltf"), "-o", in("rig.mrw")}, 0);
    expect({"cook", "--graph", in_golden("graph.toml"), "-o", in("graphs.mrw")}, 0);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static std::string in(const std::string& name) { return *folder_ / name; }
  // What it says; of failures a line that has these words.
  static Ran expect(const std::vector<std::string>& arguments, int code, const std::string& words = "") {
    Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, code) << ::testing::PrintToString(arguments) << '\n' << ran.err;
    if (!words.empty()) {
      EXPECT_EQ(ran.complaints().size(), 1u) << ran.err;
      EXPECT_NE(ran.err.find(words), std::string::npos) << ::testing::PrintToString(arguments) << '\n' << ran.err;
    }
    return ran;
  }

 private:
  static TemporaryFolder* folder_;
};

TemporaryFolder* Kinds::folder_ = nullptr;

struct Row {
  const char* file;
  // "": it does; else words of why not.
  const char *exported, *posed, *as_clips, *worn;
};

TEST_F(Kinds, DoWhatTheTableSays) {
  const char *const pack = "a clip pack has nothing to move: name the character's file", *const no_mesh = "no mesh: ",
                    *const no_pack = "not a clip pack: cook it with --clips-only", *const unfit = "does not fit";
  const Row rows[] = {
      {"character.mrw", "", "", no_pack, ""},
      {"packed.mrw", "", "", no_pack, ""},
      {"outfit.mrw", "", "", no_pack, ""},
      {"face.mrw", "", "", no_pack, unfit},
      {"scenery.mrw", "", "", no_pack, unfit},
      {"rig.mrw", "", no_mesh, no_pack, unfit},
      {"moves.mrw", pack, pack, "", "no skeleton: cook the outfit with --skeleton"},
      {"others.mrw", pack, pack, unfit, "no skeleton: cook the outfit with --skeleton"},
      {"graphs.mrw", "", no_mesh, no_pack, "no skeleton: cook the outfit with --skeleton"},
  };
  const auto code = [](const char* why) { return *why == '\0' ? 0 : static_cast<int>(kInvalid); };
  for (const Row& row : rows) {
    const std::string file = in(row.file), character = in("character.mrw");
    EXPECT_NE(expect({"info", file}, 0).out, "");
    EXPECT_EQ(expect({"diff", file, file}, 0).out, "");
    expect({"export", file, "-o", in("x.glb")}, code(row.exported), row.exported);
    expect({"pose", file, "-o", in("x.bin")}, code(row.posed), row.posed);
    expect({"export", character, "--clips", file, "-o", in("x.glb")}, code(row.as_clips), row.as_clips);
    expect({"pose", character, file, "-o", in("x.bin")}, code(row.worn), row.worn);
#ifdef MARROW_HAS_GLES
    if (*row.posed != '\0') expect({"render", file, "-o", in("x.png")}, kInvalid, row.posed);
#ifdef MARROW_HAS_VIEW
    if (*row.posed != '\0') expect({"view", file}, kInvalid, row.posed);
#endif
#endif
    const int same = file == character ? 0 : kDiffer;
    EXPECT_EQ(expect({"diff", character, file}, same).out == "", same == 0);
  }
  // What reads sources.
  expect({"cook", in("moves.mrw"), "-o", in("x.mrw")}, kInvalid, "this is a cooked file, not glTF");
  expect({"compare", in("moves.mrw"), "-o", in("x.html")}, kInvalid, "this is a cooked file, not glTF");
  expect({"cook", tiny_gltf(), "-o", in("x.mrw"), "--skeleton", in("moves.mrw")}, kInvalid,
         "no skeleton: name the character's file, not a clip pack");
}

// With the character it says by how far: further than the fine clips' promise, not than the rough ones'.
TEST_F(Kinds, PacksAreCompared) {
  const std::string alone = expect({"diff", in("moves.mrw"), in("rough.mrw")}, kDiffer).out;
  EXPECT_NE(alone.find("clip \"wave\": the motion differs; --skeleton CHARACTER.mrw says by how far"),
            std::string::npos)
      << alone;
  const std::string posed =
      expect({"diff", in("moves.mrw"), in("rough.mrw"), "--skeleton", in("character.mrw")}, kDiffer).out;
  const std::size_t found = posed.find("clip \"wave\": poses differ by up to ");
  ASSERT_NE(found, std::string::npos) << posed;
  const double distance_m = std::stod(posed.substr(found + 35));
  EXPECT_GT(distance_m, 1e-4);
  EXPECT_LT(distance_m, 0.0501);
  const std::string joints = expect({"diff", in("moves.mrw"), in("others.mrw")}, kDiffer).out;
  EXPECT_NE(joints.find("skeleton \"arm\": only in the first file"), std::string::npos) << joints;
  const std::string kinds = expect({"diff", in("character.mrw"), in("moves.mrw")}, kDiffer).out;
  EXPECT_NE(kinds.find("file: no clip pack, now a clip pack"), std::string::npos) << kinds;
  expect({"diff", in("moves.mrw"), in("moves.mrw"), "--skeleton", in("moves.mrw")}, kInvalid, "nothing to move");
  expect({"diff", in("moves.mrw"), in("others.mrw"), "--skeleton", in("character.mrw")}, kInvalid, "does not fit");
  expect({"diff", in("face.mrw"), in("face.mrw"), "--skeleton", in("character.mrw")}, kInvalid, "not a clip pack");
}

}  // namespace
}  // namespace marrow::test
