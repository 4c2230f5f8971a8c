// Work that machines share: plans, shares, and reports that are put together. tests/machines has engines and servers.
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Shards : public ::testing::Test {
 protected:
  Shards() {
    fs::create_directories(folder_ / "in");
    for (int i = 0; i < 7; ++i) {
      const std::string name = folder_ / ("in/" + std::to_string(i));
      write_triangle(name + ".gltf", name + ".bin", 1.0f + static_cast<float>(i));
    }
  }
  Ran cook(const std::string& out, std::vector<std::string> more) const {
    more.insert(more.begin(), {"cook", folder_ / "in", "-o", folder_ / out});
    return run_marrow(more);
  }
  TemporaryFolder folder_;
};

TEST_F(Shards, TogetherCookAll) {
  ASSERT_EQ(cook("want/", {}).code, 0);
  std::vector<std::string> merge = {"report", "--merge"};
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const std::string report = folder_ / (std::string("r") + shard[0] + ".json");
    const Ran ran = cook("out/", {"--shard", shard, "--report", report});
    EXPECT_EQ(ran.code, 0) << ran.err;
    merge.push_back(report);
  }
  int same = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "want"))
    same += read_text(entry.path().string()) == read_text(folder_ / ("out/" + entry.path().filename().string()));
  EXPECT_EQ(same, 7);
  std::vector<std::string> page = merge, list = merge, some = {merge.begin(), merge.end() - 1};
  page.insert(page.end(), {"-o", folder_ / "all.html"});
  list.insert(list.end(), {"-o", folder_ / "all.json"});
  some.insert(some.end(), {"-o", folder_ / "some.json"});
  EXPECT_EQ(run_marrow(page).code, 0);
  EXPECT_NE(read_text(folder_ / "all.html").find("<td>files</td><td class=\"n\">7</td>"), std::string::npos);
  EXPECT_EQ(run_marrow(list).code, 0);
  EXPECT_EQ(json::parse(read_text(folder_ / "all.json")).size(), 7u);
  const Ran missing = run_marrow(some);
  EXPECT_EQ(missing.code, 3);
  EXPECT_NE(missing.err.find("of 7 files are in no report: a share is missing"), std::string::npos) << missing.err;
}

TEST_F(Shards, MoreSharesThanFiles) {
  std::set<std::string> counts;
  for (int i = 1; i <= 9; ++i) {
    const Ran ran = cook("out/", {"--shard", std::to_string(i) + "/9"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    counts.insert(ran.out.substr(ran.out.rfind("\n", ran.out.size() - 2) + 1));
  }
  EXPECT_EQ(counts.size(), 2u) << "one file, or none";
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), fs::directory_iterator()), 7);
}

TEST_F(Shards, APlanListsAndCooksNothing) {
  write_text(folder_ / "in/bad.gltf", "{");
  const Ran ran = cook("out/", {"--plan", folder_ / "plan.json"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  const json plan = json::parse(read_text(folder_ / "plan.json"));
  ASSERT_EQ(plan.at("units").size(), 8u);
  EXPECT_EQ(plan.at("program").get<std::string>().size(), 32u);
  double before = 1e9, sum = 0;
  int failures = 0;
  for (const json& unit : plan.at("units")) {
    EXPECT_LE(unit.at("seconds").get<double>(), before) << "the longest first";
    before = unit.at("seconds").get<double>();
    sum += before;
    if (unit.contains("failure")) {
      ++failures;
      continue;
    }
    EXPECT_EQ(unit.at("inputs").size(), 2u) << "the document and its buffer";
    EXPECT_GT(unit.at("memory_bytes").get<std::uint64_t>(), 100'000'000u);
  }
  EXPECT_EQ(failures, 1);
  EXPECT_DOUBLE_EQ(sum, plan.at("seconds").get<double>());
}

TEST_F(Shards, WhatMakesNoSenseIsRefused) {
  EXPECT_EQ(cook("out/", {"--shard", "0/3"}).code, 1);
  EXPECT_EQ(cook("out/", {"--shard", "4/3"}).code, 1);
  EXPECT_EQ(cook("out/", {"--shard", "3"}).code, 1);
  EXPECT_EQ(cook("out/", {"--fits"}).code, 1) << "without a cache there is nowhere to keep them";
  EXPECT_EQ(cook("out/", {"--fits", "--cache", ""}).code, 1);
  EXPECT_EQ(cook("out/", {"--fits", "--cache", folder_ / "c", "--report", folder_ / "r.json"}).code, 1);
  EXPECT_EQ(cook("out/", {"--plan", folder_ / "p.json", "--shard", "1/2"}).code, 1);
  EXPECT_EQ(run_marrow({"cook", folder_ / "in/1.gltf", "-o", folder_ / "one.txt", "--shard", "1/1"}).code, 1);
  EXPECT_EQ(run_marrow({"cook", "--graph", "none.toml", "-o", folder_ / "g.mrw", "--shard", "1/2"}).code, 1);
  const Ran other = cook("out/", {"--program", "0123"});
  EXPECT_EQ(other.code, 1);
  EXPECT_NE(other.err.find("--program: another program: this one is "), std::string::npos) << other.err;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

// Reports come from other machines.
TEST_F(Shards, WrongReportsAreTold) {
  const std::string bad = folder_ / "bad.json";
  for (const char* text : {"", "[", "3", "[3]", "{}", "[{}]", "[{\"source\": 1}]", R"([{"source": {"file": "a"}}])",
                           R"([{"source": {"file": "a"}, "output": {"bytes": 1}, "run": {}}])",
                           R"([{"source": {"file": "a"}, "output": {"bytes": 1}}])"}) {
    write_text(bad, text);
    const Ran ran = run_marrow({"report", "--merge", bad, "-o", folder_ / "out.html"});
    EXPECT_EQ(ran.code, 3) << text;
    EXPECT_TRUE(ran.err.starts_with(bad + ": ")) << ran.err;
  }
  write_text(bad, R"([{"source": {"file": "<script>\"&"}, "error": {"code": 3, "text": "<b>"}}])");
  EXPECT_EQ(run_marrow({"report", "--merge", bad, "-o", folder_ / "out.html"}).code, 3) << "the failure's own";
  const std::string page = read_text(folder_ / "out.html");
  EXPECT_EQ(page.find("<script>"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;&quot;&amp;"), std::string::npos) << page;
  EXPECT_EQ(run_marrow({"report", "--merge", bad, "-o", folder_ / "out.txt"}).code, 1);
  EXPECT_EQ(run_marrow({"report", "--merge", folder_ / "none.json", "-o", folder_ / "out.html"}).code, 2);
}

TEST_F(Shards, AServerThatIsNotThereIsAWarning) {
  const Ran ran = cook("out/", {"--cache", "http://127.0.0.1:1/marrow"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.err.find("http://127.0.0.1:1/marrow: warning: "), 0u) << ran.err;
  EXPECT_NE(ran.err.find("; it is not asked any more"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace marrow::test
