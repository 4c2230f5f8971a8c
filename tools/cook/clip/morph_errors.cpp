#include "cook/clip/morph_errors.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "common/check_status.h"
#include "cook/clip/measure/channel_values.h"
#include "cook/clip/measure/source_curves.h"
#include "cook/scene/matrices.h"
#include "cook/scene/views.h"
#include "marrow/local_to_model.h"
#include "marrow/sample.h"

namespace marrow::cook {
namespace {

constexpr int kPoses = 64;  // that tell how large a clip makes a mesh

// Keys, what is just before them and the quarters between.
std::set<float> moments_of(const BuiltClip& source) {
  std::set<float> out = {0.0f};
  for (const Channel& channel : source.channels) {
    const float* const times = source.times_s.data() + channel.first_time;
    for (std::uint32_t k = 0; k < channel.key_count; ++k) {
      const float next = times[std::min(k + 1, channel.key_count - 1)];
      out.insert(just_before(times[k]));
      for (int quarter = 0; quarter < 4; ++quarter)
        out.insert(times[k] + (next - times[k]) * 0.25f * static_cast<float>(quarter));
    }
  }
  return out;
}

// Scene units a unit of the mesh, at most.
double largest_scale(const Mesh& mesh, const BuiltClip& clip, const Skeleton& skeleton) {
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> model(skeleton.joint_count);
  double out = 0;
  for (int i = 0; i <= kPoses; ++i) {
    const float time_s = clip.duration_s * static_cast<float>(i) / kPoses;
    tools::check(sample(skeleton, view(clip, skeleton), time_s, local));
    tools::check(local_to_model(skeleton, local, model));
    for (std::uint32_t j = 0; j < mesh.joint_count; ++j)
      out = std::max(out,
                     largest_stretch(glm::dmat3(to_matrix(model[mesh.joints[j]]) * to_matrix(mesh.inverse_bind[j]))));
  }
  return out;
}

// The largest sum over targets, in the mesh's units.
double largest_sum(const MorphedMesh& mesh, const std::set<float>& moments, ChannelValues& source,
                   ChannelValues& cooked) {
  std::vector<std::pair<int, int>> channels;  // a target: of both
  for (const MorphedMesh::Target& target : mesh.targets)
    channels.emplace_back(source.find(target.channel), cooked.find(target.channel));
  double worst = 0;
  for (const float time_s : moments) {
    source.go_to(time_s);
    cooked.go_to(time_s);
    double sum = 0;
    for (std::size_t t = 0; t < mesh.targets.size(); ++t) {
      const MorphedMesh::Target& target = mesh.targets[t];
      const double wanted = source.value(channels[t].first, target.rest);
      sum += std::fabs(wanted - cooked.value(channels[t].second, target.rest)) * target.reach;
      sum += std::fabs(wanted) * target.error;
    }
    worst = std::max(worst, sum);
  }
  return worst;
}

}  // namespace

double morph_error_m(const BuiltClip& source, const BuiltClip& clip, const BuiltSkeleton& skeleton,
                     const std::vector<MorphedMesh>& meshes) {
  if (std::ranges::none_of(meshes, [&](const MorphedMesh& m) { return m.mesh.skeleton == clip.skeleton; })) return 0;
  const Skeleton joints = view(skeleton);
  ChannelValues wanted(source), cooked(clip);
  const std::set<float> moments = moments_of(source);
  double worst = 0;
  for (const MorphedMesh& mesh : meshes) {
    if (mesh.mesh.skeleton != clip.skeleton) continue;
    const double sum = largest_sum(mesh, moments, wanted, cooked);
    if (sum > 0) worst = std::max(worst, sum * largest_scale(mesh.mesh, clip, joints));
  }
  return worst;
}

}  // namespace marrow::cook
