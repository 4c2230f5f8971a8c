// Many inputs at once: what is cooked where, what is said, and that one bad file does not stop the others.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"

namespace marrow::test {
namespace {

namespace fs = std::filesystem;

class Batch : public ::testing::Test {
 protected:
  // in/chars/hero.gltf, in/chars/old/foe.gltf, in/prop.gltf, all alike but for their size; and what is no scene.
  Batch() {
    fs::create_directories(folder_ / "in/chars/old");
    write_triangle(in("chars/hero.gltf"), in("chars/hero.bin"), 1);
    write_triangle(in("chars/old/foe.gltf"), in("chars/old/foe.bin"), 2);
    write_triangle(in("prop.gltf"), in("prop.bin"), 3);
    write_text(in("notes.txt"), "hello");
  }
  std::string in(const std::string& name) const { return folder_ / ("in/" + name); }
  std::string out(const std::string& name) const { return folder_ / ("out/" + name); }
  // Relative names of all files below out/, sorted.
  std::vector<std::string> outputs() const {
    std::vector<std::string> names;
    if (!fs::exists(folder_ / "out")) return names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out"))
      if (!entry.is_directory()) names.push_back(entry.path().lexically_relative(folder_ / "out").string());
    std::sort(names.begin(), names.end());
    return names;
  }
  TemporaryFolder folder_;
};

TEST_F(Batch, MirrorsTheTree) {
  const Ran ran = run_marrow({"cook", in(""), "-o", out("")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(ran.complaints().empty()) << ran.err;
  EXPECT_EQ(outputs(), (std::vector<std::string>{"chars/hero.mrw", "chars/old/foe.mrw", "prop.mrw"}));
  // Each is what cooking it alone gives.
  for (const std::string name : {"chars/hero", "chars/old/foe", "prop"}) {
    ASSERT_EQ(run_marrow({"cook", in(name + ".gltf"), "-o", folder_ / "alone.mrw"}).code, 0);
    EXPECT_EQ(read_text(folder_ / "alone.mrw"), read_text(out(name + ".mrw"))) << name;
  }
  for (const char* word : {"hero.gltf", "foe.gltf", "prop.gltf", "joints", "total", "3 files: 3 cooked", "0 failed"})
    EXPECT_NE(ran.out.find(word), std::string::npos) << word << "\n" << ran.out;
  EXPECT_EQ(ran.err.find('['), std::string::npos) << "no progress in a pipe: " << ran.err;
}

TEST_F(Batch, FilesAndFoldersTogether) {
  const Ran ran = run_marrow({"cook", tiny_gltf(), in("prop.gltf"), in("chars"), in("prop.gltf"), "-o", out("")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(outputs(), (std::vector<std::string>{"hero.mrw", "old/foe.mrw", "prop.mrw", "tiny.mrw"}));
}

TEST_F(Batch, OneFileIntoAFolder) {
  EXPECT_EQ(run_marrow({"cook", in("prop.gltf"), "-o", out("")}).code, 0);
  EXPECT_EQ(outputs(), std::vector<std::string>{"prop.mrw"});
}

TEST_F(Batch, OneFileIntoAFolderThatIsThere) {
  fs::create_directories(folder_ / "out");
  EXPECT_EQ(run_marrow({"cook", in("prop.gltf"), "-o", folder_ / "out"}).code, 0);
  EXPECT_EQ(outputs(), std::vector<std::string>{"prop.mrw"});
}

TEST_F(Batch, FoldersAreSearchedForEverySource) {
  write_triangle(in("chars/avatar.VRM"), in("chars/avatar.bin"), 1);
  EXPECT_EQ(run_marrow({"cook", in("chars"), "-o", out("")}).code, 0);
  EXPECT_EQ(outputs(), (std::vector<std::string>{"avatar.mrw", "hero.mrw", "old/foe.mrw"}));
  EXPECT_NE(run_marrow({"cook", "--help"}).out.find(".gltf, .glb, .vrm and .bvh"), std::string::npos);
}

TEST_F(Batch, LinksInACircle) {
  fs::create_directory_symlink(folder_ / "in", in("chars/again"));
  EXPECT_EQ(run_marrow({"cook", in(""), "-o", out("")}).code, 0);
  EXPECT_EQ(outputs().size(), 3u);
}

TEST_F(Batch, OneBadFileDoesNotStopTheOthers) {
  write_text(in("chars/broken.glb"), "not a scene");
  fs::remove(in("prop.bin"));
  write_text(out("prop.mrw"), "");  // the folder is not there yet: nothing is written
  const Ran ran = run_marrow({"cook", in(""), "-o", out(""), "--report", folder_ / "r.json"});
  EXPECT_EQ(ran.code, 3) << "the first failure's: " << ran.err;
  EXPECT_EQ(outputs(), (std::vector<std::string>{"chars/hero.mrw", "chars/old/foe.mrw"}));
  ASSERT_EQ(ran.complaints().size(), 2u) << ran.err;
  EXPECT_EQ(ran.complaints()[0].find(in("chars/broken.glb") + ": @0: "), 0u) << ran.err;
  EXPECT_EQ(ran.complaints()[1].find(in("prop.gltf") + ": /buffers/0/uri: "), 0u) << ran.err;
  EXPECT_NE(ran.out.find("4 files: 2 cooked, 0 from the cache, 2 failed"), std::string::npos) << ran.out;
  const nlohmann::json r = nlohmann::json::parse(read_text(folder_ / "r.json"));
  ASSERT_EQ(r.size(), 4u);
  EXPECT_EQ(r[0].at("source").at("file"), in("chars/broken.glb"));
  EXPECT_EQ(r[0].at("error").at("code"), 3);
  EXPECT_EQ(r[1].at("output").at("file"), out("chars/hero.mrw"));
  EXPECT_EQ(r[3].at("error").at("text"), ran.complaints()[1]);
}

TEST_F(Batch, ReportOnStdoutIsTheSame) {
  const Ran ran = run_marrow({"cook", in(""), "-o", out(""), "--report", folder_ / "r.json", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, read_text(folder_ / "r.json"));
  EXPECT_EQ(nlohmann::json::parse(ran.out).size(), 3u);
}

TEST_F(Batch, Mistakes) {
  fs::create_directories(folder_ / "empty/below");
  fs::create_directories(folder_ / "named.mrw");
  write_triangle(in("chars/prop.gltf"), in("chars/prop.bin"), 1);
  write_text(folder_ / "file", "");
  const struct {
    std::vector<std::string> arguments;
    int code;
    std::vector<std::string> names;
  } cases[] = {
      {{folder_ / "empty", "-o", out("")}, 3, {folder_ / "empty", ".gltf, .glb, .vrm or .bvh"}},
      {{in("prop.gltf"), in("chars"), "-o", out("")}, 1, {in("prop.gltf"), in("chars/prop.gltf"), out("prop.mrw")}},
      {{in("prop.gltf"), "-o", in("prop.gltf")}, 1, {in("prop.gltf")}},
      {{in("prop.gltf"), "-o", in("prop.bin")}, 1, {in("prop.bin")}},
      {{in("prop.gltf"), "-o", out("x"), "--report", out("x")}, 1, {out("x")}},
      {{in("prop.gltf"), "-o", out("hero.txt")}, 1, {out("hero.txt") + ": unknown format: ", ".mrw", "/"}},
      {{in("prop.gltf"), "-o", out("hero")}, 1, {out("hero") + ": unknown format: ", ".mrw", "/"}},
      {{in("prop.gltf"), "-o", folder_ / "named.mrw"}, 2, {folder_ / "named.mrw"}},
      {{in(""), "-o", folder_ / "file"}, 2, {folder_ / "file"}},
      {{in(""), "-o", out("x.mrw")}, 1, {out("x.mrw")}},
      {{in(""), "-o", out("x.MRW")}, 1, {out("x.MRW")}},
      {{in(""), "-o", "/proc/out"}, 2, {"/proc/out"}},
      {{in(""), "-o", out(""), "--jobs", "0"}, 1, {"--jobs"}},
  };
  int checked = 0;
  for (const auto& c : cases) {
    std::vector<std::string> arguments = {"cook"};
    arguments.insert(arguments.end(), c.arguments.begin(), c.arguments.end());
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, c.code) << ran.err;
    ASSERT_EQ(ran.complaints().size(), 1u) << ran.err;
    for (const std::string& name : c.names) EXPECT_NE(ran.err.find(name), std::string::npos) << ran.err;
    EXPECT_TRUE(outputs().empty()) << ran.err;
    ++checked;
  }
  EXPECT_EQ(checked, 13);
  EXPECT_EQ(read_text(in("prop.bin")).size(), 36u);
}

// Rules for many files need not fit each of them; a single file's must.
TEST_F(Batch, RulesThatFitNothingAreWarnings) {
  const std::vector<std::string> rules = {"--clip-error", "hand*=0.02mm", "--additive", "aim*=rest"};
  std::vector<std::string> many = {"cook", in(""), "-o", out("")}, one = {"cook", in("prop.gltf"), "-o", out("p.mrw")};
  many.insert(many.end(), rules.begin(), rules.end());
  one.insert(one.end(), rules.begin(), rules.end());
  const Ran ran = run_marrow(many);
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("prop.gltf: /animations: warning: rule-fits-nothing: "), std::string::npos) << ran.err;
  EXPECT_EQ(run_marrow(one).code, 1);
}

}  // namespace
}  // namespace marrow::test
