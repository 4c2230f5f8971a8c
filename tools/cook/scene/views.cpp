#include "cook/scene/views.h"

#include "asset/section_views.h"
#include "cook/scene/matrices.h"

namespace marrow::cook {

Skeleton view(const BuiltSkeleton& skeleton) {
  Skeleton out;
  out.joint_count = static_cast<std::uint32_t>(skeleton.parents.size());
  out.root_count = static_cast<std::uint32_t>(skeleton.model_from_root.size());
  out.model_from_root = skeleton.model_from_root.data();
  out.rest = skeleton.rest.data();
  out.parents = skeleton.parents.data();
  return out;
}

Clip view(const BuiltClip& clip, const Skeleton& skeleton) {
  Clip out;
  out.joint_count = skeleton.joint_count;
  out.duration_s = clip.duration_s;
  out.tracks = {clip.tracks.data(), clip.tracks.size()};
  out.channels = {clip.channels.data(), clip.channels.size()};
  out.times_s = clip.times_s.data();
  out.values = clip.values.data();
  const BuiltCoded& c = clip.coded;
  if (c.header.frame_count == 0) return out;
  out.coded.frame_count = c.header.frame_count;
  out.coded.track_count = c.header.track_count;
  out.coded.constant_count = c.header.constant_count;
  out.coded.segment_intervals = c.header.segment_intervals;
  out.coded.start_s = c.header.start_s;
  out.coded.frames_per_s = c.header.frames_per_s;
  out.coded.times_s = c.times_s.empty() ? nullptr : c.times_s.data();
  out.coded.masks = c.masks.data();
  out.coded.segment_offsets = c.offsets.data();
  out.coded.constants = reinterpret_cast<const std::byte*>(c.constants.data());
  out.coded.payload = c.payload.data();
  return out;
}

Mesh view(const BuiltMesh& mesh, const BuiltGeometry& geometry) {
  Mesh out;
  out.skeleton = mesh.skeleton;
  out.joint_count = static_cast<std::uint32_t>(mesh.joints.size());
  out.joints = mesh.joints.data();
  out.inverse_bind = mesh.inverse_bind.data();
  out.helpers = {mesh.helpers.data(), mesh.helpers.size()};
  out.helper_centres = {mesh.helper_centres.data(), mesh.helper_centres.size()};
  out.geometry = view_geometry(geometry.section.data());
  return out;
}

glm::dmat4 matrix_of(const Transform& transform) {
  return local_matrix(transform.translation, transform.rotation, transform.scale);
}

std::vector<Transform> rest_transforms(const BuiltSkeleton& skeleton) {
  std::vector<Transform> out(skeleton.parents.size());
  for (std::size_t j = 0; j < out.size(); ++j) {
    const SoaTransform& four = skeleton.rest[j / 4];
    const std::size_t lane = j % 4;
    for (int c = 0; c < 3; ++c) {
      out[j].translation[c] = static_cast<double>(four.translation[c][lane]);
      out[j].scale[c] = static_cast<double>(four.scale[c][lane]);
    }
    const auto& r = four.rotation;
    out[j].rotation = glm::dquat(static_cast<double>(r[3][lane]), static_cast<double>(r[0][lane]),
                                 static_cast<double>(r[1][lane]), static_cast<double>(r[2][lane]));
  }
  return out;
}

}  // namespace marrow::cook
