#include "cook/learn/examples.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>

#include <glm/gtc/matrix_transform.hpp>

#include "common/failure.h"
#include "cook/clip/build_clips.h"
#include "cook/scene/views.h"
#include "cook/skeleton/build_skeletons.h"
#include "marrow/sample.h"

namespace marrow::cook {
namespace {

// What is read of the file.
struct Sheet {
  const std::string& path;
  const RawScene& scene;
  BuiltScene built;

  [[noreturn]] void refuse(const std::string& where, const char* rule, const std::string& advice) const {
    throw tools::Failure(tools::Exit::invalid, path, where, rule, advice);
  }
  const RawMesh& mesh(const RawInstance& instance) const {
    return scene.meshes[static_cast<std::size_t>(instance.mesh)];
  }
};

std::string counts_of(const RawMesh& mesh) {
  std::string out;
  for (const RawPrimitive& p : mesh.primitives) out += (out.empty() ? "" : " + ") + std::to_string(p.positions.size());
  return out;
}

void check_vertices(const Sheet& sheet, const RawMesh& mesh, const RawMesh& wanted) {
  if (counts_of(mesh) == counts_of(wanted)) return;
  sheet.refuse(mesh.primitives.empty() ? "/meshes" : mesh.primitives.front().pointer, "other-vertices",
               "the example has " + counts_of(mesh) + " vertices, the character's mesh " + counts_of(wanted) +
                   "; export both with the same settings");
}

// From places of all vertices of all primitives, one after the other, to those of the mesh that is fitted.
void add_example(const Sheet& sheet, const std::string& where, const DeformSource& source,
                 const deform::Positions& places, ShownPose example, std::vector<ShownPose>& out) {
  example.positions.resize(source.mesh.positions.size());
  std::size_t at = 0;
  for (const std::vector<std::uint32_t>& vertex_of : source.vertex_of)
    for (const std::uint32_t v : vertex_of) example.positions[v] = places[at++];
  if (!deform::is_finite(example.positions))
    sheet.refuse(where, "not-finite", "the example has a position that is not finite; mend it");
  out.push_back(std::move(example));
}

// Of each joint of the character's skin which joint of the sheet's skin has its name.
std::vector<std::size_t> match_joints(const Sheet& sheet, const RawSkin& theirs, const Shown& shown) {
  std::map<std::string, std::size_t> by_name;
  for (std::size_t j = 0; j < theirs.joints.size(); ++j)
    by_name.emplace(sheet.scene.nodes[static_cast<std::size_t>(theirs.joints[j])].name, j);
  std::vector<std::size_t> out;
  for (const int node : shown.skin.joints) {
    const std::string& name = shown.scene.nodes[static_cast<std::size_t>(node)].name;
    const auto found = by_name.find(name);
    if (found == by_name.end())
      sheet.refuse("/skins", "no-such-joint", "the character's joint \"" + name + "\" is not among the example's");
    out.push_back(found->second);
  }
  return out;
}

// The weights of a mesh's morph targets at a moment of a clip.
std::vector<double> target_weights(const Sheet& sheet, const RawInstance& instance, const BuiltClip& clip,
                                   float time_s) {
  std::vector<float> values(clip.channels.size());
  const Clip view_of_clip = view(clip, view(sheet.built.skeletons[clip.skeleton]));
  if (sample_channels(view_of_clip, time_s, values) != Status::ok)
    sheet.refuse("/animations", "clip", "the clip's numbers cannot be sampled");
  std::vector<double> out;
  for (const RawTargetWeight& target : instance.weights) {
    const auto at = std::ranges::find(clip.channel_names, target.channel) - clip.channel_names.begin();
    const bool driven = at < static_cast<std::ptrdiff_t>(values.size());
    out.push_back(static_cast<double>(driven ? values[static_cast<std::size_t>(at)] : target.rest));
  }
  return out;
}

// Vertices of all primitives, with their own weights; none are welded, since targets may part them.
deform::SkinnedMesh every_vertex(const RawMesh& mesh, const SkinBinding& binding, std::size_t joints) {
  deform::SkinnedMesh out;
  out.joint_count = static_cast<std::uint32_t>(joints);
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    for (std::size_t v = 0; v < binding.primitives[p].size(); ++v) {
      out.positions.emplace_back(mesh.primitives[p].positions[v]);
      std::vector<deform::Influence>& to = out.influences.emplace_back();
      for (const BoundInfluence& i : binding.primitives[p][v]) to.push_back({i.joint, i.weight});
    }
  }
  return out;
}

void add_targets(const RawMesh& mesh, const std::vector<double>& weights, deform::Positions& positions) {
  std::size_t first = 0;
  for (const RawPrimitive& p : mesh.primitives) {
    for (std::size_t t = 0; t < std::min(weights.size(), p.targets.size()); ++t)
      for (std::size_t v = 0; v < p.targets[t].positions.size(); ++v)
        positions[first + v] += glm::dvec3(p.targets[t].positions[v]) * weights[t];
    first += p.positions.size();
  }
}

void add_moments(const Sheet& sheet, const RawInstance& instance, const Shown& shown, std::vector<ShownPose>& out) {
  const RawMesh& mesh = sheet.mesh(instance);
  check_vertices(sheet, mesh, shown.mesh);
  const RawSkin& skin = sheet.scene.skins[static_cast<std::size_t>(instance.skin)];
  const std::vector<std::size_t> joint_of = match_joints(sheet, skin, shown);
  Notes of_example;  // which nobody asks for
  const SkinBinding binding = bind_to_skin(mesh, of_example);
  const DeformSource theirs = deform_source(mesh, skin, binding, sheet.built);
  const deform::SkinnedMesh rest = every_vertex(mesh, binding, skin.joints.size());
  deform::SkinnedMesh moved = rest;
  const deform::Deformer ssd = deform::ssd(moved);
  for (const SampledPose& moment : clip_poses(sheet.built, theirs.skeleton, kTrainedRate_hz, kMostTrained)) {
    const BuiltClip& clip = sheet.built.clips[moment.clip];
    const deform::Pose pose = deform_pose(theirs, sheet.built.skeletons[theirs.skeleton], moment.local);
    moved.positions = rest.positions;
    add_targets(mesh, target_weights(sheet, instance, clip, moment.time_s), moved.positions);
    deform::Positions places;
    ssd(pose, places);
    ShownPose example;
    for (std::size_t j = 0; j < joint_of.size(); ++j)
      example.pose.emplace_back(glm::dmat4(pose[joint_of[j]]) * glm::inverse(theirs.inverse_bind[joint_of[j]]) *
                                shown.source.inverse_bind[j]);
    example.clip = moment.clip;
    example.clip_name = clip.name;
    example.time_s = static_cast<double>(moment.time_s);
    example.share = example.time_s / std::max(1e-6, static_cast<double>(clip.duration_s));
    add_example(sheet, "/animations", shown.source, places, std::move(example), out);
  }
}

glm::dmat4 model_from_node(const RawScene& scene, int node) {
  glm::dmat4 out(1.0);
  for (; node != kNone; node = scene.nodes[static_cast<std::size_t>(node)].parent) {
    const RawNode& n = scene.nodes[static_cast<std::size_t>(node)];
    out = glm::translate(glm::dmat4(1.0), n.translation) * glm::mat4_cast(n.rotation) *
          glm::scale(glm::dmat4(1.0), n.scale) * out;
  }
  return out;
}

const RawProperty* find_extra(const RawNode& node, const char* name, PropertyType type) {
  const auto found = std::ranges::find(node.extras, name, &RawProperty::name);
  return found != node.extras.end() && found->type == type ? &*found : nullptr;
}

void add_posed_mesh(const Sheet& sheet, const RawInstance& instance, const Shown& shown, std::vector<ShownPose>& out) {
  const RawNode& node = sheet.scene.nodes[static_cast<std::size_t>(instance.node)];
  const std::string where = "/nodes/" + std::to_string(instance.node);
  const RawProperty* const name = find_extra(node, "marrow.clip", PropertyType::text);
  const RawProperty* const time = find_extra(node, "marrow.time", PropertyType::number);
  if (name == nullptr && time == nullptr) return;
  if (name == nullptr || time == nullptr)
    sheet.refuse(where + "/extras", "half-a-moment", "give both marrow.clip, a name, and marrow.time, in seconds");
  const RawMesh& mesh = sheet.mesh(instance);
  check_vertices(sheet, mesh, shown.mesh);
  const BuiltScene& built = shown.built;
  const auto clip = std::ranges::find_if(
      built.clips, [&](const BuiltClip& c) { return c.name == name->text && c.skeleton == shown.source.skeleton; });
  if (clip == built.clips.end())
    sheet.refuse(where + "/extras", "no-such-clip", "the character has no clip \"" + name->text + "\"");
  if (!(time->number >= 0 && time->number <= static_cast<double>(clip->duration_s)))
    sheet.refuse(where + "/extras", "no-such-time", "the clip lasts " + std::to_string(clip->duration_s) + " s");
  const BuiltSkeleton& skeleton = built.skeletons[shown.source.skeleton];
  std::vector<SoaTransform> local(view(skeleton).soa_size());
  if (sample(view(skeleton), view(*clip, view(skeleton)), static_cast<float>(time->number), local) != Status::ok)
    sheet.refuse(where, "clip", "the character's clip cannot be sampled");
  const glm::dmat4 placed = model_from_node(sheet.scene, instance.node);
  deform::Positions places;
  for (const RawPrimitive& p : mesh.primitives)
    for (const glm::vec3& v : p.positions) places.emplace_back(placed * glm::dvec4(glm::dvec3(v), 1));
  ShownPose example;
  example.pose = deform_pose(shown.source, skeleton, local);
  example.clip = static_cast<std::uint32_t>(clip - built.clips.begin());
  example.clip_name = clip->name;
  example.time_s = time->number;
  example.share = time->number / std::max(1e-6, static_cast<double>(clip->duration_s));
  add_example(sheet, where, shown.source, places, std::move(example), out);
}

const RawInstance* skinned_like(const Sheet& sheet, const RawMesh& wanted) {
  const RawInstance* first = nullptr;
  for (const RawInstance& instance : sheet.scene.instances) {
    if (instance.skin == kNone) continue;
    if (sheet.mesh(instance).name == wanted.name) return &instance;
    if (first == nullptr) first = &instance;
  }
  return first;
}

}  // namespace

