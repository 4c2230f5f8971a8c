// marrow.toml as the program finds and applies it.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

namespace fs = std::filesystem;

// in/chars/dance.gltf and in/tiny.gltf, with clips; in/chars/deep for settings that are nearer.
class SettingsFile : public ::testing::Test {
 protected:
  SettingsFile() {
    fs::create_directories(folder_ / "in/chars/deep");
    const std::string golden = in_golden("");
    fs::copy_file(golden + "dance.gltf", folder_ / "in/chars/dance.gltf");
    fs::copy_file(golden + "tiny.gltf", folder_ / "in/tiny.gltf");
    fs::copy_file(golden + "tiny.gltf", folder_ / "in/chars/deep/tiny.gltf");
  }
  // The codec of the first clip in a cook of everything, by source.
  std::map<std::string, std::string> codecs(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"cook", folder_ / "in", "-o", folder_ / "out/", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    std::map<std::string, std::string> out;
    for (const auto& report : nlohmann::json::parse(ran.out))
      out[fs::path(report.at("source").at("file").get<std::string>()).lexically_relative(folder_ / "in").string()] =
          report.at("clips").at(0).at("codec");
    EXPECT_EQ(out.size(), 3u);
    return out;
  }
  using Codecs = std::map<std::string, std::string>;
  TemporaryFolder folder_;
};

constexpr const char *kDance = "chars/dance.gltf", *kDeep = "chars/deep/tiny.gltf", *kTiny = "tiny.gltf";

TEST_F(SettingsFile, DefaultsRulesAndTheCommandLine) {
  const Codecs coded = codecs();
  EXPECT_EQ(coded.at(kDance), "segments");
  write_text(folder_ / "in/marrow.toml", "clip-codec = 'raw'\n");
  EXPECT_EQ(codecs(), (Codecs{{kDance, "raw"}, {kDeep, "raw"}, {kTiny, "raw"}}));
  EXPECT_EQ(codecs({"--clip-codec", "segments"}), coded) << "the command line wins";
  write_text(folder_ / "in/marrow.toml",
             "clip-codec = 'raw'\n[[file]]\nmatch = 'chars/dan*'\nclip-codec = 'segments'\n");
  EXPECT_EQ(codecs(), (Codecs{{kDance, "segments"}, {kDeep, "raw"}, {kTiny, "raw"}}));
}

TEST_F(SettingsFile, TheNearestCounts) {
  const Codecs coded = codecs();
  write_text(folder_ / "in/marrow.toml", "clip-codec = 'raw'\n");
  write_text(folder_ / "in/chars/marrow.toml", "");
  EXPECT_EQ(codecs(), (Codecs{{kDance, coded.at(kDance)}, {kDeep, coded.at(kDeep)}, {kTiny, "raw"}}));
  // A file that is named on the command line: no further than its own folder, or the working directory above it.
  write_text(folder_ / "marrow.toml", "wrong = 1\n");
  EXPECT_EQ(run_marrow({"cook", folder_ / "in/tiny.gltf", "-o", folder_ / "t.mrw"}).code, 0);
  const std::string from_above = "cd '" + folder_.path() + "' && exec '" + program() + "' cook ";
  EXPECT_EQ(run_program({"sh", "-c", from_above + "in/chars/dance.gltf -o t.mrw"}).code, 0);
  fs::remove(folder_ / "in/marrow.toml");
  const Ran ran = run_program({"sh", "-c", from_above + "in/tiny.gltf -o t.mrw"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.err, "marrow.toml: 1:1: unknown setting \"wrong\": `marrow cook --help` lists the options\n");
}

TEST_F(SettingsFile, CanBeNamed) {
  write_text(folder_ / "other.toml", "clip-codec = 'raw'\n");
  write_text(folder_ / "in/marrow.toml", "wrong = 1\n");
  EXPECT_EQ(codecs({"--settings", folder_ / "other.toml"}).at(kTiny), "raw");
  const Ran ran = run_marrow({"cook", tiny_gltf(), "-o", folder_ / "t.mrw", "--settings", folder_ / "absent.toml"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("absent.toml"), std::string::npos);
}

TEST_F(SettingsFile, ErrorsAreLocatedAndNothingIsWritten) {
  const std::string path = folder_ / "in/marrow.toml";
  write_text(path, "\n\n  clip-eror = '0.1mm'\n");
  const Ran ran = run_marrow({"cook", folder_ / "in", "-o", folder_ / "out/"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.err, path + ": 3:3: unknown setting \"clip-eror\": did you mean \"clip-error\"?\n");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(SettingsFile, ARuleWithoutAnInputIsAWarning) {
  const std::string path = folder_ / "in/marrow.toml";
  write_text(path, "[[file]]\nmatch = 'chars/*'\n[[file]]\nmatch = 'props/*'\nclip-codec = 'raw'\n");
  const Ran all = run_marrow({"cook", folder_ / "in", "-o", folder_ / "out/"});
  EXPECT_EQ(all.code, 0);
  EXPECT_NE(all.err.find(path + ": 3:1: warning: no input is called \"props/*\"\n"), std::string::npos) << all.err;
  EXPECT_EQ(all.err.find("\"chars/*\""), std::string::npos) << all.err;
  // Part of the files says nothing about the rest.
  EXPECT_EQ(run_marrow({"cook", folder_ / "in/tiny.gltf", "-o", folder_ / "t.mrw"}).err.find("props"),
            std::string::npos);
}

}  // namespace
}  // namespace marrow::test
