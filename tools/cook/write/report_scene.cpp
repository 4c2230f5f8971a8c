// What the cooker reports about looks and nodes.
#include "cook/write/report_scene.h"

#include "common/words.h"

namespace marrow::cook {

using nlohmann::ordered_json;

void report_looks(const BuiltScene& built, ordered_json& report) {
  report["materials"] = ordered_json::array();
  for (const BuiltMaterial& m : built.materials) {
    ordered_json textures = ordered_json::array();
    for (const Texture& t : m.textures) textures.push_back({{"role", tools::word(t.role)}, {"image", t.image}});
    report["materials"].push_back({{"name", m.name}, {"alpha", tools::word(m.alpha)}, {"textures", textures}});
  }
  report["images"] = ordered_json::array();
  for (const RawImage& i : built.images)
    report["images"].push_back(
        {{"name", i.name}, {"uri", i.uri}, {"format", tools::word(i.format)}, {"bytes", i.bytes.size()}});
}

void report_nodes(const BuiltScene& built, ordered_json& report) {
  report["nodes"] = ordered_json::array();
  for (const BuiltNode& n : built.nodes)
    report["nodes"].push_back({{"name", n.name},
                               {"skeleton", n.skeleton},
                               {"joint", n.joint == kNoJoint ? ordered_json() : ordered_json(n.joint)},
                               {"properties", n.properties.size()}});
  report["keep"] = ordered_json::array();
  for (const Kept& rule : built.kept) report["keep"].push_back({{"glob", rule.glob}, {"nodes", rule.nodes}});
}

}  // namespace marrow::cook
