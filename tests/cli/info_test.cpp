// `marrow info`: every byte is counted once, and several files are told one after the other.
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

nlohmann::json described(const std::string& path) {
  const Ran ran = run_marrow({"info", path, "--json"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  return nlohmann::json::parse(ran.out);
}

TEST(Info, CountsImagesByThemselves) {
  const nlohmann::json r = described(in_golden("looks_v1.mrw"));
  std::size_t images = 0, all = 0;
  for (const nlohmann::json& image : r.at("images")) images += 16 + image.at("embedded_bytes").get<std::size_t>();
  for (const auto& [name, bytes] : r.at("totals").items()) all += bytes.get<std::size_t>();
  EXPECT_GE(images, 70u + 16u) << "dot.png, and what stands before it";
  EXPECT_EQ(r.at("totals").at("images"), images);
  EXPECT_EQ(r.at("bytes"), all);
  const std::string text = run_marrow({"info", in_golden("looks_v1.mrw")}).out;
  EXPECT_NE(text.find("─ images"), std::string::npos) << text;
  EXPECT_EQ(run_marrow({"info", in_golden("tiny_v1.mrw")}).out.find("─ images"), std::string::npos);
}

TEST(Info, SaysWhatLevelsOfDetailTake) {
  const nlohmann::json r = described(in_golden("lod_v1.mrw"));
  const std::string text = run_marrow({"info", in_golden("lod_v1.mrw")}).out;
  std::size_t bytes = 0, levels = 0;
  for (const nlohmann::json& mesh : r.at("meshes")) {
    bytes += mesh.at("bytes").get<std::size_t>();
    for (const nlohmann::json& level : mesh.value("lods", nlohmann::json::array())) {
      bytes += level.at("bytes").get<std::size_t>();
      EXPECT_NE(text.find(std::to_string(level.at("bytes").get<int>()) + " B  " +
                          std::to_string(level.at("vertices").get<int>()) + " vertices, "),
                std::string::npos)
          << text;
      ++levels;
    }
  }
  EXPECT_GE(levels, 2u);
  EXPECT_EQ(bytes, r.at("totals").at("geometry"));
}

TEST(Info, SaysWhatJointsAreFor) {
  const std::string file = in_golden("roles_v1.mrw");
  const nlohmann::json roles = described(file).at("skeletons").at(0).at("roles");
  EXPECT_EQ(roles.at("roles").size(), 13u);
  EXPECT_EQ(roles.at("roles").at(0), (nlohmann::json{{"role", "hips"}, {"joint", "hips"}}));
  EXPECT_EQ(roles.at("missing").size(), 57u - 12u);  // the tail has two joints
  EXPECT_EQ(roles.at("pairs").size(), 5u);
  EXPECT_EQ(roles.at("soles").at(0).at("joint"), "foot.L");
  const std::string plain = run_marrow({"info", file}).out, all = run_marrow({"info", file, "--roles"}).out;
  EXPECT_NE(plain.find("13 joints with roles, 5 pairs, 2 soles"), std::string::npos) << plain;
  for (const char* const line :
       {"  left_foot        foot.L\n", "  tail             tail.001\n", "missing: root, chest, ",
        "  pair bag one | bag two\n", "  sole of foot.L at 0 0.0625 -0.125, in its space\n"})
    EXPECT_NE(all.find(line), std::string::npos) << line << " is not in\n" << all;
  const std::string none = run_marrow({"info", in_golden("tiny_v1.mrw"), "--roles"}).out;
  EXPECT_NE(none.find("no joints with roles"), std::string::npos) << none;
}

// One, a quarter of the way: golden_test.cpp has the file's figures.
TEST(Info, SaysWhichJointsHelpersAreOf) {
  const nlohmann::json mesh = described(in_golden("centres_v1.mrw")).at("meshes").at(0);
  EXPECT_EQ(mesh.at("helpers"), nlohmann::json::array({{{"first", "upper"}, {"second", "lower"}, {"share", 0.25}}}));
  EXPECT_EQ(mesh.at("joints"), 2);
  EXPECT_EQ(mesh.at("palette_entries"), 3);
  const std::string text = run_marrow({"info", in_golden("centres_v1.mrw")}).out;
  EXPECT_NE(text.find("2 joints, 1 helper, "), std::string::npos) << text;
  const std::size_t at = text.find("helpers of \"upper\"");
  ASSERT_NE(at, std::string::npos) << text;
  EXPECT_EQ(text.substr(0, text.find('\n', at)).find("1 towards \"lower\"", at), text.find("1 towards", at)) << text;
  EXPECT_TRUE(described(in_golden("tiny_v1.mrw")).at("meshes").at(0).at("helpers").empty());
  EXPECT_EQ(run_marrow({"info", in_golden("tiny_v1.mrw")}).out.find("helper"), std::string::npos);
}

TEST(Info, TakesSeveralFiles) {
  const std::string a = in_golden("tiny_v1.mrw"), b = in_golden("pack_v1.mrw");
  EXPECT_EQ(nlohmann::json::parse(run_marrow({"info", a, b, "--json"}).out),
            nlohmann::json::array({described(a), described(b)}));
  EXPECT_EQ(run_marrow({"info", a, b}).out, run_marrow({"info", a}).out + "\n" + run_marrow({"info", b}).out);
  const Ran both = run_marrow({"info", a, b, "--source", tiny_gltf()});
  EXPECT_EQ(both.code, kUsage);
  EXPECT_NE(both.err.find("--source"), std::string::npos) << both.err;
}

}  // namespace
}  // namespace marrow::test
