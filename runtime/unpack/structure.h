// Skeletons, meshes and names in packed files (docs/format.md) → their sections.
#pragma once

#include "core/byte_reader.h"
#include "marrow/file.h"
#include "unpack/packed.h"

namespace marrow {

// The strings of a NAME record, one after the other; each may begin like one of the four before it.
class NameReader {
 public:
  explicit NameReader(Span<const std::byte> record);

  std::uint32_t pool_bytes() const { return pool_bytes_; }
  // Returns the next string's offset in the pool, and writes the string there if `pool` is given. Past the last one, or
  // with anything that does not fit: 0, and failed().
  std::uint32_t next(char* pool = nullptr);
  std::uint32_t end() const { return end_; }
  bool at_end() const { return !reader_.failed() && reader_.left() == 0; }
  bool failed() const { return failed_ || reader_.failed(); }

 private:
  ByteReader reader_;
  std::uint32_t pool_bytes_ = 0;
  std::uint32_t end_ = 1;  // behind the empty name
  bool failed_ = false;
  struct {
    std::uint32_t offset, length;
  } last_[4] = {};  // newest first
};

// Each writes a section to `out`, 16-byte aligned, and its size to `bytes`. They return null, or the rule that is
// broken. `names` must be at the skeleton's first name; it is advanced past the skeleton's names.
const char* unpack_skeleton(Span<const std::byte> record, NameReader& names, Span<std::byte> out, std::uint32_t& bytes);
// Writes one step's worth of names. names: the record's reader, which goes on from call to call.
const char* unpack_names(NameReader& names, Span<std::byte> out, std::uint32_t& bytes, bool& done);
inline const char* unpack_names(Span<const std::byte> record, Span<std::byte> out, std::uint32_t& bytes) {
  NameReader names(record);
  const char* rule = nullptr;
  for (bool done = false; !done && rule == nullptr;) rule = unpack_names(names, out, bytes, done);
  return rule;
}

// A file in the making, whose first sections are skeletons that unpack_skeleton() made, or references to others.
struct UnpackedSkeletons {
  const std::byte* file = nullptr;
  std::uint32_t count = 0, reference_count = 0;  // one of them is 0
};
// A view of the skeleton, without names. Past the last skeleton it has no joints.
Skeleton skeleton_at(UnpackedSkeletons skeletons, std::uint32_t index);
// Of a skeleton or of a reference; 0 past the last.
std::uint32_t joint_count_at(UnpackedSkeletons skeletons, std::uint32_t index);
// modelled, in and out: the skeleton whose rest pose in model space is in `scratch`; kNoneModelled: none.
inline constexpr std::uint32_t kNoneModelled = 0xFFFFFFFF;
const char* unpack_mesh(Span<const std::byte> record, UnpackedSkeletons skeletons, std::uint32_t& modelled,
                        Span<std::byte> scratch, Span<std::byte> out, std::uint32_t& bytes);
inline const char* unpack_mesh(Span<const std::byte> record, UnpackedSkeletons skeletons, Span<std::byte> scratch,
                               Span<std::byte> out, std::uint32_t& bytes) {
  std::uint32_t modelled = kNoneModelled;
  return unpack_mesh(record, skeletons, modelled, scratch, out, bytes);
}

// Inverse binds that follow from the rest pose: joint_from_mesh = (model_from_joint)⁻¹ · model_from_mesh. `model` is
// the rest pose in model space.
Affine derived_inverse_bind(const Affine& model, const Affine& model_from_mesh);

}  // namespace marrow
