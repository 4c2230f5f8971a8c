#include "cook/skin/deform_source.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "common/check_status.h"
#include "common/elementary.h"
#include "common/evenly.h"
#include "cook/scene/matrices.h"
#include "cook/scene/views.h"
#include "deform/rotations.h"
#include "marrow/limits.h"
#include "marrow/local_to_model.h"
#include "marrow/sample.h"

namespace marrow::cook {
namespace {

glm::dquat rotation_of(const SoaTransform& t, std::size_t lane) {
  return {static_cast<double>(t.rotation[3][lane]), static_cast<double>(t.rotation[0][lane]),
          static_cast<double>(t.rotation[1][lane]), static_cast<double>(t.rotation[2][lane])};
}

void set_rotation(SoaTransform& t, std::size_t lane, const glm::dquat& q) {
  const double parts[] = {q.x, q.y, q.z, q.w};
  for (int c = 0; c < 4; ++c) t.rotation[c][lane] = static_cast<float>(parts[c]);
}

// One joint of four, `share` of the way from one to the other.
void mix_joint(const SoaTransform& from, const SoaTransform& to, double share, std::size_t lane, SoaTransform& out) {
  const auto s = static_cast<float>(share);
  for (int c = 0; c < 3; ++c) {
    out.translation[c][lane] = from.translation[c][lane] + s * (to.translation[c][lane] - from.translation[c][lane]);
    out.scale[c][lane] = from.scale[c][lane] + s * (to.scale[c][lane] - from.scale[c][lane]);
  }
  set_rotation(out, lane, deform::slerp(rotation_of(from, lane), rotation_of(to, lane), share));
}

// In [0, 1); the standard's distributions differ between libraries.
double fraction(std::mt19937& random) {
  return static_cast<double>(random()) / 4294967296.0;
}

void turn_joint(SoaTransform& t, std::size_t lane, double most_rad, std::mt19937& random) {
  const double z = 2 * fraction(random) - 1, around = 6.283185307179586 * fraction(random), r = std::sqrt(1 - z * z);
  const double half = most_rad * fraction(random) / 2, s = tools::sine(half);
  const glm::dquat turn(tools::cosine(half), s * r * tools::cosine(around), s * r * tools::sine(around), s * z);
  set_rotation(t, lane, rotation_of(t, lane) * turn);
}

constexpr double kShownRate_hz = 30;
constexpr std::size_t kMostShownPoses = 320;
constexpr std::size_t kMadeUpPoses = 40;

// Vertices are the same if they lie in one place and follow the same joints alike.
using Key = std::tuple<float, float, float, std::vector<std::pair<std::uint32_t, double>>>;

Key key_of(const glm::vec3& position, const BoundVertex& influences) {
  std::vector<std::pair<std::uint32_t, double>> follows;
  for (const BoundInfluence& i : influences) follows.emplace_back(i.joint, i.weight);
  return {position.x, position.y, position.z, std::move(follows)};
}

std::vector<int> nearest_above(const std::vector<std::uint16_t>& joints, const std::vector<std::uint16_t>& parents) {
  std::map<int, int> of_skin;
  for (std::size_t j = 0; j < joints.size(); ++j) of_skin.emplace(joints[j], static_cast<int>(j));
  std::vector<int> out;
  for (const std::uint16_t joint : joints) {
    std::uint16_t above = parents[joint];
    while (above != kNoJoint && !of_skin.contains(above)) above = parents[above];
    out.push_back(above == kNoJoint ? kNone : of_skin.at(above));
  }
  return out;
}

// Of the skin's joints: the axes in the bind pose, and the rotation from the joint above.
struct Bound {
  glm::dmat3 axes, from_axes;
  glm::dquat local;
};

Bound bound(const DeformSource& source, const BuiltSkeleton& skeleton, std::uint32_t joint) {
  Bound out;
  out.from_axes = glm::dmat3(source.inverse_bind[joint]);
  out.axes = glm::inverse(out.from_axes);
  const std::uint16_t own = source.joints[joint];
  const int above = source.parents[joint];
  if (above != kNone && source.joints[to_index(above)] == skeleton.parents[own]) {
    const glm::dmat3 from_above(source.inverse_bind[to_index(above)]);
    out.local = deform::quaternion_of(deform::rotation_of(from_above * out.axes));
  } else {
    out.local = rotation_of(skeleton.rest[own / 4], own % 4);
  }
  return out;
}

// Axes may be scaled or mirrored; turns go through them as matrices.
glm::dquat through(const glm::dmat3& from, const glm::dquat& turn, const glm::dmat3& to) {
  return deform::quaternion_of(deform::rotation_of(from * glm::mat3_cast(turn) * to));
}

glm::dquat limited(const JointLimit& limit, const Bound& joint, const glm::dquat& turn) {
  const glm::dquat wanted = joint.local * through(joint.from_axes, turn, joint.axes);
  float local[4] = {static_cast<float>(wanted.x), static_cast<float>(wanted.y), static_cast<float>(wanted.z),
                    static_cast<float>(wanted.w)};
  if (clamp_rotation(limit, local) != Status::ok) return turn;
  const glm::dquat allowed(static_cast<double>(local[3]), static_cast<double>(local[0]), static_cast<double>(local[1]),
                           static_cast<double>(local[2]));
  return through(joint.axes, glm::conjugate(joint.local) * glm::normalize(allowed), joint.from_axes);
}

}  // namespace

std::vector<SampledPose> clip_poses(const BuiltScene& scene, std::uint32_t skeleton, double rate_hz, std::size_t most) {
  const Skeleton of = view(scene.skeletons[skeleton]);
  std::vector<std::uint32_t> clips;
  double wanted = 0;
  const auto moments = [&](const BuiltClip& clip, double rate) {
    return std::max(2.0, std::ceil(static_cast<double>(clip.duration_s) * rate) + 1);
  };
  for (std::uint32_t i = 0; i < scene.clips.size(); ++i) {
    const BuiltClip& clip = scene.clips[i];
    if (clip.skeleton != skeleton || (clip.tracks.empty() && clip.coded.header.frame_count == 0)) continue;
    clips.push_back(i);
    wanted += moments(clip, rate_hz);
  }
  const double rate = rate_hz * std::min(1.0, static_cast<double>(most) / std::max(wanted, 1.0));
  std::vector<SampledPose> out;
  for (const std::uint32_t i : clips) {
    const Clip clip = view(scene.clips[i], of);
    const auto count = static_cast<std::size_t>(moments(scene.clips[i], rate));
    for (std::size_t k = 0; k < count; ++k) {
      SampledPose pose{std::vector<SoaTransform>(of.soa_size()), i,
                       static_cast<float>(static_cast<double>(clip.duration_s) * static_cast<double>(k) /
                                          static_cast<double>(count - 1))};
      tools::check(sample(of, clip, pose.time_s, pose.local));
      out.push_back(std::move(pose));
    }
  }
  return out;
}

std::vector<SampledPose> resampled_poses(const BuiltSkeleton& skeleton, const std::vector<SampledPose>& poses,
                                         std::size_t count) {
  constexpr double kTurn_rad = 0.7853981633974483;  // 45°
  if (poses.empty()) return turned_poses(skeleton, count, kTurn_rad);
  std::mt19937 random(1);
  std::vector<SampledPose> out(count, {skeleton.rest});
  for (SampledPose& pose : out) {
    for (std::size_t j = 0; j < skeleton.parents.size(); ++j) {
      const SampledPose& from = poses[random() % poses.size()];
      const SampledPose& to = poses[random() % poses.size()];
      mix_joint(from.local[j / 4], to.local[j / 4], fraction(random), j % 4, pose.local[j / 4]);
    }
  }
  return out;
}

std::vector<SampledPose> turned_poses(const BuiltSkeleton& skeleton, std::size_t count, double most_rad) {
  std::mt19937 random(1);
  std::vector<SampledPose> out(count, {skeleton.rest});
  for (SampledPose& pose : out) {
    for (std::size_t j = 0; j < skeleton.parents.size(); ++j) turn_joint(pose.local[j / 4], j % 4, most_rad, random);
    tools::check(limit_pose(skeleton.limits, pose.local));
  }
  return out;
}

std::vector<Affine> model_pose(const BuiltSkeleton& skeleton, const std::vector<SoaTransform>& local) {
  std::vector<Affine> out(skeleton.parents.size());
  tools::check(local_to_model(view(skeleton), local, out));
  return out;
}

WeldedMesh welded(const RawMesh& mesh, const RawSkin& skin, const SkinBinding& binding) {
  WeldedMesh out;
  out.mesh.joint_count = static_cast<std::uint32_t>(skin.joints.size());
  std::map<Key, std::uint32_t> known;
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    const RawPrimitive& primitive = mesh.primitives[p];
    std::vector<std::uint32_t>& vertex_of = out.vertex_of.emplace_back();
    for (std::size_t v = 0; v < binding.primitives[p].size(); ++v) {
      const BoundVertex& influences = binding.primitives[p][v];
      const auto [at, is_new] = known.try_emplace(key_of(primitive.positions[v], influences),
                                                  static_cast<std::uint32_t>(out.mesh.positions.size()));
      if (is_new) {
        out.mesh.positions.emplace_back(primitive.positions[v]);
        std::vector<deform::Influence>& to = out.mesh.influences.emplace_back();
        for (const BoundInfluence& i : influences) to.push_back({i.joint, i.weight});
      }
      vertex_of.push_back(at->second);
    }
    if (vertex_of.empty()) continue;  // not skinned
    for (const std::uint32_t i : primitive.indices) out.mesh.indices.push_back(vertex_of[i]);
  }
  return out;
}

