// Every list of a scene that a mend can empty, under every option that reads it: cooked, or refused with a place.
#include <cstdio>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "cook/skeleton/build_skeletons.h"
#include "deform/weights/auto_weights.h"
#include "disk/cook_on_disk.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

// Ada (mesh 0, skin 0), whom one clip moves, and a crate (mesh 1) that another carries. The crate stands after what a
// skeleton begins with, so that a node that is no joint is asked for one that is not there.
SceneDocument full() {
  SceneDocument d;
  const std::vector<int> ada = d.character("Ada", 0);
  const int crate = d.node("crate", -1, {0, 0, 3});
  d.prop(crate);
  d.clip("nod");
  d.turn(ada[2], {0, 0.5F, 1});
  d.clip("carry");
  d.carry(crate, {0, 1});
  return d;
}

Json& primitive(Json& root, std::size_t mesh) {
  return root["meshes"][mesh]["primitives"][0];
}

// Indices of which no triangle remains.
void set_indices(SceneDocument& d, std::size_t mesh, const std::vector<std::uint16_t>& indices) {
  primitive(d.b.root, mesh)["indices"] = d.b.numbers<std::uint16_t>(kU16, "SCALAR", 1, indices);
}

void set_modes(Json& root, int mode) {
  for (Json& mesh : root["meshes"])
    for (Json& primitive : mesh["primitives"]) primitive["mode"] = mode;
}

void extend_nodes(Json& root, const char* extension, const Json& value) {
  root["extensionsUsed"] = {extension};
  for (Json& node : root["nodes"]) node["extensions"][extension] = value;
}

using Change = void (*)(SceneDocument&);

struct Emptied {
  const char* what;
  Change change;
};

