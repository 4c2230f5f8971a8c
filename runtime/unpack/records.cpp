#include "unpack/records.h"

#include "unpack/clip/bounds.h"
#include "unpack/clip/clip.h"
#include "unpack/geometry.h"

namespace marrow {
namespace {

// Of a compact record's section, but for a clip's payload. Nothing grows more than a skeleton, by 46 bytes for a
// joint's one and 48 for a root's; a name by 64 for two.
std::uint64_t most_compact_bytes(std::uint64_t record_bytes) {
  return 256 + 96 * record_bytes;
}

}  // namespace

const char* add_needs(const Record& record, RecordNeeds& needs) {
  std::uint64_t scratch_bytes = 0, section_bytes = record.bytes.size;
  if (record.codec == packed::kCompact) {
    section_bytes = most_compact_bytes(section_bytes);
    if (record.kind == format::kSkeletons) {  // for the meshes on it, the rest pose
      ByteReader reader(record.bytes.data, record.bytes.size);
      reader.take_varint();
      const std::uint64_t joint_count = reader.take_varint();
      if (joint_count > kMaxJoints) return "a count out of range";
      scratch_bytes = joint_count * sizeof(Affine);
    } else if (record.kind == format::kClips) {
      ClipNeeds clip;
      if (const char* const rule = measure_clip_record(record.bytes, clip)) return rule;
      scratch_bytes = clip.scratch_bytes;
      section_bytes += clip.most_section_bytes;
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
  needs.most_file_bytes = format::align16(needs.most_file_bytes) + section_bytes;
  return nullptr;
}

}  // namespace marrow
