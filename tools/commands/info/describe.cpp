// A cooked file in words and numbers, as JSON.
#include "commands/info/describe.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "commands/info/details.h"
#include "common/failure.h"
#include "common/section_names.h"
#include "cook/write/report_scene.h"
#include "disk/files.h"
#include "gpu_cost/vertex_cost.h"
#include "marrow/clip_pack.h"
#include "marrow/version.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

// The sections of one type, in their order.
std::vector<File::Section> sections_of(const LoadedFile& loaded, const char* type) {
  std::vector<File::Section> out;
  for (const File::Section& s : loaded.stored)
    if (section_name(s.type) == type) out.push_back(s);
  return out;
}

ordered_json describe_totals(const LoadedFile& loaded) {
  ordered_json out;
  for (const Spent& spent : spent_bytes(loaded)) out[spent.on] = spent.bytes;
  return out;
}

// Of the box around the joints at rest, scene units.
double diagonal(const Character& character, std::uint32_t skeleton) {
  double squared = 0;
  for (int r = 0; r < 3; ++r) {
    float low = 0, high = 0;
    bool first = true;
    for (const Affine& joint : character.model_from_joint(skeleton)) {
      low = first ? joint.rows[r][3] : std::min(low, joint.rows[r][3]);
      high = first ? joint.rows[r][3] : std::max(high, joint.rows[r][3]);
      first = false;
    }
    squared +=
        (static_cast<double>(high) - static_cast<double>(low)) * (static_cast<double>(high) - static_cast<double>(low));
  }
  return std::sqrt(squared);
}

// Of a vertex; null: not known.
ordered_json describe_cost(const Geometry& geometry, GpuDeformer deformer) {
  const std::optional<VertexCost> cost = vertex_cost(geometry, deformer);
  if (!cost) return nullptr;
  return {{"mali_cycles", cost->mali_cycles},
          {"adreno_instructions", cost->adreno_instructions},
          {"videocore_instructions", cost->videocore_instructions}};
}

// Between which joints, and how near to the second: 0 … 1.
ordered_json describe_helpers(const File& file, const Mesh& mesh) {
  const Skeleton skeleton = file.skeleton(mesh.skeleton);
  const auto name = [&](std::uint16_t entry) { return file.text(skeleton.names[mesh.joints[entry]]); };
  ordered_json out = ordered_json::array();
  for (const Helper& h : mesh.helpers)
    out.push_back({{"first", name(h.first)}, {"second", name(h.second)}, {"share", h.share}});
  return out;
}

ordered_json describe_mesh(const File& file, const Mesh& mesh, std::size_t mesh_bytes, const File::Section& geometry,
                           bool first_of_geometry) {
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
          {"palette_entries", mesh.palette_size()},
          {"helpers", describe_helpers(file, mesh)},
          {"influences", influences},
          {"joint_sets", g.runs.size},
          {"attributes", attributes},
          {"as", g.as_residual != nullptr ? "lift + residual" : "lift"},
          {"mwe", g.mwe_residual != nullptr},
          {"pose_examples", g.pose_space.examples.size},
          {"targets", g.targets.size},
          {"source_order", !g.source_slots.empty()},
          {"next_part", mesh.is_next_part},
          {"gpu",
           {{"ssd", describe_cost(g, GpuDeformer::ssd)},
            {"as", describe_cost(g, GpuDeformer::as)},
            {"psd", describe_cost(g, GpuDeformer::psd)}}},
          {"geometry", mesh.geometry_index},
          {"codec", mesh_codec_name(geometry.codec)},
          {"bytes", mesh_bytes + (first_of_geometry ? geometry.bytes : 0)},
          {"bytes_per_vertex", static_cast<double>(geometry.bytes) / g.vertex_count}};
}

ordered_json describe_sections(const LoadedFile& loaded) {
  ordered_json out = ordered_json::array();
  for (const File::Section& s : loaded.stored)
    out.push_back({{"type", section_name(s.type)}, {"offset", s.offset}, {"bytes", s.bytes}, {"codec", s.codec}});
  return out;
}