DeformSource deform_source(const RawMesh& mesh, const RawSkin& skin, const SkinBinding& binding,
                           const BuiltScene& built) {
  DeformSource out;
  static_cast<WeldedMesh&>(out) = welded(mesh, skin, binding);
  out.inverse_bind = skin.inverse_bind;
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    out.joints.push_back(static_cast<std::uint16_t>(built.joint_of_node[to_index(skin.joints[j])]));
    out.centres.emplace_back(glm::inverse(skin.inverse_bind[j])[3]);
  }
  out.skeleton = static_cast<std::uint32_t>(built.nearest[to_index(skin.joints.front())].skeleton);
  out.parents = nearest_above(out.joints, built.skeletons[out.skeleton].parents);
  return out;
}

deform::Pose deform_pose(const DeformSource& source, const BuiltSkeleton& skeleton,
                         const std::vector<SoaTransform>& local) {
  const std::vector<Affine> model_from_joint = model_pose(skeleton, local);
  deform::Pose out;
  for (std::size_t j = 0; j < source.joints.size(); ++j)
    out.emplace_back(to_matrix(model_from_joint[source.joints[j]]) * source.inverse_bind[j]);
  return out;
}

std::vector<deform::FramesInARow> frames_in_a_row(const DeformSource& source, const BuiltScene& built,
                                                  std::size_t most) {
  constexpr double kRate_hz = 60;
  constexpr std::size_t kMostFrames = 4096;  // of longer clips they are farther apart
  const std::vector<SampledPose> frames = clip_poses(built, source.skeleton, kRate_hz, kMostFrames);
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i + 2 < frames.size(); ++i)
    if (frames[i].clip == frames[i + 2].clip) begins.push_back(i);
  std::vector<deform::FramesInARow> out;
  for (const std::size_t begin : tools::evenly(begins, most)) {
    out.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      out.back()[k] = deform_pose(source, built.skeletons[source.skeleton], frames[begin + k].local);
  }
  return out;
}

