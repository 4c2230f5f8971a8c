// Skeletal subspace deformation, four vertices at a time.
#include "core/mark.h"
#include "skin/joint_set.h"

namespace marrow {
namespace {

struct Ssd {
  template <class D>
  static void run(D directions, const std::uint16_t* set, std::uint32_t influences, std::uint32_t blocks,
                  const Affine* palette, Cursor& at) {
    JointSet joints;
    load_joint_set(set, influences, palette, joints);
    if constexpr (!kSmall) {
      if (influences == 1) return blend(directions, Fixed<1u>(), joints, blocks, at);
      if constexpr (!is_exact(D())) {  // there the loop over joints is a small part of the work
        if (influences == 2) return blend(directions, Fixed<2u>(), joints, blocks, at);
        if (influences == 3) return blend(directions, Fixed<3u>(), joints, blocks, at);
        if (influences == 4) return blend(directions, Fixed<4u>(), joints, blocks, at);
      }
    }
    blend(directions, influences, joints, blocks, at);
  }

  // influences: a Fixed number; or any, at least 2 but where code is to be small.
  template <class D, class Count>
  [[gnu::noinline]] static void blend(D directions, Count influences, const JointSet& joints, std::uint32_t blocks,
                                      Cursor& cursor) {
    constexpr bool kMayBeOne = kSmall || std::is_same_v<Count, Fixed<1u>>;
    const f32x4 mirror = has_tangents(directions) ? determinant(joints.last) : splat(1.0f);
    Cursor at = cursor;
    for (; blocks > 0; --blocks) {
      const float* const weights = at.stream + 12;
      Blend m = joints.last;
      std::uint32_t j = 0;
      if (!kMayBeOne) m = add_scaled(m, load_aligned(weights), joints.others[j++]);
      for (; j + 1 < influences; ++j) m = add_scaled(m, load_aligned(weights + 4 * j), joints.others[j]);
      store_xyz(at.out_positions, transform(m, load_block(at.stream)));
      at.stream += 4 * (influences + 2);
      at.out_positions += 12;
      write_directions(directions, m, mirror, at);
    }
    cursor = at;
  }
};

}  // namespace

Status skin_ssd(const Mesh& mesh, Span<const Affine> palette, const SkinOutput& out) {
  MARROW_MARK;
  MARROW_REQUIRE_GOOD(deform<Ssd>(mesh, mesh.geometry.skin, palette, out));
  return Status::ok;
}

}  // namespace marrow
