#include "cook/learn/eigen_targets.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "common/evenly.h"
#include "common/failure.h"
#include "common/parallel.h"
#include "cook/learn/truths.h"
#include "cook/scene/node_motion.h"
#include "cook/skin/deform_source.h"
#include "deform/elastic/elastic.h"
#include "deform/fit/missing.h"
#include "deform/fit/remembered.h"

namespace marrow::cook {
namespace {

constexpr double kRate_hz = 30;
constexpr std::size_t kMostMoments = 320;         // that the basis is learnt from
constexpr std::size_t kFewestMoments = 16;        // of a large mesh
constexpr std::size_t kMostMissing = 10'000'000;  // displacements that are kept meanwhile
constexpr std::size_t kMostWork = 500'000'000;    // vertices and nodes, times moments

struct Moment {
  std::size_t clip;
  float time_s;
};

struct Subject {
  const RawScene* scene;
  const RawSkin* skin;
  DeformSource source;  // its mesh alone
  deform::Deformer truth;
  std::vector<NodeMotion> motion;  // a clip
  std::vector<Moment> moments;     // clip by clip
};

deform::Pose pose_at(const Subject& subject, const Moment& moment) {
  deform::Pose out;
  const std::vector<glm::dmat4> joints = subject.motion[moment.clip].at(moment.time_s);
  for (std::size_t j = 0; j < joints.size(); ++j) out.emplace_back(joints[j] * subject.skin->inverse_bind[j]);
  return out;
}

// What is stiff in the clips it leaves alone, see deform::Elastic::look_at().
deform::Deformer elastic_truth(const Subject& subject, const LearnOptions& options) {
  std::vector<deform::Pose> poses;
  for (const Moment& moment : tools::evenly(subject.moments, kLookedAt)) poses.push_back(pose_at(subject, moment));
  return deform::remembered(deform::elastic(subject.source.mesh, options.elastic, poses));
}

// Of every clip that moves a joint, ends included.
void find_moments(Subject& subject) {
  const std::size_t vertices = subject.source.mesh.positions.size();
  for (std::size_t c = 0; c < subject.scene->clips.size(); ++c) {
    const NodeMotion& motion =
        subject.motion.emplace_back(*subject.scene, subject.scene->clips[c], subject.skin->joints);
    const double last_s = static_cast<double>(motion.range().second), frames = std::ceil(last_s * kRate_hz);
    if (!(last_s > 0) || subject.scene->clips[c].additive) continue;
    const auto most = static_cast<double>(kMostWork / (vertices + motion.step_count()));
    if (!(frames + static_cast<double>(subject.moments.size()) < most))
      throw tools::Failure(tools::Exit::unsupported, subject.scene->source, "/animations", "too-many-keys",
                           "the clips are too long for --eigenskin, which gives them 30 keys a second");
    for (double k = 0; k <= frames; ++k) subject.moments.push_back({c, static_cast<float>(last_s * (k / frames))});
  }
}

// What SSD misses in a moment, in bind space and in the scene; none where it cannot be mended or is not finite.
struct Missing {
  deform::Positions bind;
  double squares = 0;  // in the scene
};
Missing missing_at(const Subject& subject, const Moment& moment) {
  const deform::SkinnedMesh& mesh = subject.source.mesh;
  const deform::Pose pose = pose_at(subject, moment);
  Missing out{deform::Positions(mesh.positions.size(), glm::dvec3(0)), 0};
  deform::Positions wanted;
  subject.truth(pose, wanted);
  if (!deform::is_finite(wanted)) return out;
  for (std::size_t v = 0; v < wanted.size(); ++v) {
    const deform::Matrix m = deform::blended(mesh.influences[v], pose);
    const glm::dvec3 missing = wanted[v] - deform::transform(m, mesh.positions[v]);
    out.squares += glm::dot(missing, missing);
    out.bind[v] = deform::correction(m, missing).value_or(glm::dvec3(0));
  }
  return out;
}

std::vector<deform::Positions> fields_of(const Subject& subject, std::size_t most) {
  const std::size_t vertices = subject.source.mesh.positions.size();
  const std::size_t room = std::clamp(kMostMissing / std::max<std::size_t>(vertices, 1), kFewestMoments, kMostMoments);
  const std::vector<Moment> moments = tools::evenly(subject.moments, room);
  std::vector<deform::Positions> missing(moments.size());
  tools::for_each_in_parallel(moments.size(),
                              [&](std::size_t i) { missing[i] = missing_at(subject, moments[i]).bind; });
  if (std::ranges::all_of(missing, [](const deform::Positions& p) { return !(deform::dot(p, p) > 0); })) return {};
  return deform::principal_fields(missing, most).fields;
}

// A moment's weights of the fields; how far SSD is off, and how far it is with them.
struct Fitted {
  std::vector<double> weights;
  double before = 0, after = 0;
};
Fitted fitted(const Subject& subject, const std::vector<deform::Positions>& fields, const Moment& moment) {
  Missing missing = missing_at(subject, moment);
  Fitted out;
  out.before = missing.squares;
  for (const deform::Positions& field : fields) out.weights.push_back(deform::dot(field, missing.bind));
  for (std::size_t n = 0; n < fields.size(); ++n)
    for (std::size_t v = 0; v < fields[n].size(); ++v) missing.bind[v] -= fields[n][v] * out.weights[n];
  const deform::Pose pose = pose_at(subject, moment);
  for (std::size_t v = 0; v < missing.bind.size(); ++v) {
    const deform::Matrix m = deform::blended(subject.source.mesh.influences[v], pose);
    const glm::dvec3 left = deform::linear_of(m) * missing.bind[v];
    out.after += glm::dot(left, left);
  }
  return out;
}

void add_fields(const Subject& subject, const std::vector<deform::Positions>& fields, const std::vector<double>& most,
                RawMesh& mesh) {
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p)
    for (std::size_t n = 0; n < fields.size(); ++n) {
      RawTarget target;
      for (const std::uint32_t v : subject.source.vertex_of[p]) target.positions.emplace_back(fields[n][v] * most[n]);
      mesh.primitives[p].targets.push_back(std::move(target));
    }
}

void add_weights(const Subject& subject, const std::vector<Fitted>& all, const std::vector<double>& most,
                 const std::vector<RawTargetWeight>& names, int node, std::vector<RawClip>& clips) {
  for (std::size_t n = 0; n < most.size(); ++n)
    for (std::size_t i = 0; i < all.size();) {
      RawScalar scalar;
      scalar.name = names[n].channel;
      scalar.node = node;
      const std::size_t clip = subject.moments[i].clip;
      for (; i < all.size() && subject.moments[i].clip == clip; ++i) {
        scalar.times_s.push_back(subject.moments[i].time_s);
        scalar.values.push_back(static_cast<float>(all[i].weights[n] / most[n]));
      }
      clips[clip].scalars.push_back(std::move(scalar));
    }
}

std::string note_of(const std::vector<Fitted>& all, std::size_t fields, std::size_t vertices) {
  double before = 0, after = 0;
  for (const Fitted& f : all) before += f.before, after += f.after;
  const double numbers = static_cast<double>(all.size() * vertices);
  return fmt::format("{} fields take linear blend skinning from {:.4g} to {:.4g} of the truth, in {} moments of clips",
                     fields, std::sqrt(before / numbers), std::sqrt(after / numbers), all.size());
}

// Channels are called as the source's are: NODE.TARGET, or nodes[N].TARGET where another node has the name already.
std::vector<RawTargetWeight> names_for(const RawScene& scene, int node, std::size_t count,
                                       std::set<std::string>& taken) {
  const std::string& own = scene.nodes[to_index(node)].name;
  const bool is_its = !own.empty() && taken.insert(own).second;
  const std::string owner = is_its ? own : fmt::format("nodes[{}]", node);
  std::vector<RawTargetWeight> out;
  for (std::size_t n = 0; n < count; ++n) {
    const std::string name = fmt::format("eigenskin[{}]", n);
    out.push_back({name, owner + "." + name, 0});
  }
  return out;
}

// False if there is nothing to add.
bool add_to(std::size_t instance_index, const LearnOptions& options, std::set<std::string>& taken, RawScene& scene,
            Notes& notes) {
  RawInstance& instance = scene.instances[instance_index];
  Notes of_binding;  // said when it is built
  Subject subject{&scene, &scene.skins[to_index(instance.skin)], {}, {}, {}, {}};
  RawMesh mesh = scene.meshes[to_index(instance.mesh)];
  static_cast<WeldedMesh&>(subject.source) = welded(mesh, *subject.skin, bind_to_skin(mesh, of_binding));
  if (subject.source.mesh.positions.empty()) return false;
  if (subject.source.mesh.positions.size() > kMostMissing / kFewestMoments)
    throw tools::Failure(tools::Exit::unsupported, scene.source, mesh.primitives.front().pointer, "too-many-vertices",
                         fmt::format("--eigenskin takes at most {}", kMostMissing / kFewestMoments));
  find_moments(subject);
  if (subject.moments.empty()) return false;
  subject.truth =
      options.truth == Truth::elastic ? elastic_truth(subject, options) : make_truth(subject.source, options);
  const std::vector<deform::Positions> fields = fields_of(subject, to_index(options.eigen_targets));
  if (fields.empty()) return false;
  std::vector<Fitted> all(subject.moments.size());
  tools::for_each_in_parallel(all.size(), [&](std::size_t i) { all[i] = fitted(subject, fields, subject.moments[i]); });
  std::vector<double> most(fields.size(), 1e-30);  // so that weights are -1 … 1
  for (const Fitted& f : all)
    for (std::size_t n = 0; n < fields.size(); ++n) most[n] = std::max(most[n], std::abs(f.weights[n]));
  add_fields(subject, fields, most, mesh);
  const std::vector<RawTargetWeight> names = names_for(scene, instance.node, fields.size(), taken);
  add_weights(subject, all, most, names, instance.node, scene.clips);
  mesh.weights.insert(mesh.weights.end(), names.begin(), names.end());
  instance.weights.insert(instance.weights.end(), names.begin(), names.end());
  notes.warnings.push_back({fmt::format("/nodes/{}", instance.node), "eigenskin",
                            note_of(all, fields.size(), subject.source.mesh.positions.size())});
  const bool is_shared = std::ranges::count(scene.instances, instance.mesh, &RawInstance::mesh) > 1;
  if (is_shared) instance.mesh = static_cast<int>(scene.meshes.size());
  if (is_shared) scene.meshes.emplace_back();
  scene.meshes[to_index(instance.mesh)] = std::move(mesh);
  return true;
}

}  // namespace

RawScene add_eigen_targets(RawScene scene, const LearnOptions& options, Notes& notes) {
  std::set<std::string> taken;
  bool any = false;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const RawInstance& instance = scene.instances[i];
    if (instance.skin == kNone || !scene.nodes[to_index(instance.node)].in_scene) continue;
    const std::vector<RawPrimitive>& primitives = scene.meshes[to_index(instance.mesh)].primitives;
    const auto is_bound = [](const RawPrimitive& p) { return !p.influences.empty(); };
    if (!primitives.empty() && std::ranges::all_of(primitives, is_bound))
      any = add_to(i, options, taken, scene, notes) || any;
  }
  if (!any)
    notes.warnings.push_back({"/meshes", "eigenskin-idle",
                              "linear blend skinning misses nothing of the truth in any clip: no mesh gets fields"});
  return scene;
}

}  // namespace marrow::cook