// Of a skeleton or of a reference to one.
template <class Joints>
ordered_json describe_joints(const File& file, const Joints& s) {
  ordered_json out = ordered_json::array();
  for (std::uint32_t j = 0; j < s.joint_count; ++j)
    out.push_back(
        {{"name", file.text(s.names[j])}, {"parent", s.parents[j] == kNoJoint ? -1 : static_cast<int>(s.parents[j])}});
  return out;
}

// That swing: the last of a chain without a tip only ends it.
std::size_t spring_joints(const File& file, std::uint32_t skeleton) {
  std::size_t out = 0;
  for (std::uint32_t c = 0; c < file.spring_count(skeleton); ++c) {
    const SpringChain chain = file.spring(skeleton, c);
    const bool has_tip = chain.tip[0] != 0 || chain.tip[1] != 0 || chain.tip[2] != 0;
    out += chain.joints.size - (has_tip ? 0 : 1);
  }
  return out;
}

ordered_json describe_skeletons(const LoadedFile& loaded) {
  const File& file = loaded.file;
  const Character character(file);
  const std::vector<File::Section> sections = sections_of(loaded, "SKEL");
  ordered_json out = ordered_json::array();
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i) {
    const Skeleton s = file.skeleton(i);
    out.push_back({{"name", s.name},
                   {"joints", s.joint_count},
                   {"roots", s.root_count},
                   {"limits", s.limits.size},
                   {"spring_chains", file.spring_count(i)},
                   {"spring_joints", spring_joints(file, i)},
                   {"spring_colliders", file.spring_colliders(i).size},
                   {"roles", describe_roles(file, i)},
                   {"hash", fmt::format("{:016x}", skeleton_hash(file, i))},
                   {"diagonal_m", diagonal(character, i)},
                   {"bytes", sections[i].bytes},
                   {"joint_list", describe_joints(file, s)}});
  }
  return out;
}

ordered_json describe_pose_maps(const LoadedFile& loaded) {
  const File& file = loaded.file;
  const std::vector<File::Section> sections = sections_of(loaded, "PMAP");
  ordered_json out = ordered_json::array();
  for (std::uint32_t i = 0; i < file.pose_map_count(); ++i) {
    const PoseMap map = file.pose_map(i);
    std::size_t joints = 0;
    for (const MappedGroup& g : map.groups)
      for (const std::uint16_t joint : g.rig_joints) joints += joint != kNoJoint ? 1 : 0;
    for (const MappedTurn* t = map.turns.begin(); t != map.turns.end(); ++t)
      if (t == map.turns.begin() || t->joint != t[-1].joint) ++joints;
    out.push_back({{"name", map.name},
                   {"skeleton", map.skeleton},
                   {"joints", joints},
                   {"places", map.places.size},
                   {"rig_joints", map.rig_joint_count},
                   {"rig_hash", fmt::format("{:016x}", map.rig_hash)},
                   {"bytes", sections[i].bytes}});
  }
  return out;
}

ordered_json describe_references(const LoadedFile& loaded) {
  const File& file = loaded.file;
  const std::vector<File::Section> sections = sections_of(loaded, "SREF");
  ordered_json out = ordered_json::array();
  for (std::uint32_t i = 0; i < file.reference_count(); ++i) {
    const SkeletonReference s = file.reference(i);
    out.push_back({{"name", s.name},
                   {"joints", s.joint_count},
                   {"hash", fmt::format("{:016x}", s.hash)},
                   {"bytes", sections[i].bytes},
                   {"joint_list", describe_joints(file, s)}});
  }
  return out;
}

ordered_json describe_meshes(const LoadedFile& loaded) {
  const File& file = loaded.file;
  const std::vector<File::Section> meshes = sections_of(loaded, "MESH"), geometries = sections_of(loaded, "GEOM");
  ordered_json out = ordered_json::array();
  std::vector<bool> counted(geometries.size(), false);
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    const Mesh mesh = file.mesh(i);
    const std::uint32_t g = mesh.geometry_index;
    out.push_back(describe_mesh(file, mesh, meshes[i].bytes, geometries[g], !counted[g]));
    counted[g] = true;
    for (std::uint32_t level = 1; level <= mesh.lods.size; ++level) {
      const Geometry less = file.mesh(i, level).geometry;
      const std::uint32_t of = mesh.lods[level - 1].geometry;
      out.back()["lods"].push_back({{"vertices", less.vertex_count},
                                    {"triangles", less.index_count / 3},
                                    {"bytes", counted[of] ? 0 : geometries[of].bytes},
                                    {"error_m", mesh.lods[level - 1].error_m}});
      counted[of] = true;
    }
  }
  return out;
}

