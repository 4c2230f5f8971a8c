#include "cook/build.h"

#include <algorithm>

#include "common/failure.h"
#include "common/parallel.h"
#include "common/pattern.h"
#include "cook/clip/compress.h"

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

// A file may be a library: meshes that no node draws. Each is hung on a node of its own then.
void place_unplaced_meshes(RawScene& scene) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    RawNode node;
    node.name = scene.meshes[i].name;
    scene.instances.push_back({static_cast<int>(scene.nodes.size()), static_cast<int>(i), kNone});
    scene.nodes.push_back(node);
  }
  if (!scene.meshes.empty())
    scene.warnings.push_back({"/nodes", "meshes-without-nodes", "no node draws a mesh; each is placed at the origin"});
}

bool has_triangles(const RawScene& scene) {
  return std::any_of(scene.instances.begin(), scene.instances.end(), [&](const RawInstance& instance) {
    return !scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives.empty();
  });
}

// A unit that is clearly not the metre makes skeletons of 20 m or 20 cm; then what a person of 2 m would get is scaled.
Promise make_promise(const BuiltSkeleton& skeleton, const Rig& rig, const CookOptions& options,
                     std::vector<RawWarning>& warnings) {
  constexpr double kPerson = 2.0;
  Promise promise;
  const double size = rig.diagonal_m > 0 ? rig.diagonal_m : kPerson;  // one joint has no extent
  const double scale = size < 0.2 || size > 20 ? size / kPerson : 1.0;
  promise.shell *= scale;
  promise.error.resize(rig.size());
  for (const ClipErrorRule& rule : options.clip_error) {
    std::size_t found = 0;
    for (std::size_t j = 0; j < rig.size(); ++j) {
      if (!rule.joints.empty() && !tools::fits(rule.joints, skeleton.joint_names[j])) continue;
      promise.error[j] = rule.error * (rule.is_share ? size : scale);
      ++found;
    }
    if (found == 0 && !rule.origin.must_fit)
      warnings.push_back({"/nodes", "rule-fits-nothing", "clip-error: no joint is called \"" + rule.joints + "\""});
    if (found == 0 && rule.origin.must_fit)
      throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where,
                           "no joint is called \"" + rule.joints + "\"",
                           "give JOINT=E with names as `marrow info --json` lists them");
  }
  return promise;
}

}  // namespace

BuiltScene build_scene(RawScene& scene, const CookOptions& options) {
  BuiltScene out;
  if (scene.instances.empty()) place_unplaced_meshes(scene);
  if (scene.instances.empty())
    throw tools::Failure(tools::Exit::invalid, scene.source, "/meshes", "no-meshes", "the file has no mesh to cook");
  if (!has_triangles(scene))
    throw tools::Failure(tools::Exit::invalid, scene.source, "/meshes", "no-triangles",
                         "no mesh in the scene has triangles to cook");
  out.skeleton = build_skeleton(scene);
  for (const RawClip& clip : scene.clips) out.clips.push_back(build_clip(clip, out.skeleton));
  const std::vector<AdditiveReference> references = additive_references(out, options.additive, scene.warnings);
  if (!options.raw_clips) {
    const Rig rig(out.skeleton);
    const Promise promise = make_promise(out.skeleton, rig, options, scene.warnings);
    tools::for_each_in_parallel(out.clips.size(),
                                [&](std::size_t i) { compress_clip(out.clips[i], out.skeleton, rig, promise); });
  }
  for (std::size_t i = 0; i < out.clips.size(); ++i) {
    add_channels(scene.clips[i], options.raw_clips, out.clips[i]);
    out.clips[i].additive = references[i].name;
    out.clips[i].reference = references[i].pose;
  }
  build_meshes(scene, options, out);
  return out;
}

}  // namespace marrow::cook
