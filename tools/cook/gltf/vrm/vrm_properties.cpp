// Names of humanoid bones, first-person flags, and what the author says: properties of nodes, which are kept.
#include <algorithm>

#include "cook/gltf/vrm/vrm_parts.h"

namespace marrow::cook::gltf {
namespace {

void keep(VrmImport& vrm, int node, const std::string& where) {
  RawNode& raw = vrm.scene.nodes[static_cast<std::size_t>(node)];
  if (raw.name.empty() && !raw.kept)
    vrm.report.warn(where, "node-without-name", "nodes are kept by name, so what VRM says of this one is left out");
  raw.kept = true;
}

void add(VrmImport& vrm, int node, const std::string& name, const Json& value, const std::string& where) {
  keep(vrm, node, where);
  add_properties(value, name, where, vrm.budget, vrm.report, vrm.scene.nodes[static_cast<std::size_t>(node)]);
}

void import_bone(VrmImport& vrm, const std::string& bone, const Json& node, const std::string& where) {
  if (!names_one(node, vrm.scene.nodes.size())) {
    if (node.is_number() && node.get<double>() >= 0)
      vrm.report.invalid(where, "reference to nothing", "there is no such node; export again");
    return;
  }
  const auto index = node.get<int>();
  add(vrm, index, "vrm/humanoid", bone, where);
  vrm.scene.nodes[static_cast<std::size_t>(index)].moved_by_game = true;
  if (bone == "hips") vrm.avatar = index;
  if (bone == "head") vrm.head = index;
  if (bone == "leftEye") vrm.eyes[0] = index;
  if (bone == "rightEye") vrm.eyes[1] = index;
}

void import_humanoid(VrmImport& vrm) {
  const Json& bones = member_or_empty(member_or_empty(vrm.vrm, "humanoid"), "humanBones");
  const std::string where = under(vrm.where, "humanoid", "humanBones");
  if (vrm.is_0) {
    for (std::size_t i = 0; i < bones.size(); ++i)
      import_bone(vrm, text_or(bones[i], "bone", ""), member_or_empty(bones[i], "node"), under(where, i, "node"));
  } else {
    for (const auto& [bone, of] : bones.items()) import_bone(vrm, bone, of.at("node"), under(where, bone, "node"));
  }
}

// Version 0 begins its words with a capital.
std::string with_small_letter(std::string word) {
  if (!word.empty() && word[0] >= 'A' && word[0] <= 'Z') word[0] = static_cast<char>(word[0] - 'A' + 'a');
  return word;
}

void import_first_person(VrmImport& vrm) {
  const Json& list = member_or_empty(member_or_empty(vrm.vrm, "firstPerson"), "meshAnnotations");
  std::vector<char> said(vrm.scene.nodes.size(), 0);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string where = under(vrm.where, "firstPerson", "meshAnnotations", i);
    const std::string flag = with_small_letter(text_or(list[i], vrm.is_0 ? "firstPersonFlag" : "type", "auto"));
    const Json& named = member_or_empty(list[i], vrm.is_0 ? "mesh" : "node");
    bool found = false;
    for (const RawInstance& instance : vrm.scene.instances) {
      const int has = vrm.is_0 ? instance.mesh : instance.node;
      if (!named.is_number() || named.get<double>() != static_cast<double>(has)) continue;
      found = true;
      if (said[static_cast<std::size_t>(instance.node)]) continue;
      said[static_cast<std::size_t>(instance.node)] = 1;
      add(vrm, instance.node, "vrm/firstPerson", flag, where);
    }
    if (!found) vrm.report.warn(where, "annotation-dropped", "it names no node with a mesh");
  }
}

void import_meta(VrmImport& vrm) {
  Json meta = member_or_empty(vrm.vrm, "meta");
  if (!meta.is_object()) meta = Json::object();
  for (const char* picture : {"texture", "thumbnailImage"}) meta.erase(picture);  // numbers of the source
  add(vrm, vrm.avatar, "vrm/specVersion", vrm.is_0 ? "0.0" : "1.0", vrm.where);
  add(vrm, vrm.avatar, "vrm/meta", meta, under(vrm.where, "meta"));
}

// The hips, or else the first node that can be kept.
void find_avatar(VrmImport& vrm) {
  for (std::size_t n = 0; n < vrm.scene.nodes.size() && vrm.avatar == kNone; ++n)
    if (vrm.scene.nodes[n].in_scene && !vrm.scene.nodes[n].name.empty()) vrm.avatar = static_cast<int>(n);
  if (vrm.avatar == kNone) vrm.avatar = 0;
}

}  // namespace

void import_properties(VrmImport& vrm) {
  if (vrm.scene.nodes.empty()) vrm.report.invalid(vrm.where, "no nodes", "an avatar has some; export again");
  import_humanoid(vrm);
  find_avatar(vrm);
  import_meta(vrm);
  import_first_person(vrm);
}

}  // namespace marrow::cook::gltf
