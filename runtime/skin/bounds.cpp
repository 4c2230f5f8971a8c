#include "marrow/bounds.h"

#include <bit>

#include "core/builtins.h"
#include "core/check.h"
#include "core/memory.h"
#include "core/off_boundary.h"
#include "core/zone.h"
#include "math/f32x4.h"
#include "math/finite.h"

namespace marrow {
namespace {

float smaller(float a, float b) {
  return b < a ? b : a;
}
float larger(float a, float b) {
  return a < b ? b : a;
}

// x, y, z, and a fourth lane that means nothing.
struct Box {
  f32x4 least = splat(kInfinity);
  f32x4 most = splat(-kInfinity);
};

// An entry's box after its matrix, in the lanes of Box.
struct Placed {
  f32x4 centre, half;

  // shift, wider: what morph targets add to the centre (lanes 0 to 2), and to the half sides (lanes 1 to 3).
  Placed(const Affine& map, const JointExtent& entry, f32x4 shift, f32x4 wider) {
    f32x4 x = load_aligned(map.rows[0]), y = load_aligned(map.rows[1]), z = load_aligned(map.rows[2]);
    f32x4 w = splat(0.0f);
    transpose(x, y, z, w);
    const f32x4 from = load(entry.centre) + shift, side = load(entry.centre + 2) + wider;
    centre = x * splat_lane<0>(from) + y * splat_lane<1>(from) + z * splat_lane<2>(from) + w;
    half = absolute(x) * splat_lane<1>(side) + absolute(y) * splat_lane<2>(side) + absolute(z) * splat_lane<3>(side);
  }
};

// Adds a vertex to an entry's box; `half` holds the upper corner until make_extents() is done.
void add_vertex(const float (&v)[3], JointExtent& entry) {
  const bool first = entry.half[0] < entry.centre[0];
  for (int c = 0; c < 3; ++c) {
    entry.centre[c] = first ? v[c] : smaller(entry.centre[c], v[c]);
    entry.half[c] = first ? v[c] : larger(entry.half[c], v[c]);
  }
}

// Four vertices: x[4] y[4] z[4], then a weight each for all joints of the set but the last.
void add_block(const float* block, const std::uint16_t* set, std::uint32_t influences, Span<JointExtent> joints) {
  for (int lane = 0; lane < 4; ++lane) {
    const float v[3] = {block[lane], block[4 + lane], block[8 + lane]};
    float left = 1.0f;
    for (std::uint32_t j = 0; j < influences; ++j) {
      const float weight = j + 1 < influences ? block[12 + 4 * j + static_cast<std::uint32_t>(lane)] : left;
      left -= weight;
      if (weight != 0 && set[j] < joints.size) add_vertex(v, joints[set[j]]);
    }
  }
}

void add_vertices(const Geometry& g, Span<JointExtent> joints) {
  const float* block = g.skin;
  const std::uint16_t* set = g.sets;
  for (const Run& run : g.runs) {
    for (std::uint32_t left = (run.vertex_count + 3) / 4; left > 0; --left) {
      add_block(block, set, run.influences, joints);
      block += 4 * (run.influences + 2);
    }
    set += run.influences;
  }
}

// Corners become centre and half sides. The centre may be rounded; the half sides grow to make up for it.
void finish(JointExtent& entry) {
  if (entry.half[0] < entry.centre[0]) {
    entry = {};
    return;
  }
  for (int c = 0; c < 3; ++c) {
    const float least = entry.centre[c], most = entry.half[c];
    entry.centre[c] = least + (most - least) * 0.5f;
    entry.half[c] = larger(most - entry.centre[c], entry.centre[c] - least);
  }
}

// records: of a geometry's morph targets or examples.
MorphExtent extent_of(const MorphTarget& target, const std::int16_t* records) {
  MorphExtent out;
  if ((target.attributes & kMorphsPositions) == 0) return out;
  const auto stride = 12 * static_cast<std::size_t>(std::popcount(target.attributes));
  const std::int16_t* record = records + 12 * static_cast<std::size_t>(target.first_record);
  for (std::uint32_t block = 0; block < target.block_count; ++block, record += stride) {
    for (int i = 0; i < 12; ++i) {
      const float change = static_cast<float>(record[i]) * target.position_step;
      out.least[i / 4] = smaller(out.least[i / 4], change);
      out.most[i / 4] = larger(out.most[i / 4], change);
    }
  }
  return out;
}

void add_scaled(const MorphExtent& extent, float weight, MorphExtent& sum) {
  for (int c = 0; c < 3; ++c) {
    const float a = weight * extent.least[c], b = weight * extent.most[c];
    sum.least[c] += smaller(a, b);
    sum.most[c] += larger(a, b);
  }
}

void take(const Mesh& mesh, Memory& memory, MeshExtents& out) {
  out.joints = memory.take<JointExtent>(mesh.palette_size());
  out.targets = memory.take<MorphExtent>(mesh.geometry.targets.size);
}

// Calls visit(where) for the box of every palette entry that anything follows.
template <class Visit>
void for_each_placed(const MeshExtents& extents, Span<const Affine> palette, const MorphExtent& change,
                     const Visit& visit) {
  float shift[3], wider[3];
  for (int c = 0; c < 3; ++c) {
    shift[c] = (change.least[c] + change.most[c]) * 0.5f;
    wider[c] = (change.most[c] - change.least[c]) * 0.5f;
  }
  const f32x4 by = lanes(shift[0], shift[1], shift[2], 0), more = lanes(0, wider[0], wider[1], wider[2]);
  for (std::size_t i = 0; i < extents.joints.size; ++i)
    if (extents.joints[i].half[0] >= 0) visit(Placed(palette[i], extents.joints[i], by, more));
}

// The distance of the box's centre to the farthest corner of any entry's box, times `scale`, which is a power of two.
float radius_about(f32x4 centre, const MeshExtents& extents, Span<const Affine> palette, const MorphExtent& change,
                   float scale) {
  f32x4 squared = splat(0.0f);
  for_each_placed(extents, palette, change, [&](const Placed& p) {
    const f32x4 far = (absolute(p.centre - centre) + p.half) * splat(scale), square = far * far;
    squared = greater(squared, splat_lane<0>(square) + splat_lane<1>(square) + splat_lane<2>(square));
  });
  return first_lane(sqrt(squared));
}

}  // namespace

std::size_t extents_bytes(const Mesh& mesh) {
  Memory counted;
  MeshExtents unused;
  take(mesh, counted, unused);
  return counted.whole();
}

Status make_extents(const Mesh& mesh, Span<std::byte> memory, MeshExtents& out) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(memory, extents_bytes(mesh)));
  MARROW_REQUIRE_GOOD(check_boundary(memory.data));
  const Geometry& g = mesh.geometry;
  Memory taken{memory.data};
  MeshExtents made;
  take(mesh, taken, made);
  for (JointExtent& entry : made.joints) entry = {{0, 0, 0}, {-1, -1, -1}};
  add_vertices(g, made.joints);
  for (JointExtent& entry : made.joints) finish(entry);
  for (std::size_t t = 0; t < made.targets.size; ++t) made.targets[t] = extent_of(g.targets[t], g.target_records);
  for (const MorphTarget& example : g.pose_space.examples)
    add_scaled(extent_of(example, g.pose_space.records), 1.0f, made.pose_space);
  out = made;
  return Status::ok;
}

