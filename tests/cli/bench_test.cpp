// `marrow bench`: the rows it promises, and hashes that depend on nothing but what a row computes.
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"

namespace marrow::test {
namespace {

// Points MARROW_ASSETS at a folder for as long as it lives; empty ones stand for machines without the models.
class AssetsAt {
 public:
  explicit AssetsAt(const std::string& folder) {
    const char* const was = std::getenv("MARROW_ASSETS");
    if (was != nullptr) before_ = was;
    had_ = was != nullptr;
    setenv("MARROW_ASSETS", folder.c_str(), 1);
  }
  ~AssetsAt() { had_ ? setenv("MARROW_ASSETS", before_.c_str(), 1) : unsetenv("MARROW_ASSETS"); }
  AssetsAt(const AssetsAt&) = delete;
  AssetsAt& operator=(const AssetsAt&) = delete;

 private:
  std::string before_;
  bool had_ = false;
};

struct BenchRow {
  int items;
  std::string hash;
  bool operator==(const BenchRow& other) const { return items == other.items && hash == other.hash; }
};
using Rows = std::map<std::string, BenchRow>;

// What the selected rows say; checks what all rows have in common.
Rows bench(const std::string& only, const std::string& iterations) {
  const Ran ran = run_marrow({"bench", "--only", only, "--iterations", iterations, "--json"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  Rows rows;
  const nlohmann::json json = nlohmann::json::parse(ran.out, nullptr, false);
  EXPECT_TRUE(json.is_array()) << ran.out;
  for (const auto& row : json) {
    const std::string name = row.at("name"), hash = row.at("hash");
    EXPECT_EQ(row.size(), 4u) << name;
    EXPECT_GT(row.at("ns_per_item"), 0) << name;
    EXPECT_EQ(hash.size(), 16u) << name;
    EXPECT_TRUE(rows.emplace(name, BenchRow{row.at("items"), hash}).second) << name << " twice";
  }
  return rows;
}

int joints_of_the_sample() {
  const TemporaryFolder folder;
  EXPECT_EQ(run_marrow({"sample", "-o", folder / "newt.glb"}).code, 0);
  const Ran cooked =
      run_marrow({"cook", folder / "newt.glb", "-o", folder / "newt.mrw", "--clip-codec", "raw", "--json"});
  EXPECT_EQ(cooked.code, 0) << cooked.err;
  return nlohmann::json::parse(cooked.out).at("skeletons").at(0).at("joints");
}

// All parts write again what the whole file has unpacked to.
TEST(Bench, UnpacksTheSampleInWholeAndInParts) {
  const Rows rows = bench("unpack/*/newt", "2");
  ASSERT_EQ(rows.size(), 10u);
  for (const char* codec : {"draco", "meshopt"}) {
    const BenchRow& file = rows.at(std::string("unpack/") + codec + "/file/newt");
    EXPECT_GT(file.items, 1000);
    for (const char* part : {"decode", "arrange", "write"})
      EXPECT_EQ(rows.at(std::string("unpack/") + codec + '/' + part + "/newt"), file) << codec << ' ' << part;
  }
  const BenchRow& whole = rows.at("unpack/meshopt/file/newt");
  EXPECT_EQ(rows.at("unpack/clips/newt").hash, whole.hash);
  EXPECT_EQ(rows.at("unpack/structure/newt").hash, whole.hash);
  EXPECT_EQ(rows.at("unpack/structure/newt").items, joints_of_the_sample());
  EXPECT_GT(rows.at("unpack/clips/newt").items, 1000);
}

TEST(Bench, SamplesEveryClipOfTheSampleInEveryOrder) {
  const int joints = joints_of_the_sample();
  const Rows rows = bench("sample/*/newt_*", "2");
  std::set<std::string> hashes;
  for (const char* order : {"forward", "random", "backward", "crowd", "playing"}) {
    for (const char* clip : {"idle", "walk", "twist", "reach"}) {
      const auto row = rows.find(std::string("sample/") + order + "/newt_" + clip);
      ASSERT_NE(row, rows.end()) << order << ' ' << clip;
      EXPECT_EQ(row->second.items, joints);
      hashes.insert(row->second.hash);
    }
  }
  EXPECT_EQ(rows.size(), 20u);
  EXPECT_EQ(hashes.size(), 16u) << "each of them reads other poses";
  for (const std::string clip : {"idle", "walk", "twist", "reach"})
    EXPECT_EQ(rows.at("sample/playing/newt_" + clip).hash, rows.at("sample/forward/newt_" + clip).hash);
}

TEST(Bench, SkinsInEveryForm) {
  const Rows rows = bench("skin/*/1000", "1");
  for (const char* deformer : {"rigid", "ssd", "as"}) {
    for (const char* attributes : {"p", "pn", "pnt"}) {
      for (const char* influences : {"1", "2", "3", "4", "8"}) {
        const std::string name = std::string("skin/") + deformer + '/' + attributes + '/' + influences + "/1000";
        ASSERT_TRUE(rows.contains(name)) << name;
        EXPECT_EQ(rows.at(name).items, 1000);
      }
    }
  }
  for (const char* attributes : {"ps", "pst"})
    for (const char* influences : {"1", "2", "3", "4", "8"})
      EXPECT_TRUE(rows.contains(std::string("skin/as/") + attributes + '/' + influences + "/1000")) << attributes;
  EXPECT_EQ(rows.size(), 55u);
  std::set<std::string> hashes;
  for (const auto& [name, row] : rows)
    if (name.rfind("skin/rigid/", 0) != 0) hashes.insert(row.hash);
  EXPECT_EQ(hashes.size(), 40u) << "SSD and animation space differ by the residual";
  // With one influence there is nothing to blend.
  for (const char* attributes : {"p", "pn", "pnt"}) {
    const std::string form = std::string("/") + attributes + "/1/1000";
    EXPECT_EQ(rows.at("skin/rigid" + form).hash, rows.at("skin/ssd" + form).hash) << form;
  }
}

TEST(Bench, LargerMeshesHaveAsManyVerticesAsTheirNamesSay) {
  const Rows rows = bench("skin/ssd/p/4/*", "1");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows.at("skin/ssd/p/4/10000").items, 10000);
  EXPECT_EQ(rows.at("skin/ssd/p/4/100000").items, 100000);
}

TEST(Bench, MorphsInEveryForm) {
  const Rows rows = bench("skin/morph/*", "1");
  EXPECT_EQ(rows.size(), 12u);
  // An eighth of the blocks each; 67 runs of 149 or 150 vertices have 38 blocks.
  EXPECT_EQ(rows.at("skin/morph/pn/4/10000").items, 67 * 38 / 8 * 4 * 4);
  std::set<std::string> hashes;
  for (const auto& [name, row] : rows) hashes.insert(row.hash);
  EXPECT_EQ(hashes.size(), 12u);
}

TEST(Bench, WeighsExamples) {
  const Rows rows = bench("skin/examples/*", "1");
  EXPECT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows.at("skin/examples/64/6").items, 64);
  std::set<std::string> hashes;
  for (const auto& [name, row] : rows) hashes.insert(row.hash);
  EXPECT_EQ(hashes.size(), 6u);
}

TEST(Bench, HashesDoNotDependOnIterationsOrOnOtherRows) {
  const TemporaryFolder none;
  const AssetsAt empty(none / "");
  for (const char* only :
       {"sample/*/newt_walk", "[bfp]*", "skin/as/pnt/3/1000", "skin/morph/*/16/*", "skin/examples/16/*"}) {
    const Rows once = bench(only, "1");
    EXPECT_FALSE(once.empty()) << only;
    EXPECT_EQ(once, bench(only, "1")) << only;
    EXPECT_EQ(once, bench(only, "700")) << only;
  }
  EXPECT_EQ(bench("sample/random/newt_walk", "1").at("sample/random/newt_walk"),
            bench("sample/random/newt_[iw]*", "3").at("sample/random/newt_walk"));
}

TEST(Bench, WithoutModelsTheSampleStandsInAndItIsSaid) {
  const TemporaryFolder none;
  const AssetsAt empty(none / "");
  const Rows rows = bench("[!isu]*", "1");
  const int joints = joints_of_the_sample();
  for (const char* name : {"blend/2", "blend/4", "blend/2_masked", "blend/4_masked", "blend/2_additive1",
                           "local_to_model", "palette", "bounds", "frame", "character"}) {
    ASSERT_TRUE(rows.contains(name)) << name;
    EXPECT_EQ(rows.at(name).items, joints) << name;
  }
  for (const char* name : {"palette_helpers", "palette_centres"}) EXPECT_TRUE(rows.contains(name)) << name;
  EXPECT_EQ(rows.size(), 21u);
  EXPECT_NE(run_marrow({"bench", "--only", "palette", "--iterations", "1"}).err.find("no pab.glb in"),
            std::string::npos);

  const Ran left_out = run_marrow({"bench", "--only", "sample/*/*_walk*", "--iterations", "1", "--json"});
  EXPECT_EQ(left_out.code, 0);
  EXPECT_EQ(nlohmann::json::parse(left_out.out).size(), 5u);
  EXPECT_NE(left_out.err.find("no pab.glb in"), std::string::npos) << left_out.err;
  EXPECT_EQ(run_marrow({"bench", "--only", "skin/ssd/p/1/1000", "--iterations", "1"}).err, "") << "needs no model";

  for (const char* model : {"CesiumMan", "ruby"}) {
    const Ran nothing_left = run_marrow({"bench", "--only", std::string("sample/*/") + model});
    EXPECT_EQ(nothing_left.code, 2);
    EXPECT_EQ(nothing_left.out, "");
    EXPECT_NE(nothing_left.err.find(std::string("no ") + model + ".glb in"), std::string::npos) << nothing_left.err;
  }
}

TEST(Bench, TheTableSaysTheSame) {
  const Rows rows = bench("skin/ssd/p*/4/1000", "1");
  const Ran table = run_marrow({"bench", "--only", "skin/ssd/p*/4/1000"});
  EXPECT_EQ(table.code, 0);
  std::istringstream lines(table.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.rfind("name ", 0), 0u) << line;
  std::size_t count = 0;
  for (; std::getline(lines, line); ++count) {
    std::istringstream words(line);
    std::string name, hash;
    int items = 0;
    double ns = 0;
    ASSERT_TRUE(words >> name >> items >> ns >> hash) << line;
    EXPECT_EQ(rows.at(name), (BenchRow{items, hash})) << line;
    EXPECT_GT(ns, 0) << line;
  }
  EXPECT_EQ(count, 3u);
}

TEST(Bench, UnknownRowsAndSillyCountsAreUsageErrors) {
  const Ran unknown = run_marrow({"bench", "--only", "skin/dual_quaternions/*"});
  EXPECT_EQ(unknown.code, 1);
  EXPECT_EQ(unknown.out, "");
  for (const char* name : {"skin/dual_quaternions/*", "skin/{rigid,ssd,as}/{p,pn,pnt}", "local_to_model", "newt_walk"})
    EXPECT_NE(unknown.err.find(name), std::string::npos) << name;
  for (const char* count : {"0", "-1", "1.5", "many"})
    EXPECT_EQ(run_marrow({"bench", "--only", "palette", "--iterations", count}).code, 1) << count;
}

#ifdef MARROW_HAS_GLES
TEST(Bench, DrawsFramesOnEveryPath) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "SKIPPED: drivers leak, which the address sanitizer would report";
#endif
  const TemporaryFolder folder;
  const Ran ran = run_marrow({"bench", "--gpu", "--only", "gpu/*/p*/1000x3", "--json", "-o", folder / "chart.svg"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json json = nlohmann::json::parse(ran.out);
  EXPECT_FALSE(json.at("driver").get<std::string>().empty());
  std::set<std::string> names;
  for (const auto& row : json.at("rows")) {
    names.insert(row.at("name"));
    EXPECT_GT(row.at("frames_per_s"), 0) << row;
    EXPECT_GT(row.at("ns_per_vertex"), 0) << row;
    EXPECT_TRUE(row.at("gpu_ns_per_vertex").is_null() || row.at("gpu_ns_per_vertex") > 0) << row;
  }
  for (const char* path : {"ubo", "texture", "feedback", "cpu"})
    for (const char* shape : {"ssd/p", "ssd/pn", "as/p", "as/pn"})
      EXPECT_TRUE(names.contains(std::string("gpu/") + path + "/" + shape + "/1000x3")) << path << shape;
  const std::string chart = read_text(folder / "chart.svg");
  EXPECT_EQ(chart.find("<svg "), 0u);
  EXPECT_NE(chart.find("1000 vertices, 3 joints"), std::string::npos);

  const Ran unknown = run_marrow({"bench", "--gpu", "--only", "gpu/magic/*"});
  EXPECT_EQ(unknown.code, 1);
  EXPECT_NE(unknown.err.find("gpu/{ubo,texture,feedback,compute,cpu}"), std::string::npos) << unknown.err;
  EXPECT_EQ(run_marrow({"bench", "-o", folder / "no.svg"}).code, 1);
  EXPECT_EQ(run_marrow({"bench", "--gpu", "--iterations", "5"}).code, 1);
}
#endif

}  // namespace
}  // namespace marrow::test
