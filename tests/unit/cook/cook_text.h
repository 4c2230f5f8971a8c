// What is cooked of documents that are texts, by options as the command line
// has them, as facts: see facts.h.
#pragma once

#include <string>
#include <vector>

#include "unit/cook/gltf/gltf_text.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {

// Joints by their names.
inline Json facts_of(const File& file, const SpringChain& chain) {
  Json joints = Json::array();
  for (const SpringJoint& j : chain.joints)
    joints.push_back(
        {{"joint", file.text(file.skeleton(0).names[j.joint])}, {"radius_m", j.radius_m}, {"gravity", j.gravity}});
  return {{"joints", joints}, {"tip", chain.tip}, {"colliders", chain.colliders}};
}
inline Json facts_of(const File& file, const Skeleton& skeleton, std::uint32_t number) {
  Json joints = Json::array(), parents = Json::array(), limited = Json::object(), springs = Json::array(),
       colliders = Json::array();
  for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) {
    joints.push_back(file.text(skeleton.names[j]));
    parents.push_back(skeleton.parents[j]);
  }
  for (const JointLimit& limit : skeleton.limits) limited[joints[limit.joint].get<std::string>()] = limit.kind;
  for (std::uint32_t s = 0; s < file.spring_count(number); ++s)
    springs.push_back(facts_of(file, file.spring(number, s)));
  for (const SpringCollider& c : file.spring_colliders(number))
    colliders.push_back({{"joint", joints[c.joint]}, {"from", c.from}, {"to", c.to}, {"radius_m", c.radius_m}});
  return {{"name", skeleton.name}, {"joints", joints},   {"parents", parents},
          {"limits", limited},     {"springs", springs}, {"colliders", colliders}};
}
// "joint": its name, or null of a node that no joint carries.
inline Json facts_of(const File& file, const Node& node) {
  Json rows = Json::array(), properties = Json::object();
  for (const auto& row : node.joint_from_node->rows) rows.push_back({row[0], row[1], row[2], row[3]});
  for (const Property& p : node.properties)
    properties[file.text(p.name)] = p.type == PropertyType::text      ? Json(file.text(p.text))
                                    : p.type == PropertyType::boolean ? Json(p.number != 0)
                                                                      : Json(p.number);
  const bool hangs = node.joint != kNoJoint;
  return {{"name", node.name},
          {"joint", hangs ? Json(file.text(file.skeleton(node.skeleton).names[node.joint])) : Json()},
          {"rows", rows},
          {"properties", properties}};
}
inline Json facts_of(const File& file, const Mesh& mesh) {
  Json joints = Json::array(), inverse_bind = Json::array();
  for (std::uint32_t j = 0; j < mesh.joint_count; ++j) {
    joints.push_back(file.text(file.skeleton(mesh.skeleton).names[mesh.joints[j]]));
    inverse_bind.push_back(mesh.inverse_bind[j].rows);
  }
  return {{"name", mesh.name},
          {"joints", joints},
          {"inverse_bind", inverse_bind},
          {"skeleton", mesh.skeleton},
          {"material", mesh.material_index == kNoMaterial ? Json() : Json(mesh.material_index)},
          {"material_name", mesh.material},
          {"double_sided", mesh.double_sided},
          {"targets", mesh.geometry.targets.size},
          {"weights", mesh.targets.size},
          {"triangles", mesh.geometry.index_count / 3},
          {"vertices", mesh.geometry.vertex_count}};
}
// "bytes" in base64; "instead": the name of the fallback.
inline Json facts_of(const File& file, const Image& i) {
  return {{"name", i.name},
          {"uri", i.uri},
          {"format", i.format},
          {"bytes", base64({i.bytes.data, i.bytes.size})},
          {"instead", i.fallback == kNoImage ? Json() : Json(file.image(i.fallback).name)}};
}
inline Json facts_of(const File& file, const Material& m) {
  Json textures = Json::array();
  for (const Texture& t : m.textures)
    textures.push_back({{"role", t.role}, {"image", t.image}, {"name", file.image(t.image).name}});
  return {{"name", m.name}, {"alpha", m.alpha}, {"unlit", m.unlit}, {"emissive", m.emissive}, {"textures", textures}};
}