std::vector<ShownPose> read_examples(const RawScene& examples, const Shown& shown) {
  Sheet sheet{examples.source, examples, {}};
  std::vector<ShownPose> out;
  const RawInstance* const skinned = skinned_like(sheet, shown.mesh);
  if (skinned != nullptr) {
    sheet.built = build_skeletons(sheet.scene);
    sheet.built.clips = build_raw_clips(sheet.scene, sheet.built, {});
    add_moments(sheet, *skinned, shown, out);
  }
  for (const RawInstance& instance : sheet.scene.instances)
    if (instance.skin == kNone) add_posed_mesh(sheet, instance, shown, out);
  if (out.empty())
    sheet.refuse(skinned != nullptr ? "/animations" : "/nodes", "no-example",
                 "give clips that move the skin, or meshes whose nodes say which moment they show");
  std::ranges::stable_sort(out, {}, &ShownPose::clip);
  return out;
}

deform::Deformer as_shown(const deform::SkinnedMesh& mesh, const std::vector<ShownPose>& examples) {
  const auto less = [](const deform::Matrix& a, const deform::Matrix& b) {
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 3; ++r)
        if (a[c][r] != b[c][r]) return a[c][r] < b[c][r];
    return false;
  };
  const auto less_pose = [less](const deform::Pose& a, const deform::Pose& b) {
    return std::ranges::lexicographical_compare(a, b, less);
  };
  using Table = std::map<deform::Pose, deform::Positions, decltype(less_pose)>;
  const auto table = std::make_shared<Table>(less_pose);
  for (const ShownPose& e : examples) table->emplace(e.pose, e.positions);
  table->emplace(deform::Pose(mesh.joint_count, deform::Matrix(1.0)), mesh.positions);
  return [table, joints = mesh.joint_count, vertices = mesh.positions.size()](const deform::Pose& pose,
                                                                              deform::Positions& out) {
    // Helpers stand behind the joints.
    const auto found = table->find(deform::Pose(pose.begin(), pose.begin() + static_cast<std::ptrdiff_t>(joints)));
    if (found != table->end()) {
      out = found->second;
    } else {
      out.assign(vertices, glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
    }
  };
}

}  // namespace marrow::cook