ordered_json describe_shapes(const LoadedFile& loaded) {
  const File& file = loaded.file;
  const std::vector<File::Section> sections = sections_of(loaded, "SHAP");
  ordered_json out = ordered_json::array();
  for (std::uint32_t i = 0; i < file.example_space_count(); ++i) {
    ExampleSpace space;
    check(file.example_space(i, space));
    ordered_json parameters = ordered_json::array(), targets = ordered_json::array(), meshes = ordered_json::array();
    for (const ExampleParameter& p : space.parameters)
      parameters.push_back({{"name", file.text(p.name)}, {"default", p.rest}});
    const Mesh first = file.mesh(space.meshes[0]);
    for (const std::uint32_t t : space.targets) targets.push_back(file.text(first.targets[t].name));
    for (const std::uint32_t m : space.meshes) meshes.push_back(m);
    out.push_back({{"name", space.name},
                   {"parameters", parameters},
                   {"examples", space.example_count},
                   {"targets", targets},
                   {"meshes", meshes},
                   {"bytes", sections[i].bytes}});
  }
  return out;
}

ordered_json describe_clips(const LoadedFile& loaded) {
  const File& file = loaded.file;
  const std::vector<File::Section> sections = sections_of(loaded, "CLIP");
  std::vector<ordered_json> bounds = cook::report_bounds(file, loaded.bytes);
  ordered_json out = ordered_json::array();
  for (std::uint32_t i = 0; i < file.clip_count(); ++i) {
    const Clip c = file.clip(i);
    const CodedTracks& coded = c.coded;
    ordered_json channels = ordered_json::array();
    for (const Channel& channel : c.channels) channels.push_back(file.text(channel.name));
    out.push_back({{"name", c.name},
                   {"duration_s", c.duration_s},
                   {"tracks", c.tracks.size + coded.track_count + coded.constant_count},
                   {"codec", coded.frame_count > 0 ? "segments" : "raw"},
                   {"frames", coded.frame_count},
                   {"skeleton", c.skeleton},
                   {"bytes", sections[i].bytes},
                   {"motion", describe_motion(file, file.motion(i))},
                   {"additive", c.additive},
                   {"reference", c.reference != nullptr ? "own" : "rest"},
                   {"channels", channels},
                   {"bounds", std::move(bounds[i])}});
  }
  return out;
}

struct SourceText {
  std::string json;
  std::size_t file_bytes = 0;
};

SourceText read_text(const std::string& path) {
  const AlignedBytes bytes = read_file(path);
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (!all.starts_with("glTF")) return {std::string(all), all.size()};
  std::uint32_t length = 0;
  if (all.size() >= 20) std::memcpy(&length, all.data() + 12, 4);
  if (length > all.size() - std::min<std::size_t>(all.size(), 20))
    throw Failure(Exit::invalid, path, "@12", "the JSON chunk reaches past the end", "give a whole .glb file");
  return {std::string(all.substr(20, length)), all.size()};
}

// Sizes by what they are for; each accessor and view once, for whoever asks first.
class Counter {
 public:
  explicit Counter(const ordered_json& json) : json_(json) {}

