// Which meshes get weights, from which joints. The scene that is changed here is the new one.
#include "cook/prepare/bind_weights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "common/failure.h"
#include "cook/paint/paint_weights.h"
#include "cook/prepare/bind_bones.h"
#include "deform/weights/auto_weights.h"
#include "deform/weights/edit_weights.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kMostVertices = 20'000'000;  // that are bound, and that copies of meshes may have
constexpr std::size_t kMostSkins = 1000;           // that are made
constexpr std::size_t kMadeInfluences = 4;
constexpr double kRestSlack = 1e-3;  // of a matrix's entries, shares of the largest

// Meshes that are bound together, in one space.
struct Group {
  std::vector<std::size_t> instances;
  std::vector<glm::dmat4> space_from_mesh;  // one an instance
  std::vector<deform::Bone> bones;
};

bool lacks_weights(const RawMesh& mesh) {
  return std::ranges::any_of(mesh.primitives, [](const RawPrimitive& p) { return p.influences.empty(); });
}

bool has_weights(const RawMesh& mesh) {
  return std::ranges::any_of(mesh.primitives, [](const RawPrimitive& p) { return !p.influences.empty(); });
}

// Why meshes were left as they are, for a message when all were.
struct Left {
  std::size_t weighted = 0, moving = 0, many_skins = 0, no_joints = 0;
};

// Nodes that clips move, in the scene.
std::vector<char> moved_nodes(const RawScene& scene) {
  std::vector<char> moved(scene.nodes.size(), 0);
  for (const RawClip& clip : scene.clips)
    for (const RawChannel& channel : clip.channels)
      if (scene.nodes[to_index(channel.node)].in_scene) moved[to_index(channel.node)] = 1;
  return moved;
}

// Nodes at or below one that is a joint or moved.
std::vector<char> moving_nodes(const RawScene& scene) {
  std::vector<char> moving = moved_nodes(scene), out;
  for (const RawSkin& skin : scene.skins)
    for (const int joint : skin.joints) moving[to_index(joint)] = 1;
  for (const std::size_t n : nearest_known(scene, moving)) out.push_back(moving[n]);
  return out;
}

// What a skin draws is then as if it had come without weights.
void forget_weights(RawScene& scene) {
  for (const RawInstance& instance : scene.instances) {
    if (instance.skin == kNone || !scene.nodes[to_index(instance.node)].in_scene) continue;
    for (RawPrimitive& primitive : scene.meshes[to_index(instance.mesh)].primitives) primitive.influences.clear();
  }
}

// Meshes that have a skin in the file: in the skin's mesh space.
void add_skin_groups(RawScene& scene, std::vector<Group>& groups) {
  std::map<int, Group> by_skin;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    RawInstance& instance = scene.instances[i];
    const int skin = instance.skin != kNone ? instance.skin : instance.unused_skin;
    if (skin == kNone || !scene.nodes[to_index(instance.node)].in_scene ||
        !lacks_weights(scene.meshes[to_index(instance.mesh)]))
      continue;
    by_skin[skin].instances.push_back(i);
    by_skin[skin].space_from_mesh.emplace_back(1.0);
  }
  for (auto& [number, group] : by_skin) {
    const RawSkin& skin = scene.skins[to_index(number)];
    std::vector<glm::dmat4> mesh_from_joint;
    for (const glm::dmat4& m : skin.inverse_bind) mesh_from_joint.push_back(glm::inverse(m));
    group.bones = bones_of(scene, skin.joints, mesh_from_joint);
    if (group.bones.empty())
      throw tools::Failure(tools::Exit::invalid, scene.source, "/skins/" + std::to_string(number), "no-bones",
                           "none of its inverse bind matrices can be inverted; export the skin again");
    for (const std::size_t i : group.instances) scene.instances[i].skin = number;
    groups.push_back(std::move(group));
  }
}

