// The rows skin/morph/ATTRIBUTES/TARGETS/VERTICES: morph targets of a generated mesh blended, a frame an iteration.
#include "bench/vertices.h"
#include "bench/workload.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

constexpr const char* kAttributes[] = {"p", "pn", "pnt", "as"};  // positions, normals, tangents; coordinates after p
constexpr std::uint32_t kTargets[] = {1, 4, 16};
constexpr std::uint32_t kVertices = 10000;
constexpr std::uint32_t kInfluences = 4;

// Every target moves the blocks of an eighth of the mesh, one target behind the other.
class Morphing : public Workload {
 public:
  Morphing(const std::string& attributes, std::uint32_t targets) : mesh_(kVertices, kInfluences) {
    Geometry g = mesh_.view().geometry;
    const std::uint32_t all = attributes == "pnt"  ? kMorphsPositions | kMorphsNormals | kMorphsTangents
                              : attributes == "pn" ? kMorphsPositions | kMorphsNormals
                                                   : kMorphsPositions;
    const std::uint32_t records = attributes == "pnt" ? 3 : attributes == "pn" ? 2 : 1;
    const std::uint32_t blocks = g.slot_count / 4, each = blocks / 8;
    Noise noise;
    for (std::uint32_t t = 0; t < targets; ++t) {
      targets_.push_back({t * each, each, t * each * records, all, 1e-6f, 1e-5f, 1e-5f, 0});
      for (std::uint32_t b = 0; b < each; ++b) {
        blocks_.push_back(static_cast<std::uint16_t>(t % 8 * each + b));
        for (std::uint32_t i = 0; i < 12 * records; ++i)
          records_.push_back(static_cast<std::int16_t>(noise.between(-32767, 32767)));
      }
      weights_.push_back(noise.between(0.1f, 1));
    }
    g.targets = targets_;
    g.target_blocks = blocks_.data();
    g.target_records = records_.data();
    memory_.resize(morphed_bytes(g) / sizeof(Affine) + 1);
    check(make_morphed(g, {reinterpret_cast<std::byte*>(memory_.data()), memory_.size() * sizeof(Affine)}, morphed_));
    if (attributes != "as") return;
    coordinates_.resize(as_coordinate_count(g));
    check(as_coordinates(g, coordinates_));
  }
  // Vertices moved, each as often as targets move it.
  std::uint32_t items() const override { return static_cast<std::uint32_t>(4 * blocks_.size()); }
  std::uint64_t hash_output(std::uint64_t state) const override {
    return hash_of(coordinates_, hash_of(memory_, state));
  }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      check(morph(weights_, morphed_));
      if (!coordinates_.empty()) check(morph_coordinates(morphed_, coordinates_));
    }
  }

 private:
  GeneratedMesh mesh_;
  std::vector<MorphTarget> targets_;
  std::vector<std::uint16_t> blocks_;
  std::vector<std::int16_t> records_;
  std::vector<float> weights_, coordinates_;
  std::vector<Affine> memory_;  // for its alignment
  MorphedGeometry morphed_;
};

}  // namespace

RowGroup morphing_rows() {
  RowGroup group;
  for (const char* const attributes : kAttributes) {
    for (const std::uint32_t targets : kTargets) {
      group.rows.push_back(
          {fmt::format("skin/morph/{}/{}/{}", attributes, targets, kVertices), nullptr, {}, [=](Models&) {
             return std::make_unique<Morphing>(attributes, targets);
           }});
    }
  }
  group.names = fmt::format("skin/morph/{}/{}/{}\n", choice(kAttributes), choice(kTargets), kVertices);
  return group;
}

}  // namespace marrow::tools
