// Nothing is cooked twice: what counts as the same, what a damaged cache does, and what is left alone.
#include <algorithm>
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

class CliCache : public ::testing::Test {
 protected:
  CliCache() { write_triangle(gltf(), bin(), 1); }
  std::string gltf() const { return folder_ / "a.gltf"; }
  std::string bin() const { return folder_ / "a.bin"; }
  std::string out() const { return folder_ / "a.mrw"; }
  std::string cache() const { return folder_ / "cache"; }

  // Whether cooking took it from the cache.
  bool cook(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"cook", gltf(), "-o", out(), "--cache", cache()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = run_marrow(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(ran.complaints().empty()) << ran.err;
    return ran.out.find("from the cache") != std::string::npos;
  }
  std::vector<fs::path> entries() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(cache()))
      if (entry.is_regular_file()) files.push_back(entry.path());
    return files;
  }
  // An entry without its hash and without how long cooking took, which is in some: "HASHREPORT_BYTES SECONDS REPORT…".
  static std::string what_counts(const std::string& entry) {
    constexpr std::size_t kHashDigits = 32;
    const std::size_t blank = entry.find(' '), next = entry.find(' ', blank + 1);
    const bool has_time = entry.find("MRRP") != std::string::npos;
    return has_time ? entry.substr(kHashDigits, blank - kHashDigits) + entry.substr(next) : entry;
  }
  TemporaryFolder folder_;
};

TEST_F(CliCache, WhatCounts) {
  EXPECT_FALSE(cook());
  const std::string first = read_text(out());
  EXPECT_TRUE(cook());
  fs::remove(out());
  EXPECT_TRUE(cook());
  EXPECT_EQ(read_text(out()), first);
  fs::last_write_time(bin(), fs::file_time_type::clock::now());
  EXPECT_TRUE(cook()) << "touched but the same";
  EXPECT_FALSE(cook({"--keep-vertex-order"})) << "another option";
  EXPECT_TRUE(cook());

  std::string changed = read_text(bin());
  changed[12] = 0x01;  // x of the second vertex, by a hair
  write_text(bin(), changed);
  EXPECT_FALSE(cook()) << "another buffer";
  EXPECT_NE(read_text(out()), first);
  write_triangle(gltf(), bin(), 1);
  EXPECT_TRUE(cook()) << "the first one is still there";
  EXPECT_EQ(read_text(out()), first);
  write_text(gltf(), read_text(gltf()) + " ");
  EXPECT_FALSE(cook()) << "another document";
  fs::remove(bin());
  EXPECT_EQ(run_marrow({"cook", gltf(), "-o", out(), "--cache", cache()}).code, 2) << "a buffer is gone";
}

// A pack is another one for another character.
TEST_F(CliCache, CountsTheSkeleton) {
  const std::string source = in_golden("dance.gltf"), character = folder_ / "c.gltf";
  nlohmann::json scene = nlohmann::json::parse(read_text(source));
  write_text(character, scene.dump());
  const auto pack = [&] {
    const Ran ran =
        run_marrow({"cook", source, "-o", out(), "--cache", cache(), "--clips-only", "--skeleton", character});
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.out.find("from the cache") != std::string::npos;
  };
  EXPECT_FALSE(pack());
  const std::string first = read_text(out());
  EXPECT_TRUE(pack());
  scene["nodes"][1]["translation"] = {0, 2, 0};
  write_text(character, scene.dump());
  EXPECT_FALSE(pack());
  EXPECT_TRUE(read_text(out()) != first);
}

// Its name is from the working directory, which may be another the next time.
TEST_F(CliCache, CountsWhichSkeletonANameIsOf) {
  const std::string source = in_golden("dance.gltf");
  nlohmann::json scene = nlohmann::json::parse(read_text(source));
  const fs::path before = fs::current_path();
  std::string packs[2];
  for (const int i : {0, 1}) {
    const fs::path folder = fs::path(folder_ / std::to_string(i));
    fs::create_directories(folder);
    scene["nodes"][1]["translation"] = {0, 2 + i, 0};
    write_text((folder / "c.gltf").string(), scene.dump());
    fs::current_path(folder);
    const Ran ran =
        run_marrow({"cook", source, "-o", out(), "--cache", cache(), "--clips-only", "--skeleton", "c.gltf"});
    fs::current_path(before);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out.find("from the cache"), std::string::npos);
    packs[i] = read_text(out());
  }
  EXPECT_TRUE(packs[0] != packs[1]);
}

