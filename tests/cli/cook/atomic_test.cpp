// Whatever stops a cook, its output is the old file or the new one.
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
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
using Clock = std::chrono::steady_clock;

std::string golden(const std::string& name) {
  return in_golden(name);
}

TEST(Atomic, KilledAtAnyMoment) {
  const TemporaryFolder folder;
  const std::string out = folder / "x.mrw", report = folder / "r.json";
  const std::string sources[2] = {golden("tiny.gltf"), golden("dance.gltf")};
  std::string bytes[2];
  std::chrono::microseconds took[2];
  for (const int i : {0, 1}) {
    const auto start = Clock::now();
    ASSERT_EQ(run_marrow({"cook", sources[i], "-o", out, "--report", report}).code, 0);
    took[i] = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start);
    bytes[i] = read_text(out);
  }
  ASSERT_NE(bytes[0], bytes[1]);
  constexpr int kKills = 200;
  int killed = 0, old_kept = 0, leftovers = 0;
  std::string last = bytes[1];
  for (int i = 0; i < kKills; ++i) {
    const int source = last == bytes[0] ? 1 : 0;  // so that every cook would change the output
    const auto after = took[source] * (2 * i + 1) / (2 * kKills);
    const Ran ran = run_program({program(), "cook", sources[source], "-o", out, "--report", report}, after);
    killed += ran.code == 1009;
    const std::string now = read_text(out);
    ASSERT_TRUE(now == bytes[source] || now == last) << "killed after " << after.count() << " us";
    old_kept += now == last;
    ASSERT_TRUE(nlohmann::json::accept(read_text(report)));
    for (const std::string& name : folder.listing()) {
      const bool temporary = name == ".x.mrw.tmp" || name == ".r.json.tmp";
      ASSERT_TRUE(temporary || name == "x.mrw" || name == "r.json") << name;
      leftovers += temporary;
    }
    last = now;
  }
  EXPECT_GT(killed, kKills / 4);
  EXPECT_GT(old_kept, kKills / 4);
  RecordProperty("leftovers", leftovers);
  ASSERT_EQ(run_marrow({"cook", sources[0], "-o", out, "--report", report}).code, 0);
  EXPECT_EQ(folder.listing(), (std::vector<std::string>{"r.json", "x.mrw"})) << "the next cook cleans up";
}

TEST(Atomic, AStaleTemporaryFileIsUsedUp) {
  const TemporaryFolder folder;
  write_text(folder / ".x.mrw.tmp", std::string(100000, 'x'));
  ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "-o", folder / "x.mrw"}).code, 0);
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"x.mrw"});
  EXPECT_LT(read_text(folder / "x.mrw").size(), 50000u);
  // A folder of cooked files and leftovers holds nothing to cook.
  write_text(folder / ".x.glb.tmp", "x");
  EXPECT_EQ(run_marrow({"cook", folder.path(), "-o", folder / "out/"}).code, 3);
}

TEST(Atomic, WritersOfOneFileWait) {
  const TemporaryFolder folder;
  const std::string cook =
      "'" + program() + "' cook '" + tiny_gltf() + "' -o '" + (folder / "x.mrw") + "' >/dev/null 2>&1 || echo failed";
  const Ran ran = run_program({"sh", "-c", "for i in 1 2 3 4 5 6 7 8; do (" + cook + ") & done; wait"});
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"x.mrw"});
  ASSERT_EQ(run_marrow({"cook", tiny_gltf(), "-o", folder / "y.mrw"}).code, 0);
  EXPECT_EQ(read_text(folder / "x.mrw"), read_text(folder / "y.mrw"));
}

TEST(Atomic, AFullDiskKeepsTheOldFiles) {
  const TemporaryFolder folder;
  const std::string cook = "'" + program() + "' cook '" + golden("dance.gltf") + "' -o ";
  // A limit on the size of files: 512 bytes.
  for (const std::string name : {"x.mrw", "r.json"}) write_text(folder / name, "precious");
  const Ran limited = run_program(
      {"sh", "-c",
       "trap '' XFSZ; ulimit -f 1; " + cook + "'" + (folder / "x.mrw") + "' --report '" + (folder / "r.json") + "'"});
  EXPECT_EQ(limited.code, 2) << limited.err;
  EXPECT_EQ(limited.complaints().size(), 1u) << limited.err;
  EXPECT_EQ(folder.listing(), (std::vector<std::string>{"r.json", "x.mrw"}));
  EXPECT_EQ(read_text(folder / "x.mrw"), "precious");
  EXPECT_EQ(read_text(folder / "r.json"), "precious");
}

TEST(Atomic, AFullFileSystemKeepsTheOldFile) {
  const TemporaryFolder folder;
  const std::string x = folder / "x.mrw";
  const Ran ran =
      run_program({"unshare", "--mount", "sh", "-c",
                   "mount -t tmpfs -o size=4k tmpfs '" + folder.path() + "' || exit 77; printf precious > '" + x +
                       "'; '" + program() + "' cook '" + golden("dance.gltf") + "' -o '" + x + "'; code=$?; cat '" + x +
                       "'; ls -A '" + folder.path() + "'; exit $code"});
  if (ran.code == 77 || ran.err.find("unshare: ") != std::string::npos) GTEST_SKIP() << "no mounts here: " << ran.err;
  EXPECT_EQ(ran.code, 2) << ran.err;
  EXPECT_EQ(ran.out, "preciousx.mrw\n");
  EXPECT_NE(ran.err.find("No space left"), std::string::npos) << ran.err;
}

TEST(Atomic, AReadOnlyFolder) {
  const TemporaryFolder folder;
  write_text(folder / "x.mrw", "precious");
  ::chmod(folder.path().c_str(), 0555);
  ::chmod((folder / "x.mrw").c_str(), 0444);
  std::vector<std::string> cook = {program(), "cook", tiny_gltf(), "-o", folder / "x.mrw"};
  if (::geteuid() == 0) cook.insert(cook.begin(), {"setpriv", "--reuid=65534", "--clear-groups"});
  const Ran one = run_program(cook);
  if (one.code == 127 || one.code == 126) GTEST_SKIP() << "another user cannot run the program: " << one.err;
  EXPECT_EQ(one.code, 2) << one.err;
  EXPECT_EQ(one.complaints().size(), 1u) << one.err;
  cook.back() = folder / "out/";
  const Ran many = run_program(cook);
  EXPECT_EQ(many.code, 2) << many.err;
  EXPECT_EQ(many.complaints().size(), 1u) << many.err;
  ::chmod(folder.path().c_str(), 0755);
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"x.mrw"});
  EXPECT_EQ(read_text(folder / "x.mrw"), "precious");
}

// Threads change nothing: several files, one with several clips.
TEST(Atomic, SameBytesWithAnyNumberOfThreads) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "in");
  for (const char* name : {"tiny.gltf", "dance.gltf", "face.gltf"}) fs::copy_file(golden(name), folder / "in/" + name);
  int compared = 0;
  for (const std::string jobs : {"1", "2", "8"}) {
    const Ran ran = run_marrow({"cook", folder / "in", "-o", folder / (jobs + "/"), "--jobs", jobs});
    ASSERT_EQ(ran.code, 0) << ran.err;
    for (const char* name : {"tiny.mrw", "dance.mrw", "face.mrw"}) {
      EXPECT_EQ(read_text(folder / ("1/" + std::string(name))), read_text(folder / (jobs + "/" + name)))
          << jobs << name;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 9);
}

}  // namespace
}  // namespace marrow::test
