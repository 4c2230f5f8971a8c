#include "unpack/records.h"

#include "unpack/clip/bounds_record.h"
#include "unpack/clip/clip_record.h"
#include "unpack/geometry.h"

namespace marrow {
namespace {

constexpr std::uint64_t kLeastJointBytes = 10;  // of a section that stands as it is
// Per joint: masks and constants. If they are as in the clip before, they take hardly a bit in the record.
constexpr std::uint64_t kStillBytes = sizeof(GroupMasks) + 3 * sizeof(format::Constant);

// The most bytes of a compact record's section, without a clip's payload, lists, times and constants. Skeletons grow
// most: one byte of a joint becomes 46, one byte of a root 48. Two bytes of a name become 64.
std::uint64_t most_compact_bytes(std::uint64_t record_bytes) {
  return 256 + 96 * record_bytes;
}

}  // namespace

const char* add_needs(const Record& record, RecordNeeds& needs) {
  std::uint64_t scratch_bytes = 0, section_bytes = record.bytes.size, joints = 0;
  if (record.kind == format::kSkeletons || record.kind == format::kReferences)
    joints = section_bytes / kLeastJointBytes;
  if (record.codec == packed::kCompact) {
    section_bytes = most_compact_bytes(section_bytes);
    if (record.kind == format::kSkeletons) {  // for the meshes on it, the rest pose
      ByteReader reader(record.bytes.data, record.bytes.size);
      reader.take_varint();
      joints = reader.take_varint();
      if (joints > kMaxJoints) return "a count out of range";
      scratch_bytes = joints * sizeof(Affine);
    } else if (record.kind == format::kClips) {
      ClipNeeds clip;
      if (const char* const rule = measure_clip_record(record.bytes, clip)) return rule;
      scratch_bytes = clip.scratch_bytes;
      section_bytes += clip.most_section_bytes + needs.most_joints * kStillBytes;
    } else if (record.kind == format::kBounds) {
      section_bytes = measure_bounds_record(record.bytes);
      if (section_bytes == 0) return "a count out of range";
    }
  } else if (record.codec >= packed::kFirstCodec && record.kind == format::kGeometries) {
    GeometryNeeds geometry;
    if (const char* const rule = measure_geometry_record(record.bytes, geometry)) return rule;
    scratch_bytes = geometry.scratch_bytes;
    section_bytes = geometry.most_section_bytes;
  }
  if (scratch_bytes > needs.scratch_bytes) needs.scratch_bytes = scratch_bytes;
  if (joints > needs.most_joints) needs.most_joints = joints;
  needs.most_file_bytes = format::align16(needs.most_file_bytes) + section_bytes;
  return nullptr;
}

}  // namespace marrow
