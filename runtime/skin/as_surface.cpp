#include "skin/as_surface.h"

#include "core/builtins.h"

namespace marrow {
namespace {

// Vertices at one position whose weights differ by more than this do not move alike.
constexpr float kSameWeight = 1e-3f;
// The most slots that are searched for a copy. Copies beyond this many at one position may not be found.
constexpr std::uint32_t kMostProbes = 256;

struct Counts {
  std::size_t parts, slots, corners, table;
};

Counts count(Span<const AsPart> parts) {
  Counts c{parts.size, 0, 0, 4};
  for (const AsPart& part : parts) {
    if (part.mesh == nullptr) continue;  // as_tangents() refuses it
    c.slots += part.mesh->geometry.slot_count;
    c.corners += part.mesh->geometry.index_count;
  }
  while (c.table < 2 * c.slots) c.table *= 2;
  return c;
}

// The hash of a position, whose coordinates are four floats apart.
std::uint32_t hash_of(const float* position) {
  std::uint32_t h = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    h = (h ^ bit_cast<std::uint32_t>(position[4 * c] + 0.0f)) * 0x9E3779B1u;  // -0 is 0
    h ^= h >> 15;
  }
  return h;
}

std::uint32_t index_of(const Geometry& g, std::uint32_t i) {
  return g.index_bytes == 4 ? static_cast<const std::uint32_t*>(g.indices)[i]
                            : static_cast<const std::uint16_t*>(g.indices)[i];
}

bool same_joint(const Mesh& a, std::uint32_t i, const Mesh& b, std::uint32_t j) {
  if (a.joints[i] != b.joints[j]) return false;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c)
      if (a.inverse_bind[i].rows[r][c] != b.inverse_bind[j].rows[r][c]) return false;
  return true;
}

}  // namespace

std::size_t AsSurface::bytes(Span<const AsPart> parts) {
  const Counts c = count(parts);
  return c.parts * sizeof(Part) + c.slots / 4 * sizeof(Block) + 4 * (2 * c.slots + c.corners + c.table);
}

AsSurface::AsSurface(Span<const AsPart> parts, Span<std::byte> scratch) : parts_(parts) {
  const Counts c = count(parts);
  slot_count_ = static_cast<std::uint32_t>(c.slots);
  corner_count_ = static_cast<std::uint32_t>(c.corners);
  std::byte* at = scratch.data;
  numbers_ = reinterpret_cast<Part*>(at);
  blocks_ = reinterpret_cast<Block*>(at += c.parts * sizeof(Part));
  next_copy_ = reinterpret_cast<std::uint32_t*>(at + c.slots / 4 * sizeof(Block));
  first_corner_ = next_copy_ + c.slots;
  next_corner_ = first_corner_ + c.slots;
  list_blocks();
  list_corners();
  find_copies(next_corner_ + c.corners, static_cast<std::uint32_t>(c.table));
}

void AsSurface::list_blocks() {
  std::uint32_t slot = 0, corner = 0, block = 0;
  for (std::uint32_t p = 0; p < parts_.size; ++p) {
    const Geometry& g = parts_[p].mesh->geometry;
    numbers_[p] = {slot, corner};
    slot += g.slot_count;
    corner += g.index_count;
    std::uint32_t skin = 0, coordinates = 0, set = 0;
    for (const Run& run : g.runs) {
      for (std::uint32_t i = 0; i < (run.vertex_count + 3) / 4; ++i) {
        blocks_[block++] = {p, skin, coordinates, set, run.influences};
        skin += 4 * (run.influences + 2);
        coordinates += 16 * run.influences - 4;
      }
      set += run.influences;
    }
  }
}

void AsSurface::list_corners() {
  for (std::uint32_t slot = 0; slot < slot_count_; ++slot) first_corner_[slot] = kNoNumber;
  for (std::uint32_t p = 0; p < parts_.size; ++p) {
    const Geometry& g = parts_[p].mesh->geometry;
    for (std::uint32_t i = 0; i < g.index_count; ++i) {
      const std::uint32_t slot = numbers_[p].first_slot + index_of(g, i), corner = numbers_[p].first_corner + i;
      next_corner_[corner] = first_corner_[slot];
      first_corner_[slot] = corner;
    }
  }
}