const Emptied kEmptied[] = {
    {"nothing", [](SceneDocument&) {}},
    // Meshes.
    {"a mesh of points", [](SceneDocument& d) { primitive(d.b.root, 1)["mode"] = 0; }},
    {"a mesh of lines at a node that stands still",
     [](SceneDocument& d) {
       primitive(d.b.root, 1)["mode"] = 1;
       d.b.root["animations"].erase(1);
     }},
    {"skinned points", [](SceneDocument& d) { primitive(d.b.root, 0)["mode"] = 0; }},
    {"skinned points whose joints stand still",
     [](SceneDocument& d) {
       primitive(d.b.root, 0)["mode"] = 0;
       d.b.root["animations"].erase(0);
     }},
    {"all meshes of points", [](SceneDocument& d) { set_modes(d.b.root, 0); }},
    {"points and nothing that moves",
     [](SceneDocument& d) {
       set_modes(d.b.root, 0);
       d.b.root.erase("animations");
     }},
    {"two indices",
     [](SceneDocument& d) {
       set_indices(d, 1, {0, 1});
     }},
    {"two indices, skinned",
     [](SceneDocument& d) {
       set_indices(d, 0, {0, 1});
     }},
    {"no indices", [](SceneDocument& d) { set_indices(d, 1, {}); }},
    {"a strip of no indices, skinned",
     [](SceneDocument& d) {
       set_indices(d, 0, {});
       primitive(d.b.root, 0)["mode"] = 5;
     }},
    {"triangles of one vertex",
     [](SceneDocument& d) {
       set_indices(d, 1, {0, 0, 0, 1, 1, 1});
     }},
    {"triangles of one vertex, skinned",
     [](SceneDocument& d) {
       set_indices(d, 0, {0, 0, 0});
     }},
    {"a strip of one vertex",
     [](SceneDocument& d) {
       set_indices(d, 1, {0, 0, 0, 0});
       primitive(d.b.root, 1)["mode"] = 5;
     }},
    {"no positions", [](SceneDocument& d) { primitive(d.b.root, 0)["attributes"].erase("POSITION"); }},
    {"no positions in any mesh",
     [](SceneDocument& d) {
       primitive(d.b.root, 0)["attributes"].erase("POSITION");
       primitive(d.b.root, 1)["attributes"] = {{"_ID", primitive(d.b.root, 1)["attributes"]["POSITION"]}};
     }},
    {"no primitives", [](SceneDocument& d) { d.b.root["meshes"][1]["primitives"] = Json::array(); }},
    {"no primitives in any mesh",
     [](SceneDocument& d) {
       for (Json& mesh : d.b.root["meshes"]) mesh["primitives"] = Json::array();
     }},
    {"one primitive of points beside one of triangles",
     [](SceneDocument& d) {
       Json points = primitive(d.b.root, 0);
       points["mode"] = 0;
       d.b.root["meshes"][0]["primitives"].insert(d.b.root["meshes"][0]["primitives"].begin(), points);
     }},
    {"no morph targets",
     [](SceneDocument& d) {
       primitive(d.b.root, 0)["targets"] = Json::array();
       d.b.root["meshes"][0]["weights"] = Json::array();
     }},
    {"meshes that no node draws, without triangles",
     [](SceneDocument& d) {
       for (Json& node : d.b.root["nodes"]) {
         node.erase("mesh");
         node.erase("skin");
       }
       set_modes(d.b.root, 0);
     }},
    // Nodes and scenes.
    {"no children", [](SceneDocument& d) { d.b.root["nodes"][3]["children"] = Json::array(); }},
    {"no scenes",
     [](SceneDocument& d) {
       d.b.root["scenes"] = Json::array();
       d.b.root.erase("scene");
     }},
    {"no nodes in the scene", [](SceneDocument& d) { d.b.root["scenes"][0]["nodes"] = Json::array(); }},
    {"no mesh in the scene", [](SceneDocument& d) { d.b.root["scenes"][0]["nodes"] = {0}; }},
    {"no joints in the scene", [](SceneDocument& d) { d.b.root["scenes"][0]["nodes"] = {6}; }},
    {"all nodes hidden",
     [](SceneDocument& d) {
       extend_nodes(d.b.root, "KHR_node_visibility", {{"visible", false}});
     }},
    {"all nodes lower levels of one",
     [](SceneDocument& d) {
       extend_nodes(d.b.root, "MSFT_lod", {{"ids", {0, 5, 6}}});
     }},
    {"no nodes", [](SceneDocument& d) { d.b.root["nodes"] = Json::array(); }},
    {"no nodes, no scenes, no animations: a library",
     [](SceneDocument& d) {
       for (const char* name : {"nodes", "scenes", "scene", "animations", "skins"}) d.b.root.erase(name);
     }},
    // Skins.
    {"no skins", [](SceneDocument& d) { d.b.root["skins"] = Json::array(); }},
    {"no joints in a skin", [](SceneDocument& d) { d.b.root["skins"][0]["joints"] = Json::array(); }},
    {"no weights",
     [](SceneDocument& d) {
       primitive(d.b.root, 0)["attributes"]["WEIGHTS_0"] =
           d.b.numbers<float>(kF32, "VEC4", 4, std::vector<float>(16, kNan));
     }},
    // Clips.
    {"no clips", [](SceneDocument& d) { d.b.root["animations"] = Json::array(); }},
    {"no channels", [](SceneDocument& d) { d.b.root["animations"][0]["channels"] = Json::array(); }},
    {"no keys",
     [](SceneDocument& d) {
       Json& sampler = d.b.root["animations"][0]["samplers"][0];
       sampler = {{"input", d.b.numbers<float>(kF32, "SCALAR", 1, {})},
                  {"output", d.b.numbers<float>(kF32, "VEC4", 4, {})}};
     }},
    {"no channels and no samplers",
     [](SceneDocument& d) {
       for (Json& clip : d.b.root["animations"]) clip["channels"] = clip["samplers"] = Json::array();
     }},
    {"channels of nothing",
     [](SceneDocument& d) { d.b.root["animations"][0]["channels"][0]["target"]["path"] = "nothing"; }},
    {"channels of what stays out",
     [](SceneDocument& d) {
       const int lost = d.node("lost");
       d.b.root["scenes"][0]["nodes"].erase(d.b.root["scenes"][0]["nodes"].size() - 1);
       for (Json& clip : d.b.root["animations"]) clip["channels"][0]["target"]["node"] = lost;
     }},
};

struct Asked {
  const char* what;
  void (*ask)(CookOptions&);
};

std::shared_ptr<const Character> ada() {
  static const auto out = [] {
    SceneDocument d;
    d.character("Ada", 0);
    return std::make_shared<const Character>(Character{"ada.mrw", build_skeletons(d.read()).skeletons});
  }();
  return out;
}

ShapeRule shapes() {
  return {"mood", "", {{"mood", 0}}, {{"", {0}}, {"smile", {1}}}};
}

