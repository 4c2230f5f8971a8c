// A mesh of the scene as the offline deformers take it, and its poses.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cook/scene/built.h"
#include "cook/skin/skin_binding.h"
#include "deform/motion/range_of_motion.h"
#include "deform/skinned_mesh.h"

namespace marrow::cook {

struct SampledPose {
  std::vector<SoaTransform> local;
  std::uint32_t clip = 0;  // which of the built scene
  float time_s = 0;
};

// Poses of all clips of a skeleton, `rate_hz` a second and both ends, thinned evenly to at most `most`, but at least
// two a clip.
std::vector<SampledPose> clip_poses(const BuiltScene& scene, std::uint32_t skeleton, double rate_hz, std::size_t most);

// `count` poses that mix the given ones: each joint is somewhere between two of `poses`, chosen anew for each joint.
// Without poses they are turned_poses() of 45°. The same on every run.
std::vector<SampledPose> resampled_poses(const BuiltSkeleton& skeleton, const std::vector<SampledPose>& poses,
                                         std::size_t count);

// `count` poses in each of which every joint is turned from rest by up to `most_rad` about any axis, and then back into
// its limit if it has one. The same on every run.
std::vector<SampledPose> turned_poses(const BuiltSkeleton& skeleton, std::size_t count, double most_rad);

// model_from_joint.
std::vector<Affine> model_pose(const BuiltSkeleton& skeleton, const std::vector<SoaTransform>& local);

// A pose in which the surface is known.
struct ShownPose {
  deform::Pose pose;            // of the skin's joints
  deform::Positions positions;  // of DeformSource::mesh
  std::uint32_t clip = 0;
  std::string clip_name;
  double time_s = 0;
  double share = 0;  // of the clip's duration
};

struct WeldedMesh {
  deform::SkinnedMesh mesh;                           // joints are the skin's; vertices that move alike are one
  std::vector<std::vector<std::uint32_t>> vertex_of;  // for each primitive and its vertices which of the mesh's
};

WeldedMesh welded(const RawMesh& mesh, const RawSkin& skin, const SkinBinding& binding);

struct DeformSource : WeldedMesh {
  // Of the skin's joints: the nearest one above (kNone: none), where it is in the bind pose, and which of the skeleton
  // it is.
  std::vector<int> parents;
  std::vector<glm::dvec3> centres;
  std::vector<std::uint16_t> joints;
  std::vector<glm::dmat4> inverse_bind;
  std::uint32_t skeleton = 0;
  std::vector<ShownPose> shown;              // in ascending order of clips; read_examples() has them
  deform::Deformer elastic;                  // of the mesh; remember_truth() has it
  std::vector<deform::MotionPose> motion;    // what fits are judged by too; range_of_motion() has them
  std::vector<deform::FramesInARow> frames;  // the same, for what jumps; frames_in_a_row() has them
};

DeformSource deform_source(const RawMesh& mesh, const RawSkin& skin, const SkinBinding& binding,
                           const BuiltScene& built);

// The joints' matrices in a pose of the skeleton, helpers not among them.
deform::Pose deform_pose(const DeformSource& source, const BuiltSkeleton& skeleton,
                         const std::vector<SoaTransform>& local);

// Three frames in a row at 60 Hz, at so many moments of all clips at most, evenly.
std::vector<deform::FramesInARow> frames_in_a_row(const DeformSource& source, const BuiltScene& built,
                                                  std::size_t most);

// What the mesh does: the bind pose, then moments of all clips, without clips poses made up; helpers among the
// joints.
std::vector<deform::Pose> poses_of_clips(const DeformSource& source, const SkinBinding& binding,
                                         const BuiltScene& built);

// skeleton: the source's, with its limits. A limit is about the joint's rotation beside the joint above it in the bind
// pose, or at rest where that one is not in the skin.
deform::RangeOfMotion range_of_motion(const DeformSource& source, const BuiltSkeleton& skeleton);

// A line for each reason that joints were left out for, with their names. "moves_as_one", which is no fault, is not
// among them.
std::vector<std::string> left_out_of_motion(const DeformSource& source, const BuiltSkeleton& skeleton,
                                            const std::vector<deform::LeftOut>& left_out);

}  // namespace marrow::cook
