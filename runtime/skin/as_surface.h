// Meshes in animation space as one surface: which slots are one vertex, and which triangles meet there.
#pragma once

#include "marrow/skin.h"

namespace marrow {

inline constexpr std::uint32_t kNoNumber = 0xFFFFFFFF;

// Animation-space coordinates of one slot: x y z w of every influence that is not all 0, and always of the run's last.
struct AsVertex {
  float q[kMaxInfluences][4];
  std::uint16_t set[kMaxInfluences];   // palette entries
  std::uint8_t place[kMaxInfluences];  // among the run's
  std::uint32_t influences;
};

// Slots and corners of triangles are numbered over all parts. Lives in scratch memory.
class AsSurface {
 public:
  struct Part {
    std::uint32_t first_slot, first_corner;
  };
  struct Block {
    std::uint32_t part;
    std::uint32_t skin, coordinates;  // the block's first floats
    std::uint32_t set;                // the run's first entry of Geometry::sets
    std::uint32_t influences;
  };

  static std::size_t bytes(Span<const AsPart> parts);
  // scratch: bytes(), on a 4-byte boundary.
  AsSurface(Span<const AsPart> parts, Span<std::byte> scratch);

  std::uint32_t slot_count() const { return slot_count_; }
  const Block& block(std::uint32_t slot) const { return blocks_[slot / 4]; }
  const AsPart& part(std::uint32_t slot) const { return parts_[block(slot).part]; }
  const Geometry& geometry(std::uint32_t slot) const { return part(slot).mesh->geometry; }
  // A slot within its part.
  std::uint32_t local(std::uint32_t slot) const { return slot - numbers_[block(slot).part].first_slot; }

  void read(std::uint32_t slot, AsVertex& out) const;
  // The position in the bind pose, without residuals: x at [0], y at [4], z at [8].
  const float* position(std::uint32_t slot) const { return geometry(slot).skin + block(slot).skin + slot % 4; }
  // One component of a slot in a stream of normals, tangents …, whose blocks have `stride` × 4 floats.
  static float lane(const float* stream, std::uint32_t stride, std::uint32_t slot, std::uint32_t component) {
    return stream[4 * (std::size_t{stride} * (slot / 4) + component) + slot % 4];
  }
  // Whether two palette entries, each of one slot's mesh, are the same: the same joints with the same bind matrices.
  bool same_entry(std::uint32_t slot, std::uint32_t entry, std::uint32_t other_slot, std::uint32_t other_entry) const;

  // The next slot of the same vertex; these form a ring.
  std::uint32_t next_copy(std::uint32_t slot) const { return next_copy_[slot]; }
  // The corners at a slot, kNoNumber after the last.
  std::uint32_t first_corner(std::uint32_t slot) const { return first_corner_[slot]; }
  std::uint32_t next_corner(std::uint32_t corner) const { return next_corner_[corner]; }
  // The slots of the next two corners in the triangle of `corner`, which is at `slot`.
  void opposite(std::uint32_t slot, std::uint32_t corner, std::uint32_t (&out)[2]) const;

 private:
  void list_blocks();
  void list_corners();
  void find_copies(std::uint32_t* table, std::uint32_t table_size);
  bool is_copy(const AsVertex& a, std::uint32_t a_slot, std::uint32_t b_slot) const;

  Span<const AsPart> parts_;
  std::uint32_t slot_count_ = 0, corner_count_ = 0;
  Part* numbers_;
  Block* blocks_;
  std::uint32_t *next_copy_, *first_corner_, *next_corner_;
};

}  // namespace marrow
