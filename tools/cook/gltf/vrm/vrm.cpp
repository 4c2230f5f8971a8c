// Bones, flags, expressions and eyes of VRM avatars.
#include "cook/gltf/vrm/vrm.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

namespace marrow::cook::gltf {

const Json& member_or_empty(const Json& object, const char* name) {
  static const Json kEmpty;
  const auto found = object.find(name);
  return found == object.end() ? kEmpty : *found;
}

double number_or(const Json& object, const char* name, double fallback) {
  const auto found = object.find(name);
  return found == object.end() ? fallback : found->get<double>();
}

std::string text_or(const Json& object, const char* name, const std::string& fallback) {
  const auto found = object.find(name);
  return found == object.end() ? fallback : found->get<std::string>();
}

glm::dvec3 vector_or(const Json& object, const char* name, const glm::dvec3& fallback) {
  const auto found = object.find(name);
  if (found == object.end()) return fallback;
  if (found->is_array()) return {(*found)[0].get<double>(), (*found)[1].get<double>(), (*found)[2].get<double>()};
  return {number_or(*found, "x", 0), number_or(*found, "y", 0), number_or(*found, "z", 0)};
}

bool names_one(const Json& number, std::size_t count) {
  if (!number.is_number()) return false;
  const double index = number.get<double>();
  return index >= 0 && index < static_cast<double>(count) && index == std::floor(index);
}

namespace {

// Names of humanoid bones, first-person flags, and what the author says: properties of nodes, which are kept.
void keep(VrmImport& vrm, int node, const std::string& where) {
  RawNode& raw = vrm.scene.nodes[to_index(node)];
  if (raw.name.empty() && !raw.kept)
    vrm.report.warn(where, "node-without-name", "nodes are kept by name, so what VRM says of this one is left out");
  raw.kept = true;
}

void add(VrmImport& vrm, int node, const std::string& name, const Json& value, const std::string& where) {
  keep(vrm, node, where);
  add_properties(value, name, where, vrm.budget, vrm.report, vrm.scene.nodes[to_index(node)]);
}

void import_bone(VrmImport& vrm, const std::string& bone, const Json& node, const std::string& where) {
  if (!names_one(node, vrm.scene.nodes.size())) {
    if (node.is_number() && node.get<double>() >= 0)
      vrm.report.invalid(where, "reference to nothing", "there is no such node; export again");
    return;
  }
  const auto index = node.get<int>();
  add(vrm, index, "vrm/humanoid", bone, where);
  vrm.scene.nodes[to_index(index)].moved_by_game = true;
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
      if (said[to_index(instance.node)]) continue;
      said[to_index(instance.node)] = 1;
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

// "vrm/humanoid" on humanoid bones, which become joints; "vrm/firstPerson" on nodes with meshes; "vrm/specVersion" and
// "vrm/meta/…" on the hips. All these nodes are kept. Fills in head, eyes and avatar.
void import_properties(VrmImport& vrm) {
  if (vrm.scene.nodes.empty()) vrm.report.invalid(vrm.where, "no nodes", "an avatar has some; export again");
  import_humanoid(vrm);
  find_avatar(vrm);
  import_meta(vrm);
  import_first_person(vrm);
}

// Expressions, which version 0 calls blend shapes: each an additive clip of one key, in channels of morph targets.
constexpr double kLargestWeight = 1e3;

// An expression in the making: weights by node and morph target.
struct Expression {
  std::string name, where;
  std::map<std::pair<std::size_t, std::size_t>, double> weights;  // (instance, target)
  std::size_t lost = 0;                                           // binds to nothing
};

// The names of version 1; those of version 0 that it has changed.
std::string new_name(std::string preset, const std::string& name) {
  for (char& c : preset) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::array<std::array<const char*, 2>, 18> kNames = {{{"neutral", "neutral"},
                                                                  {"a", "aa"},
                                                                  {"i", "ih"},
                                                                  {"u", "ou"},
                                                                  {"e", "ee"},
                                                                  {"o", "oh"},
                                                                  {"blink", "blink"},
                                                                  {"joy", "happy"},
                                                                  {"angry", "angry"},
                                                                  {"sorrow", "sad"},
                                                                  {"fun", "relaxed"},
                                                                  {"surprised", "surprised"},
                                                                  {"lookup", "lookUp"},
                                                                  {"lookdown", "lookDown"},
                                                                  {"lookleft", "lookLeft"},
                                                                  {"lookright", "lookRight"},
                                                                  {"blink_l", "blinkLeft"},
                                                                  {"blink_r", "blinkRight"}}};
  for (const auto& [old, now] : kNames)
    if (preset == old) return now;
  return name;
}

class ExpressionImporter {
 public:
  explicit ExpressionImporter(VrmImport& vrm) : vrm_(vrm) {
    for (std::size_t i = 0; i < vrm.scene.instances.size(); ++i) {
      const RawInstance& instance = vrm.scene.instances[i];
      (vrm.is_0 ? of_[instance.mesh] : of_[instance.node]).push_back(i);
    }
  }

  void import_0() {
    const Json& groups = member_or_empty(member_or_empty(vrm_.vrm, "blendShapeMaster"), "blendShapeGroups");
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const Json& group = groups[g];
      Expression e;
      e.where = under(vrm_.where, "blendShapeMaster", "blendShapeGroups", g);
      e.name = new_name(text_or(group, "presetName", ""), text_or(group, "name", ""));
      for (const Json& bind : member_or_empty(group, "binds"))
        add(e, member_or_empty(bind, "mesh"), member_or_empty(bind, "index"), number_or(bind, "weight", 0) / 100);
      finish(e, group, !member_or_empty(group, "materialValues").empty());
    }
  }

  void import_1() {
    const Json& all = member_or_empty(vrm_.vrm, "expressions");
    for (const char* kind : {"preset", "custom"}) {
      for (const auto& [name, expression] : member_or_empty(all, kind).items()) {
        Expression e;
        e.where = under(vrm_.where, "expressions", kind, name);
        e.name = name;
        for (const Json& bind : member_or_empty(expression, "morphTargetBinds"))
          add(e, bind.at("node"), bind.at("index"), bind.at("weight").get<double>());
        finish(e, expression,
               !member_or_empty(expression, "materialColorBinds").empty() ||
                   !member_or_empty(expression, "textureTransformBinds").empty());
      }
    }
  }

 private:
  // owner: a node, in version 0 a mesh.
  void add(Expression& e, const Json& owner, const Json& target, double weight) {
    const auto found = owner.is_number() && std::fabs(owner.get<double>()) < 1e9
                           ? of_.find(static_cast<int>(owner.get<double>()))
                           : of_.end();
    if (found == of_.end()) {
      ++e.lost;
      return;
    }
    for (const std::size_t i : found->second) {
      if (!names_one(target, vrm_.scene.instances[i].weights.size()) || !(std::fabs(weight) <= kLargestWeight)) {
        ++e.lost;
        continue;
      }
      const auto [at, is_new] = e.weights.try_emplace({i, target.get<std::size_t>()}, 0.0);
      if (is_new) vrm_.budget.take(sizeof(RawScalar), e.where, vrm_.report);
      at->second += weight;
    }
  }

  void finish(const Expression& e, const Json& json, bool has_materials) {
    if (e.lost > 0)
      vrm_.report.warn(e.where, "expression-bind-dropped",
                       std::to_string(e.lost) + " binds name no morph target that there is, or a weight beyond 1000");
    if (has_materials) ++with_materials_;
    const std::string name = clean_name(e.name, e.where, vrm_.report);
    import_rules(name, json, e.where);
    if (e.weights.empty()) return;
    RawClip clip;
    clip.name = "expression/" + name;
    clip.additive = true;
    for (const auto& [place, weight] : e.weights) {
      const RawInstance& instance = vrm_.scene.instances[place.first];
      const RawTargetWeight& target = instance.weights[place.second];
      RawScalar scalar;
      scalar.name = target.channel;
      scalar.node = instance.node;
      scalar.rest = target.rest;
      scalar.interpolation = RawInterpolation::step;
      scalar.times_s = {0};
      scalar.values = {target.rest + static_cast<float>(weight)};
      clip.scalars.push_back(std::move(scalar));
    }
    vrm_.scene.clips.push_back(std::move(clip));
  }

  // What of an expression is the game's to do.
  void import_rules(const std::string& name, const Json& json, const std::string& where) {
    Json rules = Json::object();
    if (const Json& binary = member_or_empty(json, "isBinary"); binary.is_boolean() && binary.get<bool>())
      rules["isBinary"] = true;
    for (const char* rule : {"overrideBlink", "overrideLookAt", "overrideMouth"})
      if (const std::string word = text_or(json, rule, "none"); word != "none") rules[rule] = word;
    std::string path = "vrm/expressions";
    append_step(path, name);
    add_properties(rules, path, where, vrm_.budget, vrm_.report, vrm_.scene.nodes[to_index(vrm_.avatar)]);
  }

 public:
  // How many expressions change materials.
  std::size_t with_materials_ = 0;

 private:
  VrmImport& vrm_;
  std::map<int, std::vector<std::size_t>> of_;  // instances of a node, in version 0 of a mesh
};

// "expression/NAME": additive clips of one key; and properties of the avatar, "vrm/expressions/NAME/…".
void import_expressions(VrmImport& vrm) {
  ExpressionImporter importer(vrm);
  vrm.is_0 ? importer.import_0() : importer.import_1();
  if (importer.with_materials_ > 0)
    vrm.report.warn(under(vrm.where, vrm.is_0 ? "blendShapeMaster" : "expressions"), "material-binds-dropped",
                    std::to_string(importer.with_materials_) +
                        " expressions change colours or texture coordinates, which is left out");
}

// Look-at: how far eyes turn becomes limits of their joints, all that is said of it properties of the head.
constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kMostDegrees = 89;  // the second angle of an euler limit has less than 90

constexpr const char* kMaps[] = {"rangeMapHorizontalInner", "rangeMapHorizontalOuter", "rangeMapVerticalDown",
                                 "rangeMapVerticalUp"};

// In version 1's words.
Json look_at_of(const VrmImport& vrm) {
  if (!vrm.is_0) return member_or_empty(vrm.vrm, "lookAt");
  const Json& from = member_or_empty(vrm.vrm, "firstPerson");
  if (!from.is_object()) return {};
  Json out = Json::object();
  const std::string type = text_or(from, "lookAtTypeName", "");
  if (!type.empty()) out["type"] = type == "BlendShape" ? "expression" : "bone";
  if (from.contains("firstPersonBoneOffset")) {
    const glm::dvec3 offset = vector_or(from, "firstPersonBoneOffset", {});
    out["offsetFromHeadBone"] = {offset.x, offset.y, -offset.z};  // version 0's z goes the other way
  }
  constexpr const char* kOld[] = {"lookAtHorizontalInner", "lookAtHorizontalOuter", "lookAtVerticalDown",
                                  "lookAtVerticalUp"};
  for (std::size_t i = 0; i < 4; ++i) {
    const Json& map = member_or_empty(from, kOld[i]);
    if (map.is_object())
      out[kMaps[i]] = {{"inputMaxValue", number_or(map, "xRange", 90)}, {"outputScale", number_or(map, "yRange", 10)}};
  }
  return out;
}

// From the scene into a joint's own axes at rest.
glm::dvec3 in_joint(const VrmImport& vrm, int node, glm::dvec3 direction) {
  std::vector<int> way;
  for (int n = node; n != kNone; n = vrm.scene.nodes[to_index(n)].parent) way.push_back(n);
  for (std::size_t i = way.size(); i-- > 0;)
    direction = glm::conjugate(vrm.scene.nodes[to_index(way[i])].rotation) * direction;
  return direction;
}

// Yaw about the vertical, then pitch about what points to the avatar's left; no roll. degrees: as kMaps.
RawLimit eye_limit(const VrmImport& vrm, int eye, bool is_left, const double (&degrees)[4]) {
  const glm::dvec3 left = in_joint(vrm, eye, {vrm.is_0 ? -1 : 1, 0, 0}), up = in_joint(vrm, eye, {0, 1, 0});
  RawLimit out;
  LimitDescription& d = out.description;
  d.kind = LimitKind::euler;
  d.order = AxisOrder::yxz;
  for (int i = 0; i < 3; ++i) {
    d.axis[i] = static_cast<float>(left[i]);
    d.across[i] = static_cast<float>(up[i]);
  }
  const auto rad = [&](std::size_t map) { return static_cast<float>(degrees[map] * kDegree); };
  // Positive to the left, which is outwards for the left eye; and down.
  d.least_rad[0] = -rad(is_left ? 0 : 1);
  d.most_rad[0] = rad(is_left ? 1 : 0);
  d.least_rad[1] = -rad(3);
  d.most_rad[1] = rad(2);
  return out;
}

// Limits of the eyes' joints, and "vrm/lookAt/…" on the head.
void import_eyes(VrmImport& vrm) {
  const Json look_at = look_at_of(vrm);
  if (!look_at.is_object()) return;
  const int holder = vrm.head != kNone ? vrm.head : vrm.avatar;
  add_properties(look_at, "vrm/lookAt", under(vrm.where, vrm.is_0 ? "firstPerson" : "lookAt"), vrm.budget, vrm.report,
                 vrm.scene.nodes[to_index(holder)]);
  if (text_or(look_at, "type", "bone") != "bone") return;
  double degrees[4];
  for (std::size_t i = 0; i < 4; ++i) {
    const Json& map = member_or_empty(look_at, kMaps[i]);
    if (!map.is_object()) return;
    degrees[i] = std::clamp(number_or(map, "outputScale", 10), 0.0, kMostDegrees);
  }
  for (const int side : {0, 1}) {
    const int eye = vrm.eyes[side];
    if (eye == kNone || vrm.scene.nodes[to_index(eye)].limit) continue;
    vrm.scene.nodes[to_index(eye)].limit = eye_limit(vrm, eye, side == 0, degrees);
  }
}

bool uses(const Document& document, const char* extension) {
  return std::ranges::count(document.model.extensionsUsed, extension) > 0;
}

}  // namespace

void import_vrm(const Document& document, Budget& budget, Report& report, RawScene& scene) {
  VrmImport vrm{document, budget, report, scene, false, Json::object(), "", {}};
  if (uses(document, "VRMC_node_constraint"))
    report.warn("/nodes", "constraints-dropped", "VRMC_node_constraint: nobody turns these nodes after others");
  if (!document.vrm.is_object()) return;
  vrm.is_0 = !document.vrm.contains("VRMC_vrm") && document.vrm.contains("VRM");
  const char* const name = vrm.is_0 ? "VRM" : "VRMC_vrm";
  if (document.vrm.contains(name)) vrm.vrm = document.vrm.at(name);
  vrm.where = pointer("extensions", name);
  vrm.model_from_node = rest_matrices(scene.nodes);
  if (!vrm.vrm.empty()) {
    import_properties(vrm);
    import_expressions(vrm);
    import_eyes(vrm);
  }
  import_springs(vrm);
}

}  // namespace marrow::cook::gltf
