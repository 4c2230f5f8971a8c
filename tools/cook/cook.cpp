// The road from an artist's file to a cooked one, stage by stage.
#include "marrow/cook.h"

#include <memory>
#include <utility>

#include "cook/build_pack.h"
#include "cook/clip/build_clips.h"
#include "cook/graph/build_graph.h"
#include "cook/learn/eigen_targets.h"
#include "cook/mesh/bind_meshes.h"
#include "cook/mesh/build_examples.h"
#include "cook/mesh/build_materials.h"
#include "cook/mesh/build_meshes.h"
#include "cook/mesh/derive_binds.h"
#include "cook/motion/build_motions.h"
#include "cook/options/exclusions.h"
#include "cook/options/options.h"
#include "cook/prepare/match_outfit.h"
#include "cook/prepare/mirrors.h"
#include "cook/prepare/prepare_scene.h"
#include "cook/read_inputs.h"
#include "cook/retarget/add_clips.h"
#include "cook/road.h"
#include "cook/roles/build_roles.h"
#include "cook/scene/morphed_meshes.h"
#include "cook/skeleton/build_details.h"
#include "cook/skeleton/build_skeletons.h"
#include "cook/write/report_scene.h"
#include "cook/write/write_scene.h"

namespace marrow::cook {
namespace {

// Prepare: the scene with all that options add to it, and the skeletons that it gets or follows.
Matched prepare(RawScene scene, const CookOptions& options, Notes& notes) {
  notes.begin(Stage::prepare);
  scene = prepare_scene(std::move(scene), options.prepare, notes);
  if (options.mesh.subdivide > 0) check_subdivision(scene, options.mesh.subdivide);
  if (options.onto) check_for(Product::outfit, options);
  scene = with_added_clips(std::move(scene), options.retarget, options.roles, notes);
  if (options.learn.eigen_targets > 0) scene = add_eigen_targets(std::move(scene), options.learn, notes);
  if (options.onto) return match_outfit(*options.onto, std::move(scene), notes);
  BuiltScene skeletons = build_skeletons(scene);
  return {std::move(scene), std::move(skeletons)};
}

// Mesh: what is drawn, once it has been learnt, and what it looks like.
BuiltMeshes make_meshes(const RawScene& scene, const CookOptions& options, BuiltScene& out, Notes& notes) {
  notes.begin(Stage::mesh);
  BuiltMeshes meshes = build_meshes(scene, out, options.mesh, options.learn, notes);
  if (options.mesh.codec != MeshCodec::none) meshes = derive_inverse_binds(out.skeletons, std::move(meshes));
  BuiltLooks looks = build_materials(scene, meshes.meshes, options.source.images, notes);
  for (std::size_t m = 0; m < looks.sections.size(); ++m) meshes.meshes[m].material_section = looks.sections[m];
  out.materials = std::move(looks.materials);
  out.images = std::move(looks.images);
  return meshes;
}

// With limits and clips, which learning and levels of detail look at.
Matched prepare_to_learn(RawScene given, const CookOptions& options, Notes& notes) {
  Matched out = prepare(std::move(given), options, notes);
  set_limits(out.scene, out.built, notes);
  set_springs(out.scene, out.built, notes);
  out.built.clips = build_raw_clips(out.scene, out.built, options.clips.additive);
  return out;
}

// A character or an outfit.
BuiltScene build_character(RawScene given, const CookOptions& options, Notes& notes) {
  auto [scene, out] = prepare_to_learn(std::move(given), options, notes);
  BuiltMeshes meshes = make_meshes(scene, options, out, notes);
  notes.begin(Stage::clip);
  const std::vector<Mesh> full = full_meshes(meshes);
  if (!out.is_outfit) find_roles(scene, full, options.roles, out, notes);  // an outfit's body has them
  out.pose_maps = make_pose_maps({scene.source, out.skeletons}, options.retarget.poses, notes);
  measure_motions(scene, full, options.motion, out, notes);
  BuiltNodes nodes = build_nodes(scene, out, options.prepare.keep, notes);
  out.clips =
      build_clips(scene, out, {distinct_views(meshes), nodes.nodes, morphed_meshes(meshes.meshes, meshes.geometries)},
                  options.clips, notes);
  out.packs_clips = options.mesh.codec != MeshCodec::none;
  out.geometries = std::move(meshes.geometries);
  out.learnt = std::move(meshes.learnt);
  out.meshes = std::move(meshes.meshes);
  out.example_spaces = build_example_spaces(options.shapes, out.meshes, notes);
  out.nodes = std::move(nodes.nodes);
  out.kept = std::move(nodes.kept);
  return std::move(out);
}

// Write: the file, and what is said of it.
Result write(const SourceFile& source, const BuiltScene& built, std::vector<Read> reads, Notes& notes) {
  notes.begin(Stage::write);
  WrittenFile written = write_scene(built, source.file);
  Result out{{}, report_scene(source, built, written, notes.warnings), std::move(reads)};
  out.file = std::move(written.bytes);
  return out;
}

}  // namespace

BuiltScene build_scene(RawScene scene, const CookOptions& options, Notes& notes) {
  scene = with_one_form_of_mirrors(std::move(scene));
  // What has no meshes and is for a character, as motion capture, can be nothing else.
  if (options.clips_only || (options.onto && scene.meshes.empty())) return build_pack(std::move(scene), options, notes);
  return build_character(std::move(scene), options, notes);
}

Result cook_scene(RawScene scene, CookOptions options, const Host& host) {
  const tools::UseWork work({host.threads, host.stop});
  Notes notes{std::move(scene.warnings), &host};
  std::vector<Read> reads = std::move(scene.reads);
  read_named_files(options, host.files, reads);
  const SourceFile source{scene.source, scene.source_bytes};
  std::vector<BuiltGraph> graphs = build_graphs(options.graphs, notes);  // a typo is told at once
  BuiltScene built = build_scene(std::move(scene), options, notes);
  warn_of_clips(options.graphs, graphs, built.clips, notes);
  built.graphs = std::move(graphs);
  return write(source, built, std::move(reads), notes);
}

namespace {

// The scene, and in `options` what it is cooked onto.
RawScene read_scene(const std::string& name, CookOptions& options, const Host& host) {
  Notes{{}, &host}.begin(Stage::read);
  RawScene scene = read_source(name, host.files, options.source);
  if (!options.skeleton_file.empty() && !options.onto)
    options.onto = std::make_shared<Character>(
        read_character(options.skeleton_file, {host.files, host.threads, {}, host.stop}, scene.reads));
  return scene;
}

bool learns(const LearnOptions& options) {
  return options.animation_space == AnimationSpace::fit || options.helpers != 0;
}

}  // namespace

Result cook_source(const std::string& name, CookOptions options, const Host& host) {
  const tools::UseWork work({host.threads, host.stop});
  RawScene scene = read_scene(name, options, host);
  return cook_scene(std::move(scene), std::move(options), host);
}

Looked look(const std::string& name, const Options& given, const Host& host) {
  const tools::UseWork work({host.threads, host.stop});
  CookOptions options = to_options(given);
  RawScene scene = read_scene(name, options, host);
  read_named_files(options, host.files, scene.reads);
  Looked out{std::move(scene.reads), {}};
  if (!learns(options.learn) || options.clips_only) return out;
  for (const MeshOnSkin& which : skinned_meshes(scene)) {
    std::size_t& vertices = out.fits.emplace_back(0);
    for (const RawPrimitive& primitive : scene.meshes[static_cast<std::size_t>(which.first)].primitives)
      vertices += primitive.positions.size();
  }
  return out;
}

void learn_fit(const std::string& name, std::size_t which, const Options& given, const Host& host) {
  const tools::UseWork work({host.threads, host.stop});
  CookOptions options = to_options(given);
  RawScene read = read_scene(name, options, host);
  Notes notes{{}, &host};
  read_named_files(options, host.files, read.reads);
  const auto [scene, built] = prepare_to_learn(with_one_form_of_mirrors(std::move(read)), options, notes);
  const std::vector<MeshOnSkin> meshes = skinned_meshes(scene);
  if (which < meshes.size()) learn_ahead(scene, built, meshes[which], options.learn, notes);
}

Result cook(const std::string& name, const Options& options, const Host& host) {
  return cook_source(name, to_options(options), host);
}

Result cook_graphs(const Options& options, const Host& host) {
  return cook_graphs(to_graph_options(options), host);
}

Result cook_graphs(CookOptions options, const Host& host) {
  const tools::UseWork work({host.threads, host.stop});
  Notes notes{{}, &host};
  std::vector<Read> reads;
  notes.begin(Stage::read);
  read_named_files(options, host.files, reads);
  BuiltScene built;
  built.graphs = build_graphs(options.graphs, notes);
  SourceFile source{options.graphs.front().file, 0};
  for (const Read& read : reads) source.bytes += read.bytes;
  return write(source, built, std::move(reads), notes);
}

}  // namespace marrow::cook
