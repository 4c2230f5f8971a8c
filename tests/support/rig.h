// Skeletons, clips and meshes built in memory from plain numbers, so that a stage can be tested without a cooked file.
#pragma once

#include <cstdint>
#include <vector>

#include "marrow/marrow.h"
#include "support/double_math.h"

namespace marrow::test {

struct TestJoint {
  int parent = -1;
  Vec3 translation{0, 0, 0};
  Quat rotation{0, 0, 0, 1};
  Vec3 scale{1, 1, 1};
};

// Parents before children, roots first, breadth-first: as Skeleton wants them.
struct TestSkeleton {
  explicit TestSkeleton(const std::vector<TestJoint>& joints, const std::vector<Map>& above_roots = {});
  Skeleton view() const;

  std::vector<TestJoint> joints;
  std::vector<Map> above;  // one a root
  std::vector<Affine> roots;
  std::vector<SoaTransform> rest;
  std::vector<std::uint16_t> parents;
  std::vector<std::uint32_t> names;
};

struct TestClip {
  // values: floats a key times keys; see Track::first_value.
  void add(std::uint16_t joint, TrackPath path, Interpolation interpolation, const std::vector<float>& times_s,
           const std::vector<float>& values_);
  Clip view() const;

  float duration_s = 0;
  std::vector<Track> tracks;
  std::vector<float> times, values;
};

struct TestVertex {
  Vec3 position{0, 0, 0};
  Vec3 normal{0, 0, 1};
  Vec3 tangent{1, 0, 0};
  double sign = 1;
  std::vector<double> weights;                  // one a joint of the run's set; their sum is 1
  std::vector<std::array<double, 4>> residual;  // empty, or one a joint of the set
};

struct TestRun {
  std::vector<std::uint16_t> set;  // palette entries
  std::vector<TestVertex> vertices;
};

struct TestMesh {
  // Every array that the runtime reads is exactly as long as it must be, so that a sanitizer sees one float too many.
  explicit TestMesh(const std::vector<TestRun>& runs, const std::vector<Map>& inverse_bind, bool residuals = false);
  Mesh view() const;
  // Slot of vertex v of run r.
  std::size_t slot(std::size_t r, std::size_t v) const { return first_slot[r] + v; }

  std::vector<TestRun> source;
  std::vector<Map> bind_inverse;
  std::vector<std::size_t> first_slot;
  std::vector<Run> runs;
  std::vector<std::uint16_t> sets, joints;
  std::vector<float> skin, normals, tangents, residual;
  std::vector<Affine> inverse_bind;
  std::uint32_t slot_count = 0, vertex_count = 0;
};

Affine to_affine(const Map& m);
Map to_map(const Affine& a);
// Joint `joint` of a local pose.
TestJoint joint_of(const SoaTransform* pose, std::size_t joint);

// Pseudo-random numbers that are the same everywhere: no library distribution, no transcendental function.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2 + 1) {}
  std::uint32_t bits() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>(state_ >> 33);
  }
  std::uint32_t below(std::uint32_t n) { return bits() % n; }
  // A multiple of 2⁻²⁰ in [low, high): exact in float for small ranges.
  double between(double low, double high) { return low + (high - low) * (bits() & 0xFFFFF) / 1048576.0; }
  Quat rotation();

 private:
  std::uint64_t state_;
};

// A creature of noise: a forest of joints, a clip with tracks of every kind, a mesh with runs of 1 to 8 influences.
struct TestCharacter {
  TestSkeleton skeleton;
  TestClip clip;
  TestMesh mesh;
};
TestCharacter make_character(std::uint64_t seed, std::size_t joint_count, std::size_t vertices_a_run, bool residuals);

// A mesh's view with the box round its vertices, which prepare() needs.
Mesh with_box(const TestMesh& source);

}  // namespace marrow::test