// The joints for meshes that have no skin, as the file's only one or what clips move; none if it is not clear.
std::vector<int> free_joints(const RawScene& scene, const std::vector<glm::dmat4>& rest, Left& left) {
  if (scene.skins.size() > 1) ++left.many_skins;
  if (scene.skins.size() > 1) return {};
  std::vector<int> joints;
  if (scene.skins.size() == 1) {
    for (const int joint : scene.skins.front().joints)
      if (scene.nodes[to_index(joint)].in_scene) joints.push_back(joint);
  } else {
    std::vector<char> moved = moved_nodes(scene);
    for (const RawInstance& instance : scene.instances) moved[to_index(instance.node)] = 0;
    for (std::size_t n = 0; n < moved.size(); ++n)
      if (moved[n] != 0) joints.push_back(static_cast<int>(n));
  }
  std::erase_if(joints, [&](int joint) { return !is_usable(rest[to_index(joint)]); });
  if (joints.empty()) ++left.no_joints;
  return joints;
}

// Where the skin puts its meshes at rest is the same for all joints in the bind pose only.
bool rests_in_bind_pose(const RawSkin& skin, const std::vector<glm::dmat4>& rest) {
  const glm::dmat4 first = rest[to_index(skin.joints.front())] * skin.inverse_bind.front();
  for (std::size_t j = 1; j < skin.joints.size(); ++j) {
    const glm::dmat4 other = rest[to_index(skin.joints[j])] * skin.inverse_bind[j];
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r)
        if (!(std::abs(other[c][r] - first[c][r]) <= kRestSlack * (1 + std::abs(first[c][r])))) return false;
  }
  return true;
}

// Instances get skins that leave them where they are at rest; the group is in the scene's space.
Group bound_to(const MadeSkeleton& skeleton, const std::string& name, const std::vector<glm::dmat4>& rest,
               RawScene& scene) {
  Group group;
  std::vector<glm::dmat4> model_from_joint;
  for (const int joint : skeleton.joints) model_from_joint.push_back(rest[to_index(joint)]);
  group.bones = bones_of(scene, skeleton.joints, model_from_joint);
  group.instances = skeleton.instances;
  group.space_from_mesh = skeleton.model_from_mesh;
  for (std::size_t i = 0; i < skeleton.instances.size(); ++i) {
    RawSkin skin{name, skeleton.joints, {}};
    for (const glm::dmat4& m : model_from_joint)
      skin.inverse_bind.push_back(glm::inverse(m) * skeleton.model_from_mesh[i]);
    scene.instances[skeleton.instances[i]].skin = static_cast<int>(scene.skins.size());
    scene.skins.push_back(std::move(skin));
  }
  return group;
}

void expect_few(const RawScene& scene, std::size_t instances) {
  if (instances > kMostSkins)
    throw tools::Failure(tools::Exit::unsupported, scene.source, "/nodes", "too-many-meshes",
                         fmt::format("{} would be bound; the most is {}", instances, kMostSkins));
}

// Meshes that have none: in the scene's space, each with a skin of its own that leaves it where it is at rest.
void add_free_group(RawScene& scene, std::vector<Group>& groups, Left& left, Notes& notes) {
  const std::vector<char> moving = moving_nodes(scene);
  std::vector<std::size_t> instances;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const RawInstance& instance = scene.instances[i];
    const RawMesh& mesh = scene.meshes[to_index(instance.mesh)];
    if (!scene.nodes[to_index(instance.node)].in_scene || mesh.primitives.empty()) continue;
    if (instance.unused_skin != kNone || (instance.skin != kNone && lacks_weights(mesh))) continue;
    const bool weighted = has_weights(mesh), moves = moving[to_index(instance.node)] != 0;
    left.weighted += weighted;
    left.moving += !weighted && moves;
    if (!weighted && !moves) instances.push_back(i);
  }
  if (instances.empty()) return;
  const std::vector<glm::dmat4> rest = rest_of_nodes(scene);
  const std::vector<int> joints = free_joints(scene, rest, left);
  if (joints.empty()) return;
  expect_few(scene, instances.size());
  if (scene.skins.size() == 1 && !rests_in_bind_pose(scene.skins.front(), rest))
    notes.warnings.push_back({"/skins/0", "bound-at-rest",
                              "the nodes do not rest in the skin's bind pose; meshes without a skin are bound as they "
                              "rest"});
  MadeSkeleton skeleton{joints, instances, {}};
  for (const std::size_t i : instances) skeleton.model_from_mesh.push_back(rest[to_index(scene.instances[i].node)]);
  groups.push_back(bound_to(skeleton, scene.skins.empty() ? "" : scene.skins.front().name, rest, scene));
}

