#include "info/info.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/load_mrw.h"
#include "info/looks.h"
#include "marrow/clip_pack.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

std::string type_name(std::uint32_t type) {
  std::string name;
  for (int i = 0; i < 4; ++i) name += static_cast<char>(type >> (8 * i) & 0xFF);
  return name;
}

ordered_json describe_mesh(const Mesh& mesh) {
  std::uint32_t influences = 0;
  for (const Run& run : mesh.geometry.runs) influences = std::max(influences, run.influences);
  const Geometry& g = mesh.geometry;
  ordered_json attributes = ordered_json::array({"position"});
  if (g.normals != nullptr) attributes.push_back("normal");
  if (g.tangents != nullptr) attributes.push_back("tangent");
  if (g.uvs != nullptr) attributes.push_back("uv");
  if (g.colours != nullptr) attributes.push_back("colour");
  return {{"name", mesh.name},
          {"material", mesh.material},
          {"skeleton", mesh.skeleton},
          {"vertices", g.vertex_count},
          {"slots", g.slot_count},
          {"triangles", g.index_count / 3},
          {"joints", mesh.joint_count},
          {"influences", influences},
          {"joint_sets", g.runs.size},
          {"attributes", attributes},
          {"as", g.as_residual != nullptr ? "lift + residual" : "lift"},
          {"targets", g.targets.size},
          {"source_order", !g.source_slots.empty()},
          {"geometry", mesh.geometry_index},
          {"codec", "none"}};
}

ordered_json describe(const std::string& path, const LoadedFile& loaded) {
  const File& file = loaded.file;
  ordered_json r;
  r["file"] = path;
  r["version"] = 1;
  r["bytes"] = loaded.bytes.size();
  r["sections"] = ordered_json::array();
  for (const File::Section& s : file.sections())
    r["sections"].push_back(
        {{"type", type_name(s.type)}, {"offset", s.offset}, {"bytes", s.bytes}, {"codec", s.codec}});
  r["skeletons"] = ordered_json::array();
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i) {
    const Skeleton s = file.skeleton(i);
    ordered_json joints = ordered_json::array();
    for (std::uint32_t j = 0; j < s.joint_count; ++j)
      joints.push_back({{"name", file.text(s.names[j])},
                        {"parent", s.parents[j] == kNoParent ? -1 : static_cast<int>(s.parents[j])}});
    r["skeletons"].push_back({{"name", s.name},
                              {"joints", s.joint_count},
                              {"roots", s.root_count},
                              {"hash", fmt::format("{:016x}", skeleton_hash(file, i))},
                              {"joint_list", joints}});
  }
  r["references"] = ordered_json::array();
  for (std::uint32_t i = 0; i < file.reference_count(); ++i) {
    const SkeletonReference s = file.reference(i);
    ordered_json joints = ordered_json::array();
    for (std::uint32_t j = 0; j < s.joint_count; ++j)
      joints.push_back({{"name", file.text(s.names[j])},
                        {"parent", s.parents[j] == kNoParent ? -1 : static_cast<int>(s.parents[j])}});
    r["references"].push_back({{"name", s.name},
                               {"joints", s.joint_count},
                               {"hash", fmt::format("{:016x}", s.hash)},
                               {"joint_list", joints}});
  }
  r["meshes"] = ordered_json::array();
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) r["meshes"].push_back(describe_mesh(file.mesh(i)));
  r["clips"] = ordered_json::array();
  for (std::uint32_t i = 0; i < file.clip_count(); ++i) {
    const Clip c = file.clip(i);
    const CodedTracks& coded = c.coded;
    ordered_json channels = ordered_json::array();
    for (const Channel& channel : c.channels) channels.push_back(file.text(channel.name));
    r["clips"].push_back({{"name", c.name},
                          {"skeleton", c.skeleton},
                          {"duration_s", c.duration_s},
                          {"tracks", c.tracks.size + coded.track_count + coded.constant_count},
                          {"codec", coded.frame_count > 0 ? "segments" : "raw"},
                          {"frames", coded.frame_count},
                          {"additive", c.additive},
                          {"reference", c.reference != nullptr ? "own" : "rest"},
                          {"channels", channels}});
  }
  describe_looks(file, r);
  describe_nodes(file, r);
  return r;
}

void print(const ordered_json& r) {
  const auto text = [](const ordered_json& value) { return value.get<std::string>(); };
  fmt::print("{}: format version {}, {} bytes\n", text(r["file"]), r["version"].get<int>(),
             r["bytes"].get<std::size_t>());
  for (const auto& s : r["skeletons"])
    fmt::print("skeleton \"{}\": {} joints, {} roots\n", text(s["name"]), s["joints"].get<int>(),
               s["roots"].get<int>());
  for (const auto& s : r["references"])
    fmt::print("clip pack for skeleton \"{}\": {} joints, hash {}\n", text(s["name"]), s["joints"].get<int>(),
               text(s["hash"]));
  // Which skeleton, where there are several.
  const bool several = r["skeletons"].size() + r["references"].size() > 1;
  const auto of_skeleton = [&](const ordered_json& o) {
    return several ? fmt::format(", skeleton {}", o["skeleton"].get<int>()) : std::string();
  };
  for (std::size_t i = 0; i < r["clips"].size(); ++i) {
    const auto& c = r["clips"][i];
    const char* const kind = !c["additive"].get<bool>()       ? ""
                             : text(c["reference"]) == "rest" ? ", additive over the rest pose"
                                                              : ", additive over a reference of its own";
    fmt::print("clip {} \"{}\": {:.3f} s, {} tracks, {}{}{}\n", i, text(c["name"]), c["duration_s"].get<double>(),
               c["tracks"].get<int>(), text(c["codec"]), kind, of_skeleton(c));
    for (const auto& channel : c["channels"]) fmt::print("  channel \"{}\"\n", text(channel));
  }
  for (std::size_t i = 0; i < r["meshes"].size(); ++i) {
    const auto& m = r["meshes"][i];
    fmt::print("mesh {} \"{}\": {} vertices in {} slots, {} triangles, {} joints, {} influences in {} sets, {}{}{}\n", i,
               text(m["name"]), m["vertices"].get<int>(), m["slots"].get<int>(), m["triangles"].get<int>(),
               m["joints"].get<int>(), m["influences"].get<int>(), m["joint_sets"].get<int>(), text(m["as"]),
               m["targets"].get<int>() > 0 ? fmt::format(", {} morph targets", m["targets"].get<int>()) : "",
               of_skeleton(m));
  }
  print_looks(r);
  print_nodes(r);
  for (const auto& s : r["sections"])
    fmt::print("section {} at {}: {} bytes\n", text(s["type"]), s["offset"].get<int>(), s["bytes"].get<int>());
}

}  // namespace

void run_info(const InfoArguments& a) {
  const ordered_json description = describe(a.in, load_mrw(a.in));
  if (a.json) {
    fmt::print("{}\n", description.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    print(description);
  }
}

}  // namespace marrow::tools
