// Nodes that --keep asks for: which, where they hang, and what they carry.
#include <cstring>

#include "common/aligned_bytes.h"
#include "common/unpack_mrw.h"
#include "disk/cook_on_disk.h"
#include "unit/cook/gltf/document.h"

namespace marrow::cook {
namespace {

struct Cooked {
  Result result;
  tools::AlignedBytes block;
  File file;

  explicit Cooked(Builder b, const std::vector<std::string>& keep)
      : result(cook_scene(read(b), with(keep))), block(tools::unpacked(result.file, "test")) {
    EXPECT_EQ(load({block.data(), block.size()}, file), Status::ok);
  }
  static CookOptions with(const std::vector<std::string>& keep) {
    CookOptions options;
    options.prepare.keep = keep;
    return options;
  }
  std::size_t warnings(const std::string& rule) const {
    std::size_t count = 0;
    for (const auto& w : result.report["warnings"]) count += w["rule"] == rule;
    return count;
  }
};

// skinned(), and below its tip, at (0, 1, 0) from the root, a hand that no clip moves with a socket in it; beside it
// something that stands in the scene, something without a name and something outside the scene.
Builder with_sockets() {
  Builder b = skinned();
  b.root["nodes"][2]["children"] = {3};
  b.root["nodes"].push_back({{"name", "hand"}, {"translation", {0, 2, 0}}, {"scale", {2, 2, 2}}, {"children", {4}}});
  b.root["nodes"].push_back({{"name", "socket.sword"}, {"translation", {.5, 0, 0}}});
  b.root["nodes"].push_back({{"name", "socket.spawn"}, {"translation", {7, 8, 9}}});
  b.root["nodes"].push_back({{"translation", {1, 1, 1}}});
  b.root["nodes"].push_back({{"name", "socket.lost"}});
  b.root["scenes"][0]["nodes"] = {0, 1, 5, 6};
  return b;
}

void expect_affine(const Node& node, const float (&rows)[3][4]) {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) EXPECT_EQ(node.joint_from_node->rows[r][c], rows[r][c]) << node.name << r << c;
}

TEST(Keep, NothingUnlessAsked) {
  const Cooked cooked(with_sockets(), {});
  EXPECT_EQ(cooked.file.node_count(), 0U);
  EXPECT_EQ(cooked.file.find_node("hand"), 0U);
}

TEST(Keep, NodesHangOnTheNearestJoint) {
  const Cooked cooked(with_sockets(), {"socket*", "tip"});
  ASSERT_EQ(cooked.file.node_count(), 3U);
  const std::uint32_t tip_joint = 1;  // root, tip
  const Node tip = cooked.file.node(0), sword = cooked.file.node(1), spawn = cooked.file.node(2);
  EXPECT_STREQ(tip.name, "tip");
  EXPECT_EQ(tip.joint, tip_joint);
  expect_affine(tip, {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}});
  EXPECT_STREQ(sword.name, "socket.sword");
  EXPECT_EQ(sword.joint, tip_joint);
  expect_affine(sword, {{2, 0, 0, 1}, {0, 2, 0, 2}, {0, 0, 2, 0}});  // hand's (0, 2, 0) and twice 0.5
  EXPECT_STREQ(spawn.name, "socket.spawn");
  EXPECT_EQ(spawn.joint, kNoJoint);
  expect_affine(spawn, {{1, 0, 0, 7}, {0, 1, 0, 8}, {0, 0, 1, 9}});
}

TEST(Keep, TheReportSaysWhatEachGlobKept) {
  const Cooked cooked(with_sockets(), {"socket*", "*", "nothing?"});
  const auto& keep = cooked.result.report["keep"];
  ASSERT_EQ(keep.size(), 3U);
  EXPECT_EQ(keep[0]["glob"], "socket*");
  EXPECT_EQ(keep[0]["nodes"], (nlohmann::ordered_json{"socket.sword", "socket.spawn"}));
  EXPECT_EQ(keep[1]["nodes"], (nlohmann::ordered_json{"root", "tip", "hand", "socket.sword", "socket.spawn"}))
      << "those with a name";
  EXPECT_TRUE(keep[2]["nodes"].empty());
  EXPECT_EQ(cooked.warnings("keep-fits-nothing"), 1U);
  EXPECT_EQ(cooked.file.node_count(), 5U) << "each once";
  EXPECT_EQ(cooked.result.report["nodes"][4]["joint"], nullptr);
}

TEST(Keep, ExtrasBecomeProperties) {
  Builder b = with_sockets();
  b.root["nodes"][4]["extras"] = {
      {"damage", 12.5}, {"two-handed", true}, {"title", "Gr\xC3\xBC\xC3\x9F\nGott"}, {"slots", {1, {{"gem", "ruby"}}}},
      {"a/b~c", -1},    {"nothing", nullptr}, {"cut", std::string("a\0b", 3)},       {"empty", Json::object()}};
  b.root["nodes"][3]["extras"] = {{"hidden", 1}};
  const Cooked cooked(b, {"socket*"});
  const Node sword = cooked.file.node(0);
  const auto get = [&](const char* name) { return cooked.file.node_property(sword, name); };
  ASSERT_EQ(sword.properties.size, 6U);
  EXPECT_EQ(get("damage")->number, 12.5);
  EXPECT_EQ(get("damage")->type, PropertyType::number);
  EXPECT_EQ(get("two-handed")->type, PropertyType::boolean);
  EXPECT_EQ(get("two-handed")->number, 1.0);
  EXPECT_EQ(get("title")->type, PropertyType::text);
  EXPECT_STREQ(cooked.file.text(get("title")->text), "Gr\xC3\xBC\xC3\x9F\nGott");
  EXPECT_EQ(get("slots/0")->number, 1.0);
  EXPECT_STREQ(cooked.file.text(get("slots/1/gem")->text), "ruby");
  EXPECT_EQ(get("a~1b~0c")->number, -1.0);
  EXPECT_EQ(get("nothing"), nullptr);
  EXPECT_EQ(cooked.warnings("extras-dropped"), 1U) << "null, and the text that would end early";
  const std::string bytes(reinterpret_cast<const char*>(cooked.result.file.data()), cooked.result.file.size());
  EXPECT_EQ(bytes.find("hidden"), std::string::npos) << "extras of kept nodes only";
}

TEST(Keep, ExtrasThatAreNoObject) {
  Builder b = with_sockets();
  b.root["nodes"][4]["extras"] = 42;
  b.root["nodes"][5]["extras"] = {false, "x"};
  const Cooked cooked(b, {"socket*"});
  EXPECT_EQ(cooked.file.node_property(cooked.file.node(0), "")->number, 42.0);
  EXPECT_EQ(cooked.file.node_property(cooked.file.node(1), "0")->number, 0.0);
  EXPECT_STREQ(cooked.file.text(cooked.file.node_property(cooked.file.node(1), "1")->text), "x");
}

// Ten thousand leaves below a key of a megabyte: the paths alone would be ten gigabytes.
TEST(Keep, ExtrasThatUnfoldAreRefused) {
  Builder b = with_sockets();
  Json leaves = Json::array();
  for (int i = 0; i < 10000; ++i) leaves.push_back(i);
  b.root["nodes"][4]["extras"][std::string(1 << 20, 'k')] = leaves;
  expect_refused(b.text(), Exit::unsupported, "/nodes/4/extras", "unfolds");
}

}  // namespace
}  // namespace marrow::cook