void AsSurface::opposite(std::uint32_t slot, std::uint32_t corner, std::uint32_t (&out)[2]) const {
  const Part& numbers = numbers_[block(slot).part];
  const std::uint32_t i = corner - numbers.first_corner, first = i - i % 3;
  out[0] = numbers.first_slot + index_of(geometry(slot), first + (i + 1) % 3);
  out[1] = numbers.first_slot + index_of(geometry(slot), first + (i + 2) % 3);
}

void AsSurface::read(std::uint32_t slot, AsVertex& out) const {
  const Block& b = block(slot);
  const float* from = part(slot).coordinates.data + b.coordinates + slot % 4;
  const std::uint16_t* const set = geometry(slot).sets + b.set;
  float last[4] = {from[0], from[4], from[8], 1};
  out.influences = 0;
  for (std::uint32_t j = 0; j < b.influences; ++j) {
    float(&q)[4] = out.q[out.influences];
    bool counts = j + 1 == b.influences;
    for (std::uint32_t c = 0; c < 4; ++c) {
      q[c] = counts ? last[c] : from[16 * j + 12 + 4 * c];
      last[c] -= q[c];
    }
    for (const float c : q) counts = counts || c != 0;
    if (!counts) continue;
    out.set[out.influences] = set[j];
    out.place[out.influences++] = static_cast<std::uint8_t>(j);
  }
}

bool AsSurface::same_entry(std::uint32_t slot, std::uint32_t entry, std::uint32_t other_slot,
                           std::uint32_t other_entry) const {
  if (block(slot).part == block(other_slot).part) return entry == other_entry;
  const Mesh &a = *part(slot).mesh, &b = *part(other_slot).mesh;
  const bool helper = entry >= a.joint_count;
  if (a.skeleton != b.skeleton || helper != (other_entry >= b.joint_count)) return false;
  if (!helper) return same_joint(a, entry, b, other_entry);
  const Helper &i = a.helpers[entry - a.joint_count], &j = b.helpers[other_entry - b.joint_count];
  return i.share == j.share && same_joint(a, i.first, b, j.first) && same_joint(a, i.second, b, j.second);
}

// In one place, with the same weights.
bool AsSurface::is_copy(const AsVertex& a, std::uint32_t a_slot, std::uint32_t b_slot) const {
  const float *p = position(a_slot), *q = position(b_slot);
  if (!(p[0] == q[0] && p[4] == q[4] && p[8] == q[8])) return false;
  AsVertex b;
  read(b_slot, b);
  float unmatched = 1;  // weight of b's entries that a lacks
  for (std::uint32_t i = 0; i < a.influences; ++i) {
    float weight = 0;
    for (std::uint32_t j = 0; j < b.influences; ++j)
      if (same_entry(a_slot, a.set[i], b_slot, b.set[j])) weight = b.q[j][3];
    const float difference = a.q[i][3] - weight;
    if (!(-kSameWeight < difference && difference < kSameWeight)) return false;
    unmatched -= weight;
  }
  return -kSameWeight < unmatched && unmatched < kSameWeight;
}

void AsSurface::find_copies(std::uint32_t* table, std::uint32_t table_size) {
  for (std::uint32_t i = 0; i < table_size; ++i) table[i] = kNoNumber;
  for (std::uint32_t slot = 0; slot < slot_count_; ++slot) {
    AsVertex v;
    read(slot, v);
    next_copy_[slot] = slot;
    std::uint32_t at = hash_of(position(slot)) & (table_size - 1);
    for (std::uint32_t probe = 0; probe < kMostProbes; ++probe, at = (at + 1) & (table_size - 1)) {
      const std::uint32_t other = table[at];
      if (other == kNoNumber) {
        table[at] = slot;
        break;
      }
      if (!is_copy(v, slot, other)) continue;
      next_copy_[slot] = next_copy_[other];
      next_copy_[other] = slot;
      break;
    }
  }
}

}  // namespace marrow
