// Nodes that --keep asks for: which, where they hang, and what they carry.
#include "unit/cook/cook_text.h"

namespace marrow::cook {
namespace {

// skinned(), and below its tip, at (0, 1, 0) from the root, a hand that no clip
// moves with a socket in it; beside it something that stands in the scene,
// something without a name and something outside the scene.
Builder with_sockets() {
  return changed(skinned(),
                 R"("/nodes/2/children": [3], "/scenes/0/nodes": [0, 1, 5, 6],
    "/nodes/3": {"name": "hand", "translation": [0, 2, 0], "scale": [2, 2, 2], "children": [4]},
    "/nodes/4": {"name": "socket.sword", "translation": [0.5, 0, 0]},
    "/nodes/5": {"name": "socket.spawn", "translation": [7, 8, 9]}, "/nodes/6": {"translation": [1, 1, 1]},
    "/nodes/7": {"name": "socket.lost"})");
}

TEST(Keep, NodesHangOnTheNearestJoint) {
  expect_cooked(with_sockets(), {{"nothing unless asked", "", "", R"("nodes": [])"},
                                 {"of hand's (0, 2, 0) and twice 0.5", "--keep socket* --keep tip", "",
                                  R"("nodes": [
                    {"name": "tip", "joint": "tip", "rows": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]},
                    {"name": "socket.sword", "joint": "tip", "rows": [[2, 0, 0, 1], [0, 2, 0, 2], [0, 0, 2, 0]]},
                    {"name": "socket.spawn", "joint": null, "rows": [[1, 0, 0, 7], [0, 1, 0, 8], [0, 0, 1, 9]]}],
                    "skeletons/0/joints": ["root", "tip"])"},
                                 {"the report says what each glob kept: those with a name, each once",
                                  "--keep socket* --keep * --keep nothing?", "", R"("report/keep": [
                    {"glob": "socket*", "nodes": ["socket.sword", "socket.spawn"]},
                    {"nodes": ["root", "tip", "hand", "socket.sword", "socket.spawn"]}, {"nodes": []}],
                    "warned/keep-fits-nothing": 1, "nodes/#": 5, "report/nodes/4/joint": null)"}});
}

TEST(Keep, ExtrasBecomeProperties) {
  expect_cooked(
      with_sockets(),
      {{"all but null, and the text that would end early", "--keep socket*",
        R"("/nodes/4/extras": {"damage": 12.5, "two-handed": true, "title": "Gr\u00FC\u00DF\nGott", "slots": [1, {"gem": "ruby"}],
             "a/b~c": -1, "nothing": null, "cut": "a\u0000b", "empty": {}}, "/nodes/3/extras": {"hidden": 1})",
        R"("nodes/0/properties/#": 6, "nodes/0/properties": {"damage": 12.5, "two-handed": true, "title": "Gr\u00FC\u00DF\nGott",
             "slots/0": 1, "slots/1/gem": "ruby", "a~1b~0c": -1}, "warned/extras-dropped": 1)"},
       {"extras that are no object", "--keep socket*", R"("/nodes/4/extras": 42, "/nodes/5/extras": [false, "x"])",
        R"("nodes/0/properties": {"": 42}, "nodes/1/properties": {"0": false, "1": "x"})"}});
  const Result cooked =
      cook_text(changed(with_sockets(), R"("/nodes/3/extras": {"hidden": 1})"), options_of("--keep socket*"));
  const std::string bytes(reinterpret_cast<const char*>(cooked.file.data()), cooked.file.size());
  EXPECT_EQ(bytes.find("hidden"), std::string::npos) << "extras of kept nodes only";
}

// Ten thousand leaves below a key of a megabyte: the paths alone would be ten
// gigabytes.
TEST(Keep, ExtrasThatUnfoldAreRefused) {
  Builder b = with_sockets();
  Json leaves = Json::array();
  for (int i = 0; i < 10000; ++i) leaves.push_back(i);
  b.root["nodes"][4]["extras"][std::string(1 << 20, 'k')] = leaves;
  expect_refused(b.text(), Exit::unsupported, "/nodes/4/extras", "unfolds");
}

}  // namespace
}  // namespace marrow::cook
