#include "cook/prepare/add_skeleton.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/failure.h"
#include "cook/prepare/bind_bones.h"
#include "deform/rig/auto_skeleton.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kMostDrawn = 20'000'000;  // of all that is drawn

struct Drawn {
  deform::Positions positions;  // in the scene
  std::vector<std::uint32_t> indices;
};

// Where a mesh is drawn at rest; of a skin that does not rest in its bind pose, where its first joint puts it.
glm::dmat4 model_from_mesh(const RawScene& scene, const RawInstance& instance, const std::vector<glm::dmat4>& rest) {
  const int number = instance.skin != kNone ? instance.skin : instance.unused_skin;
  if (number != kNone) {
    const RawSkin& skin = scene.skins[to_index(number)];
    const glm::dmat4 out = rest[to_index(skin.joints.front())] * skin.inverse_bind.front();
    if (is_usable(out)) return out;
  }
  return rest[to_index(instance.node)];
}

void draw(const RawScene& scene, const RawMesh& mesh, const glm::dmat4& matrix, Drawn& out) {
  for (const RawPrimitive& primitive : mesh.primitives) {
    const std::size_t first = out.positions.size();
    if (first + primitive.positions.size() > kMostDrawn)
      throw tools::Failure(tools::Exit::unsupported, scene.source, primitive.pointer, "too-many-vertices",
                           fmt::format("--auto-skeleton takes at most {} in all", kMostDrawn));
    for (const glm::vec3& v : primitive.positions) {
      out.positions.emplace_back(matrix * glm::dvec4(glm::dvec3(v), 1));
      const glm::dvec3 far = glm::abs(out.positions.back());
      if (!(std::max({far.x, far.y, far.z}) <= kFarthestPlace))
        throw tools::Failure(tools::Exit::invalid, scene.source, primitive.pointer, "too-far-away",
                             "a vertex lies where no distance can be computed; check the nodes' scales");
    }
    for (const std::uint32_t i : primitive.indices) out.indices.push_back(static_cast<std::uint32_t>(first + i));
  }
}

void refuse(const RawScene& scene, deform::RigFailure failure, const std::string& name) {
  using deform::RigFailure;
  const auto fail = [&](const char* rule, const std::string& advice) {
    throw tools::Failure(tools::Exit::invalid, scene.source, "/meshes", rule, advice);
  };
  if (failure == RigFailure::no_room)
    fail("no-inside", "--auto-skeleton finds no room inside the meshes: close their holes, or give them thickness");
  if (failure == RigFailure::several_parts)
    fail("several-parts", "--auto-skeleton wants one body: its parts are far from one another, or there are several");
  if (failure == RigFailure::no_fit)
    fail("template-does-not-fit",
         "there is no place for some joint of " + name + ": the mesh stands upright, +Y up, and faces +Z");
}

// What hangs together by the old joints.
void strip(RawScene& scene, Notes& notes) {
  if (!scene.skins.empty())
    notes.warnings.push_back({"/skins", "skeleton-replaced", "--auto-skeleton takes the place of the file's skeleton"});
  bool dropped = false;
  for (RawClip& clip : scene.clips) {
    dropped |= !clip.channels.empty();
    clip.channels.clear();
  }
  std::erase_if(scene.clips, [](const RawClip& clip) { return clip.scalars.empty(); });
  if (dropped)
    notes.warnings.push_back({"/animations", "clips-dropped",
                              "clips of the file's own nodes are left out; cook them with --skeleton for the new "
                              "joints, which they find by name"});
  scene.skins.clear();
  scene.springs.clear();
  scene.colliders.clear();
  for (RawNode& node : scene.nodes) {
    node.limit.reset();
    node.moved_by_game = false;
  }
}

// The nodes' indices.
std::vector<int> add_joints(const deform::SkeletonTemplate& skeleton, const std::vector<glm::dvec3>& places,
                            RawScene& scene) {
  std::vector<int> node_of(skeleton.size(), kNone), out;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton[j].parent;
    RawNode node;
    node.name = skeleton[j].name;
    node.parent = parent == deform::kNoJoint ? kNone : node_of[to_index(parent)];
    node.translation = parent == deform::kNoJoint ? places[j] : places[j] - places[to_index(parent)];
    node_of[j] = static_cast<int>(scene.nodes.size());
    if (!skeleton[j].is_end) out.push_back(node_of[j]);
    scene.nodes.push_back(std::move(node));
  }
  return out;
}

}  // namespace

RiggedScene add_skeleton(RawScene scene, const std::string& name, const deform::SkeletonTemplate& skeleton,
                         Notes& notes) {
  const std::vector<glm::dmat4> rest = rest_of_nodes(scene);
  RiggedScene out;
  Drawn drawn;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const RawInstance& instance = scene.instances[i];
    const RawMesh& mesh = scene.meshes[to_index(instance.mesh)];
    if (!scene.nodes[to_index(instance.node)].in_scene || mesh.primitives.empty()) continue;
    out.made.instances.push_back(i);
    out.made.model_from_mesh.push_back(model_from_mesh(scene, instance, rest));
    draw(scene, mesh, out.made.model_from_mesh.back(), drawn);
  }
  if (out.made.instances.empty())
    throw tools::Failure(tools::Exit::invalid, scene.source, "/meshes", "no-meshes",
                         "--auto-skeleton needs a mesh that the scene draws");
  const deform::AutoSkeleton made = deform::auto_skeleton(drawn.positions, drawn.indices, skeleton);
  refuse(scene, made.failure, name);
  strip(scene, notes);
  for (RawInstance& instance : scene.instances) instance.skin = instance.unused_skin = kNone;
  out.made.joints = add_joints(skeleton, made.places, scene);
  notes.warnings.push_back(
      {"/nodes", "skeleton-made",
       fmt::format("{} joints of {}, put into {} spheres of {} x {} x {} voxels", out.made.joints.size(), name,
                   made.spheres, made.voxels.x, made.voxels.y, made.voxels.z)});
  out.scene = std::move(scene);
  return out;
}

}  // namespace marrow::cook