  std::size_t accessor(const ordered_json& index) {
    const ordered_json* const a = element("accessors", index);
    if (a == nullptr || !seen_.insert({0, index.get<std::size_t>()}).second) return 0;
    const std::string type = a->value("type", "");
    const std::size_t parts = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
    const int component = a->value("componentType", 0);
    const std::size_t size = component <= 5121 ? 1 : component <= 5123 ? 2 : 4;
    return a->contains("bufferView") ? a->value("count", std::size_t{0}) * parts * size : 0;
  }
  std::size_t view(const ordered_json& index) {
    const ordered_json* const v = element("bufferViews", index);
    return v != nullptr && seen_.insert({1, index.get<std::size_t>()}).second ? v->value("byteLength", std::size_t{0})
                                                                              : 0;
  }
  std::size_t primitive(const ordered_json& p) {
    const auto draco = ordered_json::json_pointer("/extensions/KHR_draco_mesh_compression/bufferView");
    if (p.contains(draco)) return view(p.at(draco));
    std::size_t sum = p.contains("indices") ? accessor(p.at("indices")) : 0;
    for (const auto& index : p.value("attributes", ordered_json::object())) sum += accessor(index);
    for (const auto& target : p.value("targets", ordered_json::array()))
      for (const auto& index : target) sum += accessor(index);
    return sum;
  }
  const ordered_json& list(const char* name) const {
    static const ordered_json none = ordered_json::array();
    const auto found = json_.find(name);
    return found != json_.end() && found->is_array() ? *found : none;
  }

 private:
  const ordered_json* element(const char* name, const ordered_json& index) const {
    const ordered_json& elements = list(name);
    if (!index.is_number_unsigned() || index.get<std::size_t>() >= elements.size()) return nullptr;
    return &elements[index.get<std::size_t>()];
  }
  const ordered_json& json_;
  std::set<std::pair<int, std::size_t>> seen_;
};

std::size_t add_bytes(ordered_json& by_name, const ordered_json& element, std::size_t bytes) {
  ordered_json& sum = by_name[element.value("name", "")];
  sum = (sum.is_null() ? 0 : sum.get<std::size_t>()) + bytes;
  return bytes;
}

ordered_json count(const ordered_json& json) {
  Counter counter(json);
  ordered_json meshes = ordered_json::object(), clips = ordered_json::object();
  std::size_t geometry = 0, skeletons = 0, animation = 0, images = 0;
  for (const auto& mesh : counter.list("meshes")) {
    std::size_t bytes = 0;
    for (const auto& p : mesh.at("primitives")) bytes += counter.primitive(p);
    geometry += add_bytes(meshes, mesh, bytes);
  }
  for (const auto& skin : counter.list("skins"))
    skeletons += counter.accessor(skin.value("inverseBindMatrices", ordered_json()));
  for (const auto& clip : counter.list("animations")) {
    std::size_t bytes = 0;
    for (const auto& s : clip.at("samplers"))
      bytes += counter.accessor(s.at("input")) + counter.accessor(s.at("output"));
    animation += add_bytes(clips, clip, bytes);
  }
  for (const auto& image : counter.list("images")) images += counter.view(image.value("bufferView", ordered_json()));
  return {{"geometry", geometry}, {"skeletons", skeletons}, {"clips", animation},
          {"images", images},     {"mesh_bytes", meshes},   {"clip_bytes", clips}};
}

}  // namespace

ordered_json describe(const std::string& path, const LoadedFile& loaded) {
  ordered_json r;
  r["file"] = path;
  r["version"] = kFileFormat;
  r["bytes"] = loaded.stored_bytes;
  r["packed"] = loaded.stored_bytes != loaded.bytes.size();
  r["totals"] = describe_totals(loaded);
  r["sections"] = describe_sections(loaded);
  r["skeletons"] = describe_skeletons(loaded);
  r["pose_maps"] = describe_pose_maps(loaded);
  r["references"] = describe_references(loaded);
  r["meshes"] = describe_meshes(loaded);
  r["shapes"] = describe_shapes(loaded);
  r["clips"] = describe_clips(loaded);
  describe_graphs(path, loaded, r);
  describe_looks(loaded.file, r);
  describe_nodes(loaded.file, r);
  return r;
}

ordered_json describe_source(const std::string& path) {
  const SourceText text = read_text(path);
  try {
    const ordered_json json = ordered_json::parse(text.json);
    ordered_json out = count(json);
    out["names_and_structure"] = text.json.size();
    out["bytes"] = text.file_bytes;
    out["file"] = path;
    return out;
  } catch (const nlohmann::json::exception&) {
    throw Failure(Exit::invalid, path, "", "not a glTF file", "give the .gltf or .glb file that was cooked");
  }
}

}  // namespace marrow::tools