std::size_t vertices_of(const RawMesh& mesh) {
  std::size_t count = 0;
  for (const RawPrimitive& primitive : mesh.primitives) count += primitive.positions.size();
  return count;
}

// A mesh that is drawn with several skins becomes several, as weights belong to joints of one.
void separate_meshes(RawScene& scene) {
  std::map<int, int> first_skin;              // of a mesh
  std::map<std::pair<int, int>, int> copies;  // of a mesh, for a skin
  std::size_t copied = 0;
  for (RawInstance& instance : scene.instances) {
    if (instance.skin == kNone) continue;
    if (first_skin.try_emplace(instance.mesh, instance.skin).first->second == instance.skin) continue;
    const auto [copy, is_new] =
        copies.try_emplace({instance.mesh, instance.skin}, static_cast<int>(scene.meshes.size()));
    if (is_new) {
      copied += vertices_of(scene.meshes[to_index(instance.mesh)]);
      if (copied > kMostVertices)
        throw tools::Failure(tools::Exit::unsupported, scene.source, "/meshes/" + std::to_string(instance.mesh),
                             "too-many-skins", "each skin needs a copy of the mesh; draw it with fewer");
      scene.meshes.push_back(RawMesh(scene.meshes[to_index(instance.mesh)]));
    }
    instance.mesh = copy->second;
  }
}

// "/meshes/2" of its primitives' pointers.
std::string pointer_of(const RawMesh& mesh) {
  if (mesh.primitives.empty()) return "/meshes";
  const std::string& pointer = mesh.primitives.front().pointer;
  return pointer.substr(0, pointer.find("/primitives"));
}

struct Bound {
  std::size_t vertices, unlit, unreached;
};

void say_bound(const RawMesh& mesh, const std::string& how, const Bound& bound, Notes& notes) {
  const auto [vertices, unlit, unreached] = bound;
  std::string text = fmt::format("{} vertices got weights, {}", vertices, how);
  if (unlit > 0) text += fmt::format("; no bone lights {} of them, which go by geodesic distance", unlit);
  if (unreached > 0)
    text += fmt::format("; no way through the mesh leads to {} of them, which go by plain distance", unreached);
  notes.warnings.push_back({pointer_of(mesh), "weights-made", text});
}

// What is bound of a group: primitives without weights, each mesh once.
struct Slot {
  std::size_t mesh, primitive;
  std::size_t first;  // of its vertices, in the group's
};

std::vector<Slot> gather(const RawScene& scene, const Group& group, deform::Positions& positions,
                         std::vector<std::uint32_t>& indices) {
  std::vector<Slot> slots;
  std::set<int> seen;
  for (std::size_t g = 0; g < group.instances.size(); ++g) {
    const int number = scene.instances[group.instances[g]].mesh;
    const RawMesh& mesh = scene.meshes[to_index(number)];
    if (!seen.insert(number).second) continue;
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const RawPrimitive& primitive = mesh.primitives[p];
      if (!primitive.influences.empty()) continue;
      const std::size_t first = positions.size();
      if (first + primitive.positions.size() > kMostVertices)
        throw tools::Failure(tools::Exit::unsupported, scene.source, primitive.pointer, "too-many-vertices",
                             fmt::format("--auto-weights takes at most {} in all", kMostVertices));
      slots.push_back({to_index(number), p, first});
      for (const glm::vec3& v : primitive.positions) {
        positions.emplace_back(group.space_from_mesh[g] * glm::dvec4(glm::dvec3(v), 1));
        const glm::dvec3 far = glm::abs(positions.back());
        if (!(std::max({far.x, far.y, far.z}) <= kFarthestPlace))
          throw tools::Failure(tools::Exit::invalid, scene.source, primitive.pointer, "too-far-away",
                               "a vertex lies where no distance can be computed; check the nodes' scales");
      }
      for (const std::uint32_t i : primitive.indices) indices.push_back(static_cast<std::uint32_t>(first + i));
    }
  }
  return slots;
}

