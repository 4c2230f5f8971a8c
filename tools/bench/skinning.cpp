// The rows skin/DEFORMER/ATTRIBUTES/INFLUENCES/VERTICES: a whole generated mesh an iteration.
#include "bench/vertices.h"
#include "bench/workload.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

constexpr const char* kKernels[] = {"rigid", "ssd", "as"};
constexpr const char* kAttributes[] = {"p", "pn", "pnt"};    // positions, normals, tangents
constexpr const char* kSurfaceAttributes[] = {"ps", "pst"};  // normals, and tangents, of the surface
constexpr std::uint32_t kInfluences[] = {1, 2, 3, 4, 8};
constexpr std::uint32_t kVertices[] = {1000, 10000, 100000};

struct SkinningShape {
  Deformer deformer;
  std::string attributes;
  std::uint32_t influences, vertices;
};

class Skinning : public Workload {
 public:
  explicit Skinning(const SkinningShape& shape)
      : deformer_(shape.deformer), mesh_(shape.vertices, shape.influences), palette_(noise_palette(kMeshJoints)) {
    const std::size_t slots = mesh_.view().geometry.slot_count;
    positions_.resize(3 * slots);
    if (shape.attributes != "p") normals_.resize(3 * slots);
    if (shape.attributes.back() == 't') tangents_.resize(4 * slots);
    if (deformer_ != Deformer::as) return;
    coordinates_.resize(as_coordinate_count(mesh_.view().geometry));
    check(as_coordinates(mesh_.view().geometry, coordinates_));
    if (shape.attributes.find('s') != std::string::npos) derive_tangents();
  }
  std::uint32_t items() const override { return mesh_.view().geometry.vertex_count; }
  std::uint64_t hash_output(std::uint64_t state) const override {
    return hash_of(tangents_, hash_of(normals_, hash_of(positions_, state)));
  }
  void run(std::uint64_t iterations) override {
    const SkinOutput out = {positions_, normals_, tangents_, NormalTransform::blended_matrix};
    for (std::uint64_t i = 0; i < iterations; ++i) {
      switch (deformer_) {
        case Deformer::rigid:
          check(skin_rigid(mesh_.view(), palette_, out));
          break;
        case Deformer::ssd:
          check(skin_ssd(mesh_.view(), palette_, out));
          break;
        default:
          check(skin_as(mesh_.view(), coordinates_, palette_, out, surface_));
          break;
      }
    }
  }

 private:
  void derive_tangents() {
    surface_.resize(as_tangent_count(mesh_.view().geometry));
    const AsPart part{&mesh_.view(), coordinates_, surface_};
    std::vector<std::uint32_t> scratch(as_tangent_scratch_bytes({&part, 1}) / sizeof(std::uint32_t));
    check(as_tangents({&part, 1}, {reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * 4}));
  }

  Deformer deformer_;
  GeneratedMesh mesh_;
  std::vector<Affine> palette_;
  std::vector<float> coordinates_, surface_, positions_, normals_, tangents_;
};

}  // namespace

RowGroup skinning_rows() {
  RowGroup group;
  const auto add_rows = [&group](const char* deformer, const char* attributes) {
    for (const std::uint32_t influences : kInfluences) {
      for (const std::uint32_t vertices : kVertices) {
        const SkinningShape shape = {*value_of(kDeformers, deformer), attributes, influences, vertices};
        group.rows.push_back({fmt::format("skin/{}/{}/{}/{}", deformer, attributes, influences, vertices),
                              nullptr,
                              {},
                              [shape](Models&) { return std::make_unique<Skinning>(shape); }});
      }
    }
  };
  for (const char* const deformer : kKernels)
    for (const char* const attributes : kAttributes) add_rows(deformer, attributes);
  for (const char* const attributes : kSurfaceAttributes) add_rows("as", attributes);
  group.names =
      fmt::format("skin/{}/{}/{}/{}\nskin/as/{}/{}/{}\n", choice(kKernels), choice(kAttributes), choice(kInfluences),
                  choice(kVertices), choice(kSurfaceAttributes), choice(kInfluences), choice(kVertices));
  return group;
}

}  // namespace marrow::tools