std::vector<deform::Pose> poses_of_clips(const DeformSource& source, const SkinBinding& binding,
                                         const BuiltScene& built) {
  const BuiltSkeleton& skeleton = built.skeletons[source.skeleton];
  std::vector<SampledPose> sampled = clip_poses(built, source.skeleton, kShownRate_hz, kMostShownPoses);
  if (sampled.empty()) sampled = resampled_poses(skeleton, sampled, kMadeUpPoses);
  std::vector<deform::Pose> out(1, deform::Pose(source.joints.size(), deform::Matrix(1.0)));
  for (const SampledPose& pose : sampled) out.push_back(deform_pose(source, skeleton, pose.local));
  for (deform::Pose& pose : out) deform::append_helpers(binding.helpers, pose);
  return out;
}

deform::RangeOfMotion range_of_motion(const DeformSource& source, const BuiltSkeleton& skeleton) {
  deform::MotionOptions options;
  options.nearest_allowed = [&](std::uint32_t joint, const glm::dquat& turn) {
    const JointLimit* const limit = find_limit(skeleton.limits, source.joints[joint]);
    return limit == nullptr ? turn : limited(*limit, bound(source, skeleton, joint), turn);
  };
  return deform::range_of_motion(source.mesh, source.parents, source.centres, options);
}

std::vector<std::string> left_out_of_motion(const DeformSource& source, const BuiltSkeleton& skeleton,
                                            const std::vector<deform::LeftOut>& left_out) {
  using Why = deform::LeftOut::Why;
  std::vector<std::string> out;
  for (const Why why :
       {Why::no_vertices, Why::not_finite, Why::no_axis, Why::limits, Why::limits_of_twist, Why::limits_of_bends}) {
    std::string names;
    for (const deform::LeftOut& joint : left_out) {
      if (joint.why != why) continue;
      names += (names.empty() ? "" : ", ") + skeleton.joint_names[source.joints[joint.joint]];
    }
    if (!names.empty()) out.push_back(deform::text_of(why) + (": " + names));
  }
  return out;
}
}  // namespace marrow::cook
