#include "cook/write/report_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "asset/format.h"
#include "asset/section_views.h"
#include "common/check_status.h"
#include "common/section_names.h"
#include "text/words.h"

namespace marrow::cook {
namespace {

using nlohmann::ordered_json;

ordered_json report_sections(const WrittenFile& written) {
  ordered_json out = ordered_json::array();
  for (const WrittenFile::Part& part : written.sections)
    out.push_back({{"type", tools::section_name(part.type)}, {"bytes", part.bytes}});
  return out;
}

ordered_json report_lods(const BuiltScene& built, const BuiltMesh& mesh, const WrittenFile& written) {
  ordered_json out = ordered_json::array();
  for (const BuiltLod& lod : mesh.lods) {
    const BuiltGeometry& geometry = built.geometries[lod.geometry];
    out.push_back({{"vertices", geometry.header.vertex_count},
                   {"triangles", geometry.header.index_count / 3},
                   {"influences", geometry.influences},
                   {"bytes", written.geometry_bytes[lod.geometry]},
                   {"rms_error_m", lod.rms_error_m},
                   {"max_error_m", lod.max_error_m}});
  }
  return out;
}

ordered_json report_learnt(const LearnReport& learnt) {
  return {{"kind", learnt.kind},
          {"truth", learnt.truth},
          {"poses", learnt.poses},
          {"made_up_poses", learnt.made_up},
          {"helpers", learnt.helpers},
          {"held_out_share", learnt.held_out_share},
          {"worse_share", learnt.worse_share}};
}

ordered_json report_deformer(const DeformerReport& learnt, double error_m) {
  return {{"shipped", learnt.shipped},
          {"truth", learnt.truth},
          {"poses", learnt.poses},
          {"made_up_poses", learnt.made_up},
          {"held_out_share", learnt.held_out_share},
          {"worse_share", learnt.worse_share},
          {"max_error_m", error_m}};
}

// What was learnt for a mesh; of what was not asked for nothing.
void report_learning(const LearnReport& learnt, const MeshError& error, double scale, ordered_json& mesh) {
  mesh["animation_space"] = report_learnt(learnt);
  if (*learnt.multi_weights.truth != '\0')
    mesh["multi_weights"] = report_deformer(learnt.multi_weights, error.multi_weight * scale);
  if (*learnt.pose_space.truth == '\0') return;
  mesh["pose_space"] = report_deformer(learnt.pose_space, error.pose_space * scale);
  mesh["pose_space"]["examples"] = learnt.pose_space.examples;
}

// Of a morph target alone, at weight 1.
double target_error_m(const BuiltMesh& mesh, const MeshError& error, std::size_t target) {
  const double at_rest = target < error.targets_rest_m.size() ? error.targets_rest_m[target] : 0;
  return std::max(error.targets[target] * mesh.scene_scale, at_rest);
}

// Where the mesh stands at rest, its morph targets weighed as then.
double rest_error_m(const BuiltMesh& mesh, const MeshError& error) {
  double more = error.bind * mesh.scene_scale;
  for (std::size_t t = 0; t < std::min(mesh.targets.size(), error.targets.size()); ++t)
    more += std::fabs(static_cast<double>(mesh.targets[t].rest)) * target_error_m(mesh, error, t);
  return std::max(error.position * mesh.scene_scale, error.rest_m) + more;
}

double worst_target_error_m(const BuiltMesh& mesh, const MeshError& error) {
  double worst = 0;
  for (std::size_t t = 0; t < error.targets.size(); ++t) worst = std::max(worst, target_error_m(mesh, error, t));
  return worst;
}

// A mesh's bytes are its own section's and, for the first mesh that uses it, its geometry's.
ordered_json report_meshes(const BuiltScene& built, const WrittenFile& written) {
  ordered_json out = ordered_json::array();
  std::vector<bool> counted(built.geometries.size(), false);
  for (std::size_t i = 0; i < built.meshes.size(); ++i) {
    const BuiltMesh& mesh = built.meshes[i];
    const BuiltGeometry& geometry = built.geometries[mesh.geometry];
    const format::GeometryHeader& h = geometry.header;
    std::size_t bytes = written.mesh_bytes[i];
    if (!counted[mesh.geometry]) bytes += written.geometry_bytes[mesh.geometry];
    counted[mesh.geometry] = true;
    out.push_back({{"name", mesh.name},
                   {"vertices", h.vertex_count},
                   {"triangles", h.index_count / 3},
                   {"influences", geometry.influences},
                   {"joints", mesh.joints.size()},
                   {"codec", tools::mesh_codec_name(geometry.codec)},
                   {"bytes", bytes},
                   {"max_position_error_m", rest_error_m(mesh, geometry.error)},
                   {"max_normal_error_deg", geometry.error.normal_deg},
                   {"max_uv_error", geometry.error.uv},
                   {"max_weight_error", geometry.error.weight},
                   {"max_target_error_m", worst_target_error_m(mesh, geometry.error)}});
    if (mesh.source_triangles > 0) out.back()["source_triangles"] = mesh.source_triangles;
    if (mesh.parts > 1)
      out.back()["split"] = {{"part", mesh.part}, {"parts", mesh.parts}, {"doubled_vertices", mesh.doubled}};
    if (!mesh.lods.empty()) out.back()["lods"] = report_lods(built, mesh, written);
    if (mesh.learnt != kNone)
      report_learning(built.learnt[static_cast<std::size_t>(mesh.learnt)], geometry.error, mesh.scene_scale,
                      out.back());
  }
  return out;
}

ordered_json report_clips(const BuiltScene& built, const WrittenFile& written) {
  File file;
  tools::check(load({written.plain.data(), written.plain.size()}, file));
  std::vector<ordered_json> bounds = report_bounds(file, written.plain);
  ordered_json out = ordered_json::array();
  for (std::size_t i = 0; i < built.clips.size(); ++i) {
    const BuiltClip& clip = built.clips[i];
    const BuiltSkeleton& skeleton = built.skeletons[clip.skeleton];
    const std::size_t joints = skeleton.parents.size();
    const std::uint64_t raw_bytes = std::uint64_t{clip.most_keys} * joints * 40, bytes = written.clip_bytes[i];
    out.push_back({{"name", clip.name},
                   {"skeleton", clip.skeleton},
                   {"duration_s", clip.duration_s},
                   {"codec", clip.coded.header.frame_count > 0 ? "segments" : "raw"},
                   {"raw_because", clip.raw_because.empty() ? ordered_json() : ordered_json(clip.raw_because)},
                   {"raw_bytes", raw_bytes},
                   {"bytes", bytes},
                   {"memory_bytes", written.clip_memory_bytes[i]},
                   {"ratio", raw_bytes > 0 ? ordered_json(static_cast<double>(bytes) / static_cast<double>(raw_bytes))
                                           : ordered_json()},
                   {"additive", clip.additive.empty() ? ordered_json() : ordered_json(clip.additive)},
                   {"channels", clip.channel_names},
                   {"max_error_m", clip.error.error_m},
                   {"max_error_joint", skeleton.joint_names[clip.error.joint]},
                   {"max_error_time_s", clip.error.time_s},
                   {"max_vertex_error_m", clip.error.vertex_error_m},
                   {"bounds", std::move(bounds[i])}});
  }
  return out;
}

void report_looks(const BuiltScene& built, ordered_json& report) {
  report["materials"] = ordered_json::array();
  for (const BuiltMaterial& m : built.materials) {
    ordered_json textures = ordered_json::array();
    for (const Texture& t : m.textures) textures.push_back({{"role", tools::word(t.role)}, {"image", t.image}});
    report["materials"].push_back({{"name", m.name}, {"alpha", tools::word(m.alpha)}, {"textures", textures}});
    if (m.unlit) report["materials"].back()["unlit"] = true;
    if (m.emissive != glm::vec3(0)) report["materials"].back()["emissive"] = {m.emissive.x, m.emissive.y, m.emissive.z};
  }
  report["images"] = ordered_json::array();
  for (const RawImage& i : built.images) {
    report["images"].push_back(
        {{"name", i.name}, {"uri", i.uri}, {"format", tools::word(i.format)}, {"bytes", i.bytes.size()}});
    if (i.fallback != kNone) report["images"].back()["fallback"] = i.fallback;
  }
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

}  // namespace

std::vector<ordered_json> report_bounds(const File& file, const tools::AlignedBytes& bytes) {
  std::vector<ordered_json> out(file.clip_count(), ordered_json::array());
  const std::size_t skeletons = file.skeleton_count();
  if (skeletons == 0) return out;  // a clip pack's clips are of references
  std::vector<std::vector<std::uint32_t>> clips(skeletons), meshes(skeletons);
  for (std::uint32_t c = 0; c < file.clip_count(); ++c) clips[file.clip(c).skeleton].push_back(c);
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) meshes[file.mesh(m).skeleton].push_back(m);
  for (const File::Section& section : file.sections()) {
    if (section.type != format::kTypes[format::kBounds]) continue;
    const std::byte* const base = bytes.data() + section.offset;
    const auto& header = *reinterpret_cast<const format::BoundsHeader*>(base);
    const auto* const codes = reinterpret_cast<const format::BoundsCodes*>(base + format::layout(header).codes);
    const std::vector<std::uint32_t>&rows = clips[header.skeleton], &columns = meshes[header.skeleton];
    for (std::size_t r = 0; r < std::min<std::size_t>(rows.size(), header.clip_count); ++r)
      for (std::size_t c = 0; c < std::min<std::size_t>(columns.size(), header.mesh_count); ++c) {
        const Bounds b = decode_bounds(codes[r * header.mesh_count + c]);
        out[rows[r]].push_back(
            {{"mesh", columns[c]}, {"box_min", b.box_min}, {"box_max", b.box_max}, {"radius_m", b.radius_m}});
      }
  }
  return out;
}

ordered_json report_scene(const SourceFile& source, const BuiltScene& built, const WrittenFile& written,
                          const std::vector<RawWarning>& warnings) {
  ordered_json r;
  r["source"] = {{"file", source.file}, {"bytes", source.bytes}};
  r["output"] = {{"bytes", written.bytes.size()}, {"sections", report_sections(written)}};
  r["clip_pack"] = built.is_pack;
  r["skeletons"] = ordered_json::array();
  for (const BuiltSkeleton& skeleton : built.skeletons) {
    const BuiltRoles& roles = skeleton.roles;
    r["skeletons"].push_back({{"name", skeleton.name},
                              {"joints", skeleton.parents.size()},
                              {"roles",
                               {{"joints", roles.roles.size()},
                                {"pairs", roles.pairs.size()},
                                {"soles", roles.soles.size()},
                                {"doubted", roles.doubted}}}});
  }
  r["meshes"] = report_meshes(built, written);
  r["clips"] = report_clips(built, written);
  report_looks(built, r);
  report_nodes(built, r);
  r["warnings"] = ordered_json::array();
  for (const RawWarning& w : warnings)
    r["warnings"].push_back({{"pointer", w.pointer}, {"rule", w.rule}, {"text", w.text}});
  return r;
}

}  // namespace marrow::cook
