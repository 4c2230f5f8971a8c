// The golden files of format version 1, embedded in the test binary; see golden/README.md.
#pragma once

#include <cstddef>

#include "support/aligned.h"

namespace marrow::embedded {
extern const unsigned char tiny_v1[];
extern const unsigned long long tiny_v1_size;
extern const unsigned char dance_v1[];
extern const unsigned long long dance_v1_size;
extern const unsigned char face_v1[];
extern const unsigned long long face_v1_size;
extern const unsigned char pack_v1[];
extern const unsigned long long pack_v1_size;
extern const unsigned char looks_v1[];
extern const unsigned long long looks_v1_size;
extern const unsigned char stride_v1[];
extern const unsigned long long stride_v1_size;
extern const unsigned char centres_v1[];
extern const unsigned long long centres_v1_size;
extern const unsigned char elbow_v1[];
extern const unsigned long long elbow_v1_size;
extern const unsigned char lod_v1[];
extern const unsigned long long lod_v1_size;
extern const unsigned char limits_v1[];
extern const unsigned long long limits_v1_size;
extern const unsigned char roles_v1[];
extern const unsigned long long roles_v1_size;
extern const unsigned char springs_v1[];
extern const unsigned long long springs_v1_size;
extern const unsigned char maps_v1[];
extern const unsigned long long maps_v1_size;
extern const unsigned char graph_v1[];
extern const unsigned long long graph_v1_size;
extern const unsigned char shapes_v1[];
extern const unsigned long long shapes_v1_size;
extern const unsigned char packed_v3[];
extern const unsigned long long packed_v3_size;
}  // namespace marrow::embedded

namespace marrow::test {

// A copy that a test may damage.
inline AlignedBlock golden_copy() {
  return AlignedBlock(embedded::tiny_v1, static_cast<std::size_t>(embedded::tiny_v1_size));
}
// A file whose clip is coded.
inline AlignedBlock golden_coded_copy() {
  return AlignedBlock(embedded::dance_v1, static_cast<std::size_t>(embedded::dance_v1_size));
}

// A file whose clip has channels and is additive.
inline AlignedBlock golden_channels_copy() {
  return AlignedBlock(embedded::face_v1, static_cast<std::size_t>(embedded::face_v1_size));
}

// The clip pack as a packed file of version 2.
inline AlignedBlock golden_packed_copy() {
  return AlignedBlock(embedded::packed_v3, static_cast<std::size_t>(embedded::packed_v3_size));
}

// A clip pack.
inline AlignedBlock golden_pack_copy() {
  return AlignedBlock(embedded::pack_v1, static_cast<std::size_t>(embedded::pack_v1_size));
}

// A file whose coded clip has frames at uneven times.
inline AlignedBlock golden_uneven_copy() {
  return AlignedBlock(embedded::stride_v1, static_cast<std::size_t>(embedded::stride_v1_size));
}

// A file with a residual and a half-joint.
inline AlignedBlock golden_half_joint_copy() {
  return AlignedBlock(embedded::elbow_v1, static_cast<std::size_t>(embedded::elbow_v1_size));
}

// The same, but the helper turns about a centre.
inline AlignedBlock golden_centres_copy() {
  return AlignedBlock(embedded::centres_v1, static_cast<std::size_t>(embedded::centres_v1_size));
}

// A file with materials, embedded images and kept nodes.
inline AlignedBlock golden_looks_copy() {
  return AlignedBlock(embedded::looks_v1, static_cast<std::size_t>(embedded::looks_v1_size));
}

// A file whose meshes have levels of detail.
inline AlignedBlock golden_lod_copy() {
  return AlignedBlock(embedded::lod_v1, static_cast<std::size_t>(embedded::lod_v1_size));
}

// A file whose joints have limits.
inline AlignedBlock golden_limits_copy() {
  return AlignedBlock(embedded::limits_v1, static_cast<std::size_t>(embedded::limits_v1_size));
}

// A file with spring bones and colliders.
inline AlignedBlock golden_springs_copy() {
  return AlignedBlock(embedded::springs_v1, static_cast<std::size_t>(embedded::springs_v1_size));
}

// A file with roles of joints.
inline AlignedBlock golden_roles_copy() {
  return AlignedBlock(embedded::roles_v1, static_cast<std::size_t>(embedded::roles_v1_size));
}

// A file with a pose map.
inline AlignedBlock golden_maps_copy() {
  return AlignedBlock(embedded::maps_v1, static_cast<std::size_t>(embedded::maps_v1_size));
}

// A file with a graph of behaviour.
inline AlignedBlock golden_graph_copy() {
  return AlignedBlock(embedded::graph_v1, static_cast<std::size_t>(embedded::graph_v1_size));
}

// A file with a space of example shapes.
inline AlignedBlock golden_shapes_copy() {
  return AlignedBlock(embedded::shapes_v1, static_cast<std::size_t>(embedded::shapes_v1_size));
}

}  // namespace marrow::test
