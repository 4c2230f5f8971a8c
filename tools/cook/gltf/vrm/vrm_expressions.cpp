// Expressions, which version 0 calls blend shapes: each an additive clip of one key, in channels of morph targets.
#include <array>
#include <cctype>
#include <cmath>
#include <map>

#include "cook/gltf/vrm/vrm_parts.h"

namespace marrow::cook::gltf {
namespace {

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
    add_properties(rules, path, where, vrm_.budget, vrm_.report,
                   vrm_.scene.nodes[static_cast<std::size_t>(vrm_.avatar)]);
  }

 public:
  // How many expressions change materials.
  std::size_t with_materials_ = 0;

 private:
  VrmImport& vrm_;
  std::map<int, std::vector<std::size_t>> of_;  // instances of a node, in version 0 of a mesh
};

}  // namespace

void import_expressions(VrmImport& vrm) {
  ExpressionImporter importer(vrm);
  vrm.is_0 ? importer.import_0() : importer.import_1();
  if (importer.with_materials_ > 0)
    vrm.report.warn(under(vrm.where, vrm.is_0 ? "blendShapeMaster" : "expressions"), "material-binds-dropped",
                    std::to_string(importer.with_materials_) +
                        " expressions change colours or texture coordinates, which is left out");
}

}  // namespace marrow::cook::gltf