std::vector<RawInfluence> to_raw(const std::vector<deform::Influence>& influences) {
  std::vector<RawInfluence> out;
  for (const deform::Influence& i : influences) out.push_back({i.joint, static_cast<float>(i.weight)});
  return out;
}

std::string how_of(deform::WeightMethod method, const deform::AutoWeights& made) {
  if (method == deform::WeightMethod::nearest) return "by the nearest bones";
  if (method == deform::WeightMethod::gaussian) return "by a Gaussian of the distance to bones";
  return fmt::format("by {} through {} x {} x {} voxels",
                     method == deform::WeightMethod::glow ? "the light of bones" : "geodesic distance to bones",
                     made.voxels.x, made.voxels.y, made.voxels.z);
}

using Made = std::set<std::pair<std::size_t, std::size_t>>;  // mesh, primitive

void bind(RawScene& scene, const Group& group, deform::WeightMethod method, Made& done, Notes& notes) {
  deform::Positions positions;
  std::vector<std::uint32_t> indices;
  const std::vector<Slot> slots = gather(scene, group, positions, indices);
  const deform::AutoWeights made =
      deform::auto_weights(positions, indices, group.bones, {.method = method, .most = kMadeInfluences});
  for (std::size_t s = 0; s < slots.size();) {
    RawMesh& mesh = scene.meshes[slots[s].mesh];
    const std::size_t first = slots[s].first;
    std::size_t end = first;
    for (const std::size_t number = slots[s].mesh; s < slots.size() && slots[s].mesh == number; ++s) {
      RawPrimitive& primitive = mesh.primitives[slots[s].primitive];
      for (std::size_t v = 0; v < primitive.positions.size(); ++v, ++end)
        primitive.influences.push_back(to_raw(made.influences[end]));
      done.emplace(number, slots[s].primitive);
    }
    const auto among = [&](const std::vector<std::size_t>& vertices) {
      const auto own = [&](std::size_t v) { return v >= first && v < end; };
      return static_cast<std::size_t>(std::ranges::count_if(vertices, own));
    };
    say_bound(mesh, how_of(method, made), {end - first, among(made.unlit), among(made.unreached)}, notes);
  }
  // It was read as one that is drawn rigidly.
  for (const std::size_t i : group.instances) {
    const std::string pointer = fmt::format("/nodes/{}/skin", scene.instances[i].node);
    std::erase_if(notes.warnings,
                  [&](const RawWarning& w) { return w.rule == "skin-without-weights" && w.pointer == pointer; });
  }
}

void say_nothing_bound(const Left& left, const RuleOrigin& origin, Notes& notes) {
  std::string why = "every mesh has weights already", advice = "leave the option out, or replace them by --rebind";
  tools::Exit code = tools::Exit::usage;
  if (left.many_skins > 0) {
    why = "the file has several skins, and no mesh without weights has one of them";
    advice = "give the meshes their skins in the modelling program";
  } else if (left.no_joints > 0) {
    why = "the file has neither a skin nor nodes that clips move";
    advice = "export the skeleton too";
    code = tools::Exit::invalid;
  } else if (left.moving > 0) {
    why = "the meshes without weights hang on joints or moved nodes, which they follow";
  } else if (left.weighted == 0) {
    why = "no mesh to bind";
  }
  if (origin.must_fit) throw tools::Failure(code, origin.file, origin.where, why, advice);
  notes.warnings.push_back({"/meshes", "rule-fits-nothing", "auto-weights: " + why});
}

