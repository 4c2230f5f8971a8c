#include "cook/build.h"

#include <algorithm>
#include <map>

#include "common/failure.h"
#include "common/parallel.h"
#include "common/pattern.h"
#include "cook/clip/compress/compress_clip.h"
#include "cook/mesh/subdivide_mesh.h"
#include "cook/prepare/bind_weights.h"
#include "cook/skeleton/group_trees.h"
#include "cook/write/compact.h"

namespace marrow::cook {

glm::dmat4 local_matrix(const RawNode& node) {
  glm::dmat4 m = glm::mat4_cast(node.rotation);
  for (int axis = 0; axis < 3; ++axis) m[axis] *= node.scale[axis];
  m[3] = glm::dvec4(node.translation, 1.0);
  return m;
}

Affine to_affine(const glm::dmat4& m) {
  Affine a;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) a.rows[row][column] = static_cast<float>(m[column][row]);
  return a;
}

namespace {

constexpr double kPerson = 2.0;  // metres

// A file may be a library: meshes that no node draws. Each is hung on a node of its own then.
void place_unplaced_meshes(RawScene& scene) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    RawNode node;
    node.name = scene.meshes[i].name;
    scene.instances.push_back(
        {static_cast<int>(scene.nodes.size()), static_cast<int>(i), kNone, scene.meshes[i].weights, kNone});
    scene.nodes.push_back(node);
  }
  if (!scene.meshes.empty())
    scene.warnings.push_back({"/nodes", "meshes-without-nodes", "no node draws a mesh; each is placed at the origin"});
}

// Nodes that would be joints in a file without meshes.
bool has_joints(const RawScene& scene) {
  return !skins_in_use(scene).empty() || std::ranges::any_of(scene.clips, [&](const RawClip& clip) {
    return std::ranges::any_of(clip.channels, [&](const RawChannel& channel) {
      return scene.nodes[static_cast<std::size_t>(channel.node)].in_scene;
    });
  });
}

bool has_triangles(const RawScene& scene) {
  return std::any_of(scene.instances.begin(), scene.instances.end(), [&](const RawInstance& instance) {
    return !scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives.empty();
  });
}

// What a person of 2 m would get, scaled where the unit is clearly not the metre: `largest` skeleton of the file is
// over 20 or under 0.2 across.
Promise make_promise(const BuiltSkeleton& skeleton, const Rig& rig, double largest, const CookOptions& options) {
  const double scale = largest < 0.2 || largest > 20 ? largest / kPerson : 1.0;
  const double size = rig.diagonal_m > 0 ? rig.diagonal_m : largest;  // one joint has no extent
  Promise promise;
  promise.shell *= scale;
  promise.error.resize(rig.size());
  for (const ClipErrorRule& rule : options.clip_error)
    for (std::size_t j = 0; j < rig.size(); ++j)
      if (rule.joints.empty() || tools::fits(rule.joints, skeleton.joint_names[j]))
        promise.error[j] = rule.error * (rule.is_share ? size : scale);
  return promise;
}

void check_clip_error_rules(const BuiltScene& scene, const CookOptions& options, std::vector<RawWarning>& warnings) {
  for (const ClipErrorRule& rule : options.clip_error) {
    const auto fits = [&](const std::string& joint) { return tools::fits(rule.joints, joint); };
    const bool found = rule.joints.empty() || std::ranges::any_of(scene.skeletons, [&](const BuiltSkeleton& skeleton) {
                         return std::ranges::any_of(skeleton.joint_names, fits);
                       });
    if (!found && !rule.origin.must_fit)
      warnings.push_back({"/nodes", "rule-fits-nothing", "clip-error: no joint is called \"" + rule.joints + "\""});
    if (!found && rule.origin.must_fit)
      throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where,
                           "no joint is called \"" + rule.joints + "\"",
                           "give JOINT=E with names as `marrow info --json` lists them");
  }
}

void compress_clips(const CookOptions& options, BuiltScene& scene, std::vector<RawWarning>& warnings) {
  check_clip_error_rules(scene, options, warnings);
  std::map<std::uint32_t, Rig> rigs;
  for (const BuiltClip& clip : scene.clips) rigs.try_emplace(clip.skeleton, scene.skeletons[clip.skeleton]);
  double largest = 0;
  for (const auto& [skeleton, rig] : rigs) largest = std::max(largest, rig.diagonal_m);
  if (!(largest > 0)) largest = kPerson;
  std::map<std::uint32_t, Promise> promises;
  for (const auto& [skeleton, rig] : rigs)
    promises.emplace(skeleton, make_promise(scene.skeletons[skeleton], rig, largest, options));
  tools::for_each_in_parallel(scene.clips.size(), [&](std::size_t i) {
    const std::uint32_t skeleton = scene.clips[i].skeleton;
    compress_clip(scene.clips[i], scene.skeletons[skeleton], rigs.at(skeleton), promises.at(skeleton));
  });
}

}  // namespace

void build_clips(RawScene& scene, const CookOptions& options, BuiltScene& out) {
  const std::vector<ClipPart> parts = split_clips(scene, out);
  for (const ClipPart& part : parts) {
    out.clips.push_back(build_clip(part.clip, out.joint_of_node));
    out.clips.back().skeleton = part.skeleton;
    out.clips.back().duration_s = part.duration_s;
  }
  const std::vector<AdditiveReference> references = additive_references(out, options.additive, scene.warnings);
  if (!options.raw_clips) compress_clips(options, out, scene.warnings);
  for (std::size_t i = 0; i < out.clips.size(); ++i) {
    add_channels(parts[i].clip, options.raw_clips, out.clips[i]);
    out.clips[i].additive = references[i].name;
    out.clips[i].reference = references[i].pose;
  }
}

BuiltScene build_scene(RawScene& scene, const CookOptions& options) {
  if (options.clips_only) return build_pack(scene, options);
  BuiltScene out;
  if (scene.instances.empty()) place_unplaced_meshes(scene);
  if (options.weights.any()) bind_weights(scene, options.weights);
  if (scene.instances.empty() && !has_joints(scene))
    throw tools::Failure(tools::Exit::invalid, scene.source, "/meshes", "no-meshes",
                         "the file has no mesh, no skin and no node that moves");
  if (scene.instances.empty()) {
    scene.warnings.push_back(
        {"/meshes", "no-meshes", "only skeletons and clips are cooked; --clips-only makes a clip pack of them"});
  } else if (!has_triangles(scene))
    throw tools::Failure(tools::Exit::invalid, scene.source, "/meshes", "no-triangles",
                         "no mesh in the scene has triangles to cook");
  if (options.subdivide > 0) check_subdivision(scene, options.subdivide);
  build_skeletons(scene, out);
  build_limits(scene, out);
  build_clips(scene, options, out);
  build_meshes(scene, options, out);
  if (options.mesh_codec != MeshCodec::none) derive_inverse_binds(out);
  build_materials(scene, options.images, out);
  build_nodes(scene, options.keep, out);
  return out;
}

}  // namespace marrow::cook
