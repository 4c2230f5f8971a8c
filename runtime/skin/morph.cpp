#include "marrow/morph.h"

#include <bit>
#include <cstring>

#include "core/check.h"
#include "core/off_boundary.h"
#include "core/zone.h"
#include "marrow/skin.h"
#include "math/vector.h"
#include "skin/as_block.h"

namespace marrow {
namespace {

// Where the parts of an instance's memory begin, in bytes; those of floats at multiples of 16.
struct MorphMemory {
  std::size_t skin_floats, normals, tangents, offsets, moved, changed, attributes, bytes;
};

std::size_t word_count(const Geometry& g) {
  return (std::size_t{g.slot_count} / 4 + 31) / 32;
}

MorphMemory memory_of(const Geometry& g) {
  const std::size_t blocks = g.slot_count / 4;
  MorphMemory m{};
  for (const Run& run : g.runs)
    m.skin_floats += (std::size_t{run.vertex_count} + 3) / 4 * 4 * (std::size_t{run.influences} + 2);
  m.normals = m.skin_floats * sizeof(float);
  m.tangents = m.normals + (g.normals != nullptr ? blocks * 48 : 0);
  m.offsets = m.tangents + (g.tangents != nullptr ? blocks * 64 : 0);
  m.moved = m.offsets + (blocks + 1) * 4;
  m.changed = m.moved + word_count(g) * 4;
  m.attributes = m.changed + word_count(g) * 4;
  m.bytes = m.attributes + 4;
  return m;
}

template <class T>
T* part(Span<std::byte> memory, std::size_t offset) {
  return reinterpret_cast<T*>(memory.data + offset);
}

// Calls visit(block) for every bit that is set.
template <class Visit>
void for_each_block(const std::uint32_t* bits, std::size_t words, const Visit& visit) {
  for (std::size_t i = 0; i < words; ++i)
    for (std::uint32_t left = bits[i]; left != 0; left &= left - 1)
      visit(32 * i + static_cast<std::size_t>(std::countr_zero(left)));
}

// The writable side of a morphed geometry.
struct Streams {
  float *skin, *normals, *tangents;