void smooth(RawMesh& mesh, std::size_t number, int steps, const Made& made) {
  deform::Positions positions;
  std::vector<std::uint32_t> indices;
  std::vector<std::vector<deform::Influence>> influences;
  for (const RawPrimitive& primitive : mesh.primitives) {
    if (primitive.influences.empty()) continue;
    const std::size_t first = positions.size();
    positions.insert(positions.end(), primitive.positions.begin(), primitive.positions.end());
    for (const std::uint32_t i : primitive.indices) indices.push_back(static_cast<std::uint32_t>(first + i));
    for (const std::vector<RawInfluence>& vertex : primitive.influences) {
      influences.emplace_back();
      for (const RawInfluence& i : vertex) influences.back().push_back({i.joint, static_cast<double>(i.weight)});
    }
  }
  deform::smooth_weights(positions, indices, steps, influences);
  std::size_t at = 0;
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    const std::size_t most = made.contains({number, p}) ? kMadeInfluences : kMaxInfluences;
    for (std::vector<RawInfluence>& vertex : mesh.primitives[p].influences) {
      deform::keep_largest(influences[at], most, 0);
      vertex = to_raw(influences[at++]);
    }
  }
}

void smooth_all(RawScene& scene, const WeightOptions& options, const Made& made, Notes& notes) {
  std::set<int> meshes;
  for (const RawInstance& instance : scene.instances)
    if (instance.skin != kNone && has_weights(scene.meshes[to_index(instance.mesh)])) meshes.insert(instance.mesh);
  for (const int number : meshes) smooth(scene.meshes[to_index(number)], to_index(number), options.smooth_steps, made);
  if (!meshes.empty()) return;
  if (options.smooth_origin.must_fit)
    throw tools::Failure(tools::Exit::usage, options.smooth_origin.file, options.smooth_origin.where,
                         "no mesh has weights to smooth", "leave the option out or give --auto-weights too");
  notes.warnings.push_back({"/meshes", "rule-fits-nothing", "smooth-weights: no mesh has weights"});
}

RawScene bind_groups(RawScene scene, const std::vector<Group>& groups, const WeightOptions& options, Notes& notes) {
  Made made;
  separate_meshes(scene);
  for (const Group& group : groups)
    bind(scene, group, options.make.value_or(deform::WeightMethod::geodesic), made, notes);
  if (options.smooth_steps > 0) smooth_all(scene, options, made, notes);
  return options.paint.empty() ? std::move(scene) : paint_weights(std::move(scene), options.paint, notes);
}

}  // namespace

RawScene bind_weights(RawScene scene, const WeightOptions& options, Notes& notes) {
  std::vector<Group> groups;
  Left left;
  if (options.make) {
    if (options.rebind) forget_weights(scene);
    add_skin_groups(scene, groups);
    add_free_group(scene, groups, left, notes);
    if (groups.empty()) say_nothing_bound(left, options.make_origin, notes);
  }
  return bind_groups(std::move(scene), groups, options, notes);
}

RawScene bind_to(const MadeSkeleton& made, RawScene scene, const WeightOptions& options, Notes& notes) {
  expect_few(scene, made.instances.size());
  for (const std::size_t i : made.instances) {
    scene.instances[i].skin = scene.instances[i].unused_skin = kNone;
    for (RawPrimitive& primitive : scene.meshes[to_index(scene.instances[i].mesh)].primitives)
      primitive.influences.clear();
  }
  const Group group = bound_to(made, "", rest_of_nodes(scene), scene);
  return bind_groups(std::move(scene), {group}, options, notes);
}

}  // namespace marrow::cook