const Asked kAsked[] = {
    {"nothing", [](CookOptions&) {}},
    {"--mesh-codec meshopt --keep-vertex-order",
     [](CookOptions& o) {
       o.mesh.codec = MeshCodec::meshopt;
       o.mesh.keep_vertex_order = true;
     }},
    {"--mesh-codec none --keep * --images embed --scene 0",
     [](CookOptions& o) {
       o.mesh.codec = MeshCodec::none;
       o.prepare.keep = {"*"};
       o.source.images = Images::embed;
       o.source.scene.name = "0";
     }},
    {"--clips-only", [](CookOptions& o) { o.clips_only = true; }},
    {"--clips-only --skeleton",
     [](CookOptions& o) {
       o.clips_only = true;
       o.onto = ada();
     }},
    {"--skeleton", [](CookOptions& o) { o.onto = ada(); }},
    {"--auto-skeleton", [](CookOptions& o) { o.prepare.auto_skeleton = "humanoid"; }},
    {"--auto-weights --rebind --smooth-weights",
     [](CookOptions& o) {
       o.prepare.weights.make = deform::WeightMethod::nearest;
       o.prepare.weights.rebind = true;
       o.prepare.weights.smooth_steps = 1;
     }},
    {"--weights-over-time",
     [](CookOptions& o) {
       o.prepare.weights_over_time = {{"mood", "hips", "head"}};
     }},
    {"--subdivide --lod",
     [](CookOptions& o) {
       o.mesh.subdivide = 1;
       o.mesh.lod = {{0.5, 2}};
     }},
    {"--as fit --helpers auto --mwe --psd",
     [](CookOptions& o) {
       o.learn.animation_space = AnimationSpace::fit;
       o.learn.helpers = kAutoHelpers;
       o.learn.multi_weights = true;
       o.learn.pose_examples = 2;
     }},
    {"--eigenskin", [](CookOptions& o) { o.learn.eigen_targets = 1; }},
    {"--additive",
     [](CookOptions& o) {
       o.clips.additive = {{"nod", "carry"}};
     }},
    {"--roles",
     [](CookOptions& o) {
       o.roles = {{Role::head, "head"}, {Role::jaw, ""}};
     }},
    {"[[shapes]]", [](CookOptions& o) { o.shapes = {shapes()}; }},
    {"--strict", [](CookOptions& o) { o.source.strict = true; }},
};

struct Counts {
  std::size_t cooked = 0, refused = 0;
};

void try_one(const Emptied& emptied, const Asked& asked, Counts& counts) {
  SCOPED_TRACE(std::string(emptied.what) + ", " + asked.what);
  SceneDocument d = full();
  emptied.change(d);
  CookOptions options;
  options.clips.raw = std::string(asked.what) != "nothing";
  asked.ask(options);
  try {
    const ReadOptions reading{options.source.images == Images::embed, options.source.scene, options.source.strict};
    const LoadedCook cooked(cook_scene(read(d.b, reading), options));
    ++counts.cooked;
  } catch (const Failure& failure) {
    ++counts.refused;
    EXPECT_TRUE(failure.code() == Exit::usage || failure.code() == Exit::invalid || failure.code() == Exit::unsupported)
        << failure.what();
    EXPECT_TRUE(failure.where().starts_with('/') || failure.file().starts_with("--") || failure.file() == "[[shapes]]")
        << "no place: " << failure.what();
    EXPECT_FALSE(failure.rule().empty() || failure.advice().empty()) << failure.what();
  }
}

TEST(EmptiedLists, AreCookedOrRefusedWithAPlace) {
  Counts counts;
  for (const Asked& asked : kAsked)
    for (const Emptied& emptied : kEmptied) try_one(emptied, asked, counts);
  EXPECT_EQ(counts.cooked + counts.refused, std::size(kEmptied) * std::size(kAsked));
  EXPECT_GT(counts.cooked, 250u);
  EXPECT_GT(counts.refused, 100u);
  std::printf("%zu cooked, %zu refused\n", counts.cooked, counts.refused);
}

// What is drawn beside a mesh without triangles is cooked, and the mesh named.
TEST(EmptiedLists, LeaveTheOthersAlone) {
  std::size_t checked = 0;
  for (const Emptied& emptied : kEmptied) {
    const std::string what = emptied.what;
    if (what != "a mesh of points" && what != "two indices" && what != "no primitives" && what != "skinned points")
      continue;
    SCOPED_TRACE(what);
    SceneDocument d = full();
    emptied.change(d);
    const Result cooked = cook_scene(d.read(), {});
    ASSERT_EQ(cooked.report["meshes"].size(), 1u);
    EXPECT_EQ(cooked.report["meshes"][0]["name"], what == "skinned points" ? "prop" : "Ada mesh");
    EXPECT_EQ(cooked.report["meshes"][0]["triangles"], 2);
    const std::string mesh = what == "skinned points" ? "/meshes/0" : "/meshes/1";
    EXPECT_TRUE(std::ranges::any_of(cooked.report["warnings"], [&](const auto& warning) {
      return warning["pointer"].template get<std::string>().starts_with(mesh);
    }));
    ++checked;
  }
  EXPECT_EQ(checked, 4u);
}

}  // namespace
}  // namespace marrow::cook