Status palette_bounds(const MeshExtents& extents, Span<const Affine> palette, Span<const float> weights, Bounds& out) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(palette, extents.joints.size));
  MARROW_REQUIRE(weights.empty() || holds(weights, extents.targets.size));
  MARROW_REQUIRE(weights.empty() || all_finite(weights.data, extents.targets.size));
  MorphExtent change = extents.pose_space;
  for (std::size_t t = 0; t < extents.targets.size && !weights.empty(); ++t)
    add_scaled(extents.targets[t], weights[t], change);
  Box box;
  for_each_placed(extents, palette, change, [&](const Placed& p) {
    box.least = lesser(box.least, p.centre - p.half);
    box.most = greater(box.most, p.centre + p.half);
  });
  float least[4], most[4];
  store(least, box.least);
  store(most, box.most);
  Bounds made;
  if (least[0] <= most[0]) {
    for (int c = 0; c < 3; ++c) {
      made.box_min[c] = least[c];
      made.box_max[c] = most[c];
    }
    const f32x4 centre = lanes(made.centre(0), made.centre(1), made.centre(2), 0);
    made.radius_m = radius_about(centre, extents, palette, change, 1.0f);
    // For distant corners the squares overflow a float; at a smaller scale they do not.
    if (!is_finite(made.radius_m)) made.radius_m = radius_about(centre, extents, palette, change, 0x1p-66f) * 0x1p66f;
  }
  out = made;
  return Status::ok;
}

}  // namespace marrow
