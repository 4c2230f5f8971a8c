// The road from an artist's scene to a cooked file, stage by stage.
#include "cook/cook.h"

#include <memory>
#include <string>
#include <unordered_set>
#include <utility>

#include "common/failure.h"
#include "common/hash.h"
#include "common/load_mrw.h"
#include "cook/add_clips.h"
#include "cook/add_pose_maps.h"
#include "cook/clip/build_clips.h"
#include "cook/graph/read_graphs.h"
#include "cook/learn/eigen_targets.h"
#include "cook/mesh/build_examples.h"
#include "cook/mesh/build_materials.h"
#include "cook/mesh/build_meshes.h"
#include "cook/mesh/derive_binds.h"
#include "cook/motion/build_motions.h"
#include "cook/prepare/idle_motion.h"
#include "cook/prepare/match_outfit.h"
#include "cook/prepare/match_skeletons.h"
#include "cook/prepare/mirrors.h"
#include "cook/prepare/prepare_scene.h"
#include "cook/read_source.h"
#include "cook/retarget/mirror_clips.h"
#include "cook/retarget/retarget.h"
#include "cook/roles/build_roles.h"
#include "cook/scene/morphed_meshes.h"
#include "cook/scene/views.h"
#include "cook/skeleton/build_limits.h"
#include "cook/skeleton/build_nodes.h"
#include "cook/skeleton/build_skeletons.h"
#include "cook/skeleton/build_springs.h"
#include "cook/write/report_scene.h"
#include "cook/write/write_scene.h"

