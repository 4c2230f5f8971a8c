// Posing and skinning the newt on the CPU, nanoseconds a joint or a vertex.
#include <cstdio>

#include "phone/phone.h"

namespace marrow::phone {
namespace {

constexpr double kBatch_s = 8e-3;
constexpr std::size_t kBatches = 15;

class Rows {
 public:
  // step(): one call for so many joints or vertices.
  template <class Step>
  void add(const std::string& name, std::uint32_t items, Step step) {
    const double each_s = median_seconds(kBatch_s, kBatches, [&step](std::uint64_t count) {
      const Clock::time_point start = Clock::now();
      for (std::uint64_t i = 0; i < count; ++i) step();
      return seconds_since(start);
    });
    text_ += std::string(text_.empty() ? "" : ",") + "\n  {\"name\": " + quoted(name) +
             ", \"items\": " + std::to_string(items) + ", \"ns\": " + number(1e9 * each_s / items) + "}";
  }
  void print() const { std::printf("{\"rows\": [%s\n]}\n", text_.c_str()); }

 private:
  std::string text_;
};

}  // namespace

void bench_cpu(const Newt& newt) {
  const Skeleton& skeleton = newt.skeleton;
  const Mesh& mesh = newt.body;
  const Geometry& g = mesh.geometry;
  std::vector<SoaTransform> pose(skeleton.soa_size());
  std::vector<Affine> joints(skeleton.joint_count), palette(mesh.palette_size());
  float time_s = 0;
  Rows rows;
  rows.add("sample", skeleton.joint_count, [&] {
    time_s = time_s + 1.0f / 60 < newt.walk.duration_s ? time_s + 1.0f / 60 : 0;
    must(sample(skeleton, newt.walk, time_s, pose), "sample");
  });
  rows.add("local_to_model", skeleton.joint_count,
           [&] { must(local_to_model(skeleton, pose, joints), "local_to_model"); });
  rows.add("build_palette", mesh.palette_size(), [&] { must(build_palette(mesh, joints, palette), "build_palette"); });

  std::vector<float> coordinates(as_coordinate_count(g)), positions(3 * std::size_t{g.slot_count}),
      normals(positions.size());
  must(as_coordinates(g, coordinates), "as_coordinates");
  for (const bool with_normals : {false, true}) {
    SkinOutput out{positions, {}, {}, NormalTransform::blended_matrix};
    if (with_normals) out.normals = normals;
    const char* const attributes = with_normals ? "pn" : "p";
    rows.add(std::string("skin/rigid/") + attributes, g.vertex_count,
             [&] { must(skin_rigid(mesh, palette, out), "skin_rigid"); });
    rows.add(std::string("skin/ssd/") + attributes, g.vertex_count,
             [&] { must(skin_ssd(mesh, palette, out), "skin_ssd"); });
    rows.add(std::string("skin/as/") + attributes, g.vertex_count,
             [&] { must(skin_as(mesh, coordinates, palette, out), "skin_as"); });
  }
  rows.print();
}

}  // namespace marrow::phone
