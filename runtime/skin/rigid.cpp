// Every vertex follows one joint, four vertices at a time.
#include "core/zone.h"
#include "skin/joint_set.h"

namespace marrow {
namespace {

struct FourJoints {
  const Affine* lane[4];
};

// The joint with the largest weight; of equal ones the first.
FourJoints largest(const std::uint16_t* set, std::uint32_t influences, const float* weights, const Affine* palette) {
  float which[4] = {0, 0, 0, 0};
  if (influences > 1) {
    f32x4 most = load_aligned(weights), rest = splat(1.0f) - most, entry = splat(0.0f);
    for (std::uint32_t j = 1; j < influences; ++j) {
      f32x4 w = rest;
      if (j + 1 < influences) {
        w = load_aligned(weights + 4 * j);
        rest = rest - w;
      }
      const mask4 larger = most < w;
      most = select(larger, w, most);
      entry = select(larger, splat(static_cast<float>(j)), entry);
    }
    store(which, entry);
  }
  FourJoints joints;
  for (int i = 0; i < 4; ++i) joints.lane[i] = palette + set[static_cast<int>(which[i])];
  return joints;
}

struct Rigid {
  static constexpr bool kFixedDirections = true, kFixedInfluences = false;

  template <class D>
  [[gnu::always_inline]] static void run(D directions, std::uint32_t influences, const std::uint16_t* set,
                                         std::uint32_t blocks, const Affine* palette, Cursor& cursor) {
    Cursor at = cursor;
    if (influences == 1) {  // one matrix for the whole run
      const JointSet<Factors> joints(set, 1u, palette);
      const f32x4 mirror = directions == Directions::blended_tangents ? determinant(joints.last) : splat(1.0f);
      for (; blocks > 0; --blocks) write_block(directions, joints.last, mirror, 1, at);
    }
    for (; blocks > 0; --blocks) {
      const FourJoints joints = largest(set, influences, at.stream + 12, palette);
      const Blend m = load_affines(*joints.lane[0], *joints.lane[1], *joints.lane[2], *joints.lane[3]);
      write_block(directions, m, directions == Directions::blended_tangents ? determinant(m) : splat(1.0f), influences,
                  at);
    }
    cursor = at;
  }

  template <class D>
  static void write_block(D directions, const Blend& m, f32x4 mirror, std::uint32_t influences, Cursor& at) {
    store_xyz(at.out_positions, transform(m, load_block(at.stream)));
    at.stream += 4 * (influences + 2);
    at.out_positions += 12;
    write_directions(directions, m, mirror, at);
  }
};

}  // namespace

Status skin_rigid(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(deform<Rigid>(mesh, mesh.geometry.skin, palette, out));
  return Status::ok;
}

}  // namespace marrow