// "reference": whether an additive one is over another pose than rest. Of tracks the first numbers.
inline Json facts_of(const File& file, const Clip& clip) {
  Json tracks = Json::array(), channels = Json::array();
  for (const Track& t : clip.tracks) {
    const float* const v = clip.values + t.first_value;
    const char* const paths[] = {"translation", "rotation", "scale"};
    tracks.push_back({{"joint", t.joint},
                      {"path", paths[static_cast<int>(t.path)]},
                      {"keys", t.key_count},
                      {"values", {v[0], v[1], v[2]}}});
  }
  for (const Channel& c : clip.channels) channels.push_back(file.text(c.name));
  return {{"name", clip.name},
          {"skeleton", clip.skeleton},
          {"duration_s", clip.duration_s},
          {"additive", clip.additive},
          {"reference", clip.reference != nullptr},
          {"tracks", tracks},
          {"channels", channels}};
}

// Of a cooked file; "report" as it is, "node" and "image" by their names, "warned" how often by each rule. A pack's
// references are its skeletons.
inline Json facts_of(const LoadedCook& cooked) {
  const File& file = cooked.file;
  Json out = {{"report", Json::parse(cooked.report.dump())},
              {"warnings", Json::array()},
              {"said", Json::object()},
              {"skeletons", Json::array()},
              {"clips", Json::array()},
              {"meshes", Json::array()},
              {"nodes", Json::array()},
              {"node", Json::object()},
              {"materials", Json::array()},
              {"images", Json::array()}};
  for (const Json& w : out["report"]["warnings"]) {
    out["warnings"].push_back(w["rule"].get<std::string>() + " " + w["pointer"].get<std::string>());
    out["said"].emplace(w["rule"], w["text"]);
    Json& times = out["warned"][w["rule"].get<std::string>()];
    times = times.is_null() ? 1 : times.get<int>() + 1;
  }
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s)
    out["skeletons"].push_back(facts_of(file, file.skeleton(s), s));
  for (std::uint32_t r = 0; r < file.reference_count(); ++r) {
    const SkeletonReference reference = file.reference(r);
    Json joints = Json::array();
    for (std::uint32_t j = 0; j < reference.joint_count; ++j) joints.push_back(file.text(reference.names[j]));
    out["skeletons"].push_back({{"name", reference.name}, {"joints", joints}});
  }
  for (std::uint32_t c = 0; c < file.clip_count(); ++c) {
    out["clips"].push_back(facts_of(file, file.clip(c)));
  }
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) out["meshes"].push_back(facts_of(file, file.mesh(m)));
  for (std::uint32_t n = 0; n < file.node_count(); ++n) {
    out["nodes"].push_back(facts_of(file, file.node(n)));
    out["node"][file.node(n).name] = out["nodes"].back();
  }
  for (std::uint32_t m = 0; m < file.material_count(); ++m)
    out["materials"].push_back(facts_of(file, file.material(m)));
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < file.image_count(); ++i) {
    out["images"].push_back(facts_of(file, file.image(i)));
    out["image"][file.image(i).name] = out["images"].back();
    names.emplace_back(file.image(i).name);
  }
  std::ranges::sort(names);
  out["image_names"] = names;
  return out;
}

inline Result cook_text(Builder document, const CookOptions& options = {}) {
  return cook_scene(
      read(document, {options.source.images == Images::embed, options.source.scene, options.source.strict}), options);
}

struct CookRow {
  std::string name, options, change, facts;
};
// more: what options have that no text says.
inline void expect_cooked(
    const Builder& document, std::initializer_list<CookRow> rows,
    const std::function<void(CookOptions&)>& more = [](CookOptions&) {}) {
  for (const CookRow& row : rows) {
    SCOPED_TRACE(row.name + ": " + row.options + ": " + row.change);
    const auto cook = [&] {
      CookOptions options = options_of(row.options);
      more(options);
      return facts_of(LoadedCook(cook_text(changed(document, row.change), options)));
    };
    expect_outcome(cook, row.facts);
  }
}

}  // namespace marrow::cook
