// Skeletal subspace deformation, four vertices at a time.
#include "core/mark.h"
#include "skin/joint_set.h"

namespace marrow {
namespace {

struct Ssd {
  template <Directions D>
  static void run(const std::uint16_t* set, std::uint32_t influences, std::uint32_t blocks, const Affine* palette,
                  Cursor& at) {
    JointSet joints;
    load_joint_set(set, influences, palette, joints);
    if (influences == 1) return blend<D, 1>(joints, influences, blocks, at);
    if constexpr (kUnrolled && !is_exact(D)) {  // there the loop over joints is a small part of the work
      if (influences == 2) return blend<D, 2>(joints, influences, blocks, at);
      if (influences == 3) return blend<D, 3>(joints, influences, blocks, at);
      if (influences == 4) return blend<D, 4>(joints, influences, blocks, at);
    }
    blend<D, 0>(joints, influences, blocks, at);
  }

  // Influences: how many, or 0 for as many as the argument says, at least 2.
  template <Directions D, std::uint32_t Influences>
  [[gnu::noinline]] static void blend(const JointSet& joints, std::uint32_t influences, std::uint32_t blocks,
                                      Cursor& cursor) {
    const std::uint32_t k = Influences > 0 ? Influences : influences;
    const f32x4 mirror = has_tangents(D) ? determinant(joints.last) : splat(1.0f);
    Cursor at = cursor;
    for (; blocks > 0; --blocks) {
      const float* const weights = at.stream + 12;
      Blend m = joints.last;
      if constexpr (Influences != 1) m = add_scaled(m, load_aligned(weights), joints.others[0]);
      for (std::uint32_t j = 1; j + 1 < k; ++j) m = add_scaled(m, load_aligned(weights + 4 * j), joints.others[j]);
      store_xyz(at.out_positions, transform(m, load_block(at.stream)));
      at.stream += 4 * (k + 2);
      at.out_positions += 12;
      write_directions<D>(m, mirror, at);
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
