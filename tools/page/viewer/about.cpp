#include "page/viewer/about.h"

#include <algorithm>
#include <string>
#include <vector>

#include "marrow/roles.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

ordered_json clips(Actor& actor) {
  ordered_json out = ordered_json::array();
  Settings settings;
  for (std::size_t i = 0; i < actor.plays().size(); ++i) {
    settings.clip = i;
    const NamedPlay& named = actor.plays()[i];
    ordered_json& clip = out.emplace_back(ordered_json{{"name", named.name},
                                                       {"duration_s", named.play.duration_s},
                                                       {"rate_hz", actor.rate_hz(settings)},
                                                       {"events", ordered_json::array()},
                                                       {"contacts", ordered_json::array()}});
    const ClipMotion& motion = named.play.motion;
    for (const ClipEvent& event : motion.events) {
      const std::string name = named.play.clips.text(event.name);
      if (find_role(name.c_str()) != Role::none) {
        clip["contacts"].push_back({{"role", name}, {"from_s", event.time_s}, {"until_s", event.until_s}});
      } else {
        clip["events"].push_back({{"name", name}, {"time_s", event.time_s}});
      }
    }
  }
  return out;
}

ordered_json joints(const Actor& actor) {
  ordered_json out = ordered_json::array();
  std::vector<int> first;  // a skeleton
  for (std::size_t i = 0; i < actor.joints().size(); ++i) {
    const NamedJoint& joint = actor.joints()[i];
    if (joint.skeleton >= first.size()) first.resize(joint.skeleton + 1, static_cast<int>(i));
    const Skeleton skeleton = actor.file().skeleton(joint.skeleton);
    const std::uint16_t parent = skeleton.parents[joint.joint];
    const bool limited =
        std::ranges::any_of(skeleton.limits, [&](const JointLimit& limit) { return limit.joint == joint.joint; });
    const Role role = role_of(actor.file().roles(joint.skeleton), joint.joint);
    out.push_back({{"name", joint.name},
                   {"parent", parent == kNoJoint ? -1 : first[joint.skeleton] + parent},
                   {"skeleton", joint.skeleton},
                   {"limited", limited},
                   {"role", role == Role::none ? "" : role_name(role)}});
  }
  return out;
}

void add_meshes(const File& file, ordered_json& out) {
  out["meshes"] = ordered_json::array();
  out["morphs"] = ordered_json::array();
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    const Mesh mesh = file.mesh(i);
    out["meshes"].push_back({{"name", mesh.name},
                             {"vertices", mesh.geometry.vertex_count},
                             {"triangles", mesh.geometry.index_count / 3},
                             {"levels", mesh.lods.size + 1},
                             {"skeleton", mesh.skeleton}});
    for (const MeshTarget& target : mesh.targets)
      out["morphs"].push_back({{"name", file.text(target.name)}, {"mesh", i}});
  }
}

// Those that have data of their own, and what every file can do.
ordered_json deformers(const File& file) {
  const auto any = [&](auto has) {
    for (std::uint32_t i = 0; i < file.mesh_count(); ++i)
      if (has(file.mesh(i).geometry)) return true;
    return false;
  };
  ordered_json out = {"rigid", "ssd"};
  if (any([](const Geometry& g) { return g.as_residual != nullptr; })) out.push_back("as");
  if (any([](const Geometry& g) { return g.mwe_residual != nullptr; })) out.push_back("mwe");
  if (any([](const Geometry& g) { return !g.pose_space.examples.empty(); })) out.push_back("psd");
  return out;
}

ordered_json parts(const LoadedFile& loaded) {
  ordered_json out = ordered_json::array();
  for (const Spent& spent : spent_bytes(loaded)) out.push_back({{"name", spent.on}, {"bytes", spent.bytes}});
  return out;
}

ordered_json graphs(const Actor& actor) {
  ordered_json out = ordered_json::array();
  const File& file = actor.file();
  constexpr const char* kKinds[] = {"number", "flag", "trigger"};
  for (const Graph& graph : graphs_of(actor.path(), file)) {
    ordered_json& one = out.emplace_back(
        ordered_json{{"name", graph.name}, {"parameters", ordered_json::array()}, {"machines", ordered_json::array()}});
    for (const GraphParameter& p : graph.parameters)
      one["parameters"].push_back({{"name", file.text(p.name)},
                                   {"kind", kKinds[static_cast<std::size_t>(p.kind)]},
                                   {"least", p.least},
                                   {"most", p.most},
                                   {"initial", p.initial}});
    for (const GraphNode& node : graph.nodes) {
      if (node.kind != GraphNodeKind::machine) continue;
      const GraphMachine& of = graph.machines[node.record];
      ordered_json states = ordered_json::array();
      for (std::uint32_t i = 0; i < of.state_count; ++i)
        states.push_back(file.text(graph.states[of.first_state + i].name));
      one["machines"].push_back({{"name", file.text(node.name)}, {"states", states}});
    }
  }
  return out;
}

}  // namespace

ordered_json about(Actor& actor) {
  const File& file = actor.file();
  ordered_json out = {{"clips", clips(actor)}, {"joints", joints(actor)}};
  add_meshes(file, out);
  out["parameters"] = ordered_json::array();
  const ShapeWeights shapes(file);
  for (const ExampleSpace& space : shapes.spaces())
    for (const ExampleParameter& p : space.parameters) out["parameters"].push_back(file.text(p.name));
  out["deformers"] = deformers(file);
  out["levels"] = actor.coarsest_lod() + 1;
  out["springs"] = actor.rig().has_springs();
  bool limits = false;
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s) limits |= !file.skeleton(s).limits.empty();
  out["limits"] = limits;
  out["parts"] = parts(actor.loaded());
  out["bytes"] = actor.loaded().stored_bytes;
  out["graphs"] = graphs(actor);
  return out;
}

}  // namespace marrow::tools