// The skeleton of --auto-skeleton: its template is an input, of the cache and of --depfile.
TEST_F(CliCache, CountsTheTemplate) {
  const std::string bar = folder_ / "bar.toml", depfile = folder_ / "a.d";
  const std::string before =
      "[[joint]]\nname = \"low\"\nplace = [0, 0, 0]\n[[joint]]\nname = \"high\"\n"
      "parent = \"low\"\nend = [0, 2, 0]\nplace = ";
  const auto from_cache = [&](const std::string& place) {
    write_text(bar, before + place);
    const Ran ran = run_marrow({"cook", in_golden("elbow.gltf"), "-o", out(), "--cache", cache(), "--depfile", depfile,
                                "--auto-skeleton", bar});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(ran.err.find("skeleton-made: 2 joints of"), std::string::npos) << ran.err;
    EXPECT_NE(ran.out.find("2 joints, 1 meshes"), std::string::npos) << ran.out;
    EXPECT_NE(read_text(depfile).find("bar.toml"), std::string::npos);
    return ran.out.find("from the cache") != std::string::npos;
  };
  EXPECT_FALSE(from_cache("[0, 1, 0]"));
  EXPECT_TRUE(from_cache("[0, 1, 0]"));
  EXPECT_FALSE(from_cache("[0, 1.2, 0]"));
  write_text(bar, before + "[0, 1]");
  const Ran bad = run_marrow({"cook", in_golden("elbow.gltf"), "-o", out(), "--auto-skeleton", bar});
  EXPECT_EQ(bad.code, 1);
  EXPECT_NE(bad.err.find("bar.toml: 8:9: \"place\" must be three numbers"), std::string::npos) << bad.err;
  EXPECT_EQ(run_marrow({"cook", in_golden("elbow.gltf"), "-o", out(), "--auto-skeleton", "humanoit"}).code, 1);
}

TEST_F(CliCache, GoesByContentsNotByName) {
  EXPECT_FALSE(cook());
  fs::create_directory(folder_ / "b");
  write_triangle(folder_ / "b/a.gltf", folder_ / "b/a.bin", 1);
  const Ran ran = run_marrow(
      {"cook", folder_ / "b/a.gltf", "-o", folder_ / "b.mrw", "--cache", cache(), "--report", folder_ / "r.json"});
  EXPECT_NE(ran.out.find("from the cache"), std::string::npos);
  const nlohmann::json r = nlohmann::json::parse(read_text(folder_ / "r.json"));
  EXPECT_EQ(r.at("source").at("file"), folder_ / "b/a.gltf");
  EXPECT_EQ(r.at("output").at("file"), folder_ / "b.mrw");
  // The same report as without.
  ASSERT_EQ(run_marrow({"cook", folder_ / "b/a.gltf", "-o", folder_ / "b.mrw", "--report", folder_ / "s.json"}).code,
            0);
  EXPECT_EQ(read_text(folder_ / "r.json"), read_text(folder_ / "s.json"));
}

TEST_F(CliCache, UnchangedOutputsAreNotWritten) {
  cook();
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(100);
  fs::last_write_time(out(), long_ago);
  const auto before = fs::last_write_time(out());
  EXPECT_TRUE(cook());
  EXPECT_EQ(fs::last_write_time(out()), before);
  write_text(out(), "changed by hand");
  EXPECT_TRUE(cook());
  EXPECT_EQ(read_text(out()).substr(0, 4), "MRRP");
}

TEST_F(CliCache, DamagedEntriesAreReplaced) {
  cook();
  const std::string good = read_text(out());
  const std::vector<fs::path> files = entries();
  ASSERT_EQ(files.size(), 2u);
  int damages = 0;
  for (const fs::path& file : files) {
    const std::string whole = read_text(file);
    for (const std::size_t cut :
         {std::size_t{0}, std::size_t{1}, std::size_t{31}, whole.size() / 2, whole.size() - 1}) {
      write_text(file, whole.substr(0, cut));
      EXPECT_FALSE(cook()) << file << " cut to " << cut;
      EXPECT_EQ(what_counts(read_text(file)), what_counts(whole));
      EXPECT_EQ(read_text(out()), good);
      ++damages;
    }
    for (const std::size_t at : {std::size_t{0}, std::size_t{33}, whole.size() - 1}) {
      std::string bad = whole;
      bad[at] = static_cast<char>(bad[at] ^ 4);
      write_text(file, bad);
      EXPECT_FALSE(cook()) << file << " at " << at;
      EXPECT_EQ(what_counts(read_text(file)), what_counts(whole));
      EXPECT_EQ(read_text(out()), good);
      ++damages;
    }
  }
  EXPECT_EQ(damages, 16);
}

