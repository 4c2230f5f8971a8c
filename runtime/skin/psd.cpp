// Pose-space deformation, four vertices at a time: deltas of the examples that move them, then skeletal subspace
// deformation.
#include "core/zone.h"
#include "math/elementary.h"
#include "skin/joint_set.h"

namespace marrow {
namespace {

// Where each example stands in its list of blocks, as the kernel goes over all blocks in order.
class Examples {
 public:
  Examples(const Geometry& g) : space_(g.pose_space), wide_(g.index_bytes == 4) {
    for (std::size_t k = 0; k < size(); ++k) {
      const MorphTarget& example = space_.examples[k];
      next_[k] = example.first_block;
      record_[k] = space_.records + std::size_t{12} * example.first_record;
      find_block(k);
    }
  }

  std::size_t size() const { return space_.examples.size; }
  bool moves(std::size_t k, std::uint32_t block) const { return block_[k] == block; }

  // The next record of an example that moves the block, times phi.
  void add(std::size_t k, f32x4 phi, Vector<f32x4>& delta) {
    const f32x4 scale = phi * splat(space_.examples[k].position_step);
    const std::int16_t* const r = record_[k];
    delta = delta + Vector<f32x4>{load_int16(r), load_int16(r + 4), load_int16(r + 8)} * scale;
    record_[k] += 12;
    ++next_[k];
    find_block(k);
  }

 private:
  void find_block(std::size_t k) {
    const MorphTarget& example = space_.examples[k];
    const std::size_t i = next_[k];
    block_[k] = i >= std::size_t{example.first_block} + example.block_count ? kNoSlot
                : wide_ ? static_cast<const std::uint32_t*>(space_.blocks)[i]
                        : static_cast<const std::uint16_t*>(space_.blocks)[i];
  }

  PoseSpace space_;
  bool wide_;
  std::size_t next_[kMaxPoseExamples];
  const std::int16_t* record_[kMaxPoseExamples];
  std::uint32_t block_[kMaxPoseExamples];
};

// The distances of a run's influences from one pose. As in JointSet, all but the last are differences from the last.
struct SetDistance {
  f32x4 last, others[kMaxInfluences - 1];

  // Row j of `distances` has `stride` floats, of which this is number k.
  void load(const float* distances, std::size_t stride, std::size_t k, const std::uint16_t* set,
            std::uint32_t influences) {
    const float of_last = distances[stride * set[influences - 1] + k];
    last = splat(of_last);
    for (std::uint32_t j = 0; j + 1 < influences; ++j) others[j] = splat(distances[stride * set[j] + k] - of_last);
  }
  // The exponential of the weighted distance, for four vertices.
  f32x4 phi(const float* weights, std::uint32_t influences) const {
    f32x4 sum = last;
    for (std::uint32_t j = 0; j + 1 < influences; ++j) sum = sum + load_aligned(weights + 4 * j) * others[j];
    return exp_negative(sum);
  }
};

class PoseSpaceSkin {
 public:
  PoseSpaceSkin(const Geometry& g, const float* distances) : examples_(g), distances_(distances) {}

  static constexpr bool kFixedDirections = false, kFixedInfluences = false;

  [[gnu::always_inline]] void run(Directions directions, std::uint32_t influences, const std::uint16_t* set,
                                  std::uint32_t blocks, const Affine* palette, Cursor& at) {
    const JointSet<Factors> joints(set, influences, palette);
    const std::size_t count = examples_.size();
    for (std::size_t k = 0; count > 0 && k <= count; ++k) from_[k].load(distances_, count + 1, k, set, influences);
    const f32x4 mirror = directions == Directions::blended_tangents ? determinant(joints.last) : splat(1.0f);
    for (; blocks > 0; --blocks, ++block_) {
      const float* const weights = at.stream + 12;
      Vector<f32x4> v = load_block(at.stream);
      add_deltas(weights, influences, v);
      Blend m = joints.last;
      add_others(influences, joints, weights, 4, m);
      store_xyz(at.out_positions, transform(m, v));
      at.stream += 4 * (influences + 2);
      at.out_positions += 12;
      write_directions(directions, m, mirror, at);
    }
  }

 private:
  void add_deltas(const float* weights, std::uint32_t influences, Vector<f32x4>& v) {
    Vector<f32x4> delta = splat(0.0f, 0.0f, 0.0f);
    bool moved = false;
    for (std::size_t k = 0; k < examples_.size(); ++k) {
      if (!examples_.moves(k, block_)) continue;
      examples_.add(k, from_[k].phi(weights, influences), delta);
      moved = true;
    }
    if (!moved) return;
    const f32x4 lift = splat(1.0f) - from_[examples_.size()].phi(weights, influences);
    v = v + delta * lift;
  }

  Examples examples_;
  const float* distances_;
  std::uint32_t block_ = 0;
  SetDistance from_[kMaxPoseExamples + 1];  // the examples, then the bind pose
};

}  // namespace

Status skin_psd(const Mesh& mesh, Span<const float> distances, Span<const Affine> palette, const SkinOutput& out) {
  MARROW_ZONE;
  const Geometry& g = mesh.geometry;
  MARROW_REQUIRE(g.pose_space.examples.size <= kMaxPoseExamples);
  MARROW_REQUIRE(holds(distances, psd_distance_count(g)));
  MARROW_REQUIRE_GOOD(deform(mesh, g.skin, palette, out, PoseSpaceSkin(g, distances.data)));
  return Status::ok;
}

}  // namespace marrow
