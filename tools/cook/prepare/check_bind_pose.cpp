#include "cook/prepare/check_bind_pose.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "cook/scene/matrices.h"
#include "cook/scene/views.h"
#include "cook/skeleton/build_skeletons.h"

namespace marrow::cook {
namespace {

constexpr double kAllowed_m = 1e-3;

// Vertices of one skin's joint.
struct Follower {
  std::size_t joint;  // of the skin
  glm::dvec4 position;
  double weight;
};

std::vector<Follower> followers_of(const RawScene& scene, int skin) {
  std::vector<Follower> out;
  std::set<int> meshes;
  for (const RawInstance& instance : scene.instances)
    if (instance.skin == skin) meshes.insert(instance.mesh);
  for (const int mesh : meshes)
    for (const RawPrimitive& primitive : scene.meshes[static_cast<std::size_t>(mesh)].primitives)
      for (std::size_t v = 0; v < primitive.influences.size(); ++v)
        for (const RawInfluence& i : primitive.influences[v])
          if (i.weight > 0)
            out.push_back({i.joint, glm::dvec4(primitive.positions[v], 1), static_cast<double>(i.weight)});
  return out;
}

// The joint of the skin that most vertices follow.
std::size_t heaviest(const std::vector<Follower>& followers, std::size_t joints) {
  std::vector<double> weight(joints, 0);
  for (const Follower& f : followers) weight[f.joint] += f.weight;
  return static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
}

struct Distance {
  double metres = 0;
  std::size_t joint = 0;  // of the skin
};

// How far `here` takes a vertex from where `there` does, both carried along with the joint `with`.
Distance worst_distance(const std::vector<Follower>& followers, const std::vector<glm::dmat4>& here,
                        const std::vector<glm::dmat4>& there, std::size_t with) {
  const glm::dmat4 place = here[with] * glm::inverse(there[with]);
  Distance out;
  for (const Follower& f : followers) {
    const double metres = glm::length(glm::dvec3(here[f.joint] * f.position - place * (there[f.joint] * f.position)));
    if (metres > out.metres) out = {metres, f.joint};
  }
  return out;
}

// model_from_joint.
std::vector<glm::dmat4> rest_of(const BuiltSkeleton& skeleton) {
  std::vector<glm::dmat4> out;
  for (const Transform& t : rest_transforms(skeleton)) {
    RawNode joint;
    joint.translation = t.translation;
    joint.rotation = t.rotation;
    joint.scale = t.scale;
    const std::size_t j = out.size();
    const std::uint16_t parent = skeleton.parents[j];
    const glm::dmat4 above = parent == kNoJoint ? to_matrix(skeleton.model_from_root[j]) : out[parent];
    out.push_back(above * local_matrix(joint));
  }
  return out;
}

// model_from_node as the file has them.
std::vector<glm::dmat4> own_rest(const RawScene& scene) {
  std::vector<glm::dmat4> out(scene.nodes.size());
  for (const std::size_t n : parents_first(scene)) {
    const int parent = scene.nodes[n].parent;
    const glm::dmat4 local = local_matrix(scene.nodes[n]);
    out[n] = parent == kNone ? local : out[static_cast<std::size_t>(parent)] * local;
  }
  return out;
}

}  // namespace

void check_bind_pose(const RawScene& scene, const BuiltScene& built, const std::string& body, Notes& notes) {
  const std::vector<glm::dmat4> own = own_rest(scene);
  std::vector<std::vector<glm::dmat4>> models;
  for (const BuiltSkeleton& skeleton : built.skeletons) models.push_back(rest_of(skeleton));
  for (std::size_t s = 0; s < scene.skins.size(); ++s) {
    const RawSkin& skin = scene.skins[s];
    const std::vector<Follower> followers = followers_of(scene, static_cast<int>(s));
    if (followers.empty()) continue;
    std::vector<glm::dmat4> bodys, owns;
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      const auto node = static_cast<std::size_t>(skin.joints[j]);
      const NearestJoint& at = built.nearest[node];
      const std::vector<glm::dmat4>& model = models[static_cast<std::size_t>(at.skeleton)];
      bodys.push_back(model[static_cast<std::size_t>(at.joint)] * skin.inverse_bind[j]);
      owns.push_back(own[node] * skin.inverse_bind[j]);
    }
    const std::size_t with = heaviest(followers, skin.joints.size());
    const std::vector<glm::dmat4> bound(skin.joints.size(), glm::dmat4(1.0));
    const Distance from_bind = worst_distance(followers, bodys, bound, with);
    if (!(from_bind.metres > kAllowed_m) || !(worst_distance(followers, bodys, owns, with).metres > kAllowed_m))
      continue;
    const std::string& name = scene.nodes[static_cast<std::size_t>(skin.joints[from_bind.joint])].name;
    notes.warnings.push_back(
        {"/skins/" + std::to_string(s), "bind-pose-differs",
         fmt::format("at \"{}\" vertices are up to {:.3g} m from where they were bound when {} rests; bind the outfit "
                     "in the body's rest pose",
                     name, from_bind.metres, body)});
  }
}

}  // namespace marrow::cook