  explicit Streams(const Geometry& g)
      : skin(const_cast<float*>(g.skin)),
        normals(const_cast<float*>(g.normals)),
        tangents(const_cast<float*>(g.tangents)) {}
};

// Copies the x, y and z of a block.
void copy_block(const float* from, float* to) {
  for (int i = 0; i < 12; i += 4) store(to + i, load_aligned(from + i));
}

void add_record(const std::int16_t* record, f32x4 scale, float* to) {
  for (int i = 0; i < 12; i += 4) store(to + i, load_aligned(to + i) + load_int16(record + i) * scale);
}

void normalise_block(float* v) {
  const Vector<f32x4> unit = normalised(Vector<f32x4>{load_aligned(v), load_aligned(v + 4), load_aligned(v + 8)});
  store(v, unit.x);
  store(v + 4, unit.y);
  store(v + 8, unit.z);
}

void undo(MorphedGeometry& m, const Streams& to) {
  const Geometry& bind = m.bind;
  const std::size_t words = word_count(bind);
  const std::uint32_t attributes = *m.attributes;
  for_each_block(m.moved, words, [&](std::size_t block) {
    const std::size_t offset = m.offsets[block];
    if ((attributes & kMorphsPositions) != 0) copy_block(bind.skin + offset, to.skin + offset);
    if ((attributes & kMorphsNormals) != 0) copy_block(bind.normals + 12 * block, to.normals + 12 * block);
    if ((attributes & kMorphsTangents) != 0) copy_block(bind.tangents + 16 * block, to.tangents + 16 * block);
  });
  for (std::size_t i = 0; i < words; ++i) {
    m.changed[i] |= m.moved[i];
    m.moved[i] = 0;
  }
}

// Attributes: those of the target; known to the compiler, so that the loop has no branches.
template <std::uint32_t Attributes, class Index>
void add_target(const MorphTarget& t, const Index* blocks, float weight, const MorphedGeometry& m, const Streams& to) {
  const std::int16_t* record = m.bind.target_records + std::size_t{12} * t.first_record;
  const f32x4 position = splat(weight * t.position_step), normal = splat(weight * t.normal_step),
              tangent = splat(weight * t.tangent_step);
  const std::uint32_t* const offsets = m.offsets;
  std::uint32_t* const moved = m.moved;
  blocks += t.first_block;
  for (std::uint32_t i = 0; i < t.block_count; ++i) {
    const std::size_t block = blocks[i];
    moved[block / 32] |= std::uint32_t{1} << (block % 32);
    if constexpr ((Attributes & kMorphsPositions) != 0) {
      add_record(record, position, to.skin + offsets[block]);
      record += 12;
    }
    if constexpr ((Attributes & kMorphsNormals) != 0) {
      add_record(record, normal, to.normals + 12 * block);
      record += 12;
    }
    if constexpr ((Attributes & kMorphsTangents) != 0) {
      add_record(record, tangent, to.tangents + 16 * block);
      record += 12;
    }
  }
}

template <class Index>
void add_target(const MorphTarget& t, const Index* blocks, float weight, const MorphedGeometry& m, const Streams& to) {
  switch (t.attributes) {
    case 1:
      return add_target<1>(t, blocks, weight, m, to);
    case 2:
      return add_target<2>(t, blocks, weight, m, to);
    case 3:
      return add_target<3>(t, blocks, weight, m, to);
    case 4:
      return add_target<4>(t, blocks, weight, m, to);
    case 5:
      return add_target<5>(t, blocks, weight, m, to);
    case 6:
      return add_target<6>(t, blocks, weight, m, to);
    case 7:
      return add_target<7>(t, blocks, weight, m, to);
    default:
      return;
  }
}

}  // namespace

Status find_weight_channels(const File& file, const Mesh& mesh, const File& clips, const Clip& clip,
                            Span<std::uint32_t> out) {
  MARROW_REQUIRE(holds(out, mesh.targets.size));
  for (std::size_t t = 0; t < mesh.targets.size; ++t) {
    const std::uint32_t found = clips.find_channel(clip, file.text(mesh.targets[t].channel));
    out[t] = found < clip.channels.size ? found : kNoChannel;
  }
  return Status::ok;
}

Status morph_weights(const Mesh& mesh, Span<const std::uint32_t> channels, Span<const float> values, Span<float> out) {
  MARROW_REQUIRE(holds(out, mesh.targets.size));
  MARROW_REQUIRE(channels.empty() || holds(channels, mesh.targets.size));
  MARROW_REQUIRE(holds(values));
  const auto channel_of = [&](std::size_t t) { return channels.empty() ? kNoChannel : channels[t]; };
  for (std::size_t t = 0; t < mesh.targets.size; ++t)
    MARROW_REQUIRE(channel_of(t) == kNoChannel || channel_of(t) < values.size);
  for (std::size_t t = 0; t < mesh.targets.size; ++t) {
    const std::uint32_t channel = channel_of(t);
    out[t] = channel == kNoChannel ? mesh.targets[t].weight : values[channel];
  }
  return Status::ok;
}

std::size_t morphed_bytes(const Geometry& geometry) {
  return geometry.targets.empty() ? 0 : memory_of(geometry).bytes;
}

Status make_morphed(const Geometry& geometry, Span<std::byte> memory, MorphedGeometry& out) {
  MARROW_REQUIRE(holds(memory, morphed_bytes(geometry)));
  MorphedGeometry made;
  made.bind = made.geometry = geometry;
  if (!geometry.targets.empty()) {
    MARROW_REQUIRE_GOOD(check_boundary(memory.data));
    const MorphMemory m = memory_of(geometry);
    const auto copy = [&](const float* from, std::size_t offset, std::size_t end) -> const float* {
      if (from == nullptr) return nullptr;
      std::memcpy(memory.data + offset, from, end - offset);
      return part<float>(memory, offset);
    };
    made.geometry.skin = copy(geometry.skin, 0, m.normals);
    made.geometry.normals = copy(geometry.normals, m.normals, m.tangents);
    made.geometry.tangents = copy(geometry.tangents, m.tangents, m.offsets);
    auto* offset = part<std::uint32_t>(memory, m.offsets);
    made.offsets = offset;
    *offset = 0;
    for (const Run& run : geometry.runs)
      for (std::uint32_t block = 0; block < (run.vertex_count + 3) / 4; ++block, ++offset)
        offset[1] = offset[0] + 4 * (run.influences + 2);
    made.moved = part<std::uint32_t>(memory, m.moved);
    made.changed = part<std::uint32_t>(memory, m.changed);
    made.attributes = part<std::uint32_t>(memory, m.attributes);
    std::memset(made.moved, 0, m.bytes - m.moved);
  }
  out = made;
  return Status::ok;
}

Status morph(Span<const float> weights, MorphedGeometry& morphed) {
  MARROW_ZONE;
  const Geometry& bind = morphed.bind;
  MARROW_REQUIRE(holds(weights, bind.targets.size));
  for (std::size_t t = 0; t < bind.targets.size; ++t) MARROW_REQUIRE(weights[t] - weights[t] == 0.0f);
  const Streams to(morphed.geometry);
  if (bind.targets.empty()) return Status::ok;
  undo(morphed, to);
  std::uint32_t attributes = 0;
  for (std::size_t t = 0; t < bind.targets.size; ++t) {
    const MorphTarget& target = bind.targets[t];
    if (weights[t] == 0.0f) continue;
    attributes |= target.attributes;
    if (bind.index_bytes == 2) {
      add_target(target, static_cast<const std::uint16_t*>(bind.target_blocks), weights[t], morphed, to);
    } else {
      add_target(target, static_cast<const std::uint32_t*>(bind.target_blocks), weights[t], morphed, to);
    }
  }
  *morphed.attributes = attributes;
  const std::size_t words = word_count(bind);
  constexpr std::uint32_t kDirections = kMorphsNormals | kMorphsTangents;
  for_each_block(morphed.moved, (attributes & kDirections) != 0 ? words : 0, [&](std::size_t block) {
    if ((attributes & kMorphsNormals) != 0) normalise_block(to.normals + 12 * block);
    if ((attributes & kMorphsTangents) != 0) normalise_block(to.tangents + 16 * block);
  });
  for (std::size_t i = 0; i < words; ++i) morphed.changed[i] |= morphed.moved[i];
  return Status::ok;
}

Status morph_coordinates(MorphedGeometry& morphed, Span<float> coordinates) {
  MARROW_ZONE;
  const Geometry& bind = morphed.bind;
  MARROW_REQUIRE(holds(coordinates, as_coordinate_count(bind)));
  if (bind.targets.empty()) return Status::ok;
  const std::size_t words = word_count(bind);
  for_each_block(morphed.changed, words, [&](std::size_t block) {
    // The skin's offset is 4 K + 8 · block, where K is the number of influences of all blocks before.
    const std::size_t at = morphed.offsets[block], influences = (at - 8 * block) / 4;
    const std::uint32_t k = (morphed.offsets[block + 1] - morphed.offsets[block]) / 4 - 2;
    float* q = coordinates.data + 16 * influences - 4 * block;
    write_as_block(bind.skin + at, bind.as_residual != nullptr ? bind.as_residual + 16 * influences : nullptr, k, q);
    f32x4 change[3];
    for (int i = 0; i < 3; ++i) {
      change[i] = load_aligned(morphed.geometry.skin + at + 4 * i) - load_aligned(bind.skin + at + 4 * i);
      store(q + 4 * i, load(q + 4 * i) + change[i]);
    }
    q += 12;
    for (std::uint32_t j = 0; j + 1 < k; ++j, q += 16)
      for (int i = 0; i < 3; ++i) store(q + 4 * i, load(q + 4 * i) + load(q + 12) * change[i]);
  });
  std::memset(morphed.changed, 0, words * 4);
  return Status::ok;
}

}  // namespace marrow
