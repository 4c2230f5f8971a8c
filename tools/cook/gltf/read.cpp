// The road from a glTF file to a RawScene, stage by stage.
#include "cook/gltf/read.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "common/formats.h"
#include "cook/gltf/document/buffers.h"
#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/json.h"
#include "cook/gltf/document/model.h"
#include "cook/gltf/document/scene_files.h"
#include "cook/gltf/import/import.h"
#include "cook/gltf/rules/rules.h"
#include "cook/gltf/rules/schema.h"
#include "cook/gltf/vrm/vrm.h"
#include "text/nearest.h"

namespace marrow::cook {
namespace {

using namespace gltf;

constexpr const char* kVrmExtensions[] = {"VRM", "VRMC_vrm", "VRMC_springBone"};

void warn_of_ignored(const Json& root, Report& report) {
  if (root.contains("cameras")) report.warn("/cameras", "cameras-dropped", "cameras are left out");
  const auto extensions = root.find("extensions");
  if (extensions != root.end() && extensions->contains("KHR_lights_punctual")) {
    report.warn("/extensions/KHR_lights_punctual", "lights-dropped", "lights are left out");
  }
}

// extras.marrow.limits, which are for the cooker and not for the game; null without.
Json take_limits(Json& extras) {
  if (!extras.is_object()) return {};
  const auto marrow = extras.find("marrow");
  if (marrow == extras.end() || !marrow->is_object()) return {};
  const auto limits = marrow->find("limits");
  if (limits == marrow->end()) return {};
  Json taken = std::move(*limits);
  marrow->erase(limits);
  if (marrow->empty()) extras.erase(marrow);
  // A `limits` that is null says as little as none would; it is refused like any other that is no object.
  return taken.is_null() ? Json(false) : taken;
}

// Names of morph targets as exporters write them, mesh.extras.targetNames; one list a mesh, empty where there is none.
std::vector<std::vector<std::string>> read_target_names(const Json& root) {
  std::vector<std::vector<std::string>> out;
  const auto meshes = root.find("meshes");
  if (meshes == root.end()) return out;
  for (const Json& mesh : *meshes) {
    out.emplace_back();
    const auto extras = mesh.find("extras");
    if (extras == mesh.end() || !extras->is_object()) continue;
    const auto names = extras->find("targetNames");
    if (names == extras->end() || !names->is_array()) continue;
    for (const Json& name : *names) out.back().push_back(name.is_string() ? name.get<std::string>() : std::string());
  }
  return out;
}

NodeShown read_shown(const Json& node) {
  NodeShown out;
  const auto all = node.find("extensions");
  if (all == node.end()) return out;
  if (const auto shown = all->find("KHR_node_visibility"); shown != all->end())
    out.visible = shown->value("visible", true);
  if (const auto levels = all->find("MSFT_lod"); levels != all->end())
    out.lower = levels->value("ids", std::vector<int>());
  return out;
}

Json events_of(const Json& animation) {
  const Json* at = &animation;
  for (const char* name : {"extras", "marrow", "events"}) {
    const auto member = at->find(name);
    if (member == at->end()) return {};
    at = &*member;
  }
  return *at;
}

// What is imported from the JSON itself.
void set_aside(Json& root, Document& document) {
  for (const char* name : {"materials", "textures", "samplers", "images"})
    if (const auto member = root.find(name); member != root.end()) document.looks[name] = std::move(*member);
  if (const auto all = root.find("extensions"); all != root.end())
    for (const char* name : kVrmExtensions)
      if (const auto member = all->find(name); member != all->end()) document.vrm[name] = std::move(*member);
  if (const auto animations = root.find("animations"); animations != root.end())
    for (const Json& animation : *animations) document.clip_events.push_back(events_of(animation));
  const auto nodes = root.find("nodes");
  if (nodes == root.end()) return;
  for (Json& node : *nodes) {
    document.node_shown.push_back(read_shown(node));
    const auto extras = node.find("extras");
    document.node_extras.push_back(extras == node.end() ? Json() : std::move(*extras));
    document.node_limits.push_back(take_limits(document.node_extras.back()));
    const auto extensions = node.find("extensions");
    document.node_is_view.push_back(node.contains("camera") ||
                                    (extensions != node.end() && extensions->contains("KHR_lights_punctual")));
  }
}

// VRM's exporters write null for what there is not.
void drop_nulls(Json& value) {
  for (auto member = value.begin(); member != value.end();) {
    if (value.is_object() && member->is_null()) {
      member = value.erase(member);
      continue;
    }
    if (member->is_structured()) drop_nulls(*member);
    ++member;
  }
}

Document read_document(const Container& container, Files* files, Report& report) {
  Json root = parse_json(container, report);
  if (const auto all = root.find("extensions"); all != root.end() && all->is_object())
    for (const char* name : kVrmExtensions)
      if (const auto member = all->find(name); member != all->end()) drop_nulls(*member);
  check_generation(root, report);
  check_schema(root, report);
  check_asset_and_extensions(root, report);
  check_image_uris(root, report);
  warn_of_ignored(root, report);
  Document document;
  document.buffers = load_buffers(root, container, files, report);
  document.accessors = build_accessors(root, document.buffers, report);
  check_texture_coordinates(root, report);
  check_transforms(root, report);
  document.target_names = read_target_names(root);
  document.user_numbers = aim_channels(root, report);
  set_aside(root, document);
  document.model = parse_model(std::move(root), report);
  return document;
}

// The scene that is chosen by its name or number, else the default one, else the first; kNone without any.
int find_scene(const tinygltf::Model& model, const SceneChoice& choice, Report& report) {
  const std::string& wanted = choice.name;
  const int standard = model.scenes.empty() ? kNone : std::max(model.defaultScene, 0);
  if (wanted.empty()) return standard;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model.scenes.size(); ++i) {
    if (model.scenes[i].name == wanted) return static_cast<int>(i);
    names.push_back(model.scenes[i].name.empty() ? std::to_string(i) : model.scenes[i].name);
  }
  int number = kNone;
  const char* const end = wanted.data() + wanted.size();
  const auto [rest, error] = std::from_chars(wanted.data(), end, number);
  if (error == std::errc() && rest == end && number >= 0 && to_index(number) < names.size()) return number;
  const std::string why = "no scene is called \"" + tools::printable(wanted) + '"';
  if (choice.origin.must_fit)
    throw tools::Failure(tools::Exit::usage, choice.origin.file, choice.origin.where, why,
                         names.empty() ? "the file has no scenes" : tools::suggestion(wanted, names));
  report.warn("/scenes", "rule-fits-nothing", "scene: " + why + "; taken is the default one");
  return standard;
}

bool draws_meshes(const tinygltf::Model& model) {
  return std::ranges::any_of(model.nodes, [](const tinygltf::Node& node) { return node.mesh >= 0; });
}

RawScene read_scene(const std::string& name, std::span<const std::byte> bytes, Files* files, const ReadOptions& options,
                    Report& report) {
  if (options.strict) report.mend_nothing("as --strict asks");
  const Container container = split_container(bytes, report);
  const Document document = read_document(container, files, report);
  const NodeGraph graph = check_nodes(document, find_scene(document.model, options.scene, report), report);
  check_skins(document, graph, report);
  check_meshes(document, report);
  check_animations(document, report);

  RawScene scene;
  scene.source = name;
  scene.source_bytes = bytes.size() + document.buffers.external_bytes;
  Budget budget(scene.source_bytes);
  scene.nodes = import_nodes(document, graph, report);
  scene.skins = import_skins(document, scene.nodes, report);
  import_extras(document, scene.nodes, budget, report);
  import_limits(document, scene.nodes, report);
  Materials materials = import_materials(document.looks, report);
  scene.images = import_images(document, materials, files, options.image_bytes, budget, scene.source_bytes, report);
  scene.meshes = import_meshes(document, materials, budget, report);
  scene.materials = std::move(materials.raw);
  scene.instances = import_instances(document, graph, scene.nodes, scene.meshes, scene.skins, report);
  scene.draws_elsewhere = scene.instances.empty() && draws_meshes(document.model);
  scene.clips = import_clips(document, graph, scene.nodes, budget, report);
  import_vrm(document, budget, report, scene);
  scene.warnings = report.take_warnings();
  scene.reads = report.take_reads();
  return scene;
}

}  // namespace

RawScene read_gltf(const std::string& name, Files& files, const ReadOptions& options) {
  Report report(name);
  const std::vector<std::byte> bytes = read_scene_file(files, name, kMostBytes + 1, "@0", report);
  tools::expect_gltf(name, bytes);
  return read_scene(name, bytes, &files, options, report);
}

RawScene read_gltf(const std::string& name, std::span<const std::byte> bytes, const ReadOptions& options) {
  Report report(name);
  return read_scene(name, bytes, nullptr, options, report);
}

}  // namespace marrow::cook