namespace marrow::cook {
namespace {

// Skeletons that no clip moves are of no use.
BuiltScene without_unmoved(BuiltScene scene) {
  std::vector<std::uint32_t> number(scene.skeletons.size(), 0);
  for (const BuiltClip& clip : scene.clips) number[clip.skeleton] = 1;
  std::uint32_t count = 0;
  for (std::size_t s = 0; s < number.size(); ++s) {
    if (number[s] == 0) continue;
    if (count != s) scene.skeletons[count] = std::move(scene.skeletons[s]);
    number[s] = count++;
  }
  scene.skeletons.resize(count);
  for (BuiltClip& clip : scene.clips) clip.skeleton = number[clip.skeleton];
  return scene;
}

void find_roles(const RawScene& scene, const std::vector<Mesh>& meshes, const CookOptions& options, BuiltScene& out,
                Notes& notes) {
  std::vector<BuiltRoles> roles = build_roles(scene, out, meshes, options.roles, notes);
  for (std::size_t s = 0; s < roles.size(); ++s) out.skeletons[s].roles = std::move(roles[s]);
}

// Clips of other rigs, for the character or for what the scene is.
Matched add_to_pack(RawScene scene, const CookOptions& options, Notes& notes) {
  if (options.onto) return only_added_clips(*options.onto, std::move(scene), options, notes);
  scene = prepare_scene(std::move(scene), options, notes);
  const Character own = character_of(scene, options.roles);
  return only_added_clips(own, std::move(scene), options, notes);
}

// Of clips that are as the source has them.
void measure_motions(const RawScene& scene, const std::vector<Mesh>& meshes, const CookOptions& options,
                     BuiltScene& out, Notes& notes) {
  std::vector<BuiltMotion> motions = build_motions(scene, out, meshes, options.motion, notes);
  for (std::size_t i = 0; i < motions.size(); ++i) out.clips[i].motion = std::move(motions[i]);
}

[[noreturn]] void refuse(const RuleOrigin& origin, const std::string& what, const std::string& advice) {
  throw tools::Failure(tools::Exit::usage, origin.file, origin.where, what, advice);
}

// A clip pack: clips and what they were made for, without the skeletons themselves and without meshes.
BuiltScene build_pack(RawScene scene, const CookOptions& options, Notes& notes) {
  BuiltScene out;
  if (!options.pose_maps.empty() && options.pose_maps[0].origin.must_fit)
    refuse(options.pose_maps[0].origin, "--pose-map for a clip pack", "give it for the character");
  if (!options.retarget.empty()) {
    Matched matched = add_to_pack(std::move(scene), options, notes);
    scene = std::move(matched.scene);
    out = std::move(matched.built);
  } else if (options.onto) {
    Matched matched = scene.is_capture ? retarget(*options.onto, std::move(scene), notes)
                                       : match_skeletons(*options.onto, std::move(scene), options.keep, notes);
    scene = std::move(matched.scene);
    out = std::move(matched.built);
  } else {
    scene = without_idle_motion(std::move(scene), options.keep, notes);
    out = build_skeletons(scene);
  }
  if (scene.clips.empty() || out.skeletons.empty())
    throw tools::Failure(tools::Exit::invalid, scene.source, "/animations", "no-clips",
                         "no animation moves a node of the scene; cook without --clips-only");
  if (options.retarget.empty()) {
    if (!options.onto) find_roles(scene, {}, options, out, notes);
    scene = with_mirrored_clips(std::move(scene), out, options.mirror);
  }
  out.is_pack = true;
  out.packs_clips = options.mesh_codec != MeshCodec::none;
  Carried carried;
  if (options.onto) {
    carried.meshes = options.onto->meshes;
    carried.morphed = options.onto->morphed;
  }
  out.clips = build_raw_clips(scene, out, options.additive);
  measure_motions(scene, carried.meshes, options, out, notes);
  out.clips = build_clips(scene, out, carried, options, notes);
  return without_unmoved(std::move(out));
}

// Tells meshes apart that differ in their vertices or in what these hang on.
std::string key_of(const BuiltMesh& mesh) {
  std::string key;
  const auto add = [&](const auto* first, std::size_t count) {
    key.append(reinterpret_cast<const char*>(first), count * sizeof *first);
  };
  add(&mesh.geometry, 1);
  add(&mesh.skeleton, 1);
  add(mesh.joints.data(), mesh.joints.size());
  add(mesh.inverse_bind.data(), mesh.inverse_bind.size());
  add(mesh.helpers.data(), mesh.helpers.size());
  add(mesh.helper_centres.data(), mesh.helper_centres.size());
  return key;
}

// Each once that moves otherwise than those before it.
std::vector<Mesh> views_of(const BuiltMeshes& built) {
  std::vector<Mesh> out;
  std::unordered_set<std::string> seen;
  for (const BuiltMesh& mesh : built.meshes) {
    if (!seen.insert(key_of(mesh)).second) continue;
    out.push_back(view(mesh, built.geometries[mesh.geometry]));
    for (const BuiltLod& lod : mesh.lods) out.push_back(view(mesh, built.geometries[lod.geometry]));
  }
  return out;
}

// Of a scene that is prepared, and what its meshes follow.
BuiltScene build_whole(const RawScene& scene, BuiltScene out, const CookOptions& options, Notes& notes) {
  std::vector<std::vector<JointLimit>> limits = build_limits(scene, out, notes);
  for (std::size_t s = 0; s < limits.size(); ++s) out.skeletons[s].limits = std::move(limits[s]);
  std::vector<BuiltSprings> springs = build_springs(scene, out, notes);
  for (std::size_t s = 0; s < springs.size(); ++s) out.skeletons[s].springs = std::move(springs[s]);
  // What learning and levels of detail look at.
  out.clips = build_raw_clips(scene, out, options.additive);
  BuiltMeshes meshes = build_meshes(scene, out, options, notes);
  if (options.mesh_codec != MeshCodec::none) meshes = derive_inverse_binds(out.skeletons, std::move(meshes));
  BuiltLooks looks = build_materials(scene, meshes.meshes, options.images, notes);
  for (std::size_t m = 0; m < looks.sections.size(); ++m) meshes.meshes[m].material_section = looks.sections[m];
  const std::vector<Mesh> full = full_meshes(meshes);
  if (!out.is_outfit) find_roles(scene, full, options, out, notes);  // an outfit's body has them
  if (!options.pose_maps.empty()) out.pose_maps = make_pose_maps({scene.source, out.skeletons}, options, notes);
  measure_motions(scene, full, options, out, notes);
  BuiltNodes nodes = build_nodes(scene, out, options.keep, notes);
  out.clips = build_clips(scene, out, {views_of(meshes), nodes.nodes, morphed_meshes(meshes.meshes, meshes.geometries)},
                          options, notes);
  out.packs_clips = options.mesh_codec != MeshCodec::none;
  out.geometries = std::move(meshes.geometries);
  out.learnt = std::move(meshes.learnt);
  out.meshes = std::move(meshes.meshes);
  out.example_spaces = build_example_spaces(options.shapes, out.meshes, notes);
  out.materials = std::move(looks.materials);
  out.images = std::move(looks.images);
  out.nodes = std::move(nodes.nodes);
  out.kept = std::move(nodes.kept);
  return out;
}

// The body plays the clips, and the clothes follow.
void refuse_for_outfit(const CookOptions& options) {
  if (!options.onto) return;
  const std::string advice = "give it for the body, or --clips-only for a clip pack";
  if (!options.retarget.empty()) refuse(options.retarget[0].origin, "--retarget for an outfit", advice);
  if (!options.mirror.empty()) refuse(options.mirror[0].origin, "--mirror for an outfit", advice);
  if (!options.pose_maps.empty())
    refuse(options.pose_maps[0].origin, "--pose-map for an outfit", "give it for the body, which poses it");
}

}  // namespace

BuiltScene build_scene(RawScene scene, const CookOptions& options, Notes& notes) {
  scene = with_one_form_of_mirrors(std::move(scene));
  // What has no meshes and is for a character, as motion capture, can be nothing else.
  if (options.clips_only || (options.onto && scene.meshes.empty())) return build_pack(std::move(scene), options, notes);
  scene = prepare_scene(std::move(scene), options, notes);
  refuse_for_outfit(options);
  scene = with_added_clips(std::move(scene), options, notes);
  if (options.learn.eigen_targets > 0) scene = add_eigen_targets(std::move(scene), options.learn, notes);
  if (!options.onto) return build_whole(scene, build_skeletons(scene), options, notes);
  Matched matched = match_outfit(*options.onto, std::move(scene), notes);
  return build_whole(matched.scene, std::move(matched.built), options, notes);
}

CookResult cook_scene(RawScene scene, const CookOptions& options) {
  Notes notes{std::move(scene.warnings), {}};
  CookResult result;
  result.reads = std::move(scene.reads);
  const SourceFile source{scene.source, scene.source_bytes};
  std::vector<BuiltGraph> graphs = read_graphs(options.graphs, notes.reads, notes);  // a typo is told at once
  BuiltScene built = build_scene(std::move(scene), options, notes);
  warn_of_clips(options.graphs, graphs, built.clips, notes);
  built.graphs = std::move(graphs);
  WrittenFile written = write_scene(built, source.file);
  result.report = report_scene(source, built, written, notes.warnings);
  result.file = std::move(written.bytes);
  // A scene in memory has none.
  if (!result.reads.empty()) result.reads.insert(result.reads.end(), notes.reads.begin(), notes.reads.end());
  return result;
}

CookResult cook_graphs(const CookOptions& options) {
  Notes notes;
  CookResult result;
  BuiltScene built;
  built.graphs = read_graphs(options.graphs, result.reads, notes);
  SourceFile source{options.graphs.front().file, 0};
  for (const RawRead& read : result.reads) source.bytes += read.bytes;
  WrittenFile written = write_scene(built, source.file);
  result.report = report_scene(source, built, written, notes.warnings);
  result.file = std::move(written.bytes);
  return result;
}

Character read_character(const std::string& path) {
  if (path.ends_with(".mrw")) {
    const auto loaded = std::make_shared<tools::LoadedFile>(tools::load_mrw(path));
    Character out = view_character(path, loaded->file);
    out.holds = loaded;
    out.hash = tools::hash_of({loaded->bytes.data(), loaded->bytes.size()});
    return out;
  }
  struct Cooked {
    tools::AlignedBytes bytes;
    File file;
  };
  CookOptions plain;
  plain.mesh_codec = MeshCodec::none;
  plain.images = Images::none;
  plain.raw_clips = true;
  const auto cooked = std::make_shared<Cooked>();
  cooked->bytes = tools::AlignedBytes(cook_file(path, plain).file);
  if (load({cooked->bytes.data(), cooked->bytes.size()}, cooked->file) != Status::ok)
    throw tools::Failure(tools::Exit::internal, path, "", "it cannot be loaded as cooked", "please report this");
  Character out = view_character(path, cooked->file);
  out.holds = cooked;
  out.hash = tools::hash_of({cooked->bytes.data(), cooked->bytes.size()});
  return out;
}

CookResult cook_file(const std::string& path, const CookOptions& options) {
  return cook_scene(read_source(path, options), options);
}

}  // namespace marrow::cook