// An entry is what it is called: another one's bytes under its name, whole and unharmed, are nothing.
TEST_F(CliCache, EntriesUnderOthersNamesAreNone) {
  const auto entry = [&](const char* extension, const std::vector<fs::path>& but) {
    for (const fs::path& file : entries())
      if (file.extension() == extension && std::ranges::find(but, file) == but.end()) return file;
    ADD_FAILURE() << extension;
    return fs::path();
  };
  EXPECT_FALSE(cook());
  const std::vector<fs::path> first = entries();
  const std::string one = read_text(out());
  write_triangle(gltf(), bin(), 2);
  EXPECT_FALSE(cook());
  const std::string two = read_text(out());
  ASSERT_NE(one, two);
  for (const char* extension : {".cooked", ".inputs"}) {
    const fs::path mine = entry(extension, first), other = entry(extension, {mine});
    const std::string whole = read_text(mine);
    write_text(mine, read_text(other));
    EXPECT_FALSE(cook()) << extension;
    EXPECT_EQ(read_text(out()), two);
    EXPECT_EQ(what_counts(read_text(mine)), what_counts(whole)) << "written anew";
    EXPECT_TRUE(cook());
  }
}

TEST_F(CliCache, StaysBelowItsSize) {
  write_text(folder_ / "cache_note", "");
  fs::create_directories(cache() + "/ab");
  write_text(cache() + "/ab/own.txt", std::string(100000, 'x'));  // not the cache's
  for (const float size : {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f}) {
    write_triangle(gltf(), bin(), size);
    EXPECT_FALSE(cook({"--cache-size", "3KB"}));
    std::uintmax_t sum = 0;
    for (const fs::path& file : entries()) sum += fs::file_size(file);
    EXPECT_LE(sum, 100000u + 3000u);
  }
  EXPECT_TRUE(cook({"--cache-size", "3KB"})) << "the newest is kept";
  EXPECT_TRUE(fs::exists(cache() + "/ab/own.txt"));
  write_triangle(gltf(), bin(), 1);
  EXPECT_FALSE(cook()) << "the oldest is gone";
}

TEST_F(CliCache, ByTheEnvironmentAndWithout) {
  const std::vector<std::string> cook = {program(), "cook", gltf(), "-o", out()};
  std::vector<std::string> with = {"env", "MARROW_CACHE=" + cache()};
  with.insert(with.end(), cook.begin(), cook.end());
  EXPECT_EQ(run_program(with).code, 0);
  EXPECT_NE(run_program(with).out.find("from the cache"), std::string::npos);
  with[1] = "MARROW_CACHE=";
  const Ran without = run_program(with);
  EXPECT_EQ(without.code, 0) << without.err;
  EXPECT_EQ(without.out.find("from the cache"), std::string::npos);
}

TEST_F(CliCache, AnUnusableFolderIsAWarning) {
  write_text(cache(), "a file");
  const Ran ran = run_marrow({"cook", gltf(), "-o", out(), "--cache", cache()});
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.err.find(cache() + ": warning: the cache is not kept: "), std::string::npos) << ran.err;
  EXPECT_EQ(read_text(out()).substr(0, 4), "MRRP");
}

TEST_F(CliCache, BatchesSayHowMany) {
  fs::create_directory(folder_ / "in");
  for (const char* name : {"a", "b", "c"})
    write_triangle(folder_ / "in/" + name + ".gltf", folder_ / "in/" + name + ".bin", name[0] == 'c' ? 2 : 1);
  const std::vector<std::string> batch = {"cook", folder_ / "in", "-o", folder_ / "out/", "--cache", cache()};
  EXPECT_EQ(run_marrow(batch).code, 0);
  write_triangle(folder_ / "in/b.gltf", folder_ / "in/b.bin", 7);
  const Ran ran = run_marrow(batch);
  EXPECT_NE(ran.out.find("3 files: 1 cooked, 2 from the cache, 0 failed"), std::string::npos) << ran.out;
}

// Several processes at once, with a cache too small for them all.
TEST_F(CliCache, Shared) {
  fs::create_directory(folder_ / "in");
  for (int i = 0; i < 12; ++i) {
    const std::string name = folder_ / ("in/" + std::to_string(i));
    write_triangle(name + ".gltf", name + ".bin", 1.0f + static_cast<float>(i));
  }
  ASSERT_EQ(run_marrow({"cook", folder_ / "in", "-o", folder_ / "want/"}).code, 0);
  std::string script = "set -e; for k in 1 2 3 4; do (for n in 1 2 3; do '" + program() + "' cook '" +
                       (folder_ / "in") + "' -o '" + (folder_ / "got") + "'$k/ --cache '" + cache() +
                       "' --cache-size 12KB >/dev/null || touch '" + (folder_ / "failed") + "'; done) & done; wait";
  const Ran ran = run_program({"sh", "-c", script});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_FALSE(fs::exists(folder_ / "failed")) << ran.err;
  int compared = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "want"))
    for (const char* k : {"1", "2", "3", "4"}) {
      EXPECT_EQ(read_text(entry.path()), read_text((folder_ / "got") + k + "/" + entry.path().filename().string()));
      ++compared;
    }
  EXPECT_EQ(compared, 48);
}

}  // namespace
}  // namespace marrow::test
